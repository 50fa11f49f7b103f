#ifndef ARMTOL_MACHINING_H
#define ARMTOL_MACHINING_H

#include "armtol/bounds.h"
#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/link.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/* What one parameter may be off. */
typedef struct armtol_shares {
    double distance; /* length unit */
    double angle;    /* radians */
} armtol_shares;

/*
 * Each parameter's share of the bounds.
 *
 * Given:
 *    bounds                the radii of the two spheres
 *    n_lengths, n_angles   the numbers of parameters
 *    errata                root-of-ratio, copied-counts, float
 *
 * Returned (function value):
 *    the shares, r / sqrt(n): they put the corner of a cube on the sphere of radius r; 0 for a count of 0
 *
 * Reference:
 *    Hahn 1987, the main programs.
 */
armtol_shares armtol_parameter_shares(const armtol_bounds *bounds, size_t n_lengths, size_t n_angles,
                                      const armtol_errata *errata);

/*
 * The tolerance of the distance between the two axes of a link, h = sqrt(a^2 + d^2), when a and d may be off.
 *
 * Given:
 *    link     placed
 *    share    what each of the two may be off by
 *    errata   signed-mach, float
 *
 * Returned (function value):
 *    rd = -h + sqrt(h^2 + 2 a share + 2 d share + 2 share^2); infinite or nan where the squares overflow
 *
 * Reference:
 *    Hahn 1987, Eq. (4.32), routine mach.
 */
double armtol_machining_distance(const armtol_link *link, double share, const armtol_errata *errata);

/*
 * The same, corrected, when a and d may be off by tolerances of their own:
 *     hypot(|a| + a_tolerance, |d| + d_tolerance) - hypot(a, d),
 * written so that small tolerances do not cancel.
 *
 * Reference:
 *    Hahn 1987, Eq. (4.32).
 */
double armtol_distance_tolerance(double a, double d, double a_tolerance, double d_tolerance);

/*
 * The tolerance of the motor of a placed link: the angle share of a revolute joint, the machining distance (given) of a
 * prismatic one, 0 of a fixed link.
 *
 * Reference:
 *    Hahn 1987, the main programs.
 */
double armtol_motor_tolerance(const armtol_link *link, double machining_distance,
                              const armtol_shares *shares);

ARMTOL_INTERFACE_END

#endif
