#ifndef ARMTOL_LIB_TOOL_POSES_KERNEL_H
#define ARMTOL_LIB_TOOL_POSES_KERNEL_H

#include "lib/tool/poses_walk.h"

/* A with its bounds in many poses (lanes.h). */

/* Of the rows of A: of its upper three over lengths and over angles, of its lower three over angles. */
typedef struct squares {
    triple lengths, moving, turning;
} squares;

/*
 * The least over rows of tolerance / root of squares is scale / root of the largest weight squares, with
 * weight (scale / tolerance)^2: one root and one division instead of one a row.
 */
LANE_INLINE void angle_bound(const armtol_poses *poses, const squares *squares, real *bound)
{
    const real zero = {0};
    real largest = zero, sum = zero;
    for (int i = 0; i < 6; i++) {
        const real square = i < 3 ? squares->moving[i] : squares->turning[i - 3];
        const real weighted = square * poses->angle_weights[i];
        make_larger(&largest, &weighted);
        sum += square;
    }
    largest += sum * 0; /* a comparison passes nan over, a sum does not */
    take_root(&largest);
    *bound = poses->angle_scale / largest;
}

/*
 * Eq. (4.31): the least over rows of what the angles within their bound leave of the row's limit, over the root of the
 * lengths' squares; as the inverse of the largest inverse, so that a row without a length needs no question. The
 * angles' bound is finite: every kind of link counts an angle.
 */
LANE_INLINE void length_bound(const armtol_poses *poses, const real lengths[3], const real angles[3],
                              const real *bound_of_angles, real *bound)
{
    const real zero = {0}, delta = zero + poses->delta;
    real largest = zero, sum = zero;
    for (int i = 0; i < 3; i++) {
        real length = lengths[i], angle = angles[i];
        take_root(&length);
        take_root(&angle);
        real left = poses->limits[i] - angle * *bound_of_angles;
        make_larger(&left, &delta); /* rounding apart it is */
        const real inverse = length / left;
        make_larger(&largest, &inverse);
        sum += inverse;
    }
    largest += sum * 0;
    *bound = 1 / largest;
}

LANE_INLINE void add_squares(const triple of, triple sums)
{
    for (int i = 0; i < 3; i++) {
        sums[i] += of[i] * of[i];
    }
}

/* An axis after the other: of more at once the compiler would have too few registers. */
LANE_INLINE void complete_axis(const matrix_view *matrix, size_t angle, size_t length, const target *target,
                               const triple way, squares *squares)
{
    triple axis, about;
    finish_axis(matrix, angle, target, way, axis, about);
    write_axis(matrix, angle, length, target, axis, about);
    add_squares(about, squares->moving);
    add_squares(axis, squares->turning);
    if (length != NO_COLUMN) {
        add_squares(axis, squares->lengths);
    }
}

LANE_INLINE void finish_links(const armtol_poses *poses, const matrix_view *matrix, const target *target,
                              squares *squares)
{
    const size_t n = poses->n_links;
    triple way;
    way_before(poses->links[0].columns, matrix, target, way);
    for (size_t i = 0; i < n; i++) {
        const size_t *const columns = poses->links[i].columns;
        complete_axis(matrix, columns[ARMTOL_THETA], columns[ARMTOL_D], target, way, squares);
        if (i + 1 < n) {
            way_before(poses->links[i + 1].columns, matrix, target, way);
        } else {
            way_from(target->along->origin, target, way);
        }
        complete_axis(matrix, columns[ARMTOL_ALPHA], columns[ARMTOL_A], target, way, squares);
        if (columns[ARMTOL_BETA] != NO_COLUMN) {
            complete_axis(matrix, columns[ARMTOL_BETA], NO_COLUMN, target, way, squares);
        }
    }
}

/* The second half: the frame has come to the end of the chain. */
LANE_INLINE void finish_poses(const armtol_poses *poses, const frame *last, const matrix_view *matrix,
                              armtol_bounds bounds[LANES])
{
    target target = {.along = last};
    squares squares;
    set_triple(0, 0, 0, squares.lengths);
    set_triple(0, 0, 0, squares.moving);
    set_triple(0, 0, 0, squares.turning);
    point_of(last, poses->tool.offset, target.point);
    if (poses->tool.frame == ARMTOL_TOOL_FRAME) {
        target.turned = true;
        finish_links(poses, matrix, &target, &squares);
    } else {
        target.turned = false;
        finish_links(poses, matrix, &target, &squares);
    }
    real angle, distance;
    angle_bound(poses, &squares, &angle);
    length_bound(poses, squares.lengths, squares.moving, &angle, &distance);
    double distances[LANES], angles[LANES];
    unload(&distance, distances);
    unload(&angle, angles);
    for (int l = 0; l < LANES; l++) {
        bounds[l] = (armtol_bounds){distances[l], angles[l]};
    }
}

LANE_INLINE void some_poses(const armtol_poses *poses, const lane_poses *at, const matrix_view *matrix,
                            armtol_bounds bounds[LANES])
{
    frame frame;
    walk_poses(poses, at, matrix, &frame);
    finish_poses(poses, &frame, matrix, bounds);
}

LANE_INLINE void pose_blocks(const armtol_poses *poses, const double q[], size_t n_poses, double blocks[],
                             armtol_bounds bounds[])
{
    for (size_t first = 0; first < n_poses; first += BLOCK) {
        armtol_bounds some[BLOCK];
        for (size_t l = 0; l < BLOCK; l += LANES) {
            const size_t here = smaller(first + l, n_poses - 1);
            const lane_poses at = {q + here * poses->n_joints, poses->n_joints, n_poses - 1 - here};
            const matrix_view matrix = {blocks + first * 6 * poses->n_columns + l, BLOCK * poses->n_columns, BLOCK};
            some_poses(poses, &at, &matrix, some + l);
        }
        memcpy(bounds + first, some, smaller(BLOCK, n_poses - first) * sizeof some[0]);
    }
}

#endif
