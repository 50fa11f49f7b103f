#ifndef ARMTOL_LAB_YIELD_DRAWN_ARM_H
#define ARMTOL_LAB_YIELD_DRAWN_ARM_H

#include "armtol/armtol.h"

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

#endif
