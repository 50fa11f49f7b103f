/* Many poses of one arm at once. */

#include "armtol/poses.h"
#include "armtol/tool_point.h"
#include "python/binding.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- where the tool is ---- */

armtol_status binding_forward(const armtol_arm *arm, const armtol_tool_point *tool, const double q[], size_t n_poses,
                              double frames[], size_t *failed)
{
    armtol_transform frame;
    const size_t n_joints = armtol_arm_joint_count(arm);
    armtol_link *placed = calloc(arm->n_links, sizeof *placed);
    armtol_status status = placed != NULL ? ARMTOL_OK : ARMTOL_NO_MEMORY;
    for (size_t pose = 0; pose < n_poses && status == ARMTOL_OK; pose++) {
        *failed = pose;
        status = armtol_arm_place(arm, q + pose * n_joints, n_joints, placed);
        if (status == ARMTOL_OK) {
            armtol_tool_frame(placed, arm->n_links, tool, &frame);
            memcpy(frames + 16 * pose, frame.m, sizeof frame.m);
        }
    }
    free(placed);
    return status;
}

/* ---- A ---- */

enum { CHUNK = 8 * ARMTOL_POSE_BLOCK, ALIGNED = 64 };

/* What a chunk of poses is done with. */
typedef struct work {
    armtol_poses poses;
    armtol_pose_link *prepared; /* n_links */
    double *values;             /* CHUNK x poses.n_joints: what is added to theta or d */
    void *memory;
    double *blocks; /* in `memory`: CHUNK x 6 x n_columns */
    armtol_bounds bounds[CHUNK];
} work;

static void work_free(work *work)
{
    free(work->prepared);
    free(work->values);
    free(work->memory);
}

static bool get_memory(work *work, const armtol_arm *arm)
{
    const size_t n_columns = armtol_column_count(arm->links, arm->n_links);
    work->prepared = calloc(arm->n_links, sizeof *work->prepared);
    work->values = calloc(CHUNK * armtol_joint_count(arm->links, arm->n_links) + 1, sizeof *work->values);
    if (posix_memalign(&work->memory, ALIGNED, CHUNK * 6 * n_columns * sizeof *work->blocks) != 0) {
        work->memory = NULL;
    }
    work->blocks = work->memory;
    return work->prepared != NULL && work->values != NULL && work->blocks != NULL;
}

static armtol_status work_start(work *work, const armtol_arm *arm, const armtol_tool_point *tool)
{
    static const double any[6] = {2, 2, 2, 2, 2, 2}; /* the bounds are not asked for, but tell what is not finite */
    const armtol_status status = armtol_arm_check(arm);
    if (status != ARMTOL_OK) {
        return status;
    }
    if (!get_memory(work, arm)) {
        return ARMTOL_NO_MEMORY;
    }
    return armtol_poses_start(&work->poses, work->prepared, arm->links, arm->n_links, tool, any, 1);
}

/* Joints that follow others, or count the other way, have values of their own in blocks of poses. */
static void take_values(work *work, const armtol_arm *arm, const double q[], size_t n_poses)
{
    const size_t n_joints = armtol_arm_joint_count(arm);
    double *value = work->values;
    for (size_t pose = 0; pose < n_poses; pose++, q += n_joints) {
        for (size_t i = 0; i < arm->n_links; i++) {
            if (arm->links[i].joint != ARMTOL_FIXED) {
                const double sign = arm->motions != NULL ? arm->motions[i].sign : 1;
                *value++ = sign * armtol_arm_joint_value(arm, q, i);
            }
        }
    }
}

/* Out of the blocks, where poses lie side by side. */
static void put_matrices(const work *work, size_t n_poses, double matrices[])
{
    const size_t size = 6 * work->poses.n_columns;
    for (size_t pose = 0; pose < n_poses; pose++) {
        const double *block = work->blocks + pose / ARMTOL_POSE_BLOCK * size * ARMTOL_POSE_BLOCK;
        double *to = matrices + pose * size;
        for (size_t k = 0; k < size; k++) {
            to[k] = block[k * ARMTOL_POSE_BLOCK + pose % ARMTOL_POSE_BLOCK];
        }
    }
}

/* The first pose of a chunk with a bound that is not a number: a joint value is none, or A overflows. */
static size_t first_not_finite(const work *work, size_t n_poses)
{
    size_t pose = 0;
    while (pose < n_poses && !isnan(work->bounds[pose].distance) && !isnan(work->bounds[pose].angle)) {
        pose++;
    }
    return pose;
}

static armtol_status do_chunk(work *work, const armtol_arm *arm, const double q[], size_t n_poses, double matrices[],
                              size_t *failed)
{
    take_values(work, arm, q, n_poses);
    armtol_pose_blocks(&work->poses, work->values, n_poses, work->blocks, work->bounds);
    const size_t wrong = first_not_finite(work, n_poses);
    if (wrong < n_poses) {
        *failed += wrong;
        return ARMTOL_NOT_FINITE;
    }
    put_matrices(work, n_poses, matrices);
    return ARMTOL_OK;
}

armtol_status binding_matrices(const armtol_arm *arm, const armtol_tool_point *tool, const double q[], size_t n_poses,
                               double matrices[], size_t *failed)
{
    work work = {.prepared = NULL};
    const size_t n_joints = armtol_arm_joint_count(arm);
    armtol_status status = work_start(&work, arm, tool);
    for (size_t done = 0; done < n_poses && status == ARMTOL_OK; done += CHUNK) {
        const size_t count = n_poses - done < CHUNK ? n_poses - done : CHUNK;
        *failed = done;
        status = do_chunk(&work, arm, q + done * n_joints, count, matrices + done * 6 * work.poses.n_columns, failed);
    }
    work_free(&work);
    return status;
}
