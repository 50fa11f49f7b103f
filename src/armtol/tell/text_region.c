#include "armtol/tell/text_tables.h"

#include "armtol/forms/wrap.h"
#include "console/table.h"

#include <math.h>
#include <stdio.h>

static void add_number(table *table, double value)
{
    table_add_cells(table, isfinite(value) ? "%.6g" : "-", value);
}

static void add_enclosure(const findings *findings, const armtol_enclosure *enclosure, table *table)
{
    const units *units = &findings->request->units;
    const bool is_length = findings_enclosure_is_length(enclosure);
    table_add(table, "%s", findings_enclosure_name(enclosure));
    add_number(table, units_shown(units, is_length, enclosure->accuracy));
    add_number(table, units_shown(units, is_length, enclosure->low));
    add_number(table, units_shown(units, is_length, enclosure->high));
    table_add_cells(table, "%.2f %%\t%s\t%zu\t%llu", 100 * findings_gap(enclosure), units_name(units, is_length),
                    enclosure->pose + 1, (unsigned long long)enclosure->boxes);
}

static void say_what(const findings *findings)
{
    const armtol_region_answer *region = findings->region;
    const units *units = &findings->request->units;
    wrap wrap;
    printf("\n");
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap,
             "In no pose of the region the error is above the bound, to first order: this is proved. It is as large as "
             "what was found in the pose of that number. The exact error differs from the first order by no more than "
             "%.2g %s and %.2g %s anywhere in the region.",
             units_shown(units, true, region->remainder[0]), units_name(units, true),
             units_shown(units, false, region->remainder[1]), units_name(units, false));
    if (findings->verification != NULL) {
        wrap_say(&wrap,
                 "What follows of arms that are drawn is for the %zu poses above, not for the rest of the region.",
                 region->n_poses);
    }
    wrap_end(&wrap);
}

/* Where the work ended early the bound can be above what was asked for. */
static void say_missed(const findings *findings)
{
    const armtol_region_answer *region = findings->region;
    for (size_t i = 0; i < region->n_enclosures; i++) {
        const armtol_enclosure *enclosure = &region->enclosures[i];
        if (enclosure->high > enclosure->accuracy * (1 + 1e-12)) {
            wrap wrap;
            wrap_start(&wrap, stdout, 0, 0);
            wrap_say(&wrap, enclosure->low > enclosure->accuracy * (1 + 1e-12)
                                ? "%s: the accuracy is NOT kept in the region."
                                : "%s: that the accuracy is kept everywhere in the region is NOT proved.",
                     findings_enclosure_name(enclosure));
            wrap_end(&wrap);
        }
    }
}

bool text_region(const findings *findings)
{
    const armtol_region_answer *region = findings->region;
    table table = TABLE_EMPTY;
    table_add(&table, "error\taccuracy\tfound\tbound\tgap\tunit\tpose\tboxes");
    for (size_t i = 0; i < region->n_enclosures; i++) {
        add_enclosure(findings, &region->enclosures[i], &table);
    }
    const bool fine = table_finish(&table, findings->answer->method == ARMTOL_METHOD_RSS
                                               ? "The largest standard deviations in the region, times sigma"
                                               : "The largest errors in the region",
                                   NULL, FORMAT_TEXT, stdout);
    if (fine) {
        say_what(findings);
        say_missed(findings);
    }
    return fine;
}
