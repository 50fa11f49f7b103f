#ifndef ARMTOL_ALLOCATION_H
#define ARMTOL_ALLOCATION_H

#include "armtol/status.h"

#include <stddef.h>

/* How the errors of parameters are thought to add up. */
typedef enum armtol_sum {
    ARMTOL_WORST_CASE,       /* sum of magnitudes: nothing built to the tolerances is outside */
    ARMTOL_ROOT_SUM_SQUARES, /* root of the sum of squares */
    ARMTOL_SUM_COUNT
} armtol_sum;

/* The number of doubles that armtol_allocate needs to work in. */
size_t armtol_allocation_workspace(size_t n_rows, size_t n_columns);

/*
 * The tolerances with the largest product, each to the power of its weight, that keep to the limits:
 *     maximise  sum_k weights[k] log t[k]   subject to   sum over k |matrix(i,k)| t[k] <= limits[i]   for every row i,
 * or, with ARMTOL_ROOT_SUM_SQUARES, the root of sum over k (matrix(i,k) t[k])^2 <= limits[i]. matrix is
 * n_rows x n_columns, row-major: A, or the A of several poses one below the other. A limit may be infinite: its row is
 * free. A column that is zero in every row that is not free (to 1e-12 of ...) gets an infinite tolerance.
 * multipliers has n_rows places: the share of the whole weight that each row's limit holds down, >= 0, 0 for rows that
 * do not bind; their sum is 1 where any column is bounded.
 * workspace has armtol_allocation_workspace places.
 * Source: the optimum that Hahn 1987 asks for; solved through its dual ...
 * Errors: ARMTOL_NOT_FINITE (matrix, weights; a limit that is nan), ARMTOL_BAD_TOLERANCE (a limit that is not
 * positive), ARMTOL_BAD_WEIGHT (a weight that is not positive), ARMTOL_NOT_SOLVED.
 */
armtol_status armtol_allocate(armtol_sum sum, const double matrix[], size_t n_rows, size_t n_columns,
                              const double limits[], const double weights[], double tolerances[],
                              double multipliers[], double workspace[]);

#endif
