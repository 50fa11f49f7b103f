#ifndef ARMTOL_LIB_OPTIMUM_ROWS_H
#define ARMTOL_LIB_OPTIMUM_ROWS_H

#include "armtol/optimum.h"
#include "lib/private_names.h"

#include <stdbool.h>
#include <stddef.h>

/* What armtol_optimum is given, and the units that make its numbers comparable. */
typedef struct optimum_rows {
    armtol_sum sum;
    const double *matrix;
    size_t n_rows;
    size_t n_columns;
    const double *limits;
    double *units;    /* a column: the largest tolerance that it could have alone; 0 where no row bounds it */
    size_t n_bounded; /* columns with a unit */
} optimum_rows;

/*
 * Find the units, with room for n_columns numbers. False where one is too large or too small to compute with.
 */
bool optimum_find_units(optimum_rows *rows, double room[]);

/* Whether a number that is not infinite is large and small enough to compute with. */
bool optimum_in_range(double value);

/*
 * An element of B, the matrix of the scaled problem B t <= 1: |matrix(i,k)| units[k] / limits[i], or with
 * ARMTOL_ROOT_SUM_SQUARES the square of that, its unknowns being the squares of tolerances then. At most 1,
 * but for rounding; 0 in a free row.
 */
double optimum_element(const optimum_rows *rows, size_t row, size_t column);

/* A row of B, the columns that are bounded. */
void optimum_pack(const optimum_rows *rows, size_t row, double packed[]);

/*
 * What part of its limit, or with ARMTOL_ROOT_SUM_SQUARES of the square, a row's error is; 0 for a free row,
 * infinite where it overflows. Tolerances are 0 where they are infinite.
 */
double optimum_use(const optimum_rows *rows, size_t row, const double tolerances[]);

#endif
