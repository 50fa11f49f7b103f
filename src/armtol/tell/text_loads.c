#include "armtol/tell/text_tables.h"
#include "console/table.h"

#include <stdio.h>

enum { MOST_ROWS = 24 };

static void add_values(table *table, const double values[6])
{
    for (size_t i = 0; i < 6; i++) {
        table_add_cells(table, "%.6g", values[i]);
    }
}

static void add_droop(table *table, const findings *findings, size_t place)
{
    const size_t n_loads = findings->answer->n_loads;
    double droop[6];
    for (size_t i = 0; i < 6; i++) {
        droop[i] = findings_shown(findings, i, findings->answer->droops[6 * place + i]);
    }
    if (n_loads > 1) {
        table_add(table, "%zu, load %zu", place / n_loads + 1, place % n_loads + 1);
    } else {
        table_add(table, "%zu", place / n_loads + 1);
    }
    add_values(table, droop);
}

/* A pose's loads, and how far they are apart. */
static void add_pose(table *table, const findings *findings, size_t pose)
{
    const size_t n_loads = findings->answer->n_loads;
    for (size_t load = 0; load < n_loads; load++) {
        add_droop(table, findings, pose * n_loads + load);
    }
    if (n_loads > 1) {
        double difference[6];
        findings_load_difference(findings, pose, difference);
        table_add(table, "%zu, difference", pose + 1);
        add_values(table, difference);
    }
}

bool text_loads(const findings *findings)
{
    const size_t n_poses = findings->request->question.n_poses, n_loads = findings->answer->n_loads;
    if (!findings->answer->loaded) {
        return true;
    }
    table table = TABLE_EMPTY;
    table_add(&table, "pose");
    for (size_t i = 0; i < 6; i++) {
        table_add_cells(&table, "%s", armtol_component_name(i));
    }
    size_t pose = 0;
    for (; pose < n_poses && (pose == 0 || (pose + 1) * (n_loads + 1) <= MOST_ROWS); pose++) {
        add_pose(&table, findings, pose);
    }
    const bool fine =
        table_finish(&table, "Where loads take the tool, by the exact kinematics", NULL, FORMAT_TEXT, stdout);
    if (fine && pose < n_poses) {
        printf("  and %zu more poses (--json has all)\n", n_poses - pose);
    }
    return fine;
}
