#ifndef ARMTOL_TABLES_ARM_MODEL_H
#define ARMTOL_TABLES_ARM_MODEL_H

#include "armtol/arm.h"

#include <stdbool.h>

typedef enum angle_unit { UNIT_RADIAN, UNIT_DEGREE } angle_unit;

/*
 * An arm that was read, and the memory that it is made of: texts, links, drives and masses are its own. Angles are radians
 * inside, whatever the file had; angle_unit says what people are to be shown.
 */
typedef struct arm_model {
    armtol_arm arm;
    angle_unit angle_unit;
    void *memory[6]; /* name, title, source, links, drives, masses; freed by arm_model_free */
} arm_model;

/* A copy of the given parts. False, after a message, where memory is short. */
bool arm_model_make(arm_model *model, const armtol_arm *arm, angle_unit angle_unit);
void arm_model_free(arm_model *model);

#endif
