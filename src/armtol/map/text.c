#include "armtol/map/output.h"

#include "armtol/forms/wrap.h"

#include <math.h>
#include <stdio.h>

static void say_point(wrap *wrap, const map_plan *plan, size_t k)
{
    double point[3];
    map_plan_point(plan, k, point);
    wrap_say(wrap, "%s %.6g, %s %.6g", map_axis_name(plan->right), map_place_shown(plan, point[plan->right]),
             map_axis_name(plan->up), map_place_shown(plan, point[plan->up]));
}

static void print_value(const map_findings *findings, const char *what, size_t k)
{
    const map_plan *plan = findings->plan;
    const map_found *found = findings->found;
    const size_t n = armtol_arm_joint_count(&plan->request->arm);
    wrap wrap;
    wrap_start(&wrap, stdout, 2, 4);
    wrap_say(&wrap, "%s: %.6g %s at", what, map_value_shown(plan, found->values[k]),
             units_name(&plan->request->units, plan->is_length));
    say_point(&wrap, plan, k);
    wrap_say(&wrap, "(joints");
    for (size_t j = 0; j < n; j++) {
        wrap_say(&wrap, "%.6g%s", map_joint_shown(plan, found, k, j), j + 1 == n ? ")" : "");
    }
    wrap_end(&wrap);
}

/* Of the points that are reached, how many keep to the wish. */
static void print_share(const map_findings *findings)
{
    const map_plan *plan = findings->plan;
    const map_found *found = findings->found;
    const double rounding = 1e-12;
    size_t n = 0;
    wrap wrap;
    for (size_t k = 0; k < map_plan_count(plan); k++) {
        const double value = found->values[k];
        n += map_is_of_tolerances(plan) ? value >= plan->wish * (1 - rounding) : value <= plan->wish * (1 + rounding);
    }
    wrap_start(&wrap, stdout, 2, 4);
    wrap_say(&wrap, "%s %.6g %s in %zu of the %zu points reached", map_is_of_tolerances(plan) ? "at least"
             : "no more than",
             map_value_shown(plan, plan->wish), units_name(&plan->request->units, plan->is_length), n,
                 found->n_reached);
    wrap_end(&wrap);
}

static void print_head(const map_findings *findings)
{
    const map_plan *plan = findings->plan;
    const map_found *found = findings->found;
    const units *units = &plan->request->units;
    wrap wrap;
    wrap_start(&wrap, stdout, 0, 2);
    wrap_say(&wrap, "%s, in %s and %s: %s", plan->request->arm.title, units_name(units, true), units_name(units, false),
             map_title_of(plan, &(map_title){""}));
    wrap_end(&wrap);
    wrap_start(&wrap, stdout, 2, 4);
    wrap_say(&wrap, "plane %s%s at %s %.6g, %zu x %zu points from", map_axis_name(plan->right), map_axis_name(plan->up),
             map_axis_name(plan->third), map_place_shown(plan, plan->offset), plan->n[0], plan->n[1]);
    say_point(&wrap, plan, 0);
    wrap_say(&wrap, "to");
    say_point(&wrap, plan, map_plan_count(plan) - 1);
    wrap_end(&wrap);
    wrap_start(&wrap, stdout, 2, 4);
    wrap_say(&wrap, "%zu of %zu points reached,", found->n_reached, map_plan_count(plan));
    wrap_say(&wrap, plan->keeps_axes ? "the tool's axes the same everywhere%s" : "the tool's axes free%s",
             found->n_seams > 0 ? ";" : "");
    if (found->n_seams > 0) {
        wrap_say(&wrap, "between %zu pairs of neighbours the arm changes its branch", found->n_seams);
    }
    wrap_end(&wrap);
}

void map_print_text(const map_findings *findings)
{
    const map_found *found = findings->found;
    print_head(findings);
    if (found->n_values < found->n_reached) {
        printf("  without a bound: %zu points\n", found->n_reached - found->n_values);
    }
    if (found->n_values > 0) {
        print_value(findings, "least", found->least);
        print_value(findings, "most", found->most);
    }
    if (found->n_reached > 0 && !isnan(findings->plan->wish)) {
        print_share(findings);
    }
}
