#ifndef ARMTOL_LIB_ARMS_ARMS_H
#define ARMTOL_LIB_ARMS_ARMS_H

#include "armtol/arm.h"
#include "lib/pi.h"
#include "lib/private_names.h"

#include <math.h>

/* The built-in arms, a file each; those of 1987 stand with their inverse kinematics. See docs/arms.md. */
extern const armtol_arm arm_adept_one;
extern const armtol_arm arm_iiwa_14;
extern const armtol_arm arm_intelledex_605t;
extern const armtol_arm arm_panda;
extern const armtol_arm arm_puma_560;
extern const armtol_arm arm_scara;
extern const armtol_arm arm_stanford;
extern const armtol_arm arm_ur5e;

/* What tables of constants are written with: a constant expression is needed there. */
#define QUARTER (PI / 2)
#define DEGREES(angle) ((angle) * (PI / 180))

/* A drive of which nothing is known but how far its joint goes, and one of which nothing is. */
#define LIMITS(low, high) {low, high, NAN, 0, 0, 0, 0, 0}
#define UNKNOWN LIMITS(-INFINITY, INFINITY)

#endif
