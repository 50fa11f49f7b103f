#ifndef ARMTOL_LIB_TOOL_SAMPLER_KERNEL_H
#define ARMTOL_LIB_TOOL_SAMPLER_KERNEL_H

#include "armtol/sampler.h"
#include "lib/lanes/rotation.h"
#include "lib/lanes/sincos.h"
#include "lib/spread/splitmix.h"
#include "lib/tool/disc_draw.h"

/* The errors of the tool of many arms (lanes.h). */

/*
 * A draw, uniform in [-1, 1), from what splitmix64 has mixed: the upper 53 bits, over 2^52, less 1; exactly, and
 * without a conversion, which not every machine has for vectors: as the lowest bits of 1 and of 2^32 their lower 32
 * count 2^-52 each, the upper 21 2^-20.
 */
LANE_INLINE void unit(const word *mixed, real *draw)
{
    const word bits = *mixed >> 11;
    const word lower_bits = (bits & 0xffffffffu) | 0x3ff0000000000000u;
    const word upper_bits = (bits >> 32) | 0x41f0000000000000u;
    real lower, upper;
    memcpy(&lower, &lower_bits, sizeof lower);
    memcpy(&upper, &upper_bits, sizeof upper);
    *draw = (upper - (0x1p32 + 2)) + lower;
}

/*
 * The errors of so many parameters of a link, each a share of its tolerance. All are drawn step by step
 * together: one alone is a long chain of operations that wait for each other. state is that of the arms'
 * first columns.
 */
LANE_INLINE void draw_some(const armtol_sampled_link *link, size_t n, const word *state,
                                  real errors[ARMTOL_PARAMETER_COUNT])
{
    word bits[ARMTOL_PARAMETER_COUNT];
    for (size_t k = 0; k < n; k++) {
        bits[k] = *state + link->steps[k];
        bits[k] = SPLITMIX_FIRST(bits[k]);
    }
    for (size_t k = 0; k < n; k++) {
        bits[k] = SPLITMIX_SECOND(bits[k]);
    }
    for (size_t k = 0; k < n; k++) {
        real share;
        bits[k] = SPLITMIX_LAST(bits[k]);
        unit(&bits[k], &share);
        errors[link->drawn[k]] = share * link->tolerances[k];
    }
}

/* The same for any distribution, lane by lane. */
LANE_INLINE void draw_shaped(const armtol_sampled_link *link, const word *state, real errors[ARMTOL_PARAMETER_COUNT])
{
    for (size_t k = 0; k < link->n_drawn; k++) {
        double shares[LANES];
        word bits = *state + link->steps[k];
        real share;
        bits = SPLITMIX_FIRST(bits);
        bits = SPLITMIX_SECOND(bits);
        bits = SPLITMIX_LAST(bits);
        unit(&bits, &share);
        unload(&share, shares);
        for (int l = 0; l < LANES; l++) {
            shares[l] = armtol_shape_value(&link->shapes[k], shares[l]);
        }
        load(shares, &share);
        errors[link->drawn[k]] = share * link->tolerances[k];
    }
}

/* Those of a link, most of which have four. What is not drawn is left as it was. */
LANE_INLINE void draw_errors(const armtol_sampled_link *link, const word *state, bool shaped,
                                    real errors[ARMTOL_PARAMETER_COUNT])
{
    if (shaped) {
        draw_shaped(link, state, errors);
    } else if (link->n_drawn == 4) {
        draw_some(link, 4, state, errors);
    } else {
        draw_some(link, link->n_drawn, state, errors);
    }
    draw_in_disc(link, errors);
}

/*
 * |angle| <= 1/128, z = angle^2: (sin / angle - 1) / z and (cos - 1) / z interpolated at the two Chebyshev
 * points of 0 <= z <= 1/128^2, which leaves out less than 5e-20 and 4e-17.
 */
LANE_INLINE void small_sine_cosine(const real *angle, real *sine, real *cosine)
{
    const real z = *angle * *angle;
    *sine = *angle + *angle * z * (-0x1.5555555554855p-3 + z * 0x1.1110f70f723abp-7);
    *cosine = 1 + z * (-0x1.fffffffffd27dp-2 + z * 0x1.555527d28p-5);
}

/* The cosine and sine of an angle with its error. */
LANE_INLINE void angle_off(const armtol_sampled_link *link, armtol_parameter parameter, double cosine,
                                  double sine, const real errors[ARMTOL_PARAMETER_COUNT], bool large,
                                  real *off_cosine, real *off_sine)
{
    if (!link->off[parameter]) {
        return;
    }
    real error_sine, error_cosine;
    if (large) {
        sine_cosine(&errors[parameter], &error_sine, &error_cosine);
    } else {
        small_sine_cosine(&errors[parameter], &error_sine, &error_cosine);
    }
    *off_cosine = error_cosine * cosine - error_sine * sine;
    *off_sine = error_cosine * sine + error_sine * cosine;
}

/* Turn two axes by it; where it has no error, by what it is meant to be. */
LANE_INLINE void turn_off(const armtol_sampled_link *link, armtol_parameter parameter, double cosine,
                                 double sine, const real *off_cosine, const real *off_sine, triple first,
                                 triple second)
{
    if (link->off[parameter]) {
        turn(first, second, off_cosine, off_sine);
    } else if (sine != 0 || cosine != 1) {
        turn_all(first, second, cosine, sine);
    }
}

LANE_INLINE void length_off(const armtol_sampled_link *link, armtol_parameter parameter, double length,
                                   const real errors[ARMTOL_PARAMETER_COUNT], real *off)
{
    const real zero = {0};
    *off = zero + length;
    if (link->off[parameter]) {
        *off += errors[parameter];
    }
}

LANE_INLINE void cross_link(const armtol_sampled_link *link, const word *state, bool large, bool shaped,
                                   frame *f)
{
    const armtol_sampled_link *const l = link;
    const real zero = {0};
    real errors[ARMTOL_PARAMETER_COUNT], cosines[3] = {zero, zero, zero}, sines[3] = {zero, zero, zero}, a, d;
    draw_errors(l, state, shaped, errors);
    angle_off(l, ARMTOL_THETA, l->cos_theta, l->sin_theta, errors, large, &cosines[0], &sines[0]);
    angle_off(l, ARMTOL_ALPHA, l->cos_alpha, l->sin_alpha, errors, large, &cosines[1], &sines[1]);
    angle_off(l, ARMTOL_BETA, l->cos_beta, l->sin_beta, errors, large, &cosines[2], &sines[2]);
    length_off(l, ARMTOL_A, l->a, errors, &a);
    length_off(l, ARMTOL_D, l->d, errors, &d);
    turn_off(l, ARMTOL_THETA, l->cos_theta, l->sin_theta, &cosines[0], &sines[0], f->x, f->y);
    advance(f, &a, &d);
    turn_off(l, ARMTOL_ALPHA, l->cos_alpha, l->sin_alpha, &cosines[1], &sines[1], f->y, f->z);
    turn_off(l, ARMTOL_BETA, l->cos_beta, l->sin_beta, &cosines[2], &sines[2], f->z, f->x);
}

/* What an error is along the base's axes that is given along the tool's. */
LANE_INLINE void along_base(const armtol_transform *meant, real vector[3])
{
    real turned[3];
    for (int i = 0; i < 3; i++) {
        turned[i] = vector[0] * meant->m[i][0] + vector[1] * meant->m[i][1] + vector[2] * meant->m[i][2];
    }
    for (int i = 0; i < 3; i++) {
        vector[i] = turned[i];
    }
}

/* The error of the tool from its last frame, seen from where that should be. */
LANE_INLINE void error_of(const armtol_sampler *sampler, const frame *frame, real error[6])
{
    point_of(frame, sampler->tool.offset, error);
    for (int i = 0; i < 3; i++) {
        error[i] = error[i] - sampler->tool.offset[i];
    }
    if (sampler->large_turn) {
        rotation(frame, error + 3);
    } else {
        small_rotation(frame, error + 3);
    }
    if (sampler->tool.frame == ARMTOL_BASE_FRAME) {
        along_base(&sampler->meant, error);
        along_base(&sampler->meant, error + 3);
    }
}

/* Component i of lane l goes to errors[i * BLOCK + l]. */
LANE_INLINE void some_arms(const armtol_sampler *sampler, uint64_t first, bool large, bool shaped, double errors[])
{
    uint64_t numbers[LANES];
    for (int l = 0; l < LANES; l++) {
        numbers[l] = (first + (uint64_t)l) * sampler->n_columns + 1;
    }
    word state;
    memcpy(&state, numbers, sizeof state);
    state = state * SPLITMIX_STEP + sampler->key;

    frame frame;
    put_frame(&sampler->start, &frame);
    for (size_t i = 0; i < sampler->n_links; i++) {
        cross_link(&sampler->links[i], &state, large, shaped, &frame);
    }
    real error[6];
    error_of(sampler, &frame, error);
    for (int i = 0; i < 6; i++) {
        unload(&error[i], errors + i * BLOCK);
    }
}

/*
 * Every arm is drawn in a whole block of lanes, and so by the same arithmetic whatever is asked for with it.
 */
LANE_INLINE void draw_blocks(const armtol_sampler *sampler, uint64_t first, size_t count, bool large, bool shaped,
                             double errors[])
{
    for (size_t done = 0; done < count; done += BLOCK) {
        const size_t some = count - done < BLOCK ? count - done : BLOCK;
        double block[6 * BLOCK];
        for (size_t l = 0; l < BLOCK; l += LANES) {
            some_arms(sampler, first + done + l, large, shaped, block + l);
        }
        for (size_t i = 0; i < 6; i++) {
            memcpy(errors + i * count + done, block + i * BLOCK, some * sizeof block[0]);
        }
    }
}

/*
 * Compiled once for each way to sines, and for other than uniform draws, which have the sines of large errors:
 * registers are not to be kept free for one that is not taken.
 */
LANE_INLINE void draw(const armtol_sampler *sampler, uint64_t first, size_t count, double errors[])
{
    if (sampler->shaped) {
        draw_blocks(sampler, first, count, true, true, errors);
    } else if (sampler->large_errors) {
        draw_blocks(sampler, first, count, true, false, errors);
    } else {
        draw_blocks(sampler, first, count, false, false, errors);
    }
}

#endif
