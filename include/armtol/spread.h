#ifndef ARMTOL_SPREAD_H
#define ARMTOL_SPREAD_H

#include "armtol/interface.h"

#include <stdbool.h>
#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/* How the error of a parameter is distributed within its tolerance t. */
typedef enum armtol_distribution {
    ARMTOL_UNIFORM,    /* every value alike */
    ARMTOL_NORMAL,     /* normal, t being so many standard deviations of it, and cut at t */
    ARMTOL_TRIANGULAR, /* the density falls evenly from the middle to 0 at t, as of the sum of two even errors */
    ARMTOL_ENDS,       /* t to the one side or to the other, each as often */
    ARMTOL_DISTRIBUTION_COUNT
} armtol_distribution;

/* "uniform", "normal", "triangular", "ends"; "?" for a value that is none. */
const char *armtol_distribution_name(armtol_distribution distribution);

/* What the sigmas of a normal distribution may be. */
#define ARMTOL_LEAST_SIGMAS 0.01
#define ARMTOL_MOST_SIGMAS 30.0

/* What is known of one parameter's error. A spread of zeros is an error that is uniform and by itself. */
typedef struct armtol_error_spread {
    armtol_distribution distribution;
    double sigmas; /* of ARMTOL_NORMAL: the tolerance, in standard deviations before the cut; else not read */
    double shift;  /* the mean of the error, a length or radians: it is from shift - t to shift + t */
    size_t group;  /* parameters of one group, a number from 1 on, come from one machine: each error is the same part of
                      its tolerance, with the same sign. 0: by itself */
} armtol_error_spread;

/* Whether all of it is within what is said above: a distribution that there is, and finite numbers. */
bool armtol_spread_is_known(const armtol_error_spread *spread);

/*
 * The variance of an error about its mean, for a tolerance of 1.
 *
 * Given:
 *    spread    one that is known
 *
 * Returned (function value):
 *    1/3, 1/6 or 1; of a normal error of K sigmas, with phi and Phi the density and the distribution of a standard
 *    normal one, 1/K^2 (1 - 2 K phi(K) / (2 Phi(K) - 1))
 *
 * Notes:
 * 1) It is right to 4e-16 of it, and the same to the bit on every machine with IEEE arithmetic.
 *
 * Reference:
 *    Johnson, Kotz, Balakrishnan, Continuous univariate distributions 1 (1994): the doubly truncated normal.
 */
double armtol_spread_variance(const armtol_error_spread *spread);

/* A distribution as it is drawn: what does not depend on the draw. Filled by armtol_shape_of. */
typedef struct armtol_shape {
    armtol_distribution distribution;
    double sigmas, half, tail; /* of ARMTOL_NORMAL: K, Phi(K) - 1/2, Phi(-K) */
} armtol_shape;

armtol_shape armtol_shape_of(const armtol_error_spread *spread);

/*
 * The error, about its mean and for a tolerance of 1, that a draw makes.
 *
 * Given:
 *    shape     as armtol_shape_of made it
 *    uniform   in [-1, 1], armtol_sampler_uniform's
 *
 * Returned (function value):
 *    in [-1, 1]: the quantile of (1 + uniform) / 2. For ARMTOL_ENDS -1 below 0, else 1
 *
 * Notes:
 * 1) It rises with the draw, and is odd, but for ARMTOL_ENDS at 0.
 * 2) Normal errors are right to 1e-15 of themselves, and all are the same to the bit on every machine with IEEE
 *    arithmetic: nothing of libm is called but the root and what takes a double apart.
 *
 * Reference:
 *    Wichura, Algorithm AS 241, the percentage points of the normal distribution, Applied Statistics 37 (1988).
 */
double armtol_shape_value(const armtol_shape *shape, double uniform);

ARMTOL_INTERFACE_END

#endif
