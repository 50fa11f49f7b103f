#include "armtol/map/output.h"

#include "console/number.h"

#include <math.h>

static void put_number(FILE *stream, double value)
{
    fputs(isfinite(value) ? number_shortest(value, &armtol_errata_none, &(number_text){""}) : isnan(value) ? "-"
          : "inf", stream);
}

static void put_head(FILE *stream, const map_plan *plan)
{
    const units *units = &plan->request->units;
    const armtol_arm *arm = &plan->request->arm;
    fprintf(stream, "# %s of %s, in %s; %s and joints in %s and %s; "
                    "marks: 1 reached, 2 and 4 joined to the next point and the one above\n",
            map_title_of(plan, &(map_title){""}), arm->name, units_name(units, plan->is_length), "x, y, z",
            units_name(units, true), units_name(units, false));
    fprintf(stream, "x\ty\tz\tmarks\t%s", armtol_map_value_name(plan->map.value));
    for (size_t j = 0; j < armtol_arm_joint_count(arm); j++) {
        fprintf(stream, "\tq%zu", j + 1);
    }
    fputc('\n', stream);
}

static void put_point(FILE *stream, const map_findings *findings, size_t k)
{
    const map_plan *plan = findings->plan;
    const map_found *found = findings->found;
    double point[3];
    map_plan_point(plan, k, point);
    for (int i = 0; i < 3; i++) {
        put_number(stream, map_place_shown(plan, point[i]));
        fputc('\t', stream);
    }
    fprintf(stream, "%d\t", found->marks[k]);
    put_number(stream, map_value_shown(plan, found->values[k]));
    for (size_t j = 0; j < armtol_arm_joint_count(&plan->request->arm); j++) {
        fputc('\t', stream);
        put_number(stream, map_joint_shown(plan, found, k, j));
    }
    fputc('\n', stream);
}

void map_write_tsv(FILE *stream, const void *data)
{
    const map_findings *findings = data;
    put_head(stream, findings->plan);
    for (size_t k = 0; k < map_plan_count(findings->plan); k++) {
        put_point(stream, findings, k);
    }
}
