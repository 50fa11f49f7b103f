#include "lib/optimum/center.h"

#include "lib/optimum/factor.h"

#include <math.h>

/*
 * Method
 *    A primal-dual interior-point method. The conditions t y = w, l s = 0 are those of the complementary pairs of a
 *    linear programme, but for w in place of 0, and its method serves: Newton's steps for t y = w, l s = mu, with mu
 *    led to 0, predictor and corrector on one factorisation (Mehrotra 1992). No logarithm is taken.
 *
 * Special cases
 *    Rows that depend on each other: the factor leaves their unknowns at 0 (factor.h). Steps that aim far can go in
 *    circles: after 30 they are careful ones (test_the_optimum_where_long_steps_do_not_get_there). After 300 the
 *    iteration has not converged.
 *
 * Accuracy
 *    As `negligible` says; what comes of it is measured in test_optimum (optimum.c).
 */

/*
 * What t y may be off from w, and s from 0 in a row that binds, as parts of w and of the limit; and what the
 * other rows may contribute to y, as parts of y. So the t found is the optimum of a problem whose weights and
 * limits differ from those given by no more than that.
 */
static const double negligible = 1e-13;

/*
 * Steps that aim far get there in 5 to 15, but in one problem of a thousand, as the tests draw them, they go
 * in circles. Careful steps, which are many, have not been seen to.
 */
enum { CAREFUL_FROM = 30, MOST_ITERATIONS = 300 };

static const double careful_reduction = 0.3;

static double largest_load(const center_problem *problem, const double t[])
{
    double largest = 0;
    for (size_t i = 0; i < problem->n_rows; i++) {
        const double *row = problem->rows + i * problem->n_columns;
        largest = fmax(largest, optimum_dot(row, t, problem->n_columns));
    }
    return largest;
}

/* product = B'l */
static void transposed_product(const center_problem *problem, const double l[], double product[])
{
    for (size_t k = 0; k < problem->n_columns; k++) {
        product[k] = 0;
    }
    for (size_t i = 0; i < problem->n_rows; i++) {
        optimum_add_multiple(product, l[i], problem->rows + i * problem->n_columns, problem->n_columns);
    }
}

/* Equal multipliers, and a t well inside with t y = w; only for small weights t y starts larger. */
static void start(const center_problem *problem, center_state *state)
{
    const size_t p = problem->n_rows, n = problem->n_columns;
    for (size_t i = 0; i < p; i++) {
        state->l[i] = 1 / (double)p;
    }
    transposed_product(problem, state->l, state->y);
    for (size_t k = 0; k < n; k++) {
        state->t[k] = fmax(problem->weights[k], 0.1 / (double)n) / state->y[k];
    }
    const double shrink = 1.25 * largest_load(problem, state->t);
    for (size_t k = 0; k < n; k++) {
        state->t[k] /= shrink;
        state->y[k] *= shrink;
    }
    for (size_t i = 0; i < p; i++) {
        state->l[i] *= shrink;
        state->s[i] = 1 - optimum_dot(problem->rows + i * n, state->t, n);
    }
}

/* B diag(t / y) B' + diag(s / l), factored. */
static void factor(const center_problem *problem, center_state *state)
{
    const size_t p = problem->n_rows, n = problem->n_columns;
    for (size_t k = 0; k < n; k++) {
        state->ratios[k] = state->t[k] / state->y[k];
    }
    for (size_t i = 0; i < p; i++) {
        const double *row = problem->rows + i * n;
        for (size_t k = 0; k < n; k++) {
            state->dt[k] = state->ratios[k] * row[k];
        }
        for (size_t j = 0; j <= i; j++) {
            state->matrix[i * p + j] = optimum_dot(problem->rows + j * n, state->dt, n);
        }
        state->matrix[i * p + i] += state->s[i] / state->l[i];
    }
    optimum_factor(state->matrix, p, state->pivots);
}

/*
 * The step that takes t y to y targets and l s to l complements, to first order, and keeps B t + s = 1, y =
 * B'l.
 */
static void find_step(const center_problem *problem, center_state *state)
{
    const size_t p = problem->n_rows, n = problem->n_columns;
    for (size_t i = 0; i < p; i++) {
        state->dl[i] = (optimum_dot(problem->rows + i * n, state->targets, n) - 1) + state->complements[i];
    }
    optimum_factor_solve(state->matrix, p, state->pivots, state->dl);
    transposed_product(problem, state->dl, state->dy);
    for (size_t k = 0; k < n; k++) {
        state->dt[k] = state->targets[k] - state->t[k] - state->ratios[k] * state->dy[k];
    }
    for (size_t i = 0; i < p; i++) {
        state->ds[i] = state->complements[i] - state->s[i] - state->s[i] / state->l[i] * state->dl[i];
    }
}

/* The longest step, at most 1, that leaves `share` of every way to 0 unused. */
static double step_length(double length, const double x[], const double dx[], size_t n, double share)
{
    for (size_t i = 0; i < n; i++) {
        if (-dx[i] * length > (1 - share) * x[i]) {
            length = (1 - share) * x[i] / -dx[i];
        }
    }
    return length;
}

static double length_of(const center_problem *problem, const center_state *state, double share)
{
    double length = 1;
    length = step_length(length, state->s, state->ds, problem->n_rows, share);
    length = step_length(length, state->l, state->dl, problem->n_rows, share);
    length = step_length(length, state->t, state->dt, problem->n_columns, share);
    return step_length(length, state->y, state->dy, problem->n_columns, share);
}

static double mean_product(const center_problem *problem, const center_state *state)
{
    return optimum_dot(state->l, state->s, problem->n_rows) / (double)problem->n_rows;
}

/* The mean of l s that the step would lead to. */
static double mean_after(const center_problem *problem, const center_state *state, double length)
{
    double sum = 0;
    for (size_t i = 0; i < problem->n_rows; i++) {
        sum += (state->l[i] + length * state->dl[i]) * (state->s[i] + length * state->ds[i]);
    }
    return sum / (double)problem->n_rows;
}

/*
 * Where to go for l s = mu; curved: the second-order part of the products, as the last step tells it, allowed
 * for. The products t y of small weights come down together with mu, lest they get in its way.
 */
static void aim(const center_problem *problem, center_state *state, double mu, bool curved)
{
    for (size_t k = 0; k < problem->n_columns; k++) {
        const double product = fmax(problem->weights[k], mu);
        state->targets[k] = (product - (curved ? state->dt[k] * state->dy[k] : 0)) / state->y[k];
    }
    for (size_t i = 0; i < problem->n_rows; i++) {
        state->complements[i] = (mu - (curved ? state->dl[i] * state->ds[i] : 0)) / state->l[i];
    }
}

static void take_step(const center_problem *problem, center_state *state, double length)
{
    optimum_add_multiple(state->t, length, state->dt, problem->n_columns);
    optimum_add_multiple(state->s, length, state->ds, problem->n_rows);
    optimum_add_multiple(state->l, length, state->dl, problem->n_rows);
    transposed_product(problem, state->l, state->y);
}

bool optimum_binds(const center_state *state, size_t row)
{
    return state->s[row] <= negligible;
}

/* Whether a multiplier could be 0 and y would hardly change. */
static bool is_idle(const center_problem *problem, const center_state *state, size_t row)
{
    const double *elements = problem->rows + row * problem->n_columns;
    bool idle = true;
    for (size_t k = 0; k < problem->n_columns; k++) {
        idle = idle && state->l[row] * elements[k] <= negligible * state->y[k];
    }
    return idle;
}

static bool is_solved(const center_problem *problem, const center_state *state)
{
    bool solved = true;
    for (size_t k = 0; solved && k < problem->n_columns; k++) {
        solved = fabs(state->t[k] * state->y[k] - problem->weights[k]) <= negligible * problem->weights[k];
    }
    for (size_t i = 0; solved && i < problem->n_rows; i++) {
        solved = optimum_binds(state, i) || is_idle(problem, state, i);
    }
    return solved;
}

/* First straight for mu = 0, to learn how far mu can be lowered and how the products curve; then for it. */
static void aim_far(const center_problem *problem, center_state *state, double mu)
{
    aim(problem, state, 0, false);
    find_step(problem, state);
    const double left = mean_after(problem, state, length_of(problem, state, 0)) / mu;
    aim(problem, state, left * left * left * mu, true);
}

static void step(const center_problem *problem, center_state *state, bool careful)
{
    const double mu = mean_product(problem, state);
    const double share = fmin(0.005, fmax(mu, 1e-8));
    factor(problem, state);
    if (careful) {
        aim(problem, state, careful_reduction * mu, false);
    } else {
        aim_far(problem, state, mu);
    }
    find_step(problem, state);
    take_step(problem, state, length_of(problem, state, share));
}

bool optimum_center(const center_problem *problem, center_state *state)
{
    start(problem, state);
    for (int i = 0; i < MOST_ITERATIONS; i++) {
        if (is_solved(problem, state)) {
            return true;
        }
        step(problem, state, i >= CAREFUL_FROM);
    }
    return false;
}
