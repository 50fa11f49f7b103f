#include "lib/optimum/factor.h"

/*
 * Method
 *    L D L' row by row, without exchanges: the matrices are positive definite, or nearly so. Products are summed in
 *    four sums, in the same order everywhere.
 *
 * Special cases
 *    A pivot that cancels to 1e-14 of its diagonal element, or below 0, is a row that depends on those before it: its
 *    unknown becomes 0.
 *
 * Accuracy
 *    Nothing is claimed of one solution: center.c repeats its steps until what they are for is reached.
 */

/* What is left of a diagonal element, as a part of it, that is no more than its rounding. */
static const double rounding = 1e-14;

double optimum_dot(const double a[], const double b[], size_t n)
{
    double sums[4] = {0, 0, 0, 0};
    size_t k = 0;
    for (; k + 4 <= n; k += 4) {
        sums[0] += a[k] * b[k];
        sums[1] += a[k + 1] * b[k + 1];
        sums[2] += a[k + 2] * b[k + 2];
        sums[3] += a[k + 3] * b[k + 3];
    }
    for (; k < n; k++) {
        sums[0] += a[k] * b[k];
    }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

void optimum_add_multiple(double y[], double factor, const double x[], size_t n)
{
    for (size_t k = 0; k < n; k++) {
        y[k] += factor * x[k];
    }
}

/* One row of L, those above being done; returns the inverse of its pivot. */
static double factor_row(double matrix[], size_t n, size_t i, const double inverse_pivots[])
{
    double *row = matrix + i * n;
    const double diagonal = row[i];
    for (size_t j = 0; j < i; j++) {
        row[j] -= optimum_dot(row, matrix + j * n, j);
    }
    double pivot = diagonal;
    for (size_t j = 0; j < i; j++) {
        const double product = row[j];
        row[j] *= inverse_pivots[j];
        pivot -= product * row[j];
    }
    return pivot > rounding * diagonal ? 1 / pivot : 0;
}

void optimum_factor(double matrix[], size_t n, double inverse_pivots[])
{
    for (size_t i = 0; i < n; i++) {
        inverse_pivots[i] = factor_row(matrix, n, i, inverse_pivots);
    }
}

void optimum_factor_solve(const double factor[], size_t n, const double inverse_pivots[], double x[])
{
    for (size_t i = 0; i < n; i++) {
        x[i] -= optimum_dot(factor + i * n, x, i);
    }
    for (size_t i = 0; i < n; i++) {
        x[i] *= inverse_pivots[i];
    }
    for (size_t i = n; i-- > 0;) {
        optimum_add_multiple(x, -x[i], factor + i * n, i);
    }
}
