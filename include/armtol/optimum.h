#ifndef ARMTOL_OPTIMUM_H
#define ARMTOL_OPTIMUM_H

#include "armtol/interface.h"
#include "armtol/status.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/* How the errors of parameters are thought to add up. */
typedef enum armtol_sum {
    ARMTOL_WORST_CASE,       /* sum of magnitudes: nothing built to the tolerances is outside */
    ARMTOL_ROOT_SUM_SQUARES, /* root of the sum of squares */
    ARMTOL_SUM_COUNT
} armtol_sum;

/*
 * The number of doubles that armtol_optimum needs to work in: n_rows and, with c the lesser of n_rows and
 * 3 n_columns + 24, about c (c + n_columns).
 */
size_t armtol_optimum_workspace(size_t n_rows, size_t n_columns);

/*
 * The tolerances with the largest product, each to the power of its weight, that keep to the limits.
 *
 * Given:
 *    sum                         how errors add up
 *    matrix, n_rows, n_columns   row-major: A, or the A of several poses one below the other
 *    limits                      n_rows, each > 0; infinity for a row that is free
 *    weights                     n_columns, each > 0
 *
 * Returned:
 *    tolerances                  n_columns
 *    multipliers                 n_rows: the share of the whole weight that each row's limit holds down; note 3
 *    workspace                   armtol_optimum_workspace places, for the work
 *
 * Notes:
 * 1) The problem is
 *        maximise    sum over k of weights[k] log t[k]
 *        subject to  sum over k of |matrix(i,k)| t[k] <= limits[i]  for every row i,
 *    or, with ARMTOL_ROOT_SUM_SQUARES, the root of sum over k (matrix(i,k) t[k])^2 <= limits[i]. There is one optimum,
 *    and no unit of measurement moves it.
 * 2) A column that is 0 in every row that is not free gets an infinite tolerance; what rounding leaves of a 0 is to be
 *    cleared before (armtol_tool_matrix_clear). All other tolerances keep to every limit to the last bit, in whatever
 *    order the products of a row are summed, infinite tolerances left out.
 * 3) Multipliers are >= 0, 0 for rows that do not bind; their sum is 1 where any column is bounded. With W the weights
 *    of the bounded columns
 *        weights[k] / W = sum over i of multipliers[i] f(i,k),
 *        f(i,k) = |matrix(i,k)| t[k] / limits[i]  or, with ARMTOL_ROOT_SUM_SQUARES, the square of that,
 *    which no other t that keeps to the limits can have: it proves the optimum. Where several sets of multipliers do,
 *    as with rows that are alike, one of them comes out.
 * 4) The result is the same to the bit on every machine with IEEE arithmetic.
 *
 * Errors:
 *    ARMTOL_NOT_FINITE      matrix or weights; a limit that is nan; limits or tolerances that are not infinite but
 *                           outside 1e-280 to 1e280
 *    ARMTOL_BAD_TOLERANCE   a limit that is not positive
 *    ARMTOL_BAD_WEIGHT      a weight that is not positive
 *    ARMTOL_NOT_SOLVED      the iteration did not converge: no case is known where weights are within 1e12 of each
 *                           other
 *
 * Reference:
 *    The largest tolerances that keep the tool within limits are what Hahn 1987 asks for; he has a sphere in their
 *    place (bounds.h).
 */
armtol_status armtol_optimum(armtol_sum sum, const double matrix[], size_t n_rows, size_t n_columns,
                              const double limits[], const double weights[], double tolerances[],
                              double multipliers[], double workspace[]);

ARMTOL_INTERFACE_END

#endif
