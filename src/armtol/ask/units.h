#ifndef ARMTOL_ASK_UNITS_H
#define ARMTOL_ASK_UNITS_H

#include "armtol/tables/arm_model.h"

#include <stdbool.h>

/*
 * The units that people type and are shown. Inside, lengths are in the arm's own unit and angles in radians.
 */
typedef struct units {
    armtol_length_unit arm; /* the arm's */
    armtol_length_unit length;
    angle_unit angle;
} units;

/* From inside to the user's, and back. */
double units_shown(const units *units, bool is_length, double value);
double units_taken(const units *units, bool is_length, double value);

/* "mm", "m", "deg" or "rad". */
const char *units_name(const units *units, bool is_length);

#endif
