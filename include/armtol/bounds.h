#ifndef ARMTOL_BOUNDS_H
#define ARMTOL_BOUNDS_H

#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/status.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/* Radii of the spheres that the errors of all lengths, and of all angles, have to stay in. */
typedef struct armtol_bounds {
    double distance; /* length unit */
    double angle;    /* radians */
} armtol_bounds;

/*
 * Whether six tolerances and delta are what the bounds need.
 *
 * Errors:
 *    ARMTOL_NOT_FINITE      one of the seven is not
 *    ARMTOL_BAD_TOLERANCE   a tolerance is not > 0
 *    ARMTOL_BAD_DELTA       delta is not > 0 and below the three linear tolerances
 */
armtol_status armtol_tolerances_check(const double tolerances[6], double delta);

/*
 * The norm bounds.
 *
 * Given:
 *    ordered, n_columns   A, 6 x n_columns, its length columns first
 *    n_lengths            how many these are
 *    tolerances           of (dx, dy, dz, rotations about x, y, z)
 *    delta                what is kept of the linear ones for the errors of lengths at least
 *    errata               distance-share, float
 *
 * Returned:
 *    *bounds              the two radii
 *
 * Notes:
 * 1) With e the tolerances
 *        angle    = least over rows i of (e_i - delta) / |row i, angle columns|, i = 0..2, and
 *                   e_i / |row i, angle columns|, i = 3..5
 *        distance = least over rows i = 0..2 of
 *                   (e_i - |row i, angle columns| angle) / |row i, length columns|
 *    which is delta / |row i, length columns| in the row that sets the angle bound and more elsewhere; with the erratum
 *    distance-share it is delta / |row i, length columns| in every row.
 * 2) A row without an entry in its columns bounds nothing; a bound that no row sets is infinite.
 *
 * Errors:
 *    those of armtol_tolerances_check
 *    ARMTOL_WRONG_SIZE   n_lengths > n_columns
 *    ARMTOL_NOT_FINITE   an element is not, or the norm of a row overflows
 *
 * Reference:
 *    Hahn 1987, Eqs (4.25) to (4.28) and (4.31).
 */
armtol_status armtol_norm_bounds(const double ordered[], size_t n_columns, size_t n_lengths,
                                 const double tolerances[6], double delta, const armtol_errata *errata,
                                 armtol_bounds *bounds);

ARMTOL_INTERFACE_END

#endif
