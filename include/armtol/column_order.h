#ifndef ARMTOL_COLUMN_ORDER_H
#define ARMTOL_COLUMN_ORDER_H

#include "armtol/error_matrix.h"
#include "armtol/interface.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * The order that puts lengths before angles.
 *
 * Given:
 *    columns, n_columns   what the columns of A stand for (armtol_columns)
 *
 * Returned:
 *    order                n_columns: order[k] is the column that comes to place k
 *    function value       the number of lengths
 *
 * Notes:
 * 1) First the a of every link that also has a d; then of every link its d, or its a where it has no d; then every
 *    theta; every alpha; every beta; each group in link order.
 *
 * Reference:
 *    The reorder tables of both programs of Hahn 1987, which this one rule gives.
 */
size_t armtol_column_order(const armtol_column columns[], size_t n_columns, size_t order[]);

/* ordered(i, k) = matrix(i, order[k]), both 6 x n_columns. */
void armtol_reorder(const double matrix[], size_t n_columns, const size_t order[], double ordered[]);

ARMTOL_INTERFACE_END

#endif
