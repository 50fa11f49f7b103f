#include "armtol/map/output.h"

#include "armtol/armtol.h"
#include "armtol/tell/json_arms.h"
#include "console/exit_code.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* docs/json.md describes what is written here. */

static void write_plane(json *json, const map_plan *plan)
{
    char axes[8];
    snprintf(axes, sizeof axes, "%s%s", map_axis_name(plan->right), map_axis_name(plan->up));
    json_open_object(json, "plane");
    json_text(json, "axes", axes);
    json_number(json, "offset", map_place_shown(plan, plan->offset));
    json_numbers(json, "first",
                 (const double[]){map_place_shown(plan, plan->first[0]), map_place_shown(plan, plan->first[1])}, 2);
    json_numbers(json, "last", (const double[]){map_place_shown(plan, plan->last[0]),
                                                map_place_shown(plan, plan->last[1])},
                 2);
    json_numbers(json, "points", (const double[]){(double)plan->n[0], (double)plan->n[1]}, 2);
    json_close_object(json);
    json_open_array(json, "tool_axes");
    for (int i = 0; i < 3 && plan->keeps_axes; i++) {
        json_numbers(json, NULL, plan->axes[i], 3);
    }
    json_close_array(json);
}

static void write_extreme(json *json, const char *name, const map_findings *findings, size_t k)
{
    const map_plan *plan = findings->plan;
    double point[3];
    map_plan_point(plan, k, point);
    json_open_object(json, name);
    json_number(json, "value", map_value_shown(plan, findings->found->values[k]));
    json_numbers(json, "at", (const double[]){map_place_shown(plan, point[0]), map_place_shown(plan, point[1]),
                                              map_place_shown(plan, point[2])}, 3);
    json_open_array(json, "joints");
    for (size_t j = 0; j < armtol_arm_joint_count(&plan->request->arm); j++) {
        json_number(json, NULL, map_joint_shown(plan, findings->found, k, j));
    }
    json_close_array(json);
    json_close_object(json);
}

static double value_at(const map_findings *findings, size_t k)
{
    return map_value_shown(findings->plan, findings->found->values[k]);
}

static double mark_at(const map_findings *findings, size_t k)
{
    return findings->found->marks[k];
}

/* Rows from below; a line each. */
static void write_rows(json *json, const char *name, const map_findings *findings, double row[],
                       double at(const map_findings *findings, size_t k))
{
    const size_t *n = findings->plan->n;
    json_open_array(json, name);
    for (size_t j = 0; j < n[1]; j++) {
        for (size_t i = 0; i < n[0]; i++) {
            row[i] = at(findings, j * n[0] + i);
        }
        json_numbers(json, NULL, row, n[0]);
    }
    json_close_array(json);
}

bool map_print_json(const map_findings *findings)
{
    double *row = calloc(findings->plan->n[0], sizeof *row);
    if (row == NULL) {
        out_of_memory();
        return false;
    }
    const map_plan *plan = findings->plan;
    const map_found *found = findings->found;
    const units *units = &plan->request->units;
    json json;
    json_start(&json, stdout);
    json_text(&json, "armtol", armtol_version());
    json_open_object(&json, "arm");
    json_arm_texts(&json, &plan->request->arm);
    json_close_object(&json);
    json_units(&json, units);
    json_text(&json, "map", armtol_map_value_name(plan->map.value));
    json_text(&json, "of", plan->of);
    json_text(&json, "unit", units_name(units, plan->is_length));
    write_plane(&json, plan);
    json_count(&json, "reached", found->n_reached);
    if (found->n_values > 0) {
        write_extreme(&json, "least", findings, found->least);
        write_extreme(&json, "most", findings, found->most);
    }
    if (!isnan(plan->wish)) {
        json_number(&json, "wish", map_value_shown(plan, plan->wish));
    }
    write_rows(&json, "values", findings, row, value_at);
    write_rows(&json, "marks", findings, row, mark_at);
    json_end(&json);
    free(row);
    return true;
}
