#ifndef ARMTOL_SPHERE_H
#define ARMTOL_SPHERE_H

#include "armtol/bounds.h"
#include "armtol/error_matrix.h"
#include "armtol/interface.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * The report's own way to tolerances, for any arm and corrected: the errors of all lengths stay in one
 * sphere, those of all angles in another (bounds.h), and each parameter gets an equal share of its sphere's
 * radius (armtol_parameter_shares). Here any of the six limits may be infinite, its row free. matrix is A, 6
 * x n_columns, columns as of armtol_columns; their order does not matter.
 * Source: Hahn 1987, Eqs (4.25) to (4.31); free rows and the choice of delta are ours.
 */

/*
 * The norm bounds of all poses, as armtol_norm_bounds has them without an erratum, of the rows that are not free.
 *
 * Given:
 *    matrix, n_poses, n_columns   A of each pose, one below the other
 *    columns                      what its columns stand for
 *    limits                       six, each > 0; infinity for a row that is free
 *    delta                        between 0 and the smallest linear limit; note 2
 *
 * Returned:
 *    *bounds                      note 1
 *
 * Notes:
 * 1) A bound that no row sets is infinite: distance where no bounded linear row has a length, angle where no bounded
 *    row has an angle.
 * 2) Delta may be 0 where no bounded linear row has a length, and is not looked at where no linear row is bounded.
 *
 * Errors:
 *    ARMTOL_NOT_FINITE      a limit or delta that is nan; an element of a bounded row that is not finite, or the norm
 *                           of such a row overflows
 *    ARMTOL_BAD_TOLERANCE   a limit that is not positive
 *    ARMTOL_BAD_DELTA
 */
armtol_status armtol_sphere_bounds(const double matrix[], size_t n_poses, size_t n_columns,
                                   const armtol_column columns[], const double limits[6], double delta,
                                   armtol_bounds *bounds);

/*
 * The delta that makes the least tolerance largest.
 *
 * Given:
 *    matrix, n_poses, n_columns, columns, limits   as above
 *    lever                                         the tolerance of an angle counts as what it moves at the end of it
 *                                                  (length unit a radian; an arm's stretched length serves)
 *
 * Returned:
 *    *delta                                        one that armtol_sphere_bounds accepts
 *
 * Notes:
 * 1) A larger delta leaves the angles less and so the lengths more. Of several that serve, it is the largest.
 * 2) It is the largest number below the smallest linear limit where angles have no say: there are none, or they do not
 *    move the row of that limit and leave the lengths' tolerance the least one.
 * 3) It is 2^-52 times the smallest linear limit at the least, where a row that no length moves leaves the angles all
 *    of its limit.
 * 4) It is 0 where there is nothing to share out: no linear row is bounded, or none that is has a length.
 *
 * Errors:
 *    those of armtol_sphere_bounds, delta apart
 *    ARMTOL_NOT_FINITE   also for a lever that is not, or where delta underflows
 *    ARMTOL_BAD_WEIGHT   a lever that is not positive
 */
armtol_status armtol_sphere_delta(const double matrix[], size_t n_poses, size_t n_columns,
                                  const armtol_column columns[], const double limits[6], double lever, double *delta);

/* Every column's tolerance: its share of the bound of its class, infinite where that is. */
void armtol_sphere_tolerances(const armtol_column columns[], size_t n_columns, const armtol_bounds *bounds,
                              double tolerances[]);

ARMTOL_INTERFACE_END

#endif
