/*
 * Files of poses, of positions, of distributions, of tolerances or weights, and what drawings say. The first byte says
 * which; the second, for poses, how many joints, and for parameters and drawings, which arm and what is asked of the
 * table.
 */

#include "fuzz/harness.h"
#include "fuzz/require.h"

#include "armtol/arm.h"
#include "armtol/drawing/drawing_file.h"
#include "armtol/lists/lists.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_COLUMNS = 64 };

static void check_poses(FILE *stream, unsigned choice)
{
    const size_t n_joints = 1 + choice % 7;
    double *poses;
    size_t n_poses;
    const bool fine = poses_read(stream, "poses.csv", n_joints, &poses, &n_poses);
    REQUIRE(fine ? caught_nothing() : caught_one_message());
    REQUIRE(fine == (poses != NULL) && fine == (n_poses > 0));
    for (size_t i = 0; i < n_poses * n_joints; i++) {
        REQUIRE(isfinite(poses[i]));
    }
    free(poses);
}

static void check_wishes(FILE *stream)
{
    typed_wish *wishes;
    size_t n_wishes;
    const bool fine = wishes_read(stream, "at.csv", &wishes, &n_wishes);
    REQUIRE(fine ? caught_nothing() : caught_one_message());
    REQUIRE(fine == (wishes != NULL) && fine == (n_wishes > 0));
    for (size_t i = 0; i < n_wishes; i++) {
        REQUIRE(wishes[i].n == 3 || wishes[i].n == 6);
        for (size_t k = 0; k < 6; k++) {
            REQUIRE(isfinite(wishes[i].value[k]));
        }
    }
    free(wishes);
}

static void check_values(const parameter_table *table, bool infinite_allowed, const double values[])
{
    for (size_t k = 0; k < table->n_columns; k++) {
        const bool kept = values[k] == -1; /* as it was */
        REQUIRE(kept || values[k] > 0 || (table->zero_allowed && values[k] == 0) || table->signed_allowed);
        REQUIRE(!isnan(values[k]));
        REQUIRE(infinite_allowed || kept || isfinite(values[k]));
    }
}

static void check_parameters(FILE *stream, unsigned choice)
{
    const armtol_arm *arm = armtol_arm_at(choice / 4 % armtol_arm_count());
    const bool zero = choice % 2 != 0, infinite_allowed = choice / 2 % 2 != 0, any_sign = choice / 128 != 0;
    const size_t n = armtol_column_count(arm->links, arm->n_links);
    armtol_column columns[MOST_COLUMNS];
    double values[MOST_COLUMNS];
    REQUIRE(n <= MOST_COLUMNS && armtol_columns(arm->links, arm->n_links, columns, n) == ARMTOL_OK);
    double means[MOST_COLUMNS] = {0};
    const bool ends = zero && !any_sign; /* may stand in place of a tolerance */
    const parameter_table table = {arm,  columns, n, any_sign ? "deviation" : zero ? "tolerance" : "weight",
                                   zero, any_sign, .means = ends ? means : NULL};
    for (size_t k = 0; k < n; k++) {
        values[k] = -1;
    }
    const bool fine = parameters_read(stream, "table.csv", &table, infinite_allowed, values);
    REQUIRE(fine ? caught_nothing() : caught_one_message());
    if (fine) {
        check_values(&table, infinite_allowed, values);
    }
    for (size_t k = 0; k < n; k++) {
        REQUIRE(isfinite(means[k]));
    }
}

/* What is taken is known, and every group has a name. */
static void check_spreads(FILE *stream, unsigned choice)
{
    const armtol_arm *arm = armtol_arm_at(choice % armtol_arm_count());
    const size_t n = armtol_column_count(arm->links, arm->n_links);
    armtol_column columns[MOST_COLUMNS];
    armtol_error_spread spreads[MOST_COLUMNS] = {{ARMTOL_UNIFORM, 0, 0, 0}};
    group_name groups[MOST_COLUMNS] = {{""}};
    REQUIRE(n <= MOST_COLUMNS && armtol_columns(arm->links, arm->n_links, columns, n) == ARMTOL_OK);
    const parameter_table table = {.arm = arm, .columns = columns, .n_columns = n, .value = "distribution"};
    const bool fine = spreads_read(stream, "spread.csv", &table, spreads, groups);
    REQUIRE(fine ? caught_nothing() : caught_one_message());
    for (size_t k = 0; k < n; k++) {
        REQUIRE(armtol_spread_is_known(&spreads[k]) && spreads[k].group <= n);
        REQUIRE(spreads[k].group == 0 || groups[spreads[k].group - 1].text[0] != '\0');
    }
}

static void check_drawn(const armtol_arm *arm, const drawing_row *row)
{
    REQUIRE(row->link < arm->n_links);
    REQUIRE(isnan(row->distance) || (row->distance >= 0 && isfinite(row->distance)));
    REQUIRE(isnan(row->angle) || (row->angle >= 0 && row->angle < 90));
    REQUIRE(isnan(row->distance) == (row->split == DRAWING_SPLIT_NONE));
}

static void check_drawing(FILE *stream, unsigned choice)
{
    const armtol_arm *arm = armtol_arm_at(choice % armtol_arm_count());
    const drawing_view view = {arm, "mm", "deg", 90};
    drawing drawing;
    const bool fine = drawing_read(stream, "drawing.csv", &view, &drawing);
    REQUIRE(fine ? caught_nothing() : caught_one_message());
    REQUIRE(drawing.n_rows <= arm->n_links);
    for (size_t i = 0; i < drawing.n_rows; i++) {
        check_drawn(arm, &drawing.rows[i]);
    }
    drawing_free(&drawing);
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    caught_start("armtol");
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size < 2) {
        return 0;
    }
    FILE *stream = caught_file(data + 2, size - 2);
    caught_forget();
    if (data[0] == 'w') {
        check_wishes(stream);
    } else if (data[0] == 'D') {
        check_drawing(stream, data[1] - '0');
    } else if (data[0] == 's') {
        check_spreads(stream, data[1]);
    } else if (data[0] % 2 == 0) {
        check_poses(stream, data[1] - '0');
    } else {
        check_parameters(stream, data[1]);
    }
    fclose(stream);
    return 0;
}
