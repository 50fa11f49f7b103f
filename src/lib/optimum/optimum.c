#include "armtol/optimum.h"

#include "lib/optimum/center.h"
#include "lib/optimum/rows.h"
#include "lib/report/finite.h"

#include <float.h>
#include <math.h>
#include <string.h>

/*
 * Method
 *    Few rows bind, so few are looked at: the problem is solved for a working set of rows, those that its solution
 *    violates most come in, those that do not bind go out, until none is violated. In the end the tolerances shrink by
 *    the rounding of a row's sum, so that every row keeps to its limit to the last bit.
 *
 * Special cases
 *    A column that no bounded row sees gets infinity and takes no part. A free row is in no set. Up to 24 rows are all
 *    taken at once. Rows that are alike within 3 % come in one at a time.
 *
 * Accuracy
 *    A row that binds uses 1 - 3e-12 of its limit or more, and every column is held down by its weight to 1e-11:
 *    test_optimum, the conditions of Karush, Kuhn and Tucker on random problems; test_optimum_nlopt holds it against
 *    another solver.
 */

enum { ALL_AT_ONCE = 24, MOST_ROUNDS = 300 };

/* A row is violated where it uses more than its limit by more than this part. */
static const double slack = 1e-12;

/* Rows whose elements of B all differ by less say nearly the same: one of them at a time is enough. */
static const double likeness = 0.03;

/* The working set: its rows packed, the places of the rows in the matrix (whole numbers, kept as doubles). */
typedef struct working_set {
    double *members;
    double *packed;
    size_t count;
    size_t capacity;
} working_set;

typedef struct optimum {
    optimum_rows rows;
    double *weights;    /* of bounded columns, their sum 1 */
    double *tolerances; /* all columns, 0 for the infinite ones */
    double *uses;       /* of every row, as far as it is of interest */
    working_set set;
    center_state state;
} optimum;

static size_t capacity_of(size_t n_rows, size_t n_columns)
{
    const size_t enough = 3 * n_columns + ALL_AT_ONCE;
    return n_rows < enough ? n_rows : enough;
}

size_t armtol_optimum_workspace(size_t n_rows, size_t n_columns)
{
    const size_t capacity = capacity_of(n_rows, n_columns);
    return (3 + CENTER_VECTORS) * n_columns + n_rows + (1 + n_columns + CENTER_VECTORS + capacity) * capacity;
}

static double *take(double **place, size_t count)
{
    double *const part = *place;
    *place += count;
    return part;
}

static void divide_workspace(optimum *optimum, double workspace[])
{
    const size_t m = optimum->rows.n_rows, n = optimum->rows.n_columns, capacity = capacity_of(m, n);
    center_state *state = &optimum->state;
    double **const of_columns[] = {
        &optimum->rows.units, &optimum->weights, &optimum->tolerances,
        &state->t, &state->y, &state->dt, &state->dy, &state->ratios, &state->targets,
    };
    double **const of_set[] = {
        &optimum->set.members, &state->l, &state->s, &state->dl, &state->ds,
        &state->complements, &state->pivots,
    };
    for (size_t i = 0; i < sizeof of_columns / sizeof of_columns[0]; i++) {
        *of_columns[i] = take(&workspace, n);
    }
    for (size_t i = 0; i < sizeof of_set / sizeof of_set[0]; i++) {
        *of_set[i] = take(&workspace, capacity);
    }
    optimum->uses = take(&workspace, m);
    optimum->set.packed = take(&workspace, capacity * n);
    state->matrix = take(&workspace, capacity * capacity);
    optimum->set.capacity = capacity;
    optimum->set.count = 0;
}

static armtol_status check_input(const optimum_rows *rows, const double weights[])
{
    if (!all_finite(rows->matrix, rows->n_rows * rows->n_columns) || !all_finite(weights, rows->n_columns)) {
        return ARMTOL_NOT_FINITE;
    }
    for (size_t i = 0; i < rows->n_rows; i++) {
        if (isnan(rows->limits[i])) {
            return ARMTOL_NOT_FINITE;
        }
        if (rows->limits[i] <= 0) {
            return ARMTOL_BAD_TOLERANCE;
        }
        if (!isinf(rows->limits[i]) && !optimum_in_range(rows->limits[i])) {
            return ARMTOL_NOT_FINITE;
        }
    }
    for (size_t k = 0; k < rows->n_columns; k++) {
        if (weights[k] <= 0) {
            return ARMTOL_BAD_WEIGHT;
        }
    }
    return ARMTOL_OK;
}

/* The weights of the bounded columns, divided by their sum; the largest first, so that no sum overflows. */
static void share_weights(optimum *optimum, const double weights[])
{
    const optimum_rows *rows = &optimum->rows;
    double largest = 0, sum = 0;
    size_t count = 0;
    for (size_t k = 0; k < rows->n_columns; k++) {
        largest = rows->units[k] > 0 ? fmax(largest, weights[k]) : largest;
    }
    for (size_t k = 0; k < rows->n_columns; k++) {
        if (rows->units[k] > 0) {
            optimum->weights[count] = weights[k] / largest;
            sum += optimum->weights[count++];
        }
    }
    for (size_t j = 0; j < count; j++) {
        optimum->weights[j] /= sum;
    }
}

/* ---- the working set ---- */

static bool is_member(const working_set *set, size_t row)
{
    for (size_t j = 0; j < set->count; j++) {
        if ((size_t)set->members[j] == row) {
            return true;
        }
    }
    return false;
}

static void add_row(optimum *optimum, size_t row)
{
    working_set *set = &optimum->set;
    set->members[set->count] = (double)row;
    optimum_pack(&optimum->rows, row, set->packed + set->count * optimum->rows.n_bounded);
    set->count++;
}

/* The row that bounds a column most when the column is alone. */
static size_t tightest_row(const optimum_rows *rows, size_t column)
{
    size_t tightest = 0;
    double largest = 0;
    for (size_t i = 0; i < rows->n_rows; i++) {
        const double element = optimum_element(rows, i, column);
        if (element > largest) {
            largest = element;
            tightest = i;
        }
    }
    return tightest;
}

/* Few rows: all; else enough to bound every column. */
static void start_set(optimum *optimum)
{
    const optimum_rows *rows = &optimum->rows;
    if (rows->n_rows <= ALL_AT_ONCE) {
        for (size_t i = 0; i < rows->n_rows; i++) {
            add_row(optimum, i);
        }
        return;
    }
    for (size_t k = 0; k < rows->n_columns; k++) {
        if (rows->units[k] > 0) {
            const size_t row = tightest_row(rows, k);
            if (!is_member(&optimum->set, row)) {
                add_row(optimum, row);
            }
        }
    }
}

static void drop_slack_rows(optimum *optimum)
{
    working_set *set = &optimum->set;
    const size_t n = optimum->rows.n_bounded;
    size_t kept = 0;
    for (size_t j = 0; j < set->count; j++) {
        if (optimum_binds(&optimum->state, j)) {
            set->members[kept] = set->members[j];
            /* not in a loop: gcc 12 for the 68020 takes the lower half of an element from another one there */
            memmove(set->packed + kept * n, set->packed + j * n, n * sizeof *set->packed);
            kept++;
        }
    }
    set->count = kept;
}

/* ---- rounds ---- */

static bool solve_set(optimum *optimum)
{
    const center_problem problem = {
        .rows = optimum->set.packed,
        .n_rows = optimum->set.count,
        .n_columns = optimum->rows.n_bounded,
        .weights = optimum->weights,
    };
    if (!optimum_center(&problem, &optimum->state)) {
        return false;
    }
    const bool squares = optimum->rows.sum == ARMTOL_ROOT_SUM_SQUARES;
    size_t place = 0;
    for (size_t k = 0; k < optimum->rows.n_columns; k++) {
        const double unit = optimum->rows.units[k];
        optimum->tolerances[k] = 0;
        if (unit > 0) {
            const double t = optimum->state.t[place++];
            optimum->tolerances[k] = unit * (squares ? sqrt(t) : t);
        }
    }
    return true;
}

/* What every row uses of its limit; returns the most. */
static double find_uses(optimum *optimum)
{
    double most = 0;
    for (size_t i = 0; i < optimum->rows.n_rows; i++) {
        optimum->uses[i] = optimum_use(&optimum->rows, i, optimum->tolerances);
        most = fmax(most, optimum->uses[i]);
    }
    return most;
}

static bool alike(const optimum_rows *rows, size_t one, size_t other)
{
    for (size_t k = 0; k < rows->n_columns; k++) {
        if (fabs(optimum_element(rows, one, k) - optimum_element(rows, other, k)) > likeness) {
            return false;
        }
    }
    return true;
}

/* Let no row like this one, nor the row, count as violated in this round. */
static void pass_over(optimum *optimum, size_t row)
{
    for (size_t i = 0; i < optimum->rows.n_rows; i++) {
        if (optimum->uses[i] > 1 + slack && alike(&optimum->rows, i, row)) {
            optimum->uses[i] = 0;
        }
    }
}

static size_t most_used(const double uses[], size_t n_rows)
{
    size_t most = 0;
    for (size_t i = 1; i < n_rows; i++) {
        most = uses[i] > uses[most] ? i : most;
    }
    return most;
}

/* Take in the rows that are violated most, as many as a round may and there is room for; returns how many. */
static size_t add_violated(optimum *optimum)
{
    working_set *set = &optimum->set;
    size_t added = 0;
    while (set->count < set->capacity && added < optimum->rows.n_bounded) {
        const size_t row = most_used(optimum->uses, optimum->rows.n_rows);
        if (!(optimum->uses[row] > 1 + slack)) {
            break;
        }
        add_row(optimum, row);
        pass_over(optimum, row);
        added++;
    }
    return added;
}

/* Rows of the set keep to their limits but for rounding. */
static bool any_violated(optimum *optimum)
{
    for (size_t j = 0; j < optimum->set.count; j++) {
        optimum->uses[(size_t)optimum->set.members[j]] = 0;
    }
    return optimum->uses[most_used(optimum->uses, optimum->rows.n_rows)] > 1 + slack;
}

/* The optimum, and what the row that uses most uses of its limit: 1, but for rounding. */
static bool solve(optimum *optimum, double *most)
{
    start_set(optimum);
    for (int round = 0; round < MOST_ROUNDS; round++) {
        if (!solve_set(optimum)) {
            return false;
        }
        *most = find_uses(optimum);
        if (!any_violated(optimum)) {
            return true;
        }
        drop_slack_rows(optimum);
        if (add_violated(optimum) == 0) {
            return false;
        }
    }
    return false;
}

/* ---- results ---- */

/*
 * Shrink the tolerances until every row keeps to its limit however its products are summed: n of them, added
 * in any order, are off by less than n + 2 roundings, and so is what we know of the row that uses most.
 */
static void keep_to_limits(optimum *optimum, double most)
{
    const optimum_rows *rows = &optimum->rows;
    const double used = rows->sum == ARMTOL_ROOT_SUM_SQUARES ? sqrt(most) : most;
    const double factor = (1 - (double)(rows->n_columns + 8) * DBL_EPSILON) / used;
    for (size_t k = 0; k < rows->n_columns; k++) {
        optimum->tolerances[k] *= factor;
    }
}

static bool all_in_range(const optimum *optimum)
{
    bool in_range = true;
    for (size_t k = 0; k < optimum->rows.n_columns; k++) {
        const bool bounded = optimum->rows.units[k] > 0;
        in_range = in_range && (!bounded || optimum_in_range(optimum->tolerances[k]));
    }
    return in_range;
}

static void write_tolerances(const optimum *optimum, double tolerances[])
{
    for (size_t k = 0; k < optimum->rows.n_columns; k++) {
        tolerances[k] = optimum->rows.units[k] > 0 ? optimum->tolerances[k] : (double)INFINITY;
    }
}

static void write_multipliers(const optimum *optimum, double multipliers[])
{
    const working_set *set = &optimum->set;
    const center_state *state = &optimum->state;
    double sum = 0;
    for (size_t i = 0; i < optimum->rows.n_rows; i++) {
        multipliers[i] = 0;
    }
    for (size_t j = 0; j < set->count; j++) {
        sum += optimum_binds(state, j) ? state->l[j] : 0;
    }
    for (size_t j = 0; j < set->count; j++) {
        multipliers[(size_t)set->members[j]] = optimum_binds(state, j) ? state->l[j] / sum : 0;
    }
}

armtol_status armtol_optimum(armtol_sum sum, const double matrix[], size_t n_rows, size_t n_columns,
                              const double limits[], const double weights[], double tolerances[],
                              double multipliers[], double workspace[])
{
    optimum optimum = {.rows = {sum, matrix, n_rows, n_columns, limits}};
    const armtol_status status = check_input(&optimum.rows, weights);
    if (status != ARMTOL_OK) {
        return status;
    }
    divide_workspace(&optimum, workspace);
    if (!optimum_find_units(&optimum.rows, optimum.tolerances)) {
        return ARMTOL_NOT_FINITE;
    }
    share_weights(&optimum, weights);
    if (optimum.rows.n_bounded > 0) {
        double most;
        if (!solve(&optimum, &most)) {
            return ARMTOL_NOT_SOLVED;
        }
        keep_to_limits(&optimum, most);
        if (!all_in_range(&optimum)) {
            return ARMTOL_NOT_FINITE;
        }
    }
    write_tolerances(&optimum, tolerances);
    write_multipliers(&optimum, multipliers);
    return ARMTOL_OK;
}
