/* A kernel (lanes.h): some poses of a block side by side. */

#include "lib/lanes/lane_kernel.h"
#include "lib/lanes/sincos_kernel.h"
#include "lib/lanes/frame_kernel.h"
#include "lib/lanes/matrix_kernel.h"

/* joint: where the values of the link's joint stand, from q of each pose on. */
LANE_INLINE void LANED(set_joint)(const armtol_pose_link *link, const double *const q[LANES], size_t joint,
                                  LANED(setting) *setting)
{
    const REAL zero = {0};
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
    REAL value;
    LANED(read)(lanes, &value);
    if (link->joint == ARMTOL_REVOLUTE) {
        value = value + link->theta;
        LANED(sine_cosine)(&value, &setting->sine, &setting->cosine);
    } else {
        setting->d = setting->d + value;
    }
}

/*
 * The least over rows of tolerance / root of squares is scale / root of the largest weight squares, with
 * weight (scale / tolerance)^2: one root and one division instead of one a row.
 */
LANE_INLINE void LANED(least_bound)(const REAL squares[], size_t n_rows, const double weights[], double scale,
                                    double bounds[LANES])
{
    const REAL zero = {0};
    REAL largest = zero, sum = zero;
    for (size_t i = 0; i < n_rows; i++) {
        const REAL weighted = squares[i] * weights[i];
        LANED(make_larger)(&largest, &weighted);
        sum += squares[i];
    }
    largest += sum * 0; /* a comparison passes nan over, a sum does not */
    LANED(take_root)(&largest);
    const REAL radius = scale / largest;
    LANED(write)(&radius, bounds);
}

LANE_INLINE void LANED(finish_links)(const armtol_poses *poses, const matrix_view *matrix,
                                     const LANED(target) *target, armtol_bounds bounds[LANES])
{
    double distances[LANES], angles[LANES];
    LANED(squares) squares;
    LANED(clear_squares)(&squares);
    for (size_t i = 0; i < poses->n_links; i++) {
        LANED(finish_link)(poses->links[i].columns, matrix, target, &squares);
    }
    REAL of_lengths[3], of_angles[6];
    LANED(get_triple)(squares.lengths, of_lengths);
    LANED(get_triple)(squares.moving, of_angles);
    LANED(get_triple)(squares.turning, of_angles + 3);
    LANED(least_bound)(of_lengths, 3, poses->length_weights, poses->length_scale, distances);
    LANED(least_bound)(of_angles, 6, poses->angle_weights, poses->angle_scale, angles);
    for (int l = 0; l < LANES; l++) {
        bounds[l] = (armtol_bounds){distances[l], angles[l]};
    }
}

/*
 * The second half: the frame has come to the end of the chain. Errors are counted along the axes of `along`,
 * NULL for the base's.
 */
LANE_INLINE void LANED(finish)(const armtol_poses *poses, const LANED(frame) *last,
                               const LANED(frame) *along, const matrix_view *matrix,
                               armtol_bounds bounds[LANES])
{
    LANED(target) target = {.along = along};
    LANED(point_of)(last, poses->tool.offset, target.point);
    LANED(finish_links)(poses, matrix, &target, bounds);
}

LANE_INLINE void LANED(poses)(const armtol_poses *poses, const double *const q[LANES],
                              const matrix_view *matrix, armtol_bounds bounds[LANES])
{
    LANED(frame) frame;
    size_t joint = 0;
    LANED(put_frame)(&base, &frame);
    for (size_t i = 0; i < poses->n_links; i++) {
        const armtol_pose_link *const link = &poses->links[i];
        LANED(setting) setting;
        LANED(set_joint)(link, q, joint, &setting);
        LANED(walk_link)(link, &setting, matrix, &frame);
        joint += link->joint != ARMTOL_FIXED;
    }
    LANED(finish)(poses, &frame, poses->tool.frame == ARMTOL_TOOL_FRAME ? &frame : NULL, matrix, bounds);
}

/* A block, its poses from the first to the last of it. */
LANE_INLINE void LANED(block)(const armtol_poses *poses, const double *const q[BLOCK], double block[],
                              armtol_bounds bounds[BLOCK])
{
    for (int first = 0; first < BLOCK; first += LANES) {
        const matrix_view matrix = {block + first, BLOCK * poses->n_columns, BLOCK};
        LANED(poses)(poses, q + first, &matrix, bounds + first);
    }
}
