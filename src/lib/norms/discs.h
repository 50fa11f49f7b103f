#ifndef ARMTOL_LIB_NORMS_DISCS_H
#define ARMTOL_LIB_NORMS_DISCS_H

#include "lib/private_names.h"

#include <stdbool.h>
#include <stddef.h>

/*
 * Tolerances of which some are radii: discs[k] says that the errors of columns k and k + 1, alpha and beta of a link,
 * move in a disc whose radius is the tolerance of both, tolerances[k]; discs[k + 1] is false. NULL: none do. Without
 * discs all is as in corners.h, bit by bit.
 */

/* The deviation of an axis of a disc, radius / 2, as a part of radius / sqrt(3), which a tolerance of that size has. */
#define DISC_FACTOR 0.86602540378443864676

/* What a column puts into the worst case of a row: a disc's is all in its first column. */
double discs_worst_part(const double row[], size_t column, const double tolerances[], const bool discs[]);

/* The sum of it over all columns. */
double discs_worst(const double row[], size_t n_columns, const double tolerances[], const bool discs[]);

/* The errors with which the row is largest (sign 1) or least (-1): of a disc the point of its rim. */
void discs_corner(const double row[], size_t n_columns, int sign, const double tolerances[], const bool discs[],
                  double errors[]);

/* Whether a column is one of the two of a disc, and how many discs there are. */
bool discs_have(const bool discs[], size_t column);
size_t discs_count(const bool discs[], size_t n_columns);

#endif
