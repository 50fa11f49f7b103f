#include "armtol/names/link_name.h"
#include "armtol/tell/grades.h"
#include "armtol/tell/text_tables.h"
#include "armtol/forms/wrap.h"
#include "console/table.h"

#include <stdio.h>

static void add_grades(table *table, const char *unit, const grades_held *held)
{
    table_add_cells(table, "%s\t%s\t%s", unit, held->iso_286 != NULL ? held->iso_286 : "-",
                    grades_class(held, "-", (char[GRADES_CLASS]){""}));
}

static void add_parameter(const findings *findings, size_t column, table *table)
{
    const parameter_row row = findings_parameter(findings, column);
    const grades_held held = grades_of_parameter(findings, column);
    table_add(table, "%s\t%s\t%.6g\t%.6g", link_cell(findings->request->question.arm, row.link, &(link_text){""}),
              row.parameter, row.nominal, row.tolerance);
    add_grades(table, row.unit, &held);
}

static void add_distance(const findings *findings, size_t link, table *table)
{
    const units *units = &findings->request->units;
    const grades_held held = grades_of_distance(findings, link);
    table_add(table, "%s\tdistance\t%.6g\t%.6g", link_cell(findings->request->question.arm, link, &(link_text){""}),
              units_shown(units, true, grades_distance(findings, link)),
              units_shown(units, true, findings->answer->parts[link].distance));
    add_grades(table, units_name(units, true), &held);
}

static void explain(void)
{
    wrap wrap;
    printf("\n");
    wrap_start(&wrap, stdout, 0, 0);
    wrap_say(&wrap, "ISO 286: the widest of the grades IT5 to IT12 with half its width within the tolerance, for the "
                    "nominal length as its size. ISO 2768: the coarser of the classes f and m that is within it; of an "
                    "angle, if its shorter side is longer than said.");
    wrap_end(&wrap);
}

bool text_grades(const findings *findings)
{
    const armtol_answer *answer = findings->answer;
    table table = {.cut_first = true};
    size_t k = 0;
    table_add(&table, "link\tof\tnominal\ttolerance\tunit\tISO 286\tISO 2768");
    for (size_t link = 0; link < answer->n_links; link++) {
        for (; k < answer->n_columns && answer->columns[k].link == link; k++) {
            if (grades_has_parameter(findings, k)) {
                add_parameter(findings, k, &table);
            }
        }
        if (grades_has_distance(findings, link)) {
            add_distance(findings, link, &table);
        }
    }
    const bool fine = table_finish(&table, "Grades within the tolerances", NULL, FORMAT_TEXT, stdout);
    if (fine) {
        explain();
    }
    return fine;
}
