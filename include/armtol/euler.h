#ifndef ARMTOL_EULER_H
#define ARMTOL_EULER_H

#include "armtol/conventions.h"
#include "armtol/errata.h"
#include "armtol/interface.h"

ARMTOL_INTERFACE_BEGIN

/*
 * zyx Euler angles: R = Rot(z, alpha) Rot(y, beta) Rot(x, gamma). A pose is (x, y, z, gamma, beta, alpha).
 * Source: Craig 1986, chapter 2; Hahn 1987, routine eulerzyx. Erratum: float.
 */
armtol_transform armtol_pose_to_transform(const double pose[6], const armtol_errata *errata);

/*
 * The other way: beta in [-pi/2, pi/2], gamma and alpha in (-pi, pi]. At beta = pi/2 the rotation gives only
 * alpha - gamma, at -pi/2 only alpha + gamma; what comes out for the two near there rests on rounding.
 * Source: Hahn 1987, routine geulerzyx. Erratum: float.
 */
void armtol_transform_to_pose(const armtol_transform *transform, const armtol_errata *errata, double pose[6]);

ARMTOL_INTERFACE_END

#endif
