#ifndef ARMTOL_LIB_LANES_FRAME_H
#define ARMTOL_LIB_LANES_FRAME_H

#include "armtol/transform.h"
#include "lib/lanes/lanes.h"

/* A point or a direction, and what is not done to each of its components alike. */
typedef real triple[3];

LANE_INLINE void set_triple(double x, double y, double z, triple triple)
{
    const real zero = {0};
    triple[0] = zero + x;
    triple[1] = zero + y;
    triple[2] = zero + z;
}

LANE_INLINE void cross(const triple one, const triple other, triple product)
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        product[i] = one[j] * other[k] - one[k] * other[j];
    }
}

/* A frame that is carried along a chain: its axes and its origin. */
typedef struct frame {
    triple x, y, z, origin;
} frame;

/* At that place, in every lane. */
LANE_INLINE void put_frame(const armtol_transform *place, frame *frame)
{
    const double(*m)[4] = place->m;
    set_triple(m[0][0], m[1][0], m[2][0], frame->x);
    set_triple(m[0][1], m[1][1], m[2][1], frame->y);
    set_triple(m[0][2], m[1][2], m[2][2], frame->z);
    set_triple(m[0][3], m[1][3], m[2][3], frame->origin);
}

/* Turn two of its axes, from the first to the second: x and y about z, y and z about x, z and x about y. */
LANE_INLINE void turn(triple first, triple second, const real *cosine, const real *sine)
{
    for (int i = 0; i < 3; i++) {
        const real turned = first[i] * *cosine + second[i] * *sine;
        second[i] = second[i] * *cosine - first[i] * *sine;
        first[i] = turned;
    }
}

/* By an angle that all lanes share. */
LANE_INLINE void turn_all(triple first, triple second, double cosine, double sine)
{
    const real zero = {0};
    const real c = zero + cosine, s = zero + sine;
    turn(first, second, &c, &s);
}

LANE_INLINE void advance(frame *frame, const real *a, const real *d)
{
    for (int i = 0; i < 3; i++) {
        frame->origin[i] += frame->x[i] * *a + frame->z[i] * *d;
    }
}

/* A point that is fixed in the frame. */
LANE_INLINE void point_of(const frame *frame, const double offset[3], triple point)
{
    for (int i = 0; i < 3; i++) {
        point[i] = frame->origin[i] +
                   (frame->x[i] * offset[0] + frame->y[i] * offset[1] + frame->z[i] * offset[2]);
    }
}

/* What the components of a direction are along the frame's axes; in place. */
LANE_INLINE void count_along(const frame *frame, triple direction)
{
    const real *const x = frame->x, *const y = frame->y, *const z = frame->z;
    const real along_x = x[0] * direction[0] + x[1] * direction[1] + x[2] * direction[2];
    const real along_y = y[0] * direction[0] + y[1] * direction[1] + y[2] * direction[2];
    const real along_z = z[0] * direction[0] + z[1] * direction[1] + z[2] * direction[2];
    direction[0] = along_x;
    direction[1] = along_y;
    direction[2] = along_z;
}

#endif
