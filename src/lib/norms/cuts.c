#include "lib/norms/cuts.h"

#include "lib/norms/discs.h"
#include "lib/norms/norm_discs.h"
#include "lib/norms/spread_norm.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/*
 * Method
 *    A row for each direction in which some norm was exceeded, until none is by more than `slack` (Kelley's cutting
 *    planes). The optimum of the rows is that of optimum.h.
 *
 * Special cases
 *    A norm that asks for nothing, or of which nothing is asked in a pose, has no cuts there.
 *
 * Accuracy
 *    What `slack` leaves is taken off all tolerances, so that they are within 1e-10 of the optimum's and exceed no norm
 *    (test_an_optimum_with_norms_fulfils_the_conditions).
 */

/* Beyond its limit by more than this part a norm is cut; what is left is taken off all that is asked for in the end. */
static const double slack = 1e-11;

static bool is_asked_for(const armtol_answer *answer, size_t norm)
{
    return isfinite(answer->norms[norm].limit);
}

static bool grow(cuts *cuts, size_t n_columns)
{
    const size_t room = 2 * cuts->room + 16;
    cut *more = realloc(cuts->cuts, room * sizeof *more);
    if (more == NULL) {
        return false;
    }
    cuts->cuts = more;
    double *rows = realloc(cuts->rows, room * n_columns * sizeof *rows);
    if (rows == NULL) {
        return false;
    }
    cuts->rows = rows;
    cuts->room = room;
    return true;
}

static bool add(cuts *cuts, const armtol_answer *answer, size_t norm, size_t pose, const double direction[6])
{
    const size_t n = answer->n_columns;
    if (cuts->count == cuts->room && !grow(cuts, n)) {
        return false;
    }
    cut *next = &cuts->cuts[cuts->count];
    *next = (cut){.norm = norm, .pose = pose};
    memcpy(next->direction, direction, sizeof next->direction);
    armtol_norm_row(armtol_answer_matrix(answer, pose), n, direction, cuts->rows + cuts->count * n);
    cuts->count++;
    return true;
}

static bool add_axes(cuts *cuts, const armtol_answer *answer, size_t norm, size_t pose)
{
    bool fine = true;
    for (size_t i = 0; i < 6; i++) {
        const bool counts = (answer->norms[norm].components >> i & 1) != 0;
        const double axis[6] = {i == 0, i == 1, i == 2, i == 3, i == 4, i == 5};
        fine = fine && (!counts || add(cuts, answer, norm, pose, axis));
    }
    return fine;
}

bool cuts_start(cuts *cuts, const armtol_answer *answer)
{
    *cuts = (struct cuts){0};
    cuts->workspace = calloc(norm_discs_workspace(answer->n_columns, discs_count(answer->discs, answer->n_columns)),
                             sizeof *cuts->workspace);
    cuts->trial = calloc(answer->n_columns, 2 * sizeof *cuts->trial);
    bool fine = cuts->workspace != NULL && cuts->trial != NULL;
    for (size_t i = 0; i < answer->n_norms * answer->n_poses && fine; i++) {
        const size_t norm = i % answer->n_norms;
        fine = !is_asked_for(answer, norm) || add_axes(cuts, answer, norm, i / answer->n_norms);
    }
    return fine;
}

void cuts_free(cuts *cuts)
{
    free(cuts->cuts);
    free(cuts->rows);
    free(cuts->workspace);
    free(cuts->trial);
}

double cuts_norm(const cuts *cuts, const armtol_answer *answer, size_t norm, size_t pose, const double tolerances[],
                 double direction[6])
{
    const double *matrix = armtol_answer_matrix(answer, pose), *shifts = armtol_answer_shifts(answer, pose);
    const unsigned components = answer->norms[norm].components;
    const size_t n = answer->n_columns;
    const bool *discs = answer->discs;
    return answer->method == ARMTOL_METHOD_RSS
               ? spread_norm(answer, pose, components, shifts, tolerances, answer->sigma / sqrt(3), direction)
               : norm_discs_worst(matrix, n, components, shifts, tolerances, discs, direction, cuts->workspace);
}

bool cuts_is_seen(const armtol_answer *answer, size_t norm, size_t pose, const bool columns[])
{
    const double *matrix = armtol_answer_matrix(answer, pose);
    bool seen = false;
    for (size_t i = 0; i < 6; i++) {
        for (size_t k = 0; k < answer->n_columns && (answer->norms[norm].components >> i & 1) != 0; k++) {
            seen = seen || (columns[k] && matrix[i * answer->n_columns + k] != 0);
        }
    }
    return seen;
}

/* All tolerances in a pose; one without a bound is seen by nothing. */
static const double *try_in_pose(const cuts *cuts, const armtol_answer *answer, size_t pose, const bool asked[],
                                 const double tolerances[])
{
    const double *given = armtol_answer_bounded(answer, pose);
    for (size_t k = 0; k < answer->n_columns; k++) {
        cuts->trial[k] = !asked[k] ? given[k] : isfinite(tolerances[k]) ? tolerances[k] : 0;
    }
    return cuts->trial;
}

/* What a norm is along its direction: with discs it may be told as more, and a cut there would cut nothing. */
static double along(const cuts *cuts, const armtol_answer *answer, size_t pose, const double trial[],
                    const double direction[6])
{
    const double *shifts = armtol_answer_shifts(answer, pose);
    double *const row = cuts->trial + answer->n_columns, shift = 0;
    armtol_norm_row(armtol_answer_matrix(answer, pose), answer->n_columns, direction, row);
    for (size_t k = 0; k < answer->n_columns; k++) {
        shift += row[k] * shifts[k];
    }
    return fabs(shift) + discs_worst(row, answer->n_columns, trial, answer->discs);
}

static bool is_beyond(const cuts *cuts, const armtol_answer *answer, size_t norm, size_t pose, const double trial[],
                      double direction[6])
{
    const double limit = answer->norms[norm].limit * (1 + slack);
    const bool exact = answer->method == ARMTOL_METHOD_RSS || discs_count(answer->discs, answer->n_columns) == 0;
    return cuts_norm(cuts, answer, norm, pose, trial, direction) > limit &&
           (exact || along(cuts, answer, pose, trial, direction) > limit);
}

bool cuts_add(cuts *cuts, const armtol_answer *answer, const bool asked[], const double tolerances[], size_t *added)
{
    *added = 0;
    for (size_t i = 0; i < answer->n_norms * answer->n_poses; i++) {
        const size_t norm = i % answer->n_norms, pose = i / answer->n_norms;
        double direction[6];
        if (!is_asked_for(answer, norm) || !cuts_is_seen(answer, norm, pose, asked)) {
            continue;
        }
        const double *trial = try_in_pose(cuts, answer, pose, asked, tolerances);
        if (is_beyond(cuts, answer, norm, pose, trial, direction)) {
            if (!add(cuts, answer, norm, pose, direction)) {
                return false;
            }
            ++*added;
        }
    }
    return true;
}

/* A norm is convex in them: a share of them adds no more than that share of what they all add to what is given. */
double cuts_factor(const cuts *cuts, const armtol_answer *answer, const bool asked[], const double tolerances[])
{
    const double rounding = (double)(answer->n_columns + 16) * DBL_EPSILON;
    double most = 0;
    for (size_t i = 0; i < answer->n_norms * answer->n_poses; i++) {
        const size_t norm = i % answer->n_norms, pose = i / answer->n_norms;
        double direction[6];
        if (!is_asked_for(answer, norm) || !cuts_is_seen(answer, norm, pose, asked)) {
            continue;
        }
        const double limit = answer->norms[norm].limit * (1 - rounding);
        const double *trial = try_in_pose(cuts, answer, pose, asked, tolerances);
        const double whole = cuts_norm(cuts, answer, norm, pose, trial, direction);
        const double given = cuts_norm(cuts, answer, norm, pose, armtol_answer_bounded(answer, pose), direction);
        most = fmax(most, (whole - limit) / (whole - given));
    }
    return 1 - fmin(most, 1);
}

/* ---- what holds ---- */

/* Two cuts that say the same of a norm in a pose: the last ones before no more are found lie close. */
static bool are_one(const armtol_held_direction *held, const cut *cut)
{
    static const double near = 1e-8; /* 1e-4 rad, squared */
    double cosine = 0;
    for (size_t i = 0; i < 6; i++) {
        cosine += held->direction[i] * cut->direction[i];
    }
    return held->norm == cut->norm && held->pose == cut->pose && fabs(cosine) > 1 - near / 2;
}

/* The mean of the two by their shares. */
static void join(armtol_held_direction *held, const cut *cut, double share)
{
    double squares = 0, cosine = 0;
    for (size_t i = 0; i < 6; i++) {
        cosine += held->direction[i] * cut->direction[i];
    }
    for (size_t i = 0; i < 6; i++) {
        held->direction[i] = held->share * held->direction[i] + (cosine < 0 ? -share : share) * cut->direction[i];
        squares += held->direction[i] * held->direction[i];
    }
    for (size_t i = 0; i < 6; i++) {
        held->direction[i] /= sqrt(squares);
    }
    held->share += share;
}

static void note(armtol_answer *answer, const cut *cut, double share)
{
    size_t i = 0;
    while (i < answer->n_held && !are_one(&answer->held_directions[i], cut)) {
        i++;
    }
    armtol_held_direction *held = &answer->held_directions[i];
    if (i < answer->n_held) {
        join(held, cut, share);
        return;
    }
    *held = (armtol_held_direction){.norm = cut->norm, .pose = cut->pose, .share = share};
    memcpy(held->direction, cut->direction, sizeof held->direction);
    answer->n_held++;
}

static void sort_held(armtol_answer *answer)
{
    for (size_t i = 1; i < answer->n_held; i++) {
        const armtol_held_direction held = answer->held_directions[i];
        size_t at = i;
        for (; at > 0 && answer->held_directions[at - 1].share < held.share; at--) {
            answer->held_directions[at] = answer->held_directions[at - 1];
        }
        answer->held_directions[at] = held;
    }
}

bool cuts_note(const cuts *cuts, armtol_answer *answer, const double shares[])
{
    double most[ARMTOL_MOST_NORMS] = {0};
    answer->held_directions = calloc(cuts->count + 1, sizeof *answer->held_directions);
    if (answer->held_directions == NULL) {
        return false;
    }
    for (size_t i = 0; i < cuts->count; i++) {
        if (shares[i] > 0) {
            note(answer, &cuts->cuts[i], shares[i]);
        }
    }
    sort_held(answer);
    for (size_t i = 0; i < answer->n_held; i++) {
        const armtol_held_direction *held = &answer->held_directions[i];
        armtol_predicted *of = &answer->norms[held->norm].of;
        of->binds += held->share;
        of->binds_pose = held->share > most[held->norm] ? held->pose : of->binds_pose;
        most[held->norm] = fmax(most[held->norm], held->share);
    }
    return true;
}
