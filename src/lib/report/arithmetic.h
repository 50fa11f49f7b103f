#ifndef ARMTOL_LIB_REPORT_ARITHMETIC_H
#define ARMTOL_LIB_REPORT_ARITHMETIC_H

#include "armtol/errata.h"
#include "lib/pi.h"

/*
 * Rounds to float for certain. The plain cast is not enough: gcc 12.2 -O2 drops it where its vectoriser joins
 * two neighbouring stores of (flag ? (double)(float)x : x). A volatile object it has to write and read.
 */
static inline double round_to_float(double value)
{
    volatile float rounded = (float)value;
    return (double)rounded;
}

/*
 * Erratum `float`: an assignment of 1987 rounds to float. Every value that the old programs kept in a variable
 * or an array passes through here; intermediate results do not.
 */
static inline double store(const armtol_errata *errata, double value)
{
    return errata->float_storage ? round_to_float(value) : value;
}

/* Erratum `short-pi`: 3.14159 wherever pi is meant. */
static inline double pi_of(const armtol_errata *errata)
{
    return errata->short_pi ? 3.14159 : PI;
}

#endif
