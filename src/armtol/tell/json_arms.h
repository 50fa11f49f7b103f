#ifndef ARMTOL_TELL_JSON_ARMS_H
#define ARMTOL_TELL_JSON_ARMS_H

#include "armtol/arm.h"
#include "armtol/ask/units.h"
#include "armtol/forms/json.h"

/*
 * --list --json and --show --json, on standard output. The arm is in the units' length, its angles in radians; the
 * lengths of how it was laid are in those of `laid`.
 */
void json_list(void);
void json_show(const arm_model *model, const units *units, const struct units *laid);

/* What an arm is, in the object at hand. */
void json_arm_texts(json *json, const armtol_arm *arm);

/* A member units: what lengths and angles are in. */
void json_units(json *json, const units *units);

/* A member joint_names, where any has one: of the joints that have a value, in order; "" for one without. */
void json_joint_names(json *json, const armtol_arm *arm);

#endif
