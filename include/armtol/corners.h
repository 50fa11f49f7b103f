#ifndef ARMTOL_CORNERS_H
#define ARMTOL_CORNERS_H

#include "armtol/link.h"
#include "armtol/tool_point.h"

#include <stddef.h>

/*
 * The corners of the box that tolerances span, every parameter off by all that it may be, and how far the exact error
 * of the tool there can be from what A says. matrix is A of the arm as meant (tool_matrix.h), 6 x n_columns;
 * tolerances has one value >= 0 a column.
 */

/* |row| tolerances: the largest that the row's component of the error gets to first order. */
double armtol_worst_error(const double matrix[], size_t n_columns, size_t row, const double tolerances[]);

/* The root of the sum of the squares of row x tolerances. */
double armtol_rss_error(const double matrix[], size_t n_columns, size_t row, const double tolerances[]);

/*
 * The corner where the row's component has its largest value, or for sign -1 its least: each error with the sign of
 * its element. A parameter that does not move the component to first order stays as meant: the sign of what rounding
 * left there would mean nothing.
 */
void armtol_corner(const double matrix[], size_t n_columns, size_t row, int sign, const double tolerances[],
                   double parameter_errors[]);

/*
 * What the six components of the exact error can differ from A's prediction by, anywhere in the box; never less than
 * the truth. Linear: T^2 L / 2 + T S, with T the sum of the angles' tolerances, S that of the lengths', L the longest
 * that the arm can reach, offset included. Angular: see corners.c. Errors: as of armtol_tool_error.
 */
armtol_status armtol_remainder(const armtol_link links[], size_t n_links, const double tolerances[],
                               size_t n_columns, const armtol_tool_point *tool, double remainder[6]);

#endif
