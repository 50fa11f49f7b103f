#ifndef ARMTOL_LIB_INVERSE_OWN_H
#define ARMTOL_LIB_INVERSE_OWN_H

#include "armtol/inverse.h"
#include "armtol/robots.h"
#include "lib/private_names.h"

/* The arm of 1987 whose corrected table the arm has, in millimetres; NULL for any other. */
const armtol_robot *own_robot(const armtol_arm *arm);

/* Joint values by its inverse kinematics, for the last frame; false where it has none. */
bool own_inverse(const armtol_robot *robot, const armtol_transform *last, double q[]);

#endif
