#include "lib/engine/find.h"

#include "armtol/optimum.h"
#include "armtol/sphere.h"
#include "lib/engine/check.h"
#include "lib/engine/parts.h"
#include "lib/norms/cuts.h"
#include "lib/norms/discs.h"
#include "lib/spread/answer_spread.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* ---- what is left beside what is given ---- */

/*
 * The columns that are asked for, and for them alone the rows, their limits and the weights: A's rows, those of cuts,
 * and `extra` ones, a column's each.
 */
typedef struct rows {
    size_t n_free, n_components, n_rows, n_extra; /* n_rows: without the extra ones */
    size_t room;                                  /* for rows of all kinds */
    cuts cuts;
    bool *asked;   /* a column of A: the free ones */
    double *found; /* a column of A: of those what was found */
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
    cuts_free(&rows->cuts);
    free(rows->asked);
    free(rows->found);
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

/* Room for all rows that there are now; what was in it is lost. */
static bool get_room(rows *rows)
{
    if (rows->n_rows + rows->n_extra <= rows->room) {
        return true;
    }
    free(rows->matrix);
    free(rows->limits);
    free(rows->multipliers);
    rows->room = rows->n_rows + rows->n_extra + (rows->cuts.count > 0 ? rows->n_rows / 2 : 0);
    rows->matrix = get(rows->room, (rows->n_free + 1) * sizeof *rows->matrix);
    rows->limits = get(rows->room, sizeof *rows->limits);
    rows->multipliers = get(rows->room, sizeof *rows->multipliers);
    return rows->matrix != NULL && rows->limits != NULL && rows->multipliers != NULL;
}

static bool get_rows(rows *rows, const armtol_answer *answer, const armtol_question *question)
{
    *rows = (struct rows){.n_components = 6 * answer->n_poses};
    for (size_t k = 0; k < answer->n_columns; k++) {
        rows->n_free += !answer->given[k];
        rows->n_extra += has_largest(answer, question, k);
    }
    rows->asked = get(answer->n_columns, sizeof *rows->asked);
    rows->found = get(answer->n_columns, sizeof *rows->found);
    rows->pinned = get(answer->n_columns, sizeof *rows->pinned);
    rows->pulls = get(answer->n_columns, sizeof *rows->pulls);
    rows->free_columns = get(rows->n_free, sizeof *rows->free_columns);
    rows->columns = get(rows->n_free, sizeof *rows->columns);
    rows->weights = get(rows->n_free, sizeof *rows->weights);
    rows->tolerances = get(rows->n_free, sizeof *rows->tolerances);
    return rows->asked != NULL && rows->found != NULL && rows->pinned != NULL && rows->pulls != NULL &&
           rows->free_columns != NULL && rows->columns != NULL && rows->weights != NULL && rows->tolerances != NULL &&
           cuts_start(&rows->cuts, answer);
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
        rows->asked[k] = is_free(rows, answer, k);
        if (rows->asked[k]) {
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

/* The whole row, all columns of A. */
static const double *whole_row(const rows *rows, const armtol_answer *answer, size_t row)
{
    return row < rows->n_components ? answer->matrices + row * answer->n_columns
                                    : rows->cuts.rows + (row - rows->n_components) * answer->n_columns;
}

/* What a tolerance counts in sums by the method. */
static double factor_of(const armtol_answer *answer, size_t column)
{
    return answer->method == ARMTOL_METHOD_RSS ? answer->factors[column] : 1;
}

static void pack_row(rows *rows, const armtol_answer *answer, size_t row)
{
    const double *whole = whole_row(rows, answer, row);
    double *packed = rows->matrix + row * rows->n_free;
    for (size_t j = 0; j < rows->n_free; j++) {
        packed[j] = whole[rows->free_columns[j]] * factor_of(answer, rows->free_columns[j]);
    }
}

static bool is_rss(const armtol_question *question)
{
    return question->method == ARMTOL_METHOD_RSS;
}

/*
 * Method rss: an error that is even within its tolerance t has the standard deviation t / sqrt(3), so that sigma
 * standard deviations of a component are within its limit when the root of the summed squares is within
 * limit sqrt(3) / sigma; of an error that is spread otherwise t counts by its factor. What is given takes its part: of
 * the sum, or of the sum of squares.
 */
static double left_of(const rows *rows, const armtol_answer *answer, size_t row, double accuracy)
{
    const bool is_component = row < rows->n_components;
    const size_t pose = is_component ? row / 6 : rows->cuts.cuts[row - rows->n_components].pose, n = answer->n_columns;
    const double *whole = whole_row(rows, answer, row), *given = armtol_answer_bounded(answer, pose);
    const double *shifts = armtol_answer_shifts(answer, pose);
    double shift = 0;
    for (size_t k = 0; k < n; k++) {
        shift += whole[k] * shifts[k];
    }
    const double left = accuracy - fabs(shift);
    if (answer->method != ARMTOL_METHOD_RSS) {
        return left - discs_worst(whole, n, given, answer->discs);
    }
    const double limit = left * sqrt(3) / answer->sigma, used = spread_rss(answer, whole, given);
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

/* Where least is left of what is asked for, as a part of it, and whether that is enough everywhere. */
typedef struct tightest {
    bool enough;
    double least;
    armtol_subject about;
    size_t number;
} tightest;

/*
 * What asks for nothing may be used up by what is given, and to its last digit; rounding apart, nothing may be by more.
 */
static void note_left(tightest *tightest, bool asked, double part, armtol_subject about, size_t number)
{
    static const double rounding = 1e-12;
    tightest->enough = tightest->enough && (asked ? part > rounding : part >= -rounding);
    if (part < tightest->least) {
        tightest->least = part;
        tightest->about = about;
        tightest->number = number;
    }
}

static void pack_components(rows *rows, const armtol_answer *answer, tightest *tightest)
{
    for (size_t row = 0; row < rows->n_components; row++) {
        const double accuracy = answer->accuracy[row % 6];
        const bool asked = is_asked(rows, row);
        rows->limits[row] = (double)INFINITY;
        if (isfinite(accuracy)) {
            const double left = left_of(rows, answer, row, accuracy);
            note_left(tightest, asked, left / accuracy, ARMTOL_ABOUT_ROW, row);
            rows->limits[row] = asked ? left : (double)INFINITY;
        }
    }
}

/* What is given may use up no norm, and then something is left in every direction. */
static void note_norms(const rows *rows, const armtol_answer *answer, tightest *tightest)
{
    for (size_t i = 0; i < answer->n_norms * answer->n_poses; i++) {
        const size_t norm = i % answer->n_norms, pose = i / answer->n_norms;
        const double limit = answer->norms[norm].limit;
        if (isfinite(limit)) {
            double direction[6];
            const double *known = armtol_answer_bounded(answer, pose);
            const double given = cuts_norm(&rows->cuts, answer, norm, pose, known, direction);
            note_left(tightest, cuts_is_seen(answer, norm, pose, rows->asked), (limit - given) / limit,
                      ARMTOL_ABOUT_NORM_PLACE, i);
        }
    }
}

static void pack_cuts(rows *rows, const armtol_answer *answer)
{
    for (size_t row = rows->n_components; row < rows->n_rows; row++) {
        const double limit = answer->norms[rows->cuts.cuts[row - rows->n_components].norm].limit;
        rows->limits[row] = is_asked(rows, row) ? left_of(rows, answer, row, limit) : (double)INFINITY;
    }
}

/* `first`: for the columns that are free now. What is given is the same until others are. */
static armtol_fault pack(rows *rows, const armtol_answer *answer, const armtol_question *question, bool first)
{
    tightest tightest = {.enough = true, .least = (double)INFINITY};
    rows->n_rows = rows->n_components + rows->cuts.count;
    if (!get_room(rows)) {
        return fault_of(ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
    }
    pack_columns(rows, answer, question);
    for (size_t row = 0; row < rows->n_rows; row++) {
        pack_row(rows, answer, row);
    }
    pack_components(rows, answer, &tightest);
    pack_cuts(rows, answer);
    if (first) {
        note_norms(rows, answer, &tightest);
    }
    return fault_of(tightest.enough ? ARMTOL_OK : ARMTOL_NOTHING_LEFT, tightest.about, tightest.number);
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
            const double effect = fabs(whole_row(rows, answer, row)[column]) * factor_of(answer, column);
            const double part = effect * least / rows->limits[row];
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

/* ---- norms: cuts ---- */

static void note_found(rows *rows)
{
    for (size_t j = 0; j < rows->n_free; j++) {
        rows->found[rows->free_columns[j]] = rows->tolerances[j];
    }
}

/* What cuts left of norms beyond their limits. */
static void keep_to_norms(rows *rows, const armtol_answer *answer)
{
    note_found(rows);
    const double factor = answer->n_norms > 0 ? cuts_factor(&rows->cuts, answer, rows->asked, rows->found) : 1;
    for (size_t j = 0; j < rows->n_free; j++) {
        rows->tolerances[j] *= factor;
    }
}

/* ---- what holds ---- */

/* What holds the optimum: rows, and the ranges of columns. */
static bool note_held(armtol_answer *answer, const armtol_question *question, const rows *rows)
{
    const double whole = free_weight(rows);
    double most[6] = {0};
    size_t extra = rows->n_rows;
    for (size_t i = 0; i < rows->n_components; i++) {
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
    return cuts_note(&rows->cuts, answer, rows->multipliers + rows->n_components);
}

/* Of the columns that are free now the optimum, and what it exceeds of norms. */
static armtol_fault optimise_once(const armtol_answer *answer, const armtol_question *question, rows *rows, bool first,
                                  size_t *added)
{
    const armtol_fault fault = pack(rows, answer, question, first);
    if (fault.status != ARMTOL_OK) {
        return fault;
    }
    const armtol_status status = rows->n_free > 0 ? optimise_free(question, rows) : ARMTOL_OK;
    if (status != ARMTOL_OK) {
        return fault_of(status, status == ARMTOL_NO_MEMORY ? ARMTOL_ABOUT_NOTHING : ARMTOL_ABOUT_METHOD, 0);
    }
    note_found(rows);
    const bool fine = cuts_add(&rows->cuts, answer, rows->asked, rows->found, added);
    return fault_of(fine ? ARMTOL_OK : ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
}

static armtol_fault optimise(armtol_answer *answer, const armtol_question *question, rows *rows)
{
    enum { MOST_CUTS = 400 }; /* rounds of them in succession; some twenty are usual */
    const size_t most_rounds = 8 * answer->n_columns + 8; /* a few are enough: no arm is known that takes more than n */
    for (size_t round = 0, cutting = 0; round < most_rounds && cutting < MOST_CUTS;) {
        size_t added = 0;
        const armtol_fault fault = optimise_once(answer, question, rows, cutting == 0, &added);
        if (fault.status != ARMTOL_OK) {
            return fault;
        }
        if (added > 0) {
            cutting++;
        } else if (pin_low(rows, answer, question) || let_go(rows, answer, question)) {
            round++;
            cutting = 0;
        } else {
            keep_to_norms(rows, answer);
            const bool fine = note_held(answer, question, rows);
            return fault_of(fine ? ARMTOL_OK : ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
        }
    }
    return fault_of(ARMTOL_NOT_SOLVED, ARMTOL_ABOUT_METHOD, 0);
}

/* ---- sphere: the report's bounds, shared out evenly ---- */

/* The least that any pose leaves of each component. */
static void least_limits(const rows *rows, const armtol_answer *answer, double limits[6])
{
    for (size_t i = 0; i < 6; i++) {
        limits[i] = answer->accuracy[i];
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
    least_limits(rows, answer, limits);
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
    const armtol_fault fault = pack(rows, answer, question, true);
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
    const size_t shared = is_rss(question) ? spread_shared(answer) : answer->n_columns;
    if (!get_rows(rows, answer, question)) {
        return fault_of(ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
    }
    if (shared < answer->n_columns) { /* two large errors that undo each other would be fine, and no optimum */
        return fault_of(ARMTOL_BAD_SPREAD, ARMTOL_ABOUT_SPREADS, shared);
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
