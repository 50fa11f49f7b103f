#ifndef ARMTOL_NORM_H
#define ARMTOL_NORM_H

#include "armtol/interface.h"

#include <stdbool.h>
#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * Accuracy as people mean it: the tool within a ball or on a disc, the length of the error in some of its components.
 * An error keeps to a norm when u'e <= limit for every unit vector u of those components.
 */
typedef struct armtol_norm {
    unsigned components; /* bit i for component i of dx to wz: two or three of the first three, or of the last three */
    double limit;        /* > 0; infinity: the norm is told and asks for nothing */
} armtol_norm;

enum { ARMTOL_MOST_NORMS = 8 }; /* as many as there are to choose components */

/* "r" of dx, dy and dz, "xy", "xz", "yz" of two of them; "w", "wxy", "wxz", "wyz" of rotations; "?" for any others. */
const char *armtol_norm_name(unsigned components);

/* The components of that name; 0 where it is none. */
unsigned armtol_norm_of_name(const char *name);

/* Whether components are a norm's. */
bool armtol_norm_is_known(unsigned components);

/* Whether they are lengths, else rotations. */
bool armtol_norm_is_length(unsigned components);

/* Of all six components of an error; also of some remainders of them, by how much the norm can be off. */
double armtol_norm_of(const double error[6], unsigned components);

/* direction' matrix, one value a column: what parameter errors do along a direction. matrix is A, 6 x n_columns. */
void armtol_norm_row(const double matrix[], size_t n_columns, const double direction[6], double row[]);

/* The number of doubles that armtol_worst_norm needs to work in: 6 a column, and 6. */
size_t armtol_norm_workspace(size_t n_columns);

/*
 * The largest norm that errors get to first order.
 *
 * Given:
 *    matrix, n_columns   A, 6 x n_columns
 *    components          of the norm (armtol_norm_is_known)
 *    shifts              what the parameters are off by before any tolerance, one a column; NULL: nothing
 *    tolerances          one value >= 0 a column; infinity for what has no bound
 *
 * Returned:
 *    direction           the unit vector u along which it is so large, 0 in components of no concern: the error is
 *                        u'A shifts + sum over k of |(u'A)_k| tolerances[k] there, either sign of u; all 0 where
 *                        nothing moves
 *    workspace           armtol_norm_workspace places, for the work
 *
 * Returns the norm; infinity, direction all 0, where a column without a bound is not 0 in some component.
 *
 * Notes:
 * 1) The errors A (shifts + e), |e_k| <= tolerances[k], are a zonotope about A shifts, and the largest norm is that of
 *    its farthest vertex. All vertices are looked at, with two components by turning a line once and with three by
 *    turning a plane once about each column: O(n log n) and O(n^2 log n). farthest_vertex.c proves that none is missed
 *    that rounding does not hide.
 * 2) The norm that is returned is one of a vertex, so it is reached; it is less than the largest by rounding at most.
 *
 * Reference:
 *    not in the report, which bounds components; ours.
 */
double armtol_worst_norm(const double matrix[], size_t n_columns, unsigned components, const double shifts[],
                         const double tolerances[], double direction[6], double workspace[]);

/*
 * The same by standard deviations: the largest, over unit vectors u, of
 *     |u'A shifts| + factor sqrt(sum over k of ((u'A)_k tolerances[k])^2).
 * With no shifts and factor 1 / sqrt 3 it is the largest standard deviation of any direction, the root of the largest
 * eigenvalue of the covariance, errors being even within their tolerances; with K / sqrt 3 it is what K standard
 * deviations come to in the worst direction. Two or three components of a normal error are within such a ball less
 * often than one is within K standard deviations: 98.9 % and 97.1 % for K = 3 and the same deviation in each direction,
 * for 99.7 % of one.
 *
 * Given, returned, errors: as of armtol_worst_norm, but for
 *    factor              >= 0 and finite
 */
double armtol_rss_norm(const double matrix[], size_t n_columns, unsigned components, const double shifts[],
                       const double tolerances[], double factor, double direction[6]);

ARMTOL_INTERFACE_END

#endif
