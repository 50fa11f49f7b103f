#ifndef ARMTOL_LIB_ARMS_MOTION_H
#define ARMTOL_LIB_ARMS_MOTION_H

#include "armtol/arm.h"
#include "lib/private_names.h"

/*
 * How the joint of a link moves, whether the arm has motions or not: of one that moves by itself the multiplier is 1
 * and the offset 0, whatever the table says of them.
 */
armtol_motion arm_motion(const armtol_arm *arm, size_t link);

/* Metres of a unit of length; of a value that is none, of a millimetre. */
double arm_metres(armtol_length_unit unit);

#endif
