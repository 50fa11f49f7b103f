#include "armtol/against/against.h"

#include "armtol/names/link_name.h"
#include "armtol/forms/wrap.h"
#include "console/table.h"

#include <math.h>
#include <stdio.h>

enum { MOST_ROWS = 24 };

static void say_what(const against *against)
{
    const request *request = against->request;
    const bool of_tool = request->question.tool.frame == ARMTOL_TOOL_FRAME;
    const units *units = &request->units;
    wrap wrap;
    wrap_start(&wrap, stdout, 0, 0);
    if (request->options->against != NULL) {
        wrap_say(&wrap, "The tool of %s, less that of %s,", against->other, request->arm.name);
    } else {
        wrap_say(&wrap, "The tool of %s with the deviations of %s, less that without them,", request->arm.name,
                 against->other);
    }
    wrap_say(&wrap, "at the same joint values, along the axes of the %s; %s and %s", of_tool ? "tool" : "base",
             units_name(units, true), units_name(units, false));
    wrap_end(&wrap);
    printf("\n");
}

static void add_sizes(table *table, const units *units, const double sizes[2])
{
    table_add_cells(table, "%.6g\t%.6g", units_shown(units, true, sizes[0]), units_shown(units, false, sizes[1]));
}

static bool print_poses(against *against)
{
    const units *units = &against->request->units;
    const size_t n_poses = against->request->question.n_poses;
    table table = TABLE_EMPTY;
    table_add(&table, "pose\tdx\tdy\tdz\tdistance\tangle");
    for (size_t pose = 0; pose < n_poses && pose < MOST_ROWS; pose++) {
        double error[6];
        against_pose(against, pose, error);
        table_add(&table, "%zu", pose + 1);
        for (size_t i = 0; i < 3; i++) {
            table_add_cells(&table, "%.6g", units_shown(units, true, error[i]));
        }
        add_sizes(&table, units, against_size_of(error).size);
    }
    const bool fine = table_finish(&table, NULL, NULL, FORMAT_TEXT, stdout);
    if (fine && n_poses > MOST_ROWS) {
        printf("  and %zu more poses (--json has all)\n", n_poses - MOST_ROWS);
    }
    return fine;
}

static void print_sizes(const against *against, const against_summary *summary)
{
    const units *units = &against->request->units;
    wrap wrap;
    wrap_start(&wrap, stdout, 2, 2);
    wrap_say(&wrap, "mean %.6g %s and %.6g %s, largest %.6g in pose %zu and %.6g in pose %zu",
             units_shown(units, true, summary->mean[0]), units_name(units, true),
             units_shown(units, false, summary->mean[1]), units_name(units, false),
             units_shown(units, true, summary->largest[0]), summary->worst[0] + 1,
             units_shown(units, false, summary->largest[1]), summary->worst[1] + 1);
    wrap_end(&wrap);
}

static void add_share(table *table, double share)
{
    if (isnan(share)) {
        table_add_cells(table, "-");
    } else {
        table_add_cells(table, "%.1f %%", fabs(share) < 0.0005 ? 0 : 100 * share); /* no -0.0 */
    }
}

static void add_difference(table *table, const against *against, const against_share *share)
{
    const armtol_difference *difference = &against->differences[share->difference];
    const units *units = &against->request->units;
    const bool is_length = armtol_parameter_is_length(difference->parameter);
    table_add(table, "%s of %s\t%.6g\t%s", armtol_parameter_name(difference->parameter),
              link_cell(&against->request->arm, difference->link, &(link_text){""}),
              units_shown(units, is_length, difference->value), units_name(units, is_length));
    add_sizes(table, units, share->largest);
    add_share(table, share->share[0]);
    add_share(table, share->share[1]);
}

static bool print_differences(const against *against, const against_summary *summary)
{
    table table = {.cut_first = true};
    if (against->n_differences == 0) {
        printf("\nNo parameter differs.\n");
        return true;
    }
    table_add(&table, "parameter\tdifference\tunit\tdistance\tangle\tof distance\tof angle");
    for (size_t k = 0; k < against->n_differences; k++) {
        add_difference(&table, against, &summary->shares[k]);
    }
    table_add(&table, "all together\t-\t-\t-\t-");
    add_share(&table, summary->together[0]);
    add_share(&table, summary->together[1]);
    return table_finish(&table, "What explains it: how far each difference moves the tool alone, at most,",
                        "and its part in the squared errors of all poses", FORMAT_TEXT, stdout);
}

bool against_text(against *against, const against_summary *summary)
{
    say_what(against);
    if (!print_poses(against)) {
        return false;
    }
    if (against->request->question.n_poses > 1) {
        print_sizes(against, summary);
    }
    return print_differences(against, summary);
}
