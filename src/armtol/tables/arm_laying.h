#ifndef ARMTOL_TABLES_ARM_LAYING_H
#define ARMTOL_TABLES_ARM_LAYING_H

#include "armtol/tables/arm_model.h"

#include <stdbool.h>

/*
 * Lay the frames of an arm anew along its axes, by armtol_links_of_axes, and say in model->laying what was done. Joints
 * keep their values and drives. False, after a message, where memory is short; the model is then as it was.
 */

/* With what is nearly exact taken for exact. Nothing changes where nothing is. */
bool arm_laying_snap(arm_model *model, double snap);

/* Where frames lie farther off the arm than three times its reach. */
bool arm_laying_gather(arm_model *model);

#endif
