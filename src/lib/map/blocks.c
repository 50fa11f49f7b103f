/* The worst case in blocks of poses. */

#include "armtol/error_matrix.h"
#include "armtol/poses.h"
#include "lib/arms/motion.h"
#include "lib/engine/check.h"
#include "lib/map/values.h"
#include "lib/report/finite.h"
#include "lib/report/trigonometry.h"
#include "lib/tool/kernels.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

/* So many poses at a time that what is taken from them stays in a near cache. */
enum { AT_ONCE = 8 * ARMTOL_POSE_BLOCK, ALIGNED = 64 };

typedef struct work {
    const armtol_question *question;
    armtol_poses poses;
    armtol_pose_link *links;
    worst_case worst;
    double *values; /* joint values, one for each link with a joint: those of a follower too */
    double *memory, *block;
    double reach; /* of what does not slide */
    bool plain;
} work;

static bool get_memory(work *work, size_t n_links, size_t n_columns)
{
    const size_t size = ARMTOL_POSE_BLOCK * 6 * n_columns + ALIGNED / sizeof(double);
    work->links = calloc(n_links, sizeof *work->links);
    work->values = calloc(n_links, AT_ONCE * sizeof *work->values);
    work->memory = calloc(size, sizeof *work->memory);
    if (work->links == NULL || work->values == NULL || work->memory == NULL) {
        return false;
    }
    const size_t beyond = (size_t)((uintptr_t)work->memory % ALIGNED / sizeof(double));
    work->block = work->memory + (beyond > 0 ? ALIGNED / sizeof(double) - beyond : 0);
    return true;
}

static void free_memory(work *work)
{
    free(work->links);
    free(work->values);
    free(work->memory);
}

static double fixed_reach(const armtol_question *question)
{
    const armtol_arm *arm = question->arm;
    double reach = length_of_vector(question->tool.offset);
    for (size_t i = 0; i < arm->n_links; i++) {
        reach += arm->links[i].joint == ARMTOL_PRISMATIC ? 0 : length_of(arm->links[i].a, arm->links[i].d);
    }
    return reach;
}

/* Where every joint moves by itself and none slides the poses are what is needed as they are. */
static bool is_plain(const armtol_arm *arm)
{
    bool plain = arm->motions == NULL;
    for (size_t i = 0; i < arm->n_links; i++) {
        plain = plain && arm->links[i].joint != ARMTOL_PRISMATIC;
    }
    return plain;
}

static worst_case case_of(const armtol_question *question, const armtol_map *map, const armtol_poses *poses)
{
    const size_t component = map->component;
    worst_case worst = {.poses = poses, .tolerances = question->tolerances, .row = component};
    if (component >= 6) {
        worst.is_length = true;
        worst.row = component == ARMTOL_MAP_POSITION ? 0 : 3;
    }
    return worst;
}

static armtol_status start(work *work, const armtol_question *question, const armtol_map *map)
{
    static const double any[6] = {1, 1, 1, 1, 1, 1}; /* the bounds are not looked at */
    const armtol_arm *arm = question->arm;
    *work = (struct work){.question = question};
    const size_t n_columns = armtol_column_count(arm->links, arm->n_links);
    if (!get_memory(work, arm->n_links, n_columns)) {
        return ARMTOL_NO_MEMORY;
    }
    work->reach = fixed_reach(question);
    work->plain = is_plain(arm);
    work->worst = case_of(question, map, &work->poses);
    return armtol_poses_start(&work->poses, work->links, arm->links, arm->n_links, &question->tool, any, 0.5);
}

/* The values of all links' joints in one pose, 0 where it could not be reached; and the arm's reach there. */
static bool take_pose(const work *work, const double q[], size_t n_joints, double values[], double *reach)
{
    const armtol_arm *arm = work->question->arm;
    const bool out = map_is_left_out(q, n_joints);
    size_t joint = 0;
    *reach = work->reach;
    for (size_t i = 0; i < arm->n_links; i++) {
        if (arm->links[i].joint == ARMTOL_FIXED) {
            continue;
        }
        const double value = out ? 0 : arm_motion(arm, i).sign * armtol_arm_joint_value(arm, q, i);
        values[joint++] = value;
        if (arm->links[i].joint == ARMTOL_PRISMATIC) {
            *reach += length_of(arm->links[i].a, arm->links[i].d + value);
        }
    }
    return all_finite(values, joint) && (out || all_finite(q, n_joints));
}

/*
 * The joint values of up to AT_ONCE poses, and the arm's reach in each. *bad as of do_some; NULL where that is not
 * count.
 */
static const double *take_poses(work *work, const double q[], size_t n_joints, size_t count, double reach[AT_ONCE],
                                size_t *bad)
{
    for (size_t l = 0; l < AT_ONCE; l++) {
        reach[l] = work->reach;
    }
    *bad = count;
    if (work->plain && all_finite(q, count * n_joints)) {
        return q;
    }
    for (*bad = 0; *bad < count; ++*bad) {
        if (!take_pose(work, q + *bad * n_joints, n_joints, work->values + *bad * work->poses.n_joints, &reach[*bad])) {
            return NULL;
        }
    }
    for (size_t l = count; l < AT_ONCE; l++) {
        reach[l] = reach[count - 1];
    }
    return work->values;
}

/* Up to AT_ONCE poses, from q on. *bad is the first that is not finite, or count. */
static void do_some(work *work, const double q[], size_t n_joints, size_t count, double values[], size_t *bad)
{
    double reach[AT_ONCE];
    const double *taken = take_poses(work, q, n_joints, count, reach, bad);
    if (taken == NULL) {
        return;
    }
    kernels_of_machine(ARMTOL_POSE_BLOCK)->worst(&work->worst, taken, count, reach, work->block, values);
    for (size_t pose = 0; pose < count; pose++) {
        if (map_is_left_out(q + pose * n_joints, n_joints)) {
            values[pose] = (double)NAN;
        } else if (!isfinite(values[pose])) {
            *bad = pose < *bad ? pose : *bad;
        }
    }
}

armtol_fault map_blocks(const armtol_question *question, const armtol_map *map, double values[])
{
    const size_t n_joints = armtol_arm_joint_count(question->arm), n = question->n_poses;
    work work;
    const armtol_status status = start(&work, question, map);
    armtol_fault fault = fault_of(status, status == ARMTOL_NO_MEMORY ? ARMTOL_ABOUT_NOTHING : ARMTOL_ABOUT_ARM, 0);
    for (size_t first = 0; first < n && fault.status == ARMTOL_OK; first += AT_ONCE) {
        const size_t count = n - first < AT_ONCE ? n - first : AT_ONCE;
        const double none = 0, *q = n_joints > 0 ? question->q + first * n_joints : &none;
        size_t bad;
        do_some(&work, q, n_joints, count, values + first, &bad);
        fault = fault_of(bad < count ? ARMTOL_NOT_FINITE : ARMTOL_OK, ARMTOL_ABOUT_POSE, first + bad);
    }
    free_memory(&work);
    return fault;
}
