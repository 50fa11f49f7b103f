#ifndef ARMTOL_LIB_LANES_LANES_H
#define ARMTOL_LIB_LANES_LANES_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/*
 * Arithmetic on several poses or arms at once, a lane each. A kernel is a header that is included once for
 * each number of lanes, LANES: its REAL is a double for 1 and a vector of doubles for more. It adds,
 * multiplies, divides and takes roots, each rounded once by IEEE 754, in the same order for any number of
 * lanes: so all of them, and all machines, give the same bits. Vectors go from routine to routine by address:
 * by value they would be passed differently on machines of different width.
 */

/* The poses of a block, and the most that a machine does at once. */
enum { BLOCK = 8 };

#define LANE_PASTE_NOW(name, lanes) name##_##lanes
#define LANE_PASTE(name, lanes) LANE_PASTE_NOW(name, lanes)

/* The kernel's own of that name. */
#define LANED(name) LANE_PASTE(name, LANES)
#define REAL LANED(real)
#define BITS LANED(bits)

typedef double real_1;
typedef uint64_t bits_1;

/*
 * A point or a direction: three REALs. All that is done to each of its components alike is a loop over PARTS
 * of type PART: for one lane they can be a single vector too (quad.h).
 */
#define TRIPLE LANED(triple)
#define PART LANED(part)
#define PARTS LANED(parts)

typedef real_1 part_1, triple_1[3];
enum { parts_1 = 3 };

#ifdef __GNUC__
#define LANE_INLINE static inline __attribute__((always_inline, unused))
#define RARELY(condition) __builtin_expect((condition), 0)

#else
#define LANE_INLINE static inline
#define RARELY(condition) (condition)
#endif

/* What computes in long double (x87, 68881) has no vectors, nor may a long double be put into one. */
#if defined(__GNUC__) && (FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 1)
#define LANES_ARE_VECTORS 1
#else
#define LANES_ARE_VECTORS 0
#endif

/*
 * Of each width: whether one is less than other, all bits or none; and lanes from and to memory, aligned or
 * not. A single double is copied as such: as bytes it would take a way round through integer registers.
 */
LANE_INLINE void less_1(const real_1 *one, const real_1 *other, bits_1 *mask)
{
    *mask = 0 - (uint64_t)(*one < *other);
}

LANE_INLINE void read_1(const double *from, real_1 *value)
{
    *value = *from;
}

LANE_INLINE void write_1(const real_1 *value, double *to)
{
    *to = *value;
}

#define LANES_OF_WIDTH(n)                                                                                    \
    typedef double real_##n __attribute__((vector_size(8 * (n))));                                           \
    typedef uint64_t bits_##n __attribute__((vector_size(8 * (n))));                                         \
    typedef real_##n part_##n, triple_##n[3];                                                                \
    enum { parts_##n = 3 };                                                                                  \
    LANE_INLINE void less_##n(const real_##n *one, const real_##n *other, bits_##n *mask)                    \
    {                                                                                                        \
        *mask = (bits_##n)(*one < *other);                                                                   \
    }                                                                                                        \
    LANE_INLINE void read_##n(const double *from, real_##n *value)                                           \
    {                                                                                                        \
        memcpy(value, from, sizeof *value);                                                                  \
    }                                                                                                        \
    LANE_INLINE void write_##n(const real_##n *value, double *to)                                            \
    {                                                                                                        \
        memcpy(to, value, sizeof *value);                                                                    \
    }

#if LANES_ARE_VECTORS
LANES_OF_WIDTH(2)
LANES_OF_WIDTH(4)
LANES_OF_WIDTH(8)
#endif

/*
 * Machines of different width. A routine that is worth it is written with a last argument, lanes, that is a
 * constant wherever it is called: LANES_CALL(kernel, lanes, (...)) calls the kernel of as many lanes.
 * LANES_MACHINES(routine, (parameters), arguments...) compiles it for each width that there may be and makes
 * routine_on_machine, which calls the widest that the machine has.
 */
#if LANES_ARE_VECTORS && defined(__x86_64__)
#define LANES_HAVE_MACHINES 1

static inline int lanes_of_machine(void)
{
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) {
        return 8;
    }
    return __builtin_cpu_supports("avx2") ? 4 : 2;
}

#define LANES_CALL(kernel, lanes, arguments)                                                                 \
    ((lanes) == 8 ? kernel##_8 arguments : (lanes) == 4 ? kernel##_4 arguments : kernel##_2 arguments)

/* The same for kernels of one lane: that of quad.h where four fit into a vector. */
#define QUAD_CALL(kernel, lanes, arguments) ((lanes) >= 4 ? kernel##_quad arguments : kernel##_1 arguments)

#define LANES_MACHINES(routine, parameters, ...)                                                             \
    __attribute__((target("avx512f,avx512dq"))) static void routine##_wide parameters                        \
    {                                                                                                        \
        routine(__VA_ARGS__, 8);                                                                             \
    }                                                                                                        \
    __attribute__((target("avx2"))) static void routine##_middle parameters { routine(__VA_ARGS__, 4); }     \
    static void routine##_narrow parameters { routine(__VA_ARGS__, 2); }                                     \
    static void routine##_on_machine parameters                                                              \
    {                                                                                                        \
        const int lanes = lanes_of_machine();                                                                \
        if (lanes == 8) {                                                                                    \
            routine##_wide(__VA_ARGS__);                                                                     \
        } else if (lanes == 4) {                                                                             \
            routine##_middle(__VA_ARGS__);                                                                   \
        } else {                                                                                             \
            routine##_narrow(__VA_ARGS__);                                                                   \
        }                                                                                                    \
    }

#else
#define LANES_HAVE_MACHINES 0
#if LANES_ARE_VECTORS
#define LANES_CALL(kernel, lanes, arguments) ((void)(lanes), kernel##_2 arguments)
#else
#define LANES_CALL(kernel, lanes, arguments) ((void)(lanes), kernel##_1 arguments)
#endif
#define QUAD_CALL(kernel, lanes, arguments) ((void)(lanes), kernel##_1 arguments)
#define LANES_MACHINES(routine, parameters, ...)                                                             \
    static void routine##_on_machine parameters                                                              \
    {                                                                                                        \
        routine(__VA_ARGS__, LANES_ARE_VECTORS ? 2 : 1);                                                     \
    }
#endif

#endif
