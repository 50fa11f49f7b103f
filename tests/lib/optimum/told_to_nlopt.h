#ifndef TEST_TOLD_TO_NLOPT_H
#define TEST_TOLD_TO_NLOPT_H

#include "armtol/optimum.h"

/*
 * The problem of optimum.h told to a general solver, which knows nothing of how it is solved there: NLopt's SLSQP
 * (sequential quadratic programming), in x = sqrt(w) log(t / unit), or log of the square, where the problem is convex,
 * its objective linear and its curvature the same all around.
 */

enum { MOST_ROWS = 60, MOST_COLUMNS = 40 };

typedef struct problem {
    armtol_sum sum;
    size_t n_rows, n_columns;
    double matrix[MOST_ROWS * MOST_COLUMNS];
    double limits[MOST_ROWS];
    double weights[MOST_COLUMNS];
    double least[MOST_COLUMNS];   /* 0 for none */
    double largest[MOST_COLUMNS]; /* infinity, or 0, for none */
    double alone[MOST_COLUMNS];   /* for the work: the largest that a tolerance could be if all others were 0 */
    double units[MOST_COLUMNS];   /* t^order = units^order e^(x / roots) */
    double roots[MOST_COLUMNS];   /* of the weights, their sum 1 */
} problem;

/* The best that it finds from a few beginnings; one that ends in an error fails the test. */
void solve_with_nlopt(problem *problem, double tolerances[]);

/* The sum of w log t. */
double log_product(const problem *problem, const double tolerances[]);

#endif
