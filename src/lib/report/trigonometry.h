#ifndef ARMTOL_LIB_REPORT_TRIGONOMETRY_H
#define ARMTOL_LIB_REPORT_TRIGONOMETRY_H

#include "armtol/errata.h"
#include "lib/private_names.h"

/*
 * Erratum `float`: 1987 called libm, and what a float keeps of that is the same on every machine. A double is
 * not: libms differ in the last bits, and so in the sign of what ought to be 0, which shows as -0.000000.
 * Corrected, these are the library's own. They add, multiply, divide and take roots in one order everywhere,
 * and come within 4.5e-16 of the result; only angles beyond 1e6 are left to libm.
 */
double sine_of(const armtol_errata *errata, double angle);
double cosine_of(const armtol_errata *errata, double angle);

/* Of the direction (x, y), in [-pi, pi], as atan2 has it. */
double angle_of(const armtol_errata *errata, double y, double x);

/* In [0, pi]; |cosine| <= 1. */
double arc_cosine_of(const armtol_errata *errata, double cosine);

/* In [-pi/2, pi/2]; |sine| <= 1. */
double arc_sine_of(const armtol_errata *errata, double sine);

/* sqrt(x^2 + y^2) as hypot has it, no square of which over- or underflows, with the same bits everywhere. */
double length_of(double x, double y);

/* The same of three components. */
double length_of_vector(const double v[3]);

#endif
