#ifndef FUZZ_MOTION_H
#define FUZZ_MOTION_H

#include "armtol/axes.h"
#include "armtol/conventions.h"

/* Rigid motions, made of their own and not of the library's routines. */

armtol_transform motion_product(const armtol_transform *left, const armtol_transform *right);

/* Rot(z, yaw) Rot(y, pitch) Rot(x, roll), moved by xyz: as URDF has it. */
armtol_transform motion_of_rpy(const double xyz[3], const double rpy[3]);

/* A turn by that angle about, or a shift by that length along, a direction through the origin. */
armtol_transform motion_about(const double direction[3], double angle);
armtol_transform motion_along(const double direction[3], double length);

/* What the joint value q of an axis does, in base coordinates. */
armtol_transform motion_of_axis(const armtol_axis *axis, double q);

/* The largest difference of two elements: of the rotations and of the translations. */
typedef struct motion_difference {
    double angle, length;
} motion_difference;

motion_difference motion_compare(const armtol_transform *one, const armtol_transform *other);

#endif
