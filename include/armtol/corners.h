#ifndef ARMTOL_CORNERS_H
#define ARMTOL_CORNERS_H

#include "armtol/interface.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * The corners of the box that tolerances span, every parameter off by all that it may be, and how far the
 * exact error of the tool (tool_error.h) can be from what A says. matrix is A of the arm as meant, 6 x
 * n_columns, its columns those of armtol_columns and its linear rows those of the tool point (tool_matrix.h);
 * tolerances has one value >= 0 a column.
 */

/*
 * |row| tolerances: the largest that the row's component of the error gets to first order. An infinite tolerance
 * makes it infinite where its element counts (optimum.h), and adds nothing where it does not.
 */
double armtol_worst_error(const double matrix[], size_t n_columns, size_t row, const double tolerances[]);

/* The root of the sum of the squares of row x tolerances, infinite ones as above. */
double armtol_rss_error(const double matrix[], size_t n_columns, size_t row, const double tolerances[]);

/*
 * The corner where the row's component has its largest value, or for sign -1 its least: each error with the
 * sign of its element. A parameter that does not move the component to first order stays as meant: the sign
 * of what rounding left there would mean nothing.
 */
void armtol_corner(const double matrix[], size_t n_columns, size_t row, int sign, const double tolerances[],
                   double parameter_errors[]);

/*
 * What the six components of the exact error can differ from A's prediction by, anywhere in the box: never
 * less than the truth, but for rounding, and near it for small tolerances, where it goes with their square.
 * Counted along the axes that A is counted along; corners.c says why it holds. The angular components are
 * bounded as long as the tolerances of all angles sum to less than pi, and have infinity from there on; an
 * infinite tolerance, or one that is nan, makes all six infinite.
 */
void armtol_remainder(const double matrix[], size_t n_columns, const double tolerances[],
                      double remainder[6]);

ARMTOL_INTERFACE_END

#endif
