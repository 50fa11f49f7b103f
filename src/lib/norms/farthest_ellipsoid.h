#ifndef ARMTOL_LIB_NORMS_FARTHEST_ELLIPSOID_H
#define ARMTOL_LIB_NORMS_FARTHEST_ELLIPSOID_H

#include "lib/private_names.h"

/*
 * The point farthest from the origin of the ellipsoid about `center` whose support along a unit vector u is the root of
 * u' squares u: symmetric, no eigenvalue below 0 but by rounding. What it has of numbers is about 1.
 */
void farthest_of_ellipsoid(const double squares[3][3], const double center[3], double point[3]);

#endif
