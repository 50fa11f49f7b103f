#ifndef ARMTOL_ASK_UNITS_H
#define ARMTOL_ASK_UNITS_H

#include "armtol/ask/options.h"
#include "armtol/tables/arm_model.h"
#include "console/number.h"

#include <stdbool.h>

/*
 * The units that people type and are shown. Inside, lengths are in the arm's own unit and angles in radians.
 */
typedef struct units {
    armtol_length_unit arm; /* the arm's */
    armtol_length_unit length;
    angle_unit angle;
} units;

/* The length that an option chose: --mm, --metres or --inches. */
armtol_length_unit units_chosen_length(unit_choice choice);

/* From inside to the user's, and back. */
double units_shown(const units *units, bool is_length, double value);
double units_taken(const units *units, bool is_length, double value);

/*
 * As shown, but the shortest decimal number that says the same to some 2 units in the last place: what was typed as 300
 * degrees, or 0.3 mm of an arm in metres, is that again.
 */
double units_typed(const units *units, bool is_length, double value);

/* A joint's value as it is typed. Returns text->text. */
const char *units_joint_text(const units *units, const armtol_link *link, double value, number_text *text);

/* Joint values, from the user's to inside: one for each joint that moves by itself. */
void units_take_joints(const units *units, const armtol_arm *arm, double q[]);

/* What the command line chooses for an arm; what it does not say is the arm's. */
units units_chosen(const cli_options *options, const arm_model *model);

/* "mm", "m", "deg" or "rad". */
const char *units_name(const units *units, bool is_length);

#endif
