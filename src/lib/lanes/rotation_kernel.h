/* A kernel (lanes.h): the rotation vector (axis times angle, up to pi) of a frame's axes. */

/* Twice the sine of the angle times the axis: what is not symmetric in the matrix of the axes. */
LANE_INLINE void LANED(twice_sine)(const LANED(frame) *frame, REAL vector[3])
{
    vector[0] = frame->y[2] - frame->z[1];
    vector[1] = frame->z[0] - frame->x[2];
    vector[2] = frame->x[1] - frame->y[0];
}

/*
 * For angles up to 1/4. The angle over its sine is the sum of (2 4 .. 2k) / (3 5 .. (2k + 1)) h^k, h the
 * square of the sine of half the angle, here at most 1/64: what is left out is less than 2e-17.
 */
LANE_INLINE void LANED(small_rotation)(const LANED(frame) *frame, REAL vector[3])
{
    static const double ratios[8] = {2.0 / 3,   4.0 / 5,   6.0 / 7,   8.0 / 9,
                                     10.0 / 11, 12.0 / 13, 14.0 / 15, 16.0 / 17};
    const REAL zero = {0};
    const REAL h = ((1 - frame->x[0]) + (1 - frame->y[1]) + (1 - frame->z[2])) * 0.25;
    REAL sum = zero + 1;
    for (int k = 7; k >= 0; k--) {
        sum = 1 + h * sum * ratios[k];
    }
    LANED(twice_sine)(frame, vector);
    for (int i = 0; i < 3; i++) {
        vector[i] = vector[i] * 0.5 * sum;
    }
}

/*
 * (atan t / t - 1) / t^2 from z = t^2, for |t| <= tan(pi/8): interpolated at the eleven Chebyshev points of
 * 0 <= z <= (1.0001 tan(pi/8))^2, which leaves out less than 0.1 half units in the last place of atan t.
 */
LANE_INLINE void LANED(arctangent_terms)(const REAL *z, REAL *sum)
{
    static const double terms[11] = {
        -0x1.5555555555555p-2, 0x1.9999999999349p-3, -0x1.2492492435f94p-3, 0x1.c71c718525179p-4,
        -0x1.745d0b24c84b9p-4, 0x1.3b1262ac559fcp-4, -0x1.10fa72be60a88p-4, 0x1.dfe5f37f19c8bp-5,
        -0x1.a097da67e4438p-5, 0x1.415dac51cd10bp-5, -0x1.3a254249c2220p-6,
    };
    const REAL zero = {0};
    *sum = zero + terms[10];
    for (int i = 9; i >= 0; i--) {
        *sum = terms[i] + *z * *sum;
    }
}

/* The angle of (cosine, sine), both >= 0 and of any size, over the sine. */
LANE_INLINE void LANED(angle_over_sine)(const REAL *cosine, const REAL *sine, REAL *ratio)
{
    const double pi = 3.14159265358979323846, tan_eighth = 0.41421356237309504880; /* of pi */
    const REAL zero = {0}, low = *cosine * tan_eighth, high = *sine * tan_eighth;
    const REAL quarter = zero + pi / 4, half = zero + pi / 2;
    const REAL difference = *sine - *cosine, sum = *sine + *cosine, minus_cosine = -*cosine;
    REAL over = *sine, under = *cosine, offset = zero, terms;
    BITS middle, steep;
    LANED(less)(&low, sine, &middle);
    LANED(less)(cosine, &high, &steep);
    LANED(choose)(&middle, &difference, &over, &over);
    LANED(choose)(&middle, &sum, &under, &under);
    LANED(choose)(&middle, &quarter, &offset, &offset);
    LANED(choose)(&steep, &minus_cosine, &over, &over);
    LANED(choose)(&steep, sine, &under, &under);
    LANED(choose)(&steep, &half, &offset, &offset);

    const REAL t = over / under, z = t * t;
    LANED(arctangent_terms)(&z, &terms);
    const REAL flat = (1 + z * terms) / *cosine, other = (offset + (t + t * z * terms)) / *sine;
    LANED(choose)(&middle, &other, &flat, ratio);
}

/* A quaternion, of any length: cos of half the angle, then sin of it times the axis. */
typedef struct LANED(quaternion) {
    REAL part[4];
} LANED(quaternion);

/* The one of two whose largest part is larger. */
LANE_INLINE void LANED(better_quaternion)(REAL *largest, const REAL *part, LANED(quaternion) *best,
                                          const LANED(quaternion) *other)
{
    BITS mask;
    LANED(less)(largest, part, &mask);
    LANED(choose)(&mask, part, largest, largest);
    for (int i = 0; i < 4; i++) {
        LANED(choose)(&mask, &other->part[i], &best->part[i], &best->part[i]);
    }
}

/*
 * Four ways to it, each the quaternion times four of one of its parts: the way by the largest part loses
 * nothing.
 */
LANE_INLINE void LANED(quaternion_of)(const LANED(frame) *f, LANED(quaternion) *best)
{
    REAL sine[3];
    LANED(twice_sine)(f, sine);
    const REAL xy = f->x[1] + f->y[0], yz = f->y[2] + f->z[1], zx = f->z[0] + f->x[2];
    const REAL parts[4] = {
        1 + f->x[0] + f->y[1] + f->z[2],
        1 + f->x[0] - f->y[1] - f->z[2],
        1 - f->x[0] + f->y[1] - f->z[2],
        1 - f->x[0] - f->y[1] + f->z[2],
    };
    const LANED(quaternion) by[4] = {
        {{parts[0], sine[0], sine[1], sine[2]}},
        {{sine[0], parts[1], xy, zx}},
        {{sine[1], xy, parts[2], yz}},
        {{sine[2], zx, yz, parts[3]}},
    };
    REAL largest = parts[0];
    *best = by[0];
    for (int i = 1; i < 4; i++) {
        LANED(better_quaternion)(&largest, &parts[i], best, &by[i]);
    }
}

/* For any angle. */
LANE_INLINE void LANED(rotation)(const LANED(frame) *frame, REAL vector[3])
{
    LANED(quaternion) q;
    LANED(quaternion_of)(frame, &q);
    REAL sine = q.part[1] * q.part[1] + q.part[2] * q.part[2] + q.part[3] * q.part[3];
    LANED(take_root)(&sine);

    const REAL zero = {0}, opposite = -q.part[0];
    BITS backward;
    REAL cosine, ratio;
    LANED(less)(&q.part[0], &zero, &backward);
    LANED(choose)(&backward, &opposite, &q.part[0], &cosine);
    LANED(angle_over_sine)(&cosine, &sine, &ratio);
    for (int i = 0; i < 3; i++) {
        const REAL forward = 2 * q.part[i + 1] * ratio, turned = -forward;
        LANED(choose)(&backward, &turned, &forward, &vector[i]);
    }
}
