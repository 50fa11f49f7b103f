#ifndef EXPERIMENTS_CORNERS_H
#define EXPERIMENTS_CORNERS_H

#include "built_arm.h"

#include <stdbool.h>
#include <stddef.h>

/*
 * The corners of the box that tolerances span: every parameter off by all that it may be. The matrix is A of
 * the arm as drawn, corrected, its linear rows those of the tool point (error_matrix.h).
 */

/* One row of A over the whole box: |row| tolerances, the largest that the component gets to first order. */
double corner_prediction(const double matrix[], size_t n_columns, size_t row, const double tolerances[]);

/*
 * The corner where that row of A has its largest value, or for sign -1 its least: each error with the sign of
 * its element. A parameter that does not move the component to first order stays as drawn: the sign of what
 * rounding left there would mean nothing.
 */
void corner_of_row(const double matrix[], size_t n_columns, size_t row, int sign, const double tolerances[],
                   double errors[]);

/*
 * From a corner to one from which no change of one sign takes the tool point farther from where it should be
 * (parameters as drawn take a sign where that helps). Returns that distance; errors is where it ends.
 */
double corner_climb(const built_arm *arm, const double tolerances[], double errors[]);

/*
 * What the linear components can differ from the prediction by, anywhere in the box:
 *     T^2 L / 2 + T S,
 * T the sum of the angles' tolerances, S that of the lengths', L the longest that the arm can reach, sum of
 * |a, d| of all links + S. For the second derivative of the tool point by two parameters, j before k in the
 * chain, is no longer than the tool point's distance from axis k (two angles) or than 1 (an angle and, after
 * it, a length), and 0 where j is a length; Taylor's remainder is half the sum of all over both orders.
 */
double corner_remainder(const built_arm *arm, const double tolerances[]);

/*
 * Whether the whole box keeps to the accuracy, by these bounds and not by samples: prediction and remainder
 * for the linear components; for the angular ones the sum of all angles, which no rotation exceeds.
 */
bool corner_all_within(const built_arm *arm, const double matrix[], const double tolerances[],
                       const double accuracy[6]);

#endif
