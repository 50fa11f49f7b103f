#include "lib/optimum/told_to_nlopt.h"

#include "unity.h"

#include <math.h>
#include <nlopt.h>
#include <string.h>

static double objective(unsigned n, const double x[], double gradient[], void *data)
{
    const problem *problem = data;
    double sum = 0;
    for (unsigned k = 0; k < n; k++) {
        sum -= problem->roots[k] * x[k];
        if (gradient != NULL) {
            gradient[k] = -problem->roots[k];
        }
    }
    return sum;
}

/* Squares are what root-sum-square limits are linear in. */
static double order_of(const problem *problem)
{
    return problem->sum == ARMTOL_ROOT_SUM_SQUARES ? 2 : 1;
}

static double tolerance_at(const problem *problem, size_t column, double x)
{
    return problem->units[column] * exp(x / (order_of(problem) * problem->roots[column]));
}

static double part(const problem *problem, size_t row, size_t column, double x)
{
    const double element = fabs(problem->matrix[row * problem->n_columns + column]);
    return pow(element * tolerance_at(problem, column, x) / problem->limits[row], order_of(problem));
}

static void constraints(unsigned m, double result[], unsigned n, const double x[], double gradient[],
                        void *data)
{
    const problem *problem = data;
    for (unsigned i = 0; i < m; i++) {
        result[i] = -1;
        for (unsigned k = 0; k < n; k++) {
            const double share = part(problem, i, k, x[k]);
            result[i] += share;
            if (gradient != NULL) {
                gradient[i * n + k] = share / problem->roots[k];
            }
        }
    }
}

static void scale(problem *problem)
{
    double weight = 0;
    for (size_t k = 0; k < problem->n_columns; k++) {
        weight += problem->weights[k];
    }
    for (size_t k = 0; k < problem->n_columns; k++) {
        problem->roots[k] = sqrt(problem->weights[k] / weight);
    }
}

/* At x = 0 what each column could have alone, parted by their number or more: inside every limit, but for the least. */
static void start(problem *problem, double parted, double x[])
{
    for (size_t k = 0; k < problem->n_columns; k++) {
        double used = 0;
        for (size_t i = 0; i < problem->n_rows; i++) {
            used = fmax(used, fabs(problem->matrix[i * problem->n_columns + k]) / problem->limits[i]);
        }
        const double most = problem->largest[k] > 0 ? fmin(1 / used, problem->largest[k]) : 1 / used;
        problem->alone[k] = most;
        problem->units[k] = fmax(most / (parted * (double)problem->n_columns), problem->least[k]);
        x[k] = 0;
    }
}

/* In x; infinity for the least of 0. */
static double bound_at(const problem *problem, size_t column, double tolerance)
{
    return order_of(problem) * problem->roots[column] * log(tolerance / problem->units[column]);
}

/* No tolerance beyond what it could be alone: keeps first steps from running away with the exponential. */
static void set_bounds(const problem *problem, nlopt_opt solver)
{
    double lower[MOST_COLUMNS], upper[MOST_COLUMNS];
    for (size_t k = 0; k < problem->n_columns; k++) {
        lower[k] = problem->least[k] > 0 ? fmin(0, bound_at(problem, k, problem->least[k])) : -(double)INFINITY;
        upper[k] = fmax(0, bound_at(problem, k, problem->alone[k]));
    }
    nlopt_set_lower_bounds(solver, lower);
    nlopt_set_upper_bounds(solver, upper);
}

static nlopt_opt solver_for(problem *problem)
{
    double allowed[MOST_ROWS];
    for (size_t i = 0; i < problem->n_rows; i++) {
        allowed[i] = 1e-13;
    }
    nlopt_opt solver = nlopt_create(NLOPT_LD_SLSQP, (unsigned)problem->n_columns);
    TEST_ASSERT_NOT_NULL(solver);
    nlopt_set_min_objective(solver, objective, problem);
    nlopt_add_inequality_mconstraint(solver, (unsigned)problem->n_rows, constraints, problem, allowed);
    nlopt_set_xtol_abs1(solver, 1e-12);
    nlopt_set_maxeval(solver, 2000);
    return solver;
}

/*
 * Make where it stands x = 0, so that the objective has digits to spare there; returns how far it had come.
 */
static double recentre(problem *problem, double x[])
{
    double moved = 0;
    for (size_t k = 0; k < problem->n_columns; k++) {
        moved = fmax(moved, fabs(x[k]));
        problem->units[k] = tolerance_at(problem, k, x[k]);
        x[k] = 0;
    }
    return moved;
}

/* Started again from where it stopped until it stays there; the tolerances are then the units. */
static void solve_from(problem *problem, double parted)
{
    double x[MOST_COLUMNS], value, moved = 1;
    scale(problem);
    start(problem, parted, x);
    nlopt_opt solver = solver_for(problem);
    for (int i = 0; i < 50 && moved > 1e-10; i++) {
        set_bounds(problem, solver);
        const nlopt_result result = nlopt_optimize(solver, x, &value);
        if (result < 0 && result != NLOPT_ROUNDOFF_LIMITED) {
            TEST_FAIL_MESSAGE(nlopt_result_to_string(result));
        }
        moved = recentre(problem, x);
    }
    nlopt_destroy(solver);
}

double log_product(const problem *problem, const double tolerances[])
{
    double sum = 0;
    for (size_t k = 0; k < problem->n_columns; k++) {
        sum += problem->weights[k] * log(tolerances[k]);
    }
    return sum;
}

/* SLSQP can stop short of the optimum, and once in a hundred problems does: the best of a few beginnings. */
void solve_with_nlopt(problem *problem, double tolerances[])
{
    static const double parted[] = {1, 1.5, 3};
    double best = -(double)INFINITY;
    for (size_t i = 0; i < sizeof parted / sizeof parted[0]; i++) {
        solve_from(problem, parted[i]);
        const double reached = log_product(problem, problem->units);
        if (reached > best) {
            best = reached;
            memcpy(tolerances, problem->units, problem->n_columns * sizeof *tolerances);
        }
    }
}
