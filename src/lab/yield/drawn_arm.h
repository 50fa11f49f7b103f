#ifndef ARMTOL_LAB_YIELD_DRAWN_ARM_H
#define ARMTOL_LAB_YIELD_DRAWN_ARM_H

#include "armtol/armtol.h"

#include <stdbool.h>
#include <stddef.h>

/* An arm as it is drawn, to be held against the same arm as it is built, its joints at the same values. */
typedef struct drawn_arm {
    const armtol_link *links; /* placed */
    size_t n_links;
    const armtol_column *columns; /* the parameters that can be off */
    size_t n_columns;
} drawn_arm;

/* Where the tool is with these errors, less where it should be: armtol_tool_error, along the base's axes. */
void drawn_arm_error(const drawn_arm *arm, const double errors[], double error[6]);

/*
 * From a corner of the box of tolerances to one from which no change of one sign takes the tool point farther
 * from where it should be (parameters as drawn take a sign where that helps). Returns that distance; errors
 * is where it ends.
 */
double drawn_arm_farthest(const drawn_arm *arm, const double tolerances[], double errors[]);

/* Whether each of the six components of an error keeps to its accuracy; nan does not. */
bool error_is_within(const double error[6], const double accuracy[6]);

/* The largest magnitude of three components, and their norm. */
double error_largest(const double components[3]);
double error_norm(const double components[3]);

#endif
