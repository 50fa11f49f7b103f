#ifndef ARMTOL_LAB_JOINT_ORDERS_KEEP_H
#define ARMTOL_LAB_JOINT_ORDERS_KEEP_H

#include "armtol/errata.h"

#include <stdbool.h>

/* The value as a float keeps it, or as it is. */
static inline double keep(bool in_float, double value)
{
    return in_float ? armtol_stored(&armtol_errata_1987, value) : value;
}

static inline double pi_of_digits(bool few)
{
    return few ? 3.14159 : 3.14159265358979323846;
}

#endif
