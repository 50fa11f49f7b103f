#ifndef ARMTOL_LIB_OPTIMUM_FACTOR_H
#define ARMTOL_LIB_OPTIMUM_FACTOR_H

#include "lib/private_names.h"

#include <stddef.h>

/*
 * L D L' of a symmetric matrix that is positive definite or nearly so: n x n, row-major, only its lower
 * triangle is read; L takes its place. A pivot that cancels down to rounding marks a row that depends on
 * those before it: its inverse is set to 0, and solutions leave that unknown at 0.
 */
void optimum_factor(double matrix[], size_t n, double inverse_pivots[]);

/* Solve with such a factor, in place. */
void optimum_factor_solve(const double factor[], size_t n, const double inverse_pivots[], double x[]);

/* a'b, in four sums that do not wait for each other; the order is the same everywhere. */
double optimum_dot(const double a[], const double b[], size_t n);

/* y += factor x */
void optimum_add_multiple(double y[], double factor, const double x[], size_t n);

#endif
