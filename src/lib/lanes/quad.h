#ifndef ARMTOL_LIB_LANES_QUAD_H
#define ARMTOL_LIB_LANES_QUAD_H

#include "lib/lanes/lanes.h"

/*
 * A kernel's parts for one lane whose triples are a vector each: x, y, z and a place that means nothing.
 * LANES is quad, which is 1. See triple_kernel.h, whose routines these are, with the same bits.
 */
enum { quad = 1, parts_quad = 1 };

typedef double real_quad;
typedef uint64_t bits_quad;
typedef real_4 part_quad, triple_quad[1];

LANE_INLINE void less_quad(const double *one, const double *other, uint64_t *mask)
{
    less_1(one, other, mask);
}

LANE_INLINE void read_quad(const double *from, double *value)
{
    *value = *from;
}

LANE_INLINE void write_quad(const double *value, double *to)
{
    *to = *value;
}

LANE_INLINE void set_triple_quad(double x, double y, double z, triple_quad triple)
{
    triple[0] = (real_4){x, y, z, z};
}

LANE_INLINE void get_triple_quad(const triple_quad triple, double components[3])
{
    for (int i = 0; i < 3; i++) {
        components[i] = triple[0][i];
    }
}

LANE_INLINE void read_triple_quad(const double from[], size_t step, triple_quad triple)
{
    set_triple_quad(from[0], from[step], from[2 * step], triple);
}

LANE_INLINE void write_triple_quad(const triple_quad triple, double to[], size_t step)
{
    for (size_t i = 0; i < 3; i++) {
        to[i * step] = triple[0][i];
    }
}

/* A permutation, which compilers know by its look. */
LANE_INLINE void rotate_quad(const triple_quad triple, triple_quad rotated)
{
    rotated[0] = (real_4){triple[0][1], triple[0][2], triple[0][0], triple[0][3]};
}

LANE_INLINE void cross_quad(const triple_quad one, const triple_quad other, triple_quad product)
{
    triple_quad one_j, one_k, other_j, other_k;
    rotate_quad(one, one_j);
    rotate_quad(one_j, one_k);
    rotate_quad(other, other_j);
    rotate_quad(other_j, other_k);
    product[0] = one_j[0] * other_k[0] - one_k[0] * other_j[0];
}

LANE_INLINE void along_axes_quad(const triple_quad x, const triple_quad y, const triple_quad z,
                                 triple_quad direction)
{
    real_4 products[3];
    for (int i = 0; i < 3; i++) {
        products[i] = (real_4){x[0][i], y[0][i], z[0][i], z[0][i]} * direction[0][i];
    }
    direction[0] = products[0] + products[1] + products[2];
}

#endif
