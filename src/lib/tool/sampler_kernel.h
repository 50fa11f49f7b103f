/* A kernel (lanes.h): the errors of the tool of some arms side by side. */

#include "lib/lanes/lane_kernel.h"
#include "lib/lanes/sincos_kernel.h"
#include "lib/lanes/frame_kernel.h"
#include "lib/tool/draw_kernel.h"
#include "lib/lanes/rotation_kernel.h"

/*
 * The errors of so many parameters of a link, each a share of its tolerance. All are drawn step by step
 * together: one alone is a long chain of operations that wait for each other. state is that of the arms'
 * first columns.
 */
LANE_INLINE void LANED(draw_some)(const armtol_sampled_link *link, size_t n, const BITS *state,
                                  REAL errors[ARMTOL_PARAMETER_COUNT])
{
    BITS bits[ARMTOL_PARAMETER_COUNT];
    REAL draws[ARMTOL_PARAMETER_COUNT];
    for (size_t k = 0; k < n; k++) {
        bits[k] = *state + link->steps[k];
    }
    LANED(uniform)(n, bits, draws);
    for (size_t k = 0; k < n; k++) {
        errors[link->drawn[k]] = draws[k] * link->tolerances[k];
    }
}

/* Those of a link, most of which have four. What is not drawn is left as it was. */
LANE_INLINE void LANED(draw_errors)(const armtol_sampled_link *link, const BITS *state,
                                    REAL errors[ARMTOL_PARAMETER_COUNT])
{
    if (link->n_drawn == 4) {
        LANED(draw_some)(link, 4, state, errors);
    } else {
        LANED(draw_some)(link, link->n_drawn, state, errors);
    }
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

/* The cosine and sine of an angle with its error. */
LANE_INLINE void LANED(angle_off)(const armtol_sampled_link *link, armtol_parameter parameter, double cosine,
                                  double sine, const REAL errors[ARMTOL_PARAMETER_COUNT], bool large,
                                  REAL *off_cosine, REAL *off_sine)
{
    if (!link->off[parameter]) {
        return;
    }
    REAL error_sine, error_cosine;
    if (large) {
        LANED(sine_cosine)(&errors[parameter], &error_sine, &error_cosine);
    } else {
        LANED(small_sine_cosine)(&errors[parameter], &error_sine, &error_cosine);
    }
    *off_cosine = error_cosine * cosine - error_sine * sine;
    *off_sine = error_cosine * sine + error_sine * cosine;
}

/* Turn two axes by it; where it has no error, by what it is meant to be. */
LANE_INLINE void LANED(turn_off)(const armtol_sampled_link *link, armtol_parameter parameter, double cosine,
                                 double sine, const REAL *off_cosine, const REAL *off_sine, TRIPLE first,
                                 TRIPLE second)
{
    if (link->off[parameter]) {
        LANED(turn)(first, second, off_cosine, off_sine);
    } else if (sine != 0 || cosine != 1) {
        LANED(turn_all)(first, second, cosine, sine);
    }
}

LANE_INLINE void LANED(length_off)(const armtol_sampled_link *link, armtol_parameter parameter, double length,
                                   const REAL errors[ARMTOL_PARAMETER_COUNT], REAL *off)
{
    const REAL zero = {0};
    *off = zero + length;
    if (link->off[parameter]) {
        *off += errors[parameter];
    }
}

LANE_INLINE void LANED(cross_link)(const armtol_sampled_link *link, const BITS *state, bool large,
                                   LANED(frame) *f)
{
    const armtol_sampled_link *const l = link;
    const REAL zero = {0};
    REAL errors[ARMTOL_PARAMETER_COUNT], cosines[3] = {zero, zero, zero}, sines[3] = {zero, zero, zero}, a, d;
    LANED(draw_errors)(l, state, errors);
    LANED(angle_off)(l, ARMTOL_THETA, l->cos_theta, l->sin_theta, errors, large, &cosines[0], &sines[0]);
    LANED(angle_off)(l, ARMTOL_ALPHA, l->cos_alpha, l->sin_alpha, errors, large, &cosines[1], &sines[1]);
    LANED(angle_off)(l, ARMTOL_BETA, l->cos_beta, l->sin_beta, errors, large, &cosines[2], &sines[2]);
    LANED(length_off)(l, ARMTOL_A, l->a, errors, &a);
    LANED(length_off)(l, ARMTOL_D, l->d, errors, &d);
    LANED(turn_off)(l, ARMTOL_THETA, l->cos_theta, l->sin_theta, &cosines[0], &sines[0], f->x, f->y);
    LANED(advance)(f, &a, &d);
    LANED(turn_off)(l, ARMTOL_ALPHA, l->cos_alpha, l->sin_alpha, &cosines[1], &sines[1], f->y, f->z);
    LANED(turn_off)(l, ARMTOL_BETA, l->cos_beta, l->sin_beta, &cosines[2], &sines[2], f->z, f->x);
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
