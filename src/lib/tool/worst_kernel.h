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

/* The columns of lengths are in the linear rows alone; d of two parallel axes that slide comes before theta. */
LANE_INLINE void add_link(const size_t columns[ARMTOL_PARAMETER_COUNT], const double tolerances[],
                          const finished *link, const smallest *least, bool linear, triple sums)
{
    const size_t theta = columns[ARMTOL_THETA], d = columns[ARMTOL_D], a = columns[ARMTOL_A];
    const bool d_first = d < theta;
    if (linear && d_first) {
        add_column(link->z, tolerances[d], &least->axis, sums);
    }
    add_column(linear ? link->about_z : link->z, tolerances[theta], linear ? &least->about : &least->axis, sums);
    if (linear && !d_first && d != NO_COLUMN) {
        add_column(link->z, tolerances[d], &least->axis, sums);
    }
    if (linear && a != NO_COLUMN) {
        add_column(link->x, tolerances[a], &least->axis, sums);
    }
    add_column(linear ? link->about_x : link->x, tolerances[columns[ARMTOL_ALPHA]],
               linear ? &least->about : &least->axis, sums);
}

/* linear: the upper three rows, else the lower three. A constant, for the compiler to leave out the others. */
LANE_INLINE void add_links(const worst_case *worst, const matrix_view *matrix, const target *target,
                           const smallest *least, bool linear, triple sums)
{
    const armtol_pose_link *const links = worst->poses->links;
    const size_t n = worst->poses->n_links;
    triple before, after;
    way_before(links[0].columns, matrix, target, before);
    for (size_t i = 0; i < n; i++) {
        const size_t *const columns = links[i].columns;
        finished link;
        if (i + 1 < n) {
            way_before(links[i + 1].columns, matrix, target, after);
        } else {
            way_from(target->along->origin, target, after);
        }
        finish_link(columns, matrix, target, before, after, &link);
        add_link(columns, worst->tolerances, &link, least, linear, sums);
        if (columns[ARMTOL_BETA] != NO_COLUMN) {
            triple y, about_y;
            finish_axis(matrix, columns[ARMTOL_BETA], target, after, y, about_y);
            add_column(linear ? about_y : y, worst->tolerances[columns[ARMTOL_BETA]],
                       linear ? &least->about : &least->axis, sums);
        }
        copy_triple(after, before);
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
