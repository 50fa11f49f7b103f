#ifndef ARMTOL_LAB_JOINT_ORDERS_KEEP_H
#define ARMTOL_LAB_JOINT_ORDERS_KEEP_H

#include "armtol/errata.h"

#include <stdbool.h>

#define HEADER_PI 3.14159 /* the macro of both robots' headers */

/* The value as a float keeps it: every variable and array of the listing is one. */
static inline double stored(double value)
{
    return armtol_stored(&armtol_errata_1987, value);
}

/* The value in a variable, or as part of a longer expression, in double. */
static inline double keep(bool in_variable, double value)
{
    return in_variable ? stored(value) : value;
}

#endif
