/* A kernel (lanes.h): the errors of the tool of some arms side by side. */

#include "lane_kernel.h"
#include "sincos_kernel.h"
#include "frame_kernel.h"
#include "draw_kernel.h"
#include "rotation_kernel.h"

/* The error of one parameter: its share of the tolerance. state is that of the arms' first columns. */
LANE_INLINE void LANED(draw_error)(const armtol_sampled_link *link, armtol_parameter parameter,
                                   const BITS *state, REAL *error)
{
    const BITS own = *state + link->steps[parameter];
    LANED(uniform)(&own, error);
    *error = *error * link->tolerances[parameter];
}

/*
 * |angle| <= 1/128, z = angle^2: (sin / angle - 1) / z and (cos - 1) / z interpolated at the two Chebyshev
 * points of 0 <= z <= 1/128^2, which leaves out less than 5e-20 and 4e-17.
 */
LANE_INLINE void LANED(small_sine_cosine)(const REAL *angle, REAL *sine, REAL *cosine)
{
    const REAL z = *angle * *angle;
    *sine = *angle + *angle * z * (-0x1.5555555554855p-3 + z * 0x1.1110f70f723abp-7);
    *cosine = 1 + z * (-0x1.fffffffffd27dp-2 + z * 0x1.555527d28p-5);
}

/* Turn two axes by an angle with its error. */
LANE_INLINE void LANED(turn_off)(const armtol_sampled_link *link, armtol_parameter parameter, double cosine,
                                 double sine, const BITS *state, bool large, TRIPLE first, TRIPLE second)
{
    if (!link->off[parameter]) {
        if (sine != 0 || cosine != 1) {
            LANED(turn_all)(first, second, cosine, sine);
        }
        return;
    }
    REAL error, error_sine, error_cosine;
    LANED(draw_error)(link, parameter, state, &error);
    if (large) {
        LANED(sine_cosine)(&error, &error_sine, &error_cosine);
    } else {
        LANED(small_sine_cosine)(&error, &error_sine, &error_cosine);
    }
    const REAL off_cosine = error_cosine * cosine - error_sine * sine;
    const REAL off_sine = error_cosine * sine + error_sine * cosine;
    LANED(turn)(first, second, &off_cosine, &off_sine);
}

LANE_INLINE void LANED(length_off)(const armtol_sampled_link *link, armtol_parameter parameter, double length,
                                   const BITS *state, REAL *off)
{
    const REAL zero = {0};
    *off = zero + length;
    if (link->off[parameter]) {
        REAL error;
        LANED(draw_error)(link, parameter, state, &error);
        *off += error;
    }
}

LANE_INLINE void LANED(cross_link)(const armtol_sampled_link *link, const BITS *state, bool large,
                                   LANED(frame) *f)
{
    REAL a, d;
    LANED(turn_off)(link, ARMTOL_THETA, link->cos_theta, link->sin_theta, state, large, f->x, f->y);
    LANED(length_off)(link, ARMTOL_A, link->a, state, &a);
    LANED(length_off)(link, ARMTOL_D, link->d, state, &d);
    LANED(advance)(f, &a, &d);
    LANED(turn_off)(link, ARMTOL_ALPHA, link->cos_alpha, link->sin_alpha, state, large, f->y, f->z);
    LANED(turn_off)(link, ARMTOL_BETA, link->cos_beta, link->sin_beta, state, large, f->z, f->x);
}

/* What an error is along the base's axes that is given along the tool's. */
LANE_INLINE void LANED(along_base)(const armtol_transform *meant, REAL vector[3])
{
    REAL turned[3];
    for (int i = 0; i < 3; i++) {
        turned[i] = vector[0] * meant->m[i][0] + vector[1] * meant->m[i][1] + vector[2] * meant->m[i][2];
    }
    for (int i = 0; i < 3; i++) {
        vector[i] = turned[i];
    }
}

/* The error of the tool from its last frame, seen from where that should be. */
LANE_INLINE void LANED(error_of)(const armtol_sampler *sampler, const LANED(frame) *frame, REAL error[6])
{
    LANED(point_of)(frame, sampler->tool.offset, error);
    for (int i = 0; i < 3; i++) {
        error[i] = error[i] - sampler->tool.offset[i];
    }
    if (sampler->large_turn) {
        LANED(rotation)(frame, error + 3);
    } else {
        LANED(small_rotation)(frame, error + 3);
    }
    if (sampler->tool.frame == ARMTOL_BASE_FRAME) {
        LANED(along_base)(&sampler->meant, error);
        LANED(along_base)(&sampler->meant, error + 3);
    }
}

/* Component i of lane l goes to errors[i * BLOCK + l]. */
LANE_INLINE void LANED(arms)(const armtol_sampler *sampler, uint64_t first, bool large, double errors[])
{
    uint64_t numbers[LANES];
    for (int l = 0; l < LANES; l++) {
        numbers[l] = (first + (uint64_t)l) * sampler->n_columns + 1;
    }
    BITS state;
    memcpy(&state, numbers, sizeof state);
    state = state * SPLITMIX_STEP + sampler->key;

    LANED(frame) frame;
    LANED(put_frame)(&sampler->start, &frame);
    for (size_t i = 0; i < sampler->n_links; i++) {
        LANED(cross_link)(&sampler->links[i], &state, large, &frame);
    }
    REAL error[6];
    LANED(error_of)(sampler, &frame, error);
    for (int i = 0; i < 6; i++) {
        LANED(write)(&error[i], errors + i * BLOCK);
    }
}

LANE_INLINE void LANED(arm_block)(const armtol_sampler *sampler, uint64_t first, bool large,
                                  double errors[6 * BLOCK])
{
    for (int l = 0; l < BLOCK; l += LANES) {
        LANED(arms)(sampler, first + (uint64_t)l, large, errors + l);
    }
}
