#ifndef ARMTOL_LAB_YIELD_GUARANTEE_H
#define ARMTOL_LAB_YIELD_GUARANTEE_H

#include "lab/yield/drawn_arm.h"

#include <stdbool.h>

/*
 * What the linear components can differ from A's prediction by, anywhere in the box:
 *     T^2 L / 2 + T S,
 * T the sum of the angles' tolerances, S that of the lengths', L the longest that the arm can reach, sum of
 * |a, d| of all links + S. For the second derivative of the tool point by two parameters, j before k in the
 * chain, is no longer than the tool point's distance from axis k (two angles) or than 1 (an angle and, after
 * it, a length), and 0 where j is a length; Taylor's remainder is half the sum of all over both orders.
 * armtol_remainder (corners.h) is sharper; this one can be had from a drawing of the arm by hand, and is
 * sharp enough for what it has to show.
 */
double guarantee_remainder(const drawn_arm *arm, const double tolerances[]);

/*
 * Whether the whole box keeps to the accuracy, by these bounds and not by samples: prediction of A, 6 x
 * n_columns, and remainder for the linear components; for the angular ones the sum of all angles, which no
 * rotation exceeds.
 */
bool guarantee_holds(const drawn_arm *arm, const double matrix[], const double tolerances[],
                     const double accuracy[6]);

#endif
