#ifndef ARMTOL_LIB_LANES_ROTATION_H
#define ARMTOL_LIB_LANES_ROTATION_H

#include "lib/lanes/frame.h"
#include "lib/pi.h"

/*
 * The rotation vector (axis times angle, up to pi) of a frame's axes.
 *
 * Method
 *    Up to 1/4 a series in the square of the sine of half the angle; else by the quaternion, from the largest of its
 *    parts, and an arc tangent of our own.
 *
 * Special cases
 *    Where the axes are the base's it is 0. Next to half a turn nothing is lost.
 *
 * Accuracy
 *    2e-16 up to where the series ends (test_series_are_good_to_rounding_up_to_where_they_end), 1e-15 up to pi
 *    (test_turns_of_any_size), 2e-15 next to it (test_almost_half_turns).
 */

/* Twice the sine of the angle times the axis: what is not symmetric in the matrix of the axes. */
LANE_INLINE void twice_sine(const frame *frame, real vector[3])
{
    vector[0] = frame->y[2] - frame->z[1];
    vector[1] = frame->z[0] - frame->x[2];
    vector[2] = frame->x[1] - frame->y[0];
}

/*
 * For angles up to 1/4. The angle over its sine is the sum of (2 4 .. 2k) / (3 5 .. (2k + 1)) h^k, h the
 * square of the sine of half the angle, here at most 1/64: what is left out is less than 2e-17.
 */
LANE_INLINE void small_rotation(const frame *frame, real vector[3])
{
    static const double ratios[8] = {2.0 / 3,   4.0 / 5,   6.0 / 7,   8.0 / 9,
                                     10.0 / 11, 12.0 / 13, 14.0 / 15, 16.0 / 17};
    const real zero = {0};
    const real h = ((1 - frame->x[0]) + (1 - frame->y[1]) + (1 - frame->z[2])) * 0.25;
    real sum = zero + 1;
    for (int k = 7; k >= 0; k--) {
        sum = 1 + h * sum * ratios[k];
    }
    twice_sine(frame, vector);
    for (int i = 0; i < 3; i++) {
        vector[i] = vector[i] * 0.5 * sum;
    }
}

/*
 * (atan t / t - 1) / t^2 from z = t^2, for |t| <= tan(pi/8): interpolated at the eleven Chebyshev points of
 * 0 <= z <= (1.0001 tan(pi/8))^2, which leaves out less than 0.1 half units in the last place of atan t.
 */
LANE_INLINE void arctangent_terms(const real *z, real *sum)
{
    static const double terms[11] = {
        -0x1.5555555555555p-2, 0x1.9999999999349p-3, -0x1.2492492435f94p-3, 0x1.c71c718525179p-4,
        -0x1.745d0b24c84b9p-4, 0x1.3b1262ac559fcp-4, -0x1.10fa72be60a88p-4, 0x1.dfe5f37f19c8bp-5,
        -0x1.a097da67e4438p-5, 0x1.415dac51cd10bp-5, -0x1.3a254249c2220p-6,
    };
    const real zero = {0};
    *sum = zero + terms[10];
    for (int i = 9; i >= 0; i--) {
        *sum = terms[i] + *z * *sum;
    }
}

/* The angle of (cosine, sine), both >= 0 and of any size, over the sine. */
LANE_INLINE void angle_over_sine(const real *cosine, const real *sine, real *ratio)
{
    const double tan_eighth = 0.41421356237309504880; /* of PI */
    const real zero = {0}, low = *cosine * tan_eighth, high = *sine * tan_eighth;
    const real quarter = zero + PI / 4, half = zero + PI / 2;
    const real difference = *sine - *cosine, sum = *sine + *cosine, minus_cosine = -*cosine;
    real over = *sine, under = *cosine, offset = zero, terms;
    word middle, steep;
    less(&low, sine, &middle);
    less(cosine, &high, &steep);
    choose(&middle, &difference, &over, &over);
    choose(&middle, &sum, &under, &under);
    choose(&middle, &quarter, &offset, &offset);
    choose(&steep, &minus_cosine, &over, &over);
    choose(&steep, sine, &under, &under);
    choose(&steep, &half, &offset, &offset);

    const real t = over / under, z = t * t;
    arctangent_terms(&z, &terms);
    const real flat = (1 + z * terms) / *cosine, other = (offset + (t + t * z * terms)) / *sine;
    choose(&middle, &other, &flat, ratio);
}

/* A quaternion, of any length: cos of half the angle, then sin of it times the axis. */
typedef struct quaternion {
    real part[4];
} quaternion;

/* The one of two whose largest part is larger. */
LANE_INLINE void better_quaternion(real *largest, const real *part, quaternion *best,
                                          const quaternion *other)
{
    word mask;
    less(largest, part, &mask);
    choose(&mask, part, largest, largest);
    for (int i = 0; i < 4; i++) {
        choose(&mask, &other->part[i], &best->part[i], &best->part[i]);
    }
}

/*
 * Four ways to it, each the quaternion times four of one of its parts: the way by the largest part loses
 * nothing.
 */
LANE_INLINE void quaternion_of(const frame *f, quaternion *best)
{
    real sine[3];
    twice_sine(f, sine);
    const real xy = f->x[1] + f->y[0], yz = f->y[2] + f->z[1], zx = f->z[0] + f->x[2];
    const real parts[4] = {
        1 + f->x[0] + f->y[1] + f->z[2],
        1 + f->x[0] - f->y[1] - f->z[2],
        1 - f->x[0] + f->y[1] - f->z[2],
        1 - f->x[0] - f->y[1] + f->z[2],
    };
    const quaternion by[4] = {
        {{parts[0], sine[0], sine[1], sine[2]}},
        {{sine[0], parts[1], xy, zx}},
        {{sine[1], xy, parts[2], yz}},
        {{sine[2], zx, yz, parts[3]}},
    };
    real largest = parts[0];
    *best = by[0];
    for (int i = 1; i < 4; i++) {
        better_quaternion(&largest, &parts[i], best, &by[i]);
    }
}

/* For any angle. */
LANE_INLINE void rotation(const frame *frame, real vector[3])
{
    quaternion q;
    quaternion_of(frame, &q);
    real sine = q.part[1] * q.part[1] + q.part[2] * q.part[2] + q.part[3] * q.part[3];
    take_root(&sine);

    const real zero = {0}, opposite = -q.part[0];
    word backward;
    real cosine, ratio;
    less(&q.part[0], &zero, &backward);
    choose(&backward, &opposite, &q.part[0], &cosine);
    angle_over_sine(&cosine, &sine, &ratio);
    for (int i = 0; i < 3; i++) {
        const real forward = 2 * q.part[i + 1] * ratio, turned = -forward;
        choose(&backward, &turned, &forward, &vector[i]);
    }
}

#endif
