#ifndef ARMTOL_LIB_LANES_SINCOS_H
#define ARMTOL_LIB_LANES_SINCOS_H

#include "lib/lanes/lanes.h"

/*
 * Sine and cosine.
 *
 * Method
 *    The angle is brought to |y| <= pi/4 by multiples of pi/2, which is kept in three parts of 33, 33 and 53 bits, so
 *    that its products with up to 20 bits are exact (Cody and Waite's way); the tail is what y's rounding left. The
 *    polynomials are our own: with z = y^2, (sin y / y - 1) / z and (cos y - 1 + z/2) / z^2 interpolated at the six
 *    Chebyshev points of 0 <= z <= (1.001 pi/4)^2. They leave out less than 0.2 and 0.01 half units in the last place.
 *
 * Special cases
 *    Beyond 1e6, for infinity and for nan, libm's.
 *
 * Accuracy
 *    0.9 units in the last place up to 1e5 (test_sines_and_cosines_are_within_a_unit_in_the_last_place), 1.1 up to 1e6
 *    (test_joint_values_of_any_size).
 */

LANE_INLINE void near_sine_cosine(const real *angle, real *sine, real *cosine)
{
    const double to_integer = 0x1.8p52; /* adding it rounds to an integer, which ends up in the lowest bits */
    const real shifted = *angle * 0x1.45f306dc9c883p-1 + to_integer;
    const real n = shifted - to_integer;
    const real r = *angle - n * 0x1.921fb544p+0, second = n * 0x1.0b4611a6p-34;
    const real t = r - second;
    const real rest = n * 0x1.3198a2e037073p-69 - ((r - t) - second);
    const real y = t - rest, tail = (t - y) - rest;
    const real z = y * y, half = 0.5 * z, most = 1 - half;

    const real sine_terms = -0x1.5555555555555p-3 +
        z * (0x1.1111111110ba5p-7 + z * (-0x1.a01a019e80693p-13 + z * (0x1.71de379252004p-19 +
        z * (-0x1.ae60069e53ef1p-26 + z * 0x1.5e098556d302ep-33))));
    const real cosine_terms = 0x1.5555555555555p-5 +
        z * (-0x1.6c16c16c16960p-10 + z * (0x1.a01a019f4d0edp-16 + z * (-0x1.27e4fa15bd814p-22 +
        z * (0x1.1eeb66b683028p-29 + z * -0x1.907c0e63adbb6p-37))));
    const real s = y + (tail * most + y * z * sine_terms);
    const real c = most + ((((1 - most) - half) - y * tail) + z * z * cosine_terms);

    /* n quarter turns: odd ones swap the two, and two of the four change a sign */
    word quarters, sine_bits, cosine_bits;
    memcpy(&quarters, &shifted, sizeof quarters);
    memcpy(&sine_bits, &s, sizeof s);
    memcpy(&cosine_bits, &c, sizeof c);
    const word swapped = (sine_bits ^ cosine_bits) & (0 - (quarters & 1));
    sine_bits = sine_bits ^ swapped ^ (quarters & 2) << 62;
    cosine_bits = cosine_bits ^ swapped ^ ((quarters + 1) & 2) << 62;
    memcpy(sine, &sine_bits, sizeof s);
    memcpy(cosine, &cosine_bits, sizeof c);
}

/* Which angles are beyond what near_sine_cosine is for. */
LANE_INLINE void find_far(const real *angle, word *far)
{
    const real zero = {0}, most = zero + 1e12, square = *angle * *angle;
    less(&most, &square, far);
}

/* What is far by libm, the others stay. */
LANE_INLINE void far_sine_cosine(const real *angle, real *sine, real *cosine)
{
    double angles[LANES], sines[LANES], cosines[LANES];
    unload(angle, angles);
    unload(sine, sines);
    unload(cosine, cosines);
    for (int l = 0; l < LANES; l++) {
        if (fabs(angles[l]) > 1e6) {
            sines[l] = sin(angles[l]);
            cosines[l] = cos(angles[l]);
        }
    }
    load(sines, sine);
    load(cosines, cosine);
}

LANE_INLINE void sine_cosine(const real *angle, real *sine, real *cosine)
{
    word far;
    near_sine_cosine(angle, sine, cosine);
    find_far(angle, &far);
    if (RARELY(any(&far))) {
        far_sine_cosine(angle, sine, cosine);
    }
}

#endif
