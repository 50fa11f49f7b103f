#ifndef ARMTOL_LIB_TOOL_POSES_KERNEL_H
#define ARMTOL_LIB_TOOL_POSES_KERNEL_H

#include "lib/lanes/sincos.h"
#include "lib/tool/columns.h"

/* A with its bounds in many poses (lanes.h). */

/* joint: where the values of the link's joint stand, from q of each pose on. */
LANE_INLINE void set_joint(const armtol_pose_link *link, const double *const q[LANES], size_t joint,
                                  setting *setting)
{
    const real zero = {0};
    setting->cosine = zero + link->cos_theta;
    setting->sine = zero + link->sin_theta;
    setting->d = zero + link->d;
    if (link->joint == ARMTOL_FIXED) {
        return;
    }
    double lanes[LANES];
    for (int l = 0; l < LANES; l++) {
        lanes[l] = q[l][joint];
    }
    real value;
    load(lanes, &value);
    if (link->joint == ARMTOL_REVOLUTE) {
        value = value + link->theta;
        sine_cosine(&value, &setting->sine, &setting->cosine);
    } else {
        setting->d = setting->d + value;
    }
}

/*
 * The least over rows of tolerance / root of squares is scale / root of the largest weight squares, with
 * weight (scale / tolerance)^2: one root and one division instead of one a row.
 */
LANE_INLINE void angle_bound(const armtol_poses *poses, const real squares[6], real *bound)
{
    const real zero = {0};
    real largest = zero, sum = zero;
    for (int i = 0; i < 6; i++) {
        const real weighted = squares[i] * poses->angle_weights[i];
        make_larger(&largest, &weighted);
        sum += squares[i];
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

/* The second half: the frame has come to the end of the chain. */
LANE_INLINE void finish_poses(const armtol_poses *poses, const frame *last, const matrix_view *matrix,
                              armtol_bounds bounds[LANES])
{
    const real zero = {0};
    target target = {.along = poses->tool.frame == ARMTOL_TOOL_FRAME ? last : NULL};
    squares squares = {{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}};
    point_of(last, poses->tool.offset, target.point);
    for (size_t i = 0; i < poses->n_links; i++) {
        finish_link(poses->links[i].columns, matrix, &target, &squares);
    }
    real of_angles[6], angle, distance;
    memcpy(of_angles, squares.moving, sizeof squares.moving);
    memcpy(of_angles + 3, squares.turning, sizeof squares.turning);
    angle_bound(poses, of_angles, &angle);
    length_bound(poses, squares.lengths, squares.moving, &angle, &distance);
    double distances[LANES], angles[LANES];
    unload(&distance, distances);
    unload(&angle, angles);
    for (int l = 0; l < LANES; l++) {
        bounds[l] = (armtol_bounds){distances[l], angles[l]};
    }
}

LANE_INLINE void some_poses(const armtol_poses *poses, const double *const q[LANES], const matrix_view *matrix,
                            armtol_bounds bounds[LANES])
{
    const armtol_transform base = armtol_transform_identity();
    frame frame;
    size_t joint = 0;
    put_frame(&base, &frame);
    for (size_t i = 0; i < poses->n_links; i++) {
        const armtol_pose_link *const link = &poses->links[i];
        setting setting;
        set_joint(link, q, joint, &setting);
        walk_link(link, &setting, matrix, &frame);
        joint += link->joint != ARMTOL_FIXED;
    }
    finish_poses(poses, &frame, matrix, bounds);
}

LANE_INLINE size_t least(size_t one, size_t other)
{
    return one < other ? one : other;
}

LANE_INLINE void pose_blocks(const armtol_poses *poses, const double q[], size_t n_poses, double blocks[],
                             armtol_bounds bounds[])
{
    for (size_t first = 0; first < n_poses; first += BLOCK) {
        const double *poses_q[BLOCK];
        armtol_bounds some[BLOCK];
        for (size_t l = 0; l < BLOCK; l++) {
            poses_q[l] = q + least(first + l, n_poses - 1) * poses->n_joints;
        }
        for (int l = 0; l < BLOCK; l += LANES) {
            const matrix_view matrix = {blocks + first * 6 * poses->n_columns + l, BLOCK * poses->n_columns, BLOCK};
            some_poses(poses, poses_q + l, &matrix, some + l);
        }
        memcpy(bounds + first, some, least(BLOCK, n_poses - first) * sizeof some[0]);
    }
}

#endif
