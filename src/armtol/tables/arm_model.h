#ifndef ARMTOL_TABLES_ARM_MODEL_H
#define ARMTOL_TABLES_ARM_MODEL_H

#include "armtol/arm.h"
#include "armtol/axes.h"

#include <stdbool.h>

enum { ARM_MOST_LINKS = 1000 }; /* in a file of any kind */

typedef enum angle_unit { UNIT_RADIAN, UNIT_DEGREE } angle_unit;

/* How the frames of an arm were laid (arm_laying.h): 0 where they are as they were read. */
typedef struct arm_laying {
    double farthest; /* how far frames lay off the arm that were laid anew; 0 where none had to be */
    size_t n_axes;
    size_t n_snapped;
    armtol_snapped *snapped; /* what was taken for exact; the model's, freed with it */
} arm_laying;

/*
 * An arm that was read, and the memory that it is made of: texts, links, drives, masses and names are its own. Angles
 * are radians inside, whatever the file had; angle_unit says what people are to be shown.
 */
typedef struct arm_model {
    armtol_arm arm;
    angle_unit angle_unit;
    arm_laying laying;
    void *memory[8]; /* name, title, source, links, drives, masses, motions, names; freed by arm_model_free */
} arm_model;

/* A copy of the given parts. False, after a message, where memory is short. */
bool arm_model_make(arm_model *model, const armtol_arm *arm, angle_unit angle_unit);

/* How many millimetres a unit has. */
double arm_model_millimetres(armtol_length_unit unit);

/* Its lengths in another unit. False, after a message, where no double holds one. */
bool arm_model_convert(arm_model *model, armtol_length_unit unit);

void arm_model_free(arm_model *model);

#endif
