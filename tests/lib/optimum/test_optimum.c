#include "armtol/error_matrix.h"
#include "armtol/optimum.h"
#include "armtol/robots.h"

#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ROWS = 600, MOST_COLUMNS = 50 };

typedef struct problem {
    armtol_sum sum;
    size_t n_rows, n_columns;
    double matrix[MOST_ROWS * MOST_COLUMNS];
    double limits[MOST_ROWS];
    double weights[MOST_COLUMNS];
} problem;

typedef struct solution {
    double tolerances[MOST_COLUMNS];
    double multipliers[MOST_ROWS];
} solution;

/* Large, and one of each is enough: what the tests solve, and what they solve to compare. */
static problem given, changed;
static solution found, other;
static double *workspace;

void setUp(void)
{
    workspace = NULL;
}

void tearDown(void)
{
    free(workspace);
}

/* ---- solving and checking ---- */

/* Exactly as much to work in as asked for, full of what would spoil a result that depended on it. */
static armtol_status find_optimum(const problem *problem, solution *solution)
{
    const size_t size = armtol_optimum_workspace(problem->n_rows, problem->n_columns);
    free(workspace);
    workspace = malloc(size > 0 ? size * sizeof *workspace : 1);
    TEST_ASSERT_NOT_NULL(workspace);
    for (size_t i = 0; i < size; i++) {
        workspace[i] = NAN;
    }
    return armtol_optimum(problem->sum, problem->matrix, problem->n_rows, problem->n_columns,
                           problem->limits, problem->weights, solution->tolerances, solution->multipliers,
                           workspace);
}

/* The part of row i's limit that column k takes. */
static long double part(const problem *problem, const solution *solution, size_t i, size_t k)
{
    if (isinf(problem->limits[i]) || isinf(solution->tolerances[k])) {
        return 0;
    }
    const long double element = fabs(problem->matrix[i * problem->n_columns + k]);
    const long double error = element * (long double)solution->tolerances[k];
    const long double ratio = error / (long double)problem->limits[i];
    return problem->sum == ARMTOL_ROOT_SUM_SQUARES ? ratio * ratio : ratio;
}

static long double used(const problem *problem, const solution *solution, size_t i)
{
    long double sum = 0;
    for (size_t k = 0; k < problem->n_columns; k++) {
        sum += part(problem, solution, i, k);
    }
    return sum;
}

/* What a user computes: the products of a row summed in the order of the columns. */
static double plain_error(const problem *problem, const solution *solution, size_t i)
{
    double sum = 0;
    for (size_t k = 0; k < problem->n_columns; k++) {
        if (!isinf(solution->tolerances[k])) {
            const double element = fabs(problem->matrix[i * problem->n_columns + k]);
            const double product = element * solution->tolerances[k];
            sum += problem->sum == ARMTOL_ROOT_SUM_SQUARES ? product * product : product;
        }
    }
    return problem->sum == ARMTOL_ROOT_SUM_SQUARES ? sqrt(sum) : sum;
}

static bool is_bounded(const problem *problem, size_t k)
{
    for (size_t i = 0; i < problem->n_rows; i++) {
        const double *row = problem->matrix + i * problem->n_columns;
        if (!isinf(problem->limits[i]) && row[k] != 0) {
            return true;
        }
    }
    return false;
}

static long double bounded_weight(const problem *problem)
{
    long double sum = 0;
    for (size_t k = 0; k < problem->n_columns; k++) {
        sum += is_bounded(problem, k) ? (long double)problem->weights[k] : 0;
    }
    return sum;
}

static void check_rows(const problem *problem, const solution *solution, const char *what)
{
    long double sum = 0;
    for (size_t i = 0; i < problem->n_rows; i++) {
        const double multiplier = solution->multipliers[i];
        if (!(plain_error(problem, solution, i) <= problem->limits[i])) {
            check_same(problem->limits[i], plain_error(problem, solution, i), "%s: row %zu", what, i);
        }
        if (!(multiplier >= 0)) {
            check_same(0, multiplier, "%s: multiplier of row %zu", what, i);
        }
        if (multiplier > 0) {
            check_within(3e-12, 1, (double)used(problem, solution, i), "%s: use of row %zu, which binds",
                         what, i);
        }
        sum += (long double)multiplier;
    }
    check_within(1e-14, bounded_weight(problem) > 0 ? 1 : 0, (double)sum, "%s: sum of multipliers", what);
}

static void check_columns(const problem *problem, const solution *solution, const char *what)
{
    const long double weight = bounded_weight(problem);
    for (size_t k = 0; k < problem->n_columns; k++) {
        if (!is_bounded(problem, k)) {
            TEST_ASSERT_TRUE_MESSAGE(isinf(solution->tolerances[k]) && solution->tolerances[k] > 0, what);
            continue;
        }
        long double held = 0;
        for (size_t i = 0; i < problem->n_rows; i++) {
            held += (long double)solution->multipliers[i] * part(problem, solution, i, k);
        }
        check_within(1e-11, 1, (double)(held * weight / (long double)problem->weights[k]),
                     "%s: what holds down column %zu, by its weight", what, k);
    }
}

/*
 * The conditions that only the optimum fulfils: limits kept, multipliers >= 0 and only where the limit is
 * used up, and every column held down as hard as its weight pushes.
 */
static void check_optimal(const problem *problem, const solution *solution, const char *what)
{
    check_rows(problem, solution, what);
    check_columns(problem, solution, what);
}

static void solve(const problem *problem, solution *solution, const char *what)
{
    for (size_t k = 0; k < problem->n_columns; k++) {
        solution->tolerances[k] = NAN; /* it is only written */
    }
    TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_OK, find_optimum(problem, solution), what);
    check_optimal(problem, solution, what);
}

static void check_tolerances(const problem *problem, const solution *expected, const solution *actual,
                             double relative, const char *what)
{
    for (size_t k = 0; k < problem->n_columns; k++) {
        const double t = expected->tolerances[k];
        if (!(t == actual->tolerances[k])) {
            check_within(relative * t, t, actual->tolerances[k], "%s: tolerance %zu", what, k);
        }
    }
}

/* ---- problems ---- */

static void shape(problem *problem, armtol_sum sum, size_t n_rows, size_t n_columns)
{
    problem->sum = sum;
    problem->n_rows = n_rows;
    problem->n_columns = n_columns;
    for (size_t i = 0; i < n_rows; i++) {
        problem->limits[i] = 1;
    }
    for (size_t k = 0; k < n_columns; k++) {
        problem->weights[k] = 1;
    }
}

static void set(problem *problem, armtol_sum sum, size_t n_rows, size_t n_columns, const double matrix[])
{
    shape(problem, sum, n_rows, n_columns);
    memcpy(problem->matrix, matrix, n_rows * n_columns * sizeof *matrix);
}

static double power_of_ten(random_source *source, double low, double high)
{
    return pow(10, random_between(source, low, high));
}

/* Of every sort: large and small elements, zeros, rows that come twice or follow from others, free rows. */
static void draw(random_source *source, problem *problem, size_t most_rows, size_t most_columns)
{
    const size_t n_rows = (size_t)random_between(source, 1, (double)most_rows + 1);
    const size_t n_columns = (size_t)random_between(source, 1, (double)most_columns + 1);
    const double spread = random_between(source, 0, 1) < 0.5 ? 0 : 3;
    const double zeros = random_between(source, 0, 1) < 0.5 ? 0 : random_between(source, 0, 0.9);
    const double weights = random_between(source, 0, 1) < 0.5 ? 0 : 6;
    const double repeated = random_between(source, 0, 1) < 0.7 ? 0 : 0.5;
    shape(problem, random_between(source, 0, 1) < 0.5 ? ARMTOL_WORST_CASE : ARMTOL_ROOT_SUM_SQUARES, n_rows,
          n_columns);
    for (size_t k = 0; k < n_columns; k++) {
        problem->weights[k] = power_of_ten(source, -weights, weights);
    }
    for (size_t i = 0; i < n_rows; i++) {
        double *row = problem->matrix + i * n_columns;
        problem->limits[i] = power_of_ten(source, -spread, spread);
        for (size_t k = 0; k < n_columns; k++) {
            const double element = random_between(source, -1, 1) * power_of_ten(source, -spread, spread);
            row[k] = random_between(source, 0, 1) < zeros ? 0 : element;
        }
        if (i > 0 && random_between(source, 0, 1) < repeated) {
            const size_t before = (size_t)random_between(source, 0, (double)i);
            memcpy(row, problem->matrix + before * n_columns, n_columns * sizeof *row);
            problem->limits[i] = problem->limits[before] * (random_between(source, 0, 1) < 0.5 ? 1 : 2);
        }
        if (random_between(source, 0, 1) < 0.03) {
            problem->limits[i] = INFINITY;
        }
    }
}

/*
 * A of the Intelledex in random poses, one below the other; limits .5 mm and .001 rad; unit: millimetres in
 * one.
 */
static void draw_poses(random_source *source, problem *problem, size_t n_poses, double unit)
{
    armtol_link links[8], placed[8];
    armtol_intelledex_605t.links(&armtol_errata_none, links);
    const size_t n_columns = armtol_column_count(links, 8);
    shape(problem, ARMTOL_WORST_CASE, 6 * n_poses, n_columns);
    for (size_t i = 0; i < 8; i++) {
        links[i].a /= unit;
        links[i].d /= unit;
    }
    for (size_t pose = 0; pose < n_poses; pose++) {
        double q[6];
        for (int j = 0; j < 6; j++) {
            q[j] = random_between(source, -3, 3);
        }
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(links, 8, q, 6, &armtol_errata_none, placed));
        double *a = problem->matrix + pose * 6 * n_columns;
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_error_matrix(placed, 8, &armtol_errata_none, a, n_columns));
        for (size_t i = 0; i < 6; i++) {
            problem->limits[pose * 6 + i] = i < 3 ? 0.5 / unit : 0.001;
        }
    }
}

/* ---- closed forms ---- */

static void test_one_row_parts_its_limit_by_weight(void)
{
    static const double row[4] = {3, -0.5, 1000, 2e-5}, weights[4] = {1, 2, 4, 0.5};
    set(&given, ARMTOL_WORST_CASE, 1, 4, row);
    given.limits[0] = 0.3;
    memcpy(given.weights, weights, sizeof weights);
    solve(&given, &found, "one row");
    for (size_t k = 0; k < 4; k++) {
        const double expected = weights[k] * 0.3 / (7.5 * fabs(row[k]));
        check_within(1e-12 * expected, expected, found.tolerances[k], "worst case, column %zu", k);
    }
    given.sum = ARMTOL_ROOT_SUM_SQUARES;
    solve(&given, &found, "one row");
    for (size_t k = 0; k < 4; k++) {
        const double expected = 0.3 * sqrt(weights[k] / 7.5) / fabs(row[k]);
        check_within(1e-12 * expected, expected, found.tolerances[k], "root of squares, column %zu", k);
    }
}

/*
 * t1 + t2 <= 1, t1 <= b. Where b < 1/2 both bind: t2 = 1 - b holds l1 = (1 - b)^-1 / 2. Else only the first
 * does.
 */
static void test_two_rows_of_which_one_or_both_bind(void)
{
    static const double matrix[4] = {1, 1, 1, 0};
    set(&given, ARMTOL_WORST_CASE, 2, 2, matrix);
    given.limits[1] = 0.25;
    solve(&given, &found, "both bind");
    check_within(1e-13, 0.25, found.tolerances[0], "t1");
    check_within(1e-13, 0.75, found.tolerances[1], "t2");
    check_within(1e-12, 2.0 / 3, found.multipliers[0], "first row");
    check_within(1e-12, 1.0 / 3, found.multipliers[1], "second row");
    given.limits[1] = 0.75;
    solve(&given, &found, "one binds");
    check_within(1e-13, 0.5, found.tolerances[0], "t1");
    check_within(1e-13, 0.5, found.tolerances[1], "t2");
    check_same(0, found.multipliers[1], "the row that does not bind");
    /* squares: u1 = 1/4 and u2 = 3/4 */
    given.sum = ARMTOL_ROOT_SUM_SQUARES;
    given.limits[1] = 0.5;
    solve(&given, &found, "squares");
    check_within(1e-13, 0.5, found.tolerances[0], "t1");
    check_within(1e-13, sqrt(0.75), found.tolerances[1], "t2");
    check_within(1e-12, 2.0 / 3, found.multipliers[0], "first row");
}

/*
 * 2 t1 + t2 <= 1, t1 + 2 t2 <= 1: the corner (1/3, 1/3) for weights from 1:2 to 2:1, beyond it one row parts
 * by weight.
 */
static void test_a_corner_is_optimal_for_a_range_of_weights(void)
{
    static const double matrix[4] = {2, 1, 1, 2};
    set(&given, ARMTOL_WORST_CASE, 2, 2, matrix);
    for (int i = 0; i < 10; i++) {
        const double w = 0.05 + 0.1 * i;
        given.weights[0] = w;
        given.weights[1] = 1 - w;
        solve(&given, &found, "corner");
        const double t1 = w < 1.0 / 3 ? w : w > 2.0 / 3 ? w / 2 : 1.0 / 3;
        const double t2 = w < 1.0 / 3 ? (1 - w) / 2 : w > 2.0 / 3 ? 1 - w : 1.0 / 3;
        check_within(1e-13, t1, found.tolerances[0], "t1 for weight %g", w);
        check_within(1e-13, t2, found.tolerances[1], "t2 for weight %g", w);
        check_within(1e-11, fmin(fmax(3 * w - 1, 0), 1), found.multipliers[0], "multiplier for weight %g", w);
    }
}

/* At weights 1:2 the second row alone has its optimum on the first: that binds, and holds nothing. */
static void test_a_row_may_bind_and_hold_nothing(void)
{
    static const double matrix[4] = {2, 1, 1, 2};
    set(&given, ARMTOL_WORST_CASE, 2, 2, matrix);
    given.weights[0] = 1;
    given.weights[1] = 2;
    solve(&given, &found, "edge");
    check_within(1e-10, 1.0 / 3, found.tolerances[0], "t1");
    check_within(1e-10, 1.0 / 3, found.tolerances[1], "t2");
    check_within(1e-9, 0, found.multipliers[0], "first row");
}

static void test_one_column_gets_what_its_tightest_row_allows(void)
{
    static const double matrix[3] = {2, -8, 0.1};
    set(&given, ARMTOL_WORST_CASE, 3, 1, matrix);
    given.limits[2] = 0.0025;
    solve(&given, &found, "one column");
    check_within(1e-15, 0.025, found.tolerances[0], "tolerance");
    check_within(1e-14, 1, found.multipliers[2], "multiplier");
}

/* ---- odd rows and columns ---- */

static void test_equal_rows_share_a_multiplier(void)
{
    static const double matrix[6] = {1, 3, 1, 3, -1, 3};
    set(&given, ARMTOL_WORST_CASE, 3, 2, matrix);
    solve(&given, &found, "equal rows");
    check_within(1e-13, 0.5, found.tolerances[0], "t1");
    check_within(1e-13, 1.0 / 6, found.tolerances[1], "t2");
}

static void test_equal_columns_get_equal_tolerances(void)
{
    static const double matrix[6] = {1, 2, 1, 5, 1, 5};
    set(&given, ARMTOL_ROOT_SUM_SQUARES, 2, 3, matrix);
    given.limits[1] = 3;
    solve(&given, &found, "equal columns");
    check_within(1e-14, found.tolerances[0], found.tolerances[2], "third column");
}

static void test_rows_that_bound_nothing_change_nothing(void)
{
    static const double two[4] = {1, 1, 1, 0};
    static const double more[12] = {0, 0, 1, 1, 100, 100, 1, 0, 0.5, 0.5, 0, 0};
    set(&given, ARMTOL_WORST_CASE, 2, 2, two);
    given.limits[1] = 0.25;
    solve(&given, &found, "two rows");
    set(&changed, ARMTOL_WORST_CASE, 6, 2, more);
    changed.limits[2] = INFINITY;
    changed.limits[3] = 0.25;
    solve(&changed, &other, "zeros, a free row, a row that follows from another");
    check_tolerances(&given, &found, &other, 1e-12, "with more rows");
    for (size_t i = 0; i < 6; i++) {
        if (i != 1 && i != 3) {
            check_same(0, other.multipliers[i], "multiplier of row %zu", i);
        }
    }
}

static void check_all_infinite(size_t n_rows, const char *what)
{
    TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_OK, find_optimum(&given, &found), what);
    for (size_t k = 0; k < given.n_columns; k++) {
        TEST_ASSERT_TRUE_MESSAGE(isinf(found.tolerances[k]) && found.tolerances[k] > 0, what);
    }
    for (size_t i = 0; i < n_rows; i++) {
        check_same(0, found.multipliers[i], "%s: multiplier %zu", what, i);
    }
}

static void test_nothing_is_bounded_where_no_row_bounds(void)
{
    static const double matrix[4] = {1, 2, 3, 4}, zeros[4] = {0, 0, 0, 0};
    set(&given, ARMTOL_WORST_CASE, 2, 2, matrix);
    given.limits[0] = given.limits[1] = INFINITY;
    check_all_infinite(2, "free rows");
    set(&given, ARMTOL_ROOT_SUM_SQUARES, 2, 2, zeros);
    check_all_infinite(2, "zeros");
    shape(&given, ARMTOL_WORST_CASE, 0, 3);
    check_all_infinite(0, "no rows");
    shape(&given, ARMTOL_WORST_CASE, 2, 0);
    check_all_infinite(2, "no columns");
}

/* However small an element is: what is rounding and what is not is known to whoever made the matrix. */
static void test_only_a_zero_bounds_nothing(void)
{
    static const double matrix[6] = {1000, 1, 0, 1, 1, 1};
    set(&given, ARMTOL_WORST_CASE, 2, 3, matrix);
    given.limits[1] = INFINITY;
    solve(&given, &found, "zero");
    TEST_ASSERT_TRUE(isinf(found.tolerances[2]));
    check_within(1e-15, 1.0 / 2000, found.tolerances[0], "t1");
    check_within(1e-12, 0.5, found.tolerances[1], "t2");
    for (int n = 1; n <= 6; n++) {
        const double element = pow(1000, -n);
        given.matrix[2] = element;
        solve(&given, &found, "small");
        check_within(1e-9 / element, 1 / (3 * element), found.tolerances[2], "t3, %g", element);
        check_within(1e-12, 1.0 / 3000, found.tolerances[0], "t1, %g", element);
    }
    given.matrix[2] = 0;
    given.limits[1] = 1e6;
    solve(&given, &found, "zero in one row, not in another");
    check_within(1e-3 / 3e-9, 1e6, found.tolerances[2], "t3, bounded by the second row");
}

/* ---- at random ---- */

static void test_the_optimum_of_random_problems(void)
{
    random_source source = {1};
    for (int i = 0; i < 400; i++) {
        char what[40];
        snprintf(what, sizeof what, "problem %d", i);
        draw(&source, &given, i < 300 ? 24 : 100, i < 300 ? 50 : 30);
        solve(&given, &found, what);
    }
}

static void test_the_optimum_of_large_random_problems(void)
{
    random_source source = {2};
    for (int i = 0; i < 12; i++) {
        char what[40];
        snprintf(what, sizeof what, "large problem %d", i);
        draw(&source, &given, MOST_ROWS, MOST_COLUMNS);
        solve(&given, &found, what);
    }
}

/* Problems in which the solver's long steps alone go in circles. */
static void test_the_optimum_where_long_steps_do_not_get_there(void)
{
    static const uint64_t seeds[] = {98, 1069, 1562, 1571, 2523, 4221};
    for (size_t i = 0; i < sizeof seeds / sizeof seeds[0]; i++) {
        random_source source = {seeds[i]};
        draw(&source, &given, 24, 20);
        solve(&given, &found, "hard to solve");
    }
}

/* Any t is optimal for the weights that it gives multipliers; here with more rows that bind than columns. */
static void test_more_rows_bind_than_there_are_columns(void)
{
    random_source source = {3};
    for (int round = 0; round < 20; round++) {
        shape(&given, round % 2 == 0 ? ARMTOL_WORST_CASE : ARMTOL_ROOT_SUM_SQUARES, round < 10 ? 20 : 200, 5);
        double held[5] = {0, 0, 0, 0, 0}, t[5];
        for (size_t k = 0; k < 5; k++) {
            t[k] = power_of_ten(&source, -2, 2);
        }
        for (size_t i = 0; i < given.n_rows; i++) {
            double *row = given.matrix + i * 5, sum = 0;
            for (size_t k = 0; k < 5; k++) {
                row[k] = random_between(&source, 0, 1) / t[k];
                const double product = row[k] * t[k];
                sum += given.sum == ARMTOL_WORST_CASE ? product : product * product;
            }
            given.limits[i] = given.sum == ARMTOL_WORST_CASE ? sum : sqrt(sum);
            for (size_t k = 0; k < 5; k++) {
                const double product = row[k] * t[k];
                held[k] += (given.sum == ARMTOL_WORST_CASE ? product : product * product) / sum;
            }
        }
        memcpy(given.weights, held, sizeof held);
        solve(&given, &found, "many rows bind");
        for (size_t k = 0; k < 5; k++) {
            check_within(1e-10 * t[k], t[k], found.tolerances[k], "round %d, tolerance %zu", round, k);
        }
    }
}

/* ---- units and order ---- */

static void test_powers_of_two_change_no_bit(void)
{
    random_source source = {4};
    for (int round = 0; round < 20; round++) {
        draw(&source, &given, 60, 20);
        solve(&given, &found, "as drawn");
        changed = given;
        double scales[MOST_COLUMNS];
        for (size_t k = 0; k < given.n_columns; k++) {
            scales[k] = ldexp(1, (int)random_between(&source, -10, 11));
            changed.weights[k] *= 0.125;
        }
        for (size_t i = 0; i < given.n_rows; i++) {
            const double scale = ldexp(1, (int)random_between(&source, -10, 11));
            changed.limits[i] *= scale;
            for (size_t k = 0; k < given.n_columns; k++) {
                /* not so far that an element would come to count, or no longer */
                changed.matrix[i * given.n_columns + k] *= scale * scales[k];
            }
        }
        solve(&changed, &other, "scaled");
        for (size_t k = 0; k < given.n_columns; k++) {
            check_same(found.tolerances[k], other.tolerances[k] * scales[k], "tolerance %zu", k);
        }
        for (size_t i = 0; i < given.n_rows; i++) {
            check_same(found.multipliers[i], other.multipliers[i], "multiplier %zu", i);
        }
    }
}

static void test_the_order_of_rows_and_columns_does_not_matter(void)
{
    random_source source = {5};
    for (int round = 0; round < 20; round++) {
        draw(&source, &given, 60, 20);
        solve(&given, &found, "as drawn");
        changed = given;
        const size_t m = given.n_rows, n = given.n_columns;
        for (size_t i = 0; i < m; i++) {
            changed.limits[i] = given.limits[m - 1 - i];
            for (size_t k = 0; k < n; k++) {
                changed.matrix[i * n + k] = given.matrix[(m - 1 - i) * n + (n - 1 - k)];
                changed.weights[k] = given.weights[n - 1 - k];
            }
        }
        solve(&changed, &other, "reversed");
        for (size_t k = 0; k < n; k++) {
            const double t = found.tolerances[k];
            if (!isinf(t)) {
                check_within(1e-9 * t, t, other.tolerances[n - 1 - k], "round %d, tolerance %zu", round, k);
            }
        }
    }
}

/* Row by row and column by column by factors of up to 1e6, and lengths in metres. */
static void test_units_do_not_matter(void)
{
    random_source source = {6};
    draw_poses(&source, &given, 50, 1);
    source.state = 6;
    draw_poses(&source, &changed, 50, 1000);
    solve(&given, &found, "millimetres");
    solve(&changed, &other, "metres");
    armtol_link links[8];
    armtol_column columns[40];
    armtol_intelledex_605t.links(&armtol_errata_none, links);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_columns(links, 8, columns, given.n_columns));
    for (size_t k = 0; k < given.n_columns; k++) {
        const double unit = armtol_parameter_is_length(columns[k].parameter) ? 1000 : 1;
        const double t = found.tolerances[k];
        check_within(1e-10 * t, t, unit * other.tolerances[k], "tolerance %zu", k);
    }
}

static void test_huge_and_tiny_numbers_are_no_trouble(void)
{
    static const double matrix[4] = {2, 1, 1, 2};
    for (int exponent = -270; exponent <= 270; exponent += 30) {
        for (int sum = 0; sum < ARMTOL_SUM_COUNT; sum++) {
            set(&given, (armtol_sum)sum, 2, 2, matrix);
            solve(&given, &found, "as it is");
            for (size_t i = 0; i < 4; i++) {
                given.matrix[i] *= pow(10, exponent);
            }
            TEST_ASSERT_EQUAL_INT(ARMTOL_OK, find_optimum(&given, &other));
            check_within(1e-12, found.tolerances[0], other.tolerances[0] * pow(10, exponent), "elements");
            given.limits[0] = given.limits[1] = pow(10, exponent);
            given.weights[0] = given.weights[1] = 1.7e308;
            TEST_ASSERT_EQUAL_INT(ARMTOL_OK, find_optimum(&given, &other));
            check_within(1e-12, found.tolerances[0], other.tolerances[0], "elements and limits");
        }
    }
}

/* As documented: n_rows and about c (c + n_columns), c being the lesser of n_rows and 3 n_columns + 24. */
static void test_the_workspace_goes_with_the_lesser_number(void)
{
    static const size_t columns[] = {1, 24, 35, 200}, rows[] = {1, 6, 18, 96, 600, 6000};
    for (size_t i = 0; i < sizeof columns / sizeof columns[0]; i++) {
        for (size_t j = 0; j < sizeof rows / sizeof rows[0]; j++) {
            const size_t most = 3 * columns[i] + 24, c = rows[j] < most ? rows[j] : most;
            const double size = (double)armtol_optimum_workspace(rows[j], columns[i]);
            const double told = (double)(rows[j] + c * (c + columns[i]));
            TEST_ASSERT_TRUE(size >= told && size <= told + 10 * (double)(c + columns[i]));
        }
    }
}

static void test_what_was_in_the_workspace_does_not_matter(void)
{
    random_source source = {7};
    draw(&source, &given, MOST_ROWS, MOST_COLUMNS);
    const size_t size = armtol_optimum_workspace(given.n_rows, given.n_columns);
    solve(&given, &found, "nan in the workspace");
    for (size_t i = 0; i < size; i++) {
        workspace[i] = 0.3;
    }
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_optimum(given.sum, given.matrix, given.n_rows, given.n_columns,
                                                     given.limits, given.weights, other.tolerances,
                                                     other.multipliers, workspace));
    check_tolerances(&given, &found, &other, 0, "numbers in the workspace");
}

/* ---- many poses ---- */

static void test_many_poses(void)
{
    random_source source = {8};
    for (int sum = 0; sum < ARMTOL_SUM_COUNT; sum++) {
        draw_poses(&source, &given, MOST_ROWS / 6, 1);
        given.sum = (armtol_sum)sum;
        solve(&given, &found, "100 poses");
    }
}

/*
 * Only rows with a multiplier matter: alone, few enough to be taken all at once, they have the same optimum.
 */
static void test_a_large_problem_is_that_of_the_rows_that_bind(void)
{
    random_source source = {9};
    draw_poses(&source, &given, MOST_ROWS / 6, 1);
    solve(&given, &found, "all rows");
    shape(&changed, given.sum, 0, given.n_columns);
    for (size_t i = 0; i < given.n_rows; i++) {
        if (found.multipliers[i] > 0) {
            changed.limits[changed.n_rows] = given.limits[i];
            memcpy(changed.matrix + changed.n_rows * given.n_columns, given.matrix + i * given.n_columns,
                   given.n_columns * sizeof *given.matrix);
            changed.n_rows++;
        }
    }
    TEST_ASSERT_TRUE(changed.n_rows > 1 && changed.n_rows <= 24);
    solve(&changed, &other, "rows that bind");
    check_tolerances(&given, &found, &other, 1e-10, "rows that bind");
}

/* The same pose a hundred times, and again with rows a hair apart. */
static void test_poses_that_are_alike(void)
{
    random_source source = {10};
    draw_poses(&source, &given, 1, 1);
    solve(&given, &found, "one pose");
    for (int hair = 0; hair < 2; hair++) {
        changed = given;
        changed.n_rows = MOST_ROWS;
        for (size_t i = 0; i < MOST_ROWS; i++) {
            changed.limits[i] = given.limits[i % 6];
            for (size_t k = 0; k < given.n_columns; k++) {
                const double factor = hair ? 1 - random_between(&source, 0, 1e-11) : 1;
                const double element = given.matrix[(i % 6) * given.n_columns + k];
                changed.matrix[i * given.n_columns + k] = element * factor;
            }
        }
        solve(&changed, &other, hair ? "nearly the same pose" : "the same pose");
        check_tolerances(&given, &found, &other, 2e-11, "the same pose");
    }
}

/* The third row is not the tightest of any column, and the first two alone violate it by 1e-10. */
static void test_a_row_that_is_hardly_violated_counts(void)
{
    shape(&given, ARMTOL_WORST_CASE, 60, 2);
    memset(given.matrix, 0, sizeof given.matrix);
    given.matrix[0] = given.matrix[3] = 1;
    given.matrix[80] = given.matrix[81] = 0.5 + 5e-11;
    solve(&given, &found, "hardly violated");
    check_within(1e-11, 1, found.multipliers[40], "multiplier");
}

/* ---- errors ---- */

static void check_refused(armtol_status expected, const char *what)
{
    for (size_t k = 0; k < given.n_columns; k++) {
        found.tolerances[k] = 42;
    }
    for (size_t i = 0; i < given.n_rows; i++) {
        found.multipliers[i] = 42;
    }
    TEST_ASSERT_EQUAL_INT_MESSAGE(expected, find_optimum(&given, &found), what);
    for (size_t k = 0; k < given.n_columns; k++) {
        check_same(42, found.tolerances[k], "%s: tolerance %zu", what, k);
    }
    for (size_t i = 0; i < given.n_rows; i++) {
        check_same(42, found.multipliers[i], "%s: multiplier %zu", what, i);
    }
}

static void test_wrong_input_is_refused(void)
{
    static const double matrix[6] = {1, 2, 3, 4, 5, 6};
    static const double bad[3] = {NAN, INFINITY, -INFINITY}, not_positive[3] = {0, -1, -INFINITY};
    for (size_t at = 0; at < 6; at++) {
        for (size_t i = 0; i < 3; i++) {
            set(&given, ARMTOL_WORST_CASE, 3, 2, matrix);
            given.matrix[at] = bad[i];
            check_refused(ARMTOL_NOT_FINITE, "matrix");
            set(&given, ARMTOL_WORST_CASE, 3, 2, matrix);
            given.weights[at % 2] = bad[i];
            check_refused(ARMTOL_NOT_FINITE, "weight");
            set(&given, ARMTOL_WORST_CASE, 3, 2, matrix);
            given.weights[at % 2] = i < 2 ? not_positive[i] : -0.0;
            check_refused(ARMTOL_BAD_WEIGHT, "weight");
            set(&given, ARMTOL_WORST_CASE, 3, 2, matrix);
            given.limits[at % 3] = not_positive[i];
            check_refused(ARMTOL_BAD_TOLERANCE, "limit");
        }
        set(&given, ARMTOL_WORST_CASE, 3, 2, matrix);
        given.limits[at % 3] = NAN;
        check_refused(ARMTOL_NOT_FINITE, "limit");
        given.limits[at % 3] = at < 3 ? 1e-300 : 1e300;
        check_refused(ARMTOL_NOT_FINITE, "limit out of range");
    }
    set(&given, ARMTOL_WORST_CASE, 3, 2, matrix);
    for (size_t i = 0; i < 6; i++) {
        given.matrix[i] *= 1e290;
    }
    check_refused(ARMTOL_NOT_FINITE, "tolerances that underflow");
    for (size_t i = 0; i < 6; i++) {
        given.matrix[i] = matrix[i] * 1e-290;
    }
    check_refused(ARMTOL_NOT_FINITE, "tolerances that overflow");
    for (size_t i = 0; i < 2; i++) {
        const double one_far[4] = {i == 0 ? 1e290 : 1, 0, 0, i == 1 ? 1e290 : 1};
        set(&given, ARMTOL_WORST_CASE, 2, 2, one_far);
        check_refused(ARMTOL_NOT_FINITE, "one tolerance that underflows");
        given.limits[i] = 1e-20; /* beyond what a double holds: no tolerance of 0 is one without a bound */
        check_refused(ARMTOL_NOT_FINITE, "one tolerance that is 0");
    }
    set(&given, ARMTOL_WORST_CASE, 1, 2, matrix);
    given.matrix[0] = given.matrix[1] = 1e279;
    given.weights[1] = 1e-10;
    check_refused(ARMTOL_NOT_FINITE, "a tolerance that its weight makes underflow");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_one_row_parts_its_limit_by_weight);
    RUN_TEST(test_two_rows_of_which_one_or_both_bind);
    RUN_TEST(test_a_corner_is_optimal_for_a_range_of_weights);
    RUN_TEST(test_a_row_may_bind_and_hold_nothing);
    RUN_TEST(test_one_column_gets_what_its_tightest_row_allows);
    RUN_TEST(test_equal_rows_share_a_multiplier);
    RUN_TEST(test_equal_columns_get_equal_tolerances);
    RUN_TEST(test_rows_that_bound_nothing_change_nothing);
    RUN_TEST(test_nothing_is_bounded_where_no_row_bounds);
    RUN_TEST(test_only_a_zero_bounds_nothing);
    RUN_TEST(test_the_optimum_of_random_problems);
    RUN_TEST(test_the_optimum_of_large_random_problems);
    RUN_TEST(test_the_optimum_where_long_steps_do_not_get_there);
    RUN_TEST(test_more_rows_bind_than_there_are_columns);
    RUN_TEST(test_powers_of_two_change_no_bit);
    RUN_TEST(test_the_order_of_rows_and_columns_does_not_matter);
    RUN_TEST(test_units_do_not_matter);
    RUN_TEST(test_huge_and_tiny_numbers_are_no_trouble);
    RUN_TEST(test_the_workspace_goes_with_the_lesser_number);
    RUN_TEST(test_what_was_in_the_workspace_does_not_matter);
    RUN_TEST(test_many_poses);
    RUN_TEST(test_a_large_problem_is_that_of_the_rows_that_bind);
    RUN_TEST(test_poses_that_are_alike);
    RUN_TEST(test_a_row_that_is_hardly_violated_counts);
    RUN_TEST(test_wrong_input_is_refused);
    return UNITY_END();
}
