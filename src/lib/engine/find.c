#include "lib/engine/find.h"

#include "armtol/corners.h"
#include "armtol/optimum.h"
#include "armtol/sphere.h"
#include "lib/engine/check.h"
#include "lib/engine/parts.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* ---- what is left beside what is given ---- */

/*
 * The columns that are asked for, and A, limits and weights for them alone: `extra` rows more than A has, a column's
 * each.
 */
typedef struct rows {
    size_t n_free, n_rows, n_extra;
    bool *pinned;          /* a column of A: held at its least for now, as if that were given */
    double *pulls;         /* a column of A: what rows take of it at the optimum, as a part of its weight's worth */
    size_t *free_columns;  /* n_free: their places in A */
    armtol_column *columns; /* n_free */
    double *matrix;        /* (n_rows + n_extra) x n_free */
    double *limits, *multipliers; /* n_rows + n_extra */
    double *weights, *tolerances; /* n_free */
} rows;

/* Room for one at least, so that NULL means that there is no memory. */
static void *get(size_t count, size_t size)
{
    return calloc(count + 1, size);
}

static void free_rows(rows *rows)
{
    free(rows->pinned);
    free(rows->pulls);
    free(rows->free_columns);
    free(rows->columns);
    free(rows->matrix);
    free(rows->limits);
    free(rows->multipliers);
    free(rows->weights);
    free(rows->tolerances);
}

/* Whether a column is asked for at all, and whether it is so with those that are pinned held. */
static bool has_largest(const armtol_answer *answer, const armtol_question *question, size_t column)
{
    return !answer->given[column] && isfinite(question_largest(question, column));
}

static bool is_free(const rows *rows, const armtol_answer *answer, size_t column)
{
    return !answer->given[column] && !rows->pinned[column];
}

static bool get_rows(rows *rows, const armtol_answer *answer, const armtol_question *question)
{
    *rows = (struct rows){.n_rows = 6 * answer->n_poses};
    for (size_t k = 0; k < answer->n_columns; k++) {
        rows->n_free += !answer->given[k];
        rows->n_extra += has_largest(answer, question, k);
    }
    rows->pinned = get(answer->n_columns, sizeof *rows->pinned);
    rows->pulls = get(answer->n_columns, sizeof *rows->pulls);
    const size_t all = rows->n_rows + rows->n_extra;
    rows->free_columns = get(rows->n_free, sizeof *rows->free_columns);
    rows->columns = get(rows->n_free, sizeof *rows->columns);
    rows->matrix = get(all, (rows->n_free + 1) * sizeof *rows->matrix);
    rows->limits = get(all, sizeof *rows->limits);
    rows->multipliers = get(all, sizeof *rows->multipliers);
    rows->weights = get(rows->n_free, sizeof *rows->weights);
    rows->tolerances = get(rows->n_free, sizeof *rows->tolerances);
    return rows->pinned != NULL && rows->pulls != NULL && rows->free_columns != NULL && rows->columns != NULL &&
           rows->matrix != NULL && rows->limits != NULL && rows->multipliers != NULL && rows->weights != NULL &&
           rows->tolerances != NULL;
}

/* A row that sees the column alone, in the place of `extra`. */
static void pack_largest(rows *rows, const armtol_question *question, size_t place, size_t extra)
{
    double *row = rows->matrix + extra * rows->n_free;
    memset(row, 0, rows->n_free * sizeof *row);
    row[place] = 1;
    rows->limits[extra] = question_largest(question, rows->free_columns[place]);
}

static void pack_columns(rows *rows, const armtol_answer *answer, const armtol_question *question)
{
    rows->n_free = 0;
    for (size_t k = 0; k < answer->n_columns; k++) {
        if (is_free(rows, answer, k)) {
            rows->free_columns[rows->n_free] = k;
            rows->columns[rows->n_free] = answer->columns[k];
            rows->weights[rows->n_free++] = question_weight(question, k);
        }
    }
    rows->n_extra = 0;
    for (size_t j = 0; j < rows->n_free; j++) {
        if (has_largest(answer, question, rows->free_columns[j])) {
            pack_largest(rows, question, j, rows->n_rows + rows->n_extra++);
        }
    }
}

static void pack_row(rows *rows, const armtol_answer *answer, size_t row)
{
    const double *whole = answer->matrices + row * answer->n_columns;
    double *packed = rows->matrix + row * rows->n_free;
    for (size_t j = 0; j < rows->n_free; j++) {
        packed[j] = whole[rows->free_columns[j]];
    }
}

static bool is_rss(const armtol_question *question)
{
    return question->method == ARMTOL_METHOD_RSS;
}

/*
 * Method rss: an error that is even within its tolerance t has the standard deviation t / sqrt(3), so that sigma
 * standard deviations of a component are within its limit when the root of the summed squares is within
 * limit sqrt(3) / sigma. What is given takes its part: of the sum, or of the sum of squares.
 */
static double left_of(const armtol_answer *answer, const armtol_question *question, size_t row)
{
    const size_t pose = row / 6, i = row % 6, n = answer->n_columns;
    const double *matrix = armtol_answer_matrix(answer, pose), *given = armtol_answer_bounded(answer, pose);
    const double left = question->accuracy[i] - fabs(armtol_answer_shift(answer, pose, i));
    if (!is_rss(question)) {
        return left - armtol_worst_error(matrix, n, i, given);
    }
    const double limit = left * sqrt(3) / question->sigma, used = armtol_rss_error(matrix, n, i, given);
    return used == 0 ? limit : used < limit ? sqrt(limit - used) * sqrt(limit + used) : limit - used;
}

static bool is_asked(const rows *rows, size_t row)
{
    bool asked = false;
    for (size_t j = 0; j < rows->n_free; j++) {
        asked = asked || rows->matrix[row * rows->n_free + j] != 0;
    }
    return asked;
}

/*
 * The limits of the accuracy. A row in which nothing is asked for may be used up by what is given, and to its last
 * digit; rounding apart, no row may by more. The fault is of the row of which least is left.
 */
static armtol_fault pack_limits(rows *rows, const armtol_answer *answer, const armtol_question *question)
{
    static const double rounding = 1e-12;
    double least = (double)INFINITY;
    size_t tightest = 0;
    bool enough = true;
    for (size_t row = 0; row < rows->n_rows; row++) {
        const double accuracy = question->accuracy[row % 6];
        const bool asked = is_asked(rows, row);
        rows->limits[row] = (double)INFINITY;
        if (isfinite(accuracy)) {
            const double left = left_of(answer, question, row), part = left / accuracy;
            enough = enough && (asked ? part > rounding : part >= -rounding);
            tightest = part < least ? row : tightest;
            least = fmin(least, part);
            rows->limits[row] = asked ? left : (double)INFINITY;
        }
    }
    return fault_of(enough ? ARMTOL_OK : ARMTOL_NOTHING_LEFT, ARMTOL_ABOUT_ROW, tightest);
}

static armtol_fault pack(rows *rows, const armtol_answer *answer, const armtol_question *question)
{
    pack_columns(rows, answer, question);
    for (size_t row = 0; row < rows->n_rows; row++) {
        pack_row(rows, answer, row);
    }
    return pack_limits(rows, answer, question);
}

/* ---- worst and rss: the optimum ---- */

/* With the columns that are pinned held. */
static armtol_status optimise_free(const armtol_question *question, const rows *rows)
{
    const size_t n_rows = rows->n_rows + rows->n_extra;
    double *workspace = get(armtol_optimum_workspace(n_rows, rows->n_free), sizeof *workspace);
    if (workspace == NULL) {
        return ARMTOL_NO_MEMORY;
    }
    const armtol_status status =
        armtol_optimum(is_rss(question) ? ARMTOL_ROOT_SUM_SQUARES : ARMTOL_WORST_CASE, rows->matrix, n_rows,
                       rows->n_free, rows->limits, rows->weights, rows->tolerances, rows->multipliers, workspace);
    free(workspace);
    return status;
}

/*
 * The least values are held by an active set. At the optimum of the free columns the multipliers say what the rows take
 * of a pinned column: f(i,k) of optimum.h at its least, summed over the rows. If that is worth less than its weight the
 * column has to be let go; a free column below its least has to be pinned. Where neither is so, all conditions of
 * Karush, Kuhn and Tucker hold, and the problem is convex: it is the optimum.
 */
static double pull_of(const armtol_answer *answer, const armtol_question *question, const rows *rows, size_t column)
{
    const double least = question_least(question, column);
    double pull = 0;
    for (size_t row = 0; row < rows->n_rows; row++) {
        if (rows->multipliers[row] > 0) {
            const double part = fabs(answer->matrices[row * answer->n_columns + column]) * least / rows->limits[row];
            pull += rows->multipliers[row] * (is_rss(question) ? part * part : part);
        }
    }
    return pull;
}

static double free_weight(const rows *rows)
{
    double sum = 0;
    for (size_t j = 0; j < rows->n_free; j++) {
        sum += isfinite(rows->tolerances[j]) ? rows->weights[j] : 0;
    }
    return sum;
}

/* Rounding apart: what is at its least to twelve digits may be on either side of it. */
static const double slack = 1e-12;

static void pin(rows *rows, armtol_answer *answer, const armtol_question *question, size_t column, bool pinned)
{
    rows->pinned[column] = pinned;
    for (size_t pose = 0; pose < answer->n_poses; pose++) {
        answer->bounded[pose * answer->n_columns + column] = pinned ? question_least(question, column) : 0;
    }
}

static bool pin_low(rows *rows, armtol_answer *answer, const armtol_question *question)
{
    bool any = false;
    for (size_t j = 0; j < rows->n_free; j++) {
        const size_t k = rows->free_columns[j];
        if (rows->tolerances[j] < question_least(question, k) * (1 - slack)) {
            pin(rows, answer, question, k, true);
            any = true;
        }
    }
    return any;
}

/* The pinned column that is pulled least; false where each is pulled down by what its weight is worth. */
static bool let_go(rows *rows, armtol_answer *answer, const armtol_question *question)
{
    const double whole = free_weight(rows);
    double most = -(double)INFINITY;
    size_t loosest = 0;
    for (size_t k = 0; k < answer->n_columns; k++) {
        if (rows->pinned[k]) {
            const double weight = question_weight(question, k);
            rows->pulls[k] = whole * pull_of(answer, question, rows, k) / weight;
            loosest = 1 - rows->pulls[k] > most ? k : loosest;
            most = fmax(most, 1 - rows->pulls[k]);
        }
    }
    if (most > slack) {
        pin(rows, answer, question, loosest, false);
    }
    return most > slack;
}

/* What holds the optimum: rows, and the ranges of columns. */
static void note_held(armtol_answer *answer, const armtol_question *question, const rows *rows)
{
    const double whole = free_weight(rows);
    double most[6] = {0};
    size_t extra = rows->n_rows;
    for (size_t i = 0; i < rows->n_rows; i++) {
        armtol_predicted *component = &answer->components[i % 6];
        component->binds += rows->multipliers[i];
        component->binds_pose = rows->multipliers[i] > most[i % 6] ? i / 6 : component->binds_pose;
        most[i % 6] = fmax(most[i % 6], rows->multipliers[i]);
    }
    for (size_t j = 0; j < rows->n_free; j++) {
        const size_t k = rows->free_columns[j];
        answer->held[k] = has_largest(answer, question, k) ? rows->multipliers[extra++] : 0;
        answer->tolerances[k] = fmax(rows->tolerances[j], question_least(question, k));
    }
    for (size_t k = 0; k < answer->n_columns; k++) {
        if (rows->pinned[k]) {
            const double weight = question_weight(question, k);
            answer->held[k] = -weight * (rows->pulls[k] - 1) / whole;
            answer->tolerances[k] = question_least(question, k);
        }
    }
}

static armtol_fault optimise(armtol_answer *answer, const armtol_question *question, rows *rows)
{
    const size_t most_rounds = 8 * answer->n_columns + 8; /* a few are enough: no arm is known that takes more than n */
    for (size_t round = 0; round < most_rounds; round++) {
        const armtol_fault fault = pack(rows, answer, question);
        if (fault.status != ARMTOL_OK) {
            return fault;
        }
        const armtol_status status = rows->n_free > 0 ? optimise_free(question, rows) : ARMTOL_OK;
        if (status != ARMTOL_OK) {
            return fault_of(status, status == ARMTOL_NO_MEMORY ? ARMTOL_ABOUT_NOTHING : ARMTOL_ABOUT_METHOD, 0);
        }
        if (!pin_low(rows, answer, question) && !let_go(rows, answer, question)) {
            note_held(answer, question, rows);
            return fault_of(ARMTOL_OK, ARMTOL_ABOUT_NOTHING, 0);
        }
    }
    return fault_of(ARMTOL_NOT_SOLVED, ARMTOL_ABOUT_METHOD, 0);
}

/* ---- sphere: the report's bounds, shared out evenly ---- */

/* The least that any pose leaves of each component. */
static void least_limits(const rows *rows, const armtol_question *question, double limits[6])
{
    for (size_t i = 0; i < 6; i++) {
        limits[i] = question->accuracy[i];
    }
    for (size_t row = 0; row < rows->n_rows; row++) {
        limits[row % 6] = fmin(limits[row % 6], rows->limits[row]);
    }
}

static armtol_status share_sphere(armtol_answer *answer, const armtol_question *question, const rows *rows)
{
    const size_t n = rows->n_free;
    double limits[6];
    armtol_status status = ARMTOL_OK;
    least_limits(rows, question, limits);
    answer->delta = question->delta;
    if (question->delta == 0) {
        status = armtol_sphere_delta(rows->matrix, answer->n_poses, n, rows->columns, limits, answer_lever(answer),
                                     &answer->delta);
    }
    if (status == ARMTOL_OK) {
        status = armtol_sphere_bounds(rows->matrix, answer->n_poses, n, rows->columns, limits, answer->delta,
                                      &answer->bounds);
    }
    if (status == ARMTOL_OK) {
        armtol_sphere_tolerances(rows->columns, n, &answer->bounds, rows->tolerances);
    }
    return status;
}

static bool has_range(const armtol_answer *answer, const armtol_question *question)
{
    bool any = false;
    for (size_t k = 0; k < answer->n_columns; k++) {
        const bool ranged = isfinite(question_largest(question, k)) || question_least(question, k) > 0;
        any = any || (!answer->given[k] && ranged);
    }
    return any;
}

static armtol_fault find_sphere(armtol_answer *answer, const armtol_question *question, rows *rows)
{
    if (has_range(answer, question)) {
        return fault_of(ARMTOL_BAD_RANGE, ARMTOL_ABOUT_METHOD, 0);
    }
    const armtol_fault fault = pack(rows, answer, question);
    if (fault.status != ARMTOL_OK || rows->n_free == 0) {
        return fault;
    }
    const armtol_status status = share_sphere(answer, question, rows);
    for (size_t j = 0; j < rows->n_free && status == ARMTOL_OK; j++) {
        answer->tolerances[rows->free_columns[j]] = rows->tolerances[j];
    }
    return fault_of(status, ARMTOL_ABOUT_METHOD, 0);
}

/* ---- both ---- */

static armtol_fault find(armtol_answer *answer, const armtol_question *question, rows *rows)
{
    if (!get_rows(rows, answer, question)) {
        return fault_of(ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
    }
    return question->method == ARMTOL_METHOD_SPHERE ? find_sphere(answer, question, rows)
                                                    : optimise(answer, question, rows);
}

armtol_fault answer_find_tolerances(armtol_answer *answer, const armtol_question *question)
{
    rows rows;
    const armtol_fault fault = find(answer, question, &rows);
    free_rows(&rows);
    return fault;
}
