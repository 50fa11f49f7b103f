#ifndef ARMTOL_TELL_JSON_ARMS_H
#define ARMTOL_TELL_JSON_ARMS_H

#include "armtol/arm.h"
#include "armtol/ask/units.h"

/* --list --json and --show --json, on standard output. The arm is in the units' length, its angles in radians. */
void json_list(void);
void json_show(const armtol_arm *arm, const units *units);

#endif
