#ifndef ARMTOL_EULER_H
#define ARMTOL_EULER_H

#include "armtol/conventions.h"
#include "armtol/errata.h"
#include "armtol/interface.h"

ARMTOL_INTERFACE_BEGIN

/*
 * A transform of zyx Euler angles, R = Rot(z, alpha) Rot(y, beta) Rot(x, gamma).
 *
 * Given:
 *    pose     x, y, z, gamma, beta, alpha
 *    errata   float
 *
 * Reference:
 *    Craig 1986, chapter 2; Hahn 1987, routine eulerzyx.
 */
armtol_transform armtol_pose_to_transform(const double pose[6], const armtol_errata *errata);

/*
 * The other way.
 *
 * Given:
 *    transform   a rigid motion
 *    errata      float
 *
 * Returned:
 *    pose        beta in [-pi/2, pi/2], gamma and alpha in [-pi, pi]
 *
 * Notes:
 * 1) At beta = pi/2 the rotation gives only alpha - gamma, at -pi/2 only alpha + gamma; what comes out for the two near
 *    there rests on rounding.
 *
 * Reference:
 *    Hahn 1987, routine geulerzyx.
 */
void armtol_transform_to_pose(const armtol_transform *transform, const armtol_errata *errata, double pose[6]);

ARMTOL_INTERFACE_END

#endif
