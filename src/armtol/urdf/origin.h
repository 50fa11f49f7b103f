#ifndef ARMTOL_URDF_ORIGIN_H
#define ARMTOL_URDF_ORIGIN_H

#include "armtol/conventions.h"
#include "armtol/urdf/tree.h"

/*
 * Where the child of a joint is at joint value 0, in the frame of the parent: of rpy, or of a quaternion of any length.
 */
armtol_transform urdf_joint_origin(const urdf_joint *joint);

#endif
