#ifndef ARMTOL_LAB_YIELD_ERROR_SIZE_H
#define ARMTOL_LAB_YIELD_ERROR_SIZE_H

#include <stdbool.h>

/* How large an error of the tool is: a displacement and a rotation vector, as drawn_arm.h has it. */

/* Whether each of the six components keeps to its accuracy; nan does not. */
bool error_is_within(const double error[6], const double accuracy[6]);

/* The largest magnitude of three components, and their norm. */
double error_largest(const double components[3]);
double error_norm(const double components[3]);

#endif
