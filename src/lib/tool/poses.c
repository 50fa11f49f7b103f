#include "armtol/poses.h"

#include "armtol/error_matrix.h"
#include "lib/report/finite.h"
#include "lib/lanes/lanes.h"
#include "lib/tool/matrix_view.h"
#include "lib/tool/pose_link.h"

static const armtol_transform base = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

#define LANES 1
#include "lib/lanes/triple_kernel.h"
#include "lib/tool/poses_kernel.h"
#undef LANES
#if LANES_ARE_VECTORS
#define LANES 2
#include "lib/lanes/triple_kernel.h"
#include "lib/tool/poses_kernel.h"
#undef LANES
#endif
#if LANES_HAVE_MACHINES
#define LANES 4
#include "lib/lanes/triple_kernel.h"
#include "lib/tool/poses_kernel.h"
#undef LANES
#define LANES 8
#include "lib/lanes/triple_kernel.h"
#include "lib/tool/poses_kernel.h"
#undef LANES
#include "lib/lanes/quad.h"
#define LANES quad
#include "lib/tool/poses_kernel.h"
#undef LANES
#endif

/* ---- one pose ---- */

LANE_INLINE void sines_of(const armtol_pose_link links[], size_t n_links, const double q[],
                          double sines[BLOCK], double cosines[BLOCK], int lanes)
{
    double angles[BLOCK] = {0};
    for (size_t i = 0; i < n_links && i < BLOCK; i++) {
        angles[i] = links[i].joint == ARMTOL_REVOLUTE ? *q + links[i].theta : links[i].theta;
        q += links[i].joint != ARMTOL_FIXED;
    }
    LANES_CALL(sines_cosines, lanes, (angles, sines, cosines));
}

#define LANES 1
#include "lib/tool/one_pose_kernel.h"
#undef LANES
#if LANES_HAVE_MACHINES
#define LANES quad
#include "lib/tool/one_pose_kernel.h"
#undef LANES
#endif

LANE_INLINE void one_pose(const armtol_poses *poses, const double q[], double matrix[], armtol_bounds *bounds,
                          int lanes)
{
    QUAD_CALL(one_pose, lanes, (poses, q, matrix, bounds, lanes));
}

/* ---- many ---- */

static inline size_t least(size_t one, size_t other)
{
    return one < other ? one : other;
}

LANE_INLINE void all_blocks(const armtol_poses *poses, const double q[], size_t n_poses, double blocks[],
                            armtol_bounds bounds[], int lanes)
{
    for (size_t first = 0; first < n_poses; first += BLOCK) {
        const double *poses_q[BLOCK];
        armtol_bounds some[BLOCK];
        for (size_t l = 0; l < BLOCK; l++) {
            poses_q[l] = q + least(first + l, n_poses - 1) * poses->n_joints;
        }
        LANES_CALL(block, lanes, (poses, poses_q, blocks + first * 6 * poses->n_columns, some));
        memcpy(bounds + first, some, least(BLOCK, n_poses - first) * sizeof some[0]);
    }
}

LANES_MACHINES(one_pose, (const armtol_poses *poses, const double q[], double matrix[],
                          armtol_bounds *bounds), poses, q, matrix, bounds)

LANES_MACHINES(all_blocks,
               (const armtol_poses *poses, const double q[], size_t n_poses, double blocks[],
                armtol_bounds bounds[]), poses, q, n_poses, blocks, bounds)

void armtol_pose(const armtol_poses *poses, const double q[], double matrix[], armtol_bounds *bounds)
{
    one_pose_on_machine(poses, q, matrix, bounds);
}

void armtol_pose_blocks(const armtol_poses *poses, const double q[], size_t n_poses, double blocks[],
                        armtol_bounds bounds[])
{
    all_blocks_on_machine(poses, q, n_poses, blocks, bounds);
}

/* ---- what is prepared ---- */

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
    const double of_lengths[3] = {delta, delta, delta};
    double of_angles[6];
    for (int i = 0; i < 6; i++) {
        of_angles[i] = i < 3 ? tolerances[i] - delta : tolerances[i];
    }
    return weigh(of_lengths, 3, &poses->length_scale, poses->length_weights) &&
           weigh(of_angles, 6, &poses->angle_scale, poses->angle_weights);
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
    for (size_t done = 0; done < n_links;) {
        done += pose_links_of(links + done, n_links - done, &started.n_columns, prepared + done);
    }
    *poses = started;
    return ARMTOL_OK;
}
