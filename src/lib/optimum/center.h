#ifndef ARMTOL_LIB_OPTIMUM_CENTER_H
#define ARMTOL_LIB_OPTIMUM_CENTER_H

#include "lib/private_names.h"

#include <stdbool.h>
#include <stddef.h>

/*
 * The inner problem of the optimum, scaled: with B >= 0, p x n, and weights that sum to 1,
 *     maximise  sum_k weights[k] log t[k]  subject to  B t + s = 1,  s >= 0.
 * With l >= 0 the multipliers of the rows and y = B'l, t is the optimum where
 *     t[k] y[k] = weights[k]  and  l[i] s[i] = 0.
 */
typedef struct center_problem {
    const double *rows; /* B; every column has an element that is not 0 */
    size_t n_rows;
    size_t n_columns;
    const double *weights;
} center_problem;

/* Where the solver stands, and the step that it takes: parts of the workspace. */
typedef struct center_state {
    double *l, *s, *dl, *ds, *complements, *pivots; /* n_rows each */
    double *t, *y, *dt, *dy, *ratios, *targets;     /* n_columns each */
    double *matrix;                                 /* n_rows x n_rows */
} center_state;

enum { CENTER_VECTORS = 6 }; /* of each of the two lengths */

/* Solve. False where the iteration does not converge. */
bool optimum_center(const center_problem *problem, center_state *state);

/* Whether the row binds at the optimum, rounding apart. */
bool optimum_binds(const center_state *state, size_t row);

#endif
