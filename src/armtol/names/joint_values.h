#ifndef ARMTOL_NAMES_JOINT_VALUES_H
#define ARMTOL_NAMES_JOINT_VALUES_H

#include "armtol/arm.h"

#include <stdbool.h>

/* Whether the argument of --joints goes by names: "elbow=20,wrist=-5" and not "20,-5". */
bool joint_values_are_named(const char *text);

/*
 * A value for each joint that moves by itself, in any order, blanks around names and values not counting; what stands
 * before the last = of an item is the name. All joints have to be there: 0 is no better guess than any other. q has a
 * place for each, in link order. False after a message.
 */
bool joint_values_parse(const char *text, const armtol_arm *arm, double q[]);

#endif
