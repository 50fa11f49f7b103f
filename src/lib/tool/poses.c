#include "armtol/poses.h"

#include "lib/report/finite.h"
#include "lib/tool/pose_link.h"

#include <math.h>
#include <string.h>

/* weights[i] = (scale / tolerances[i])^2; false where one does not fit a double. */
static bool weigh(const double tolerances[], size_t n, double *scale, double weights[])
{
    *scale = 0;
    for (size_t i = 0; i < n; i++) {
        *scale = fmax(*scale, tolerances[i]);
    }
    bool fits = true;
    for (size_t i = 0; i < n; i++) {
        const double part = *scale / tolerances[i];
        weights[i] = part * part;
        fits = fits && part <= 1e100;
    }
    return fits;
}

static bool weigh_all(armtol_poses *poses, const double tolerances[6], double delta)
{
    double of_angles[6];
    for (int i = 0; i < 6; i++) {
        of_angles[i] = i < 3 ? tolerances[i] - delta : tolerances[i];
    }
    memcpy(poses->limits, tolerances, sizeof poses->limits);
    poses->delta = delta;
    return weigh(of_angles, 6, &poses->angle_scale, poses->angle_weights);
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
    if (!weigh_all(&started, tolerances, delta)) {
        return ARMTOL_BAD_TOLERANCE;
    }
    for (size_t i = 0; i < n_links; i++) {
        prepared[i] = pose_link_of(&links[i], &started.n_columns);
    }
    *poses = started;
    return ARMTOL_OK;
}
