#ifndef ARMTOL_LIB_LANES_LANES_H
#define ARMTOL_LIB_LANES_LANES_H

#include "lib/lanes/vectors.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/*
 * Arithmetic on LANES poses or arms at once, a lane each. A source file says how many that is before it includes this
 * one: 1, or 2, 4 or 8 where there are vectors. A real is then a double or a vector of doubles.
 *
 * What is written with it adds, multiplies, divides and takes roots, each rounded once by IEEE 754, in the same order
 * for any number of lanes: so all of them, and all machines, give the same bits. Vectors go from routine to routine by
 * address: by value they would be passed differently on machines of different width.
 */

/* The poses of a block, and the most that a machine does at once. */
enum { BLOCK = 8 };

#ifdef __GNUC__
#define LANE_INLINE static inline __attribute__((always_inline, unused))
#define RARELY(condition) __builtin_expect((condition), 0)
#else
#define LANE_INLINE static inline
#define RARELY(condition) (condition)
#endif

#if LANES == 1
typedef double real;
typedef uint64_t word;
#else
typedef double real __attribute__((vector_size(8 * LANES)));
typedef uint64_t word __attribute__((vector_size(8 * LANES)));
#endif

/* From and to memory, aligned or not. */
LANE_INLINE void load(const double *from, real *value)
{
    memcpy(value, from, sizeof *value);
}

LANE_INLINE void unload(const real *value, double *to)
{
    memcpy(to, value, sizeof *value);
}

/* A lane each, so many places apart. Not by way of an array: a vector could be loaded only when all of it is stored. */
LANE_INLINE void gather(const double *at, size_t step, real *value)
{
#if LANES == 1
    (void)step;
    *value = at[0];
#elif LANES == 2
    *value = (real){at[0], at[step]};
#elif LANES == 4
    *value = (real){at[0], at[step], at[2 * step], at[3 * step]};
#else
    *value = (real){at[0],        at[step],     at[2 * step], at[3 * step],
                    at[4 * step], at[5 * step], at[6 * step], at[7 * step]};
#endif
}

/* Whether one is less than other: all bits or none. */
LANE_INLINE void less(const real *one, const real *other, word *mask)
{
#if LANES == 1
    *mask = 0 - (uint64_t)(*one < *other);
#else
    *mask = (word)(*one < *other);
#endif
}

/* Whether one is no more than other; not where one of them is nan. */
LANE_INLINE void at_most(const real *one, const real *other, word *mask)
{
#if LANES == 1
    *mask = 0 - (uint64_t)(*one <= *other);
#else
    *mask = (word)(*one <= *other);
#endif
}

/* Whether a mask is set in any lane. */
LANE_INLINE bool any(const word *mask)
{
    uint64_t lanes[LANES], set = 0;
    memcpy(lanes, mask, sizeof lanes);
    for (int l = 0; l < LANES; l++) {
        set |= lanes[l];
    }
    return set != 0;
}

LANE_INLINE void choose(const word *mask, const real *where_set, const real *elsewhere, real *chosen)
{
    word one, other;
    memcpy(&one, where_set, sizeof one);
    memcpy(&other, elsewhere, sizeof other);
    one = other ^ ((one ^ other) & *mask);
    memcpy(chosen, &one, sizeof one);
}

LANE_INLINE void make_larger(real *value, const real *other)
{
    word mask;
    less(value, other, &mask);
    choose(&mask, other, value, value);
}

LANE_INLINE void take_size(real *value)
{
    word bits;
    memcpy(&bits, value, sizeof bits);
    bits = bits & 0x7fffffffffffffffu;
    memcpy(value, &bits, sizeof bits);
}

LANE_INLINE void take_root(real *value)
{
    double lanes[LANES];
    unload(value, lanes);
    for (int l = 0; l < LANES; l++) {
        lanes[l] = sqrt(lanes[l]);
    }
    load(lanes, value);
}

#endif
