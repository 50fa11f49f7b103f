#include "lib/inverse/damped.h"

#include <math.h>

enum { MOST = 6 };

/* A x = b for a symmetric, positive definite A of n rows; by Cholesky's factor, in A's place. b becomes x. */
static void solve(double a[MOST][MOST], size_t n, double b[MOST])
{
    for (size_t j = 0; j < n; j++) {
        for (size_t i = j; i < n; i++) {
            double sum = a[i][j];
            for (size_t k = 0; k < j; k++) {
                sum -= a[i][k] * a[j][k];
            }
            a[i][j] = i == j ? sqrt(sum) : sum / a[j][j];
        }
    }
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < i; k++) {
            b[i] -= a[i][k] * b[k];
        }
        b[i] /= a[i][i];
    }
    for (size_t i = n; i-- > 0;) {
        for (size_t k = i + 1; k < n; k++) {
            b[i] -= a[k][i] * b[k];
        }
        b[i] /= a[i][i];
    }
}

/* By J'J, of as many rows as joints. */
static void step_of_joints(const double *jacobian, size_t n_rows, size_t n, const bool held[], double damping,
                           const double r[], double step[])
{
    double a[MOST][MOST] = {{0}}, b[MOST] = {0};
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j <= i; j++) {
            a[i][j] = i == j ? damping : 0;
            for (size_t k = 0; k < n_rows && !held[i] && !held[j]; k++) {
                a[i][j] += jacobian[k * n + i] * jacobian[k * n + j];
            }
        }
        for (size_t k = 0; k < n_rows && !held[i]; k++) {
            b[i] += jacobian[k * n + i] * r[k];
        }
    }
    solve(a, n, b);
    for (size_t i = 0; i < n; i++) {
        step[i] = b[i];
    }
}

/* By JJ', of as many rows as components. */
static void step_of_rows(const double *jacobian, size_t n_rows, size_t n, const bool held[], double damping,
                         const double r[], double step[])
{
    double a[MOST][MOST] = {{0}}, b[MOST] = {0};
    for (size_t i = 0; i < n_rows; i++) {
        for (size_t j = 0; j <= i; j++) {
            a[i][j] = i == j ? damping : 0;
            for (size_t k = 0; k < n; k++) {
                a[i][j] += held[k] ? 0 : jacobian[i * n + k] * jacobian[j * n + k];
            }
        }
        b[i] = r[i];
    }
    solve(a, n_rows, b);
    for (size_t k = 0; k < n; k++) {
        step[k] = 0;
        for (size_t i = 0; i < n_rows && !held[k]; i++) {
            step[k] += jacobian[i * n + k] * b[i];
        }
    }
}

void damped_step(const double *jacobian, size_t n_rows, size_t n, const bool held[], double damping, const double r[],
                 double step[])
{
    if (n < n_rows) {
        step_of_joints(jacobian, n_rows, n, held, damping, r, step);
    } else {
        step_of_rows(jacobian, n_rows, n, held, damping, r, step);
    }
}
