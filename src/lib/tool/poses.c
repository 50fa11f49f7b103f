#include "armtol/poses.h"

#include "lib/report/finite.h"
#include "lib/tool/pose_link.h"

#include <math.h>
#include <string.h>

/*
 * Method
 *    What no joint moves is worked out once; poses are then done side by side (poses_kernel.h), their bounds with one
 *    root and one division in place of one a row: each limit is a weight on the squares of its row.
 *
 * Special cases
 *    Limits that are 1e100 apart are refused: their squares would not fit. The last block repeats its last pose.
 *
 * Accuracy
 *    A has the bits of tool_matrix.c in any place of a block (test_a_pose_has_the_same_bits_in_any_block_and_alone);
 *    the bounds are those of bounds.c to rounding (test_a_pose_is_the_matrix_and_the_bounds_of_the_placed_links).
 */

/* The weight of what angles may use of a tolerance is (scale / that)^2; false where one does not fit a double. */
static bool weigh(armtol_poses *poses, const double tolerances[6], double delta)
{
    double of_angles[6];
    bool fits = true;
    for (int i = 0; i < 6; i++) {
        of_angles[i] = i < 3 ? tolerances[i] - delta : tolerances[i];
        poses->angle_scale = fmax(poses->angle_scale, of_angles[i]);
    }
    for (int i = 0; i < 6; i++) {
        const double part = poses->angle_scale / of_angles[i];
        poses->angle_weights[i] = part * part;
        fits = fits && part <= 1e100;
    }
    memcpy(poses->limits, tolerances, sizeof poses->limits);
    poses->delta = delta;
    return fits;
}

static armtol_status check(const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                           const double tolerances[6], double delta)
{
    const armtol_status status = armtol_links_check(links, n_links);
    if (status != ARMTOL_OK) {
        return status;
    }
    return all_finite(tool->offset, 3) ? armtol_tolerances_check(tolerances, delta) : ARMTOL_NOT_FINITE;
}

armtol_status armtol_poses_start(armtol_poses *poses, armtol_pose_link prepared[], const armtol_link links[],
                                 size_t n_links, const armtol_tool_point *tool, const double tolerances[6],
                                 double delta)
{
    const armtol_status status = check(links, n_links, tool, tolerances, delta);
    if (status != ARMTOL_OK) {
        return status;
    }
    armtol_poses started = {
        .links = prepared,
        .n_links = n_links,
        .n_joints = armtol_joint_count(links, n_links),
        .tool = *tool,
    };
    if (!weigh(&started, tolerances, delta)) {
        return ARMTOL_BAD_TOLERANCE;
    }
    for (size_t i = 0; i < n_links; i++) {
        prepared[i] = pose_link_of(&links[i], &started.n_columns);
    }
    *poses = started;
    return ARMTOL_OK;
}
