#ifndef ARMTOL_LIB_TOOL_WORST_KERNEL_H
#define ARMTOL_LIB_TOOL_WORST_KERNEL_H

#include "lib/tool/kernels.h"
#include "lib/tool/negligible.h"
#include "lib/tool/poses_walk.h"

/* |A| t in many poses (lanes.h). A is summed up as it comes, and kept nowhere. */

/* What elements have to be more than: those of axes, and how far a turn about an axis moves the tool point. */
typedef struct smallest {
    real axis, about;
} smallest;

/* Of a column's three elements |a| t, each to its row. No more than `least` is 0; nan is added. */
LANE_INLINE void add_column(const triple elements, double tolerance, const real *least, triple sums)
{
    for (int i = 0; i < 3; i++) {
        real size = elements[i], sum;
        word small;
        take_size(&size);
        at_most(&size, least, &small);
        sum = sums[i] + size * tolerance;
        choose(&small, &sums[i], &sum, &sums[i]);
    }
}

/*
 * The columns of an angle and of the length along its axis in their order, on which a sum depends. linear: for the
 * upper three rows, else for the lower three, in which a length has nothing; a constant, for the compiler to leave that
 * out.
 */
LANE_INLINE void add_axis(const worst_case *worst, const matrix_view *matrix, size_t angle, size_t length,
                          const target *target, const triple way, const smallest *least, bool linear, triple sums)
{
    const double *const tolerances = worst->tolerances;
    triple axis, about;
    finish_axis(matrix, angle, target, way, axis, about);
    if (!linear) {
        add_column(axis, tolerances[angle], &least->axis, sums);
        return;
    }
    if (length < angle) {
        add_column(axis, tolerances[length], &least->axis, sums);
    }
    add_column(about, tolerances[angle], &least->about, sums);
    if (length > angle && length != NO_COLUMN) {
        add_column(axis, tolerances[length], &least->axis, sums);
    }
}

LANE_INLINE void add_links(const worst_case *worst, const matrix_view *matrix, const target *target,
                           const smallest *least, bool linear, triple sums)
{
    const armtol_pose_link *const links = worst->poses->links;
    const size_t n = worst->poses->n_links;
    triple way;
    way_before(links[0].columns, matrix, target, way);
    for (size_t i = 0; i < n; i++) {
        const size_t *const columns = links[i].columns;
        add_axis(worst, matrix, columns[ARMTOL_THETA], columns[ARMTOL_D], target, way, least, linear, sums);
        if (i + 1 < n) {
            way_before(links[i + 1].columns, matrix, target, way);
        } else {
            way_from(target->along->origin, target, way);
        }
        add_axis(worst, matrix, columns[ARMTOL_ALPHA], columns[ARMTOL_A], target, way, least, linear, sums);
        if (columns[ARMTOL_BETA] != NO_COLUMN) {
            add_axis(worst, matrix, columns[ARMTOL_BETA], NO_COLUMN, target, way, least, linear, sums);
        }
    }
}

LANE_INLINE void take_length(const triple of, real *length)
{
    *length = of[0] * of[0] + of[1] * of[1] + of[2] * of[2];
    take_root(length);
}

LANE_INLINE void worst_of_some(const worst_case *worst, const lane_poses *at, const double *reach,
                               const matrix_view *matrix, real *found)
{
    const armtol_poses *const poses = worst->poses;
    const real zero = {0};
    frame frame;
    walk_poses(poses, at, matrix, &frame);
    target target = {.turned = poses->tool.frame == ARMTOL_TOOL_FRAME, .along = &frame};
    smallest least = {.axis = zero + negligible};
    triple sums = {zero, zero, zero};
    point_of(&frame, poses->tool.offset, target.point);
    load(reach, &least.about);
    least.about = least.about * negligible;
    if (worst->row < 3) {
        add_links(worst, matrix, &target, &least, true, sums);
    } else {
        add_links(worst, matrix, &target, &least, false, sums);
    }
    if (worst->is_length) {
        take_length(sums, found);
    } else {
        *found = sums[worst->row % 3];
    }
}

LANE_INLINE void worst_blocks(const worst_case *worst, const double q[], size_t n_poses, const double reach[],
                              double memory[], double found[])
{
    const armtol_poses *const poses = worst->poses;
    for (size_t first = 0; first < n_poses; first += LANES) {
        const lane_poses at = {q + first * poses->n_joints, poses->n_joints, n_poses - 1 - first};
        const matrix_view matrix = {memory, LANES * poses->n_columns, LANES};
        double lanes[LANES];
        real some;
        worst_of_some(worst, &at, reach + first, &matrix, &some);
        unload(&some, lanes);
        memcpy(found + first, lanes, (at.last < LANES ? at.last + 1 : LANES) * sizeof lanes[0]);
    }
}

#endif
