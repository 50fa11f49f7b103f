#include "armtol/answer.h"

#include "armtol/corners.h"
#include "lib/engine/check.h"
#include "lib/engine/drives.h"
#include "lib/engine/find.h"
#include "lib/engine/parts.h"
#include "lib/engine/place.h"
#include "lib/norms/answer_norms.h"
#include "lib/norms/discs.h"
#include "lib/norms/norm_discs.h"
#include "lib/spread/answer_spread.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/* What sees a parameter without a bound has none either; elsewhere such a parameter counts as exact. */
static void predict_component(const armtol_answer *answer, size_t pose, size_t i, armtol_predicted *component)
{
    const double *matrix = armtol_answer_matrix(answer, pose), *bounded = armtol_answer_bounded(answer, pose);
    const size_t n = answer->n_columns;
    const double *row = matrix + i * n;
    const bool *discs = answer->discs;
    const bool has_bound = isfinite(armtol_worst_error(matrix, n, i, answer->tolerances));
    const double shift = fabs(armtol_answer_shift(answer, pose, i));
    const double worst = has_bound ? shift + discs_worst(row, n, bounded, discs) : (double)INFINITY;
    const double deviation = has_bound ? spread_rss(answer, row, bounded) / sqrt(3) : (double)INFINITY;
    if (worst > component->worst) {
        component->worst_pose = pose;
    }
    if (deviation > component->deviation) {
        component->deviation_pose = pose;
    }
    component->worst = fmax(component->worst, worst);
    component->shift = fmax(component->shift, shift);
    component->deviation = fmax(component->deviation, deviation);
    component->remainder = fmax(component->remainder, has_bound ? answer->remainders[6 * pose + i] : worst);
}

/* The box about the arm as meant that holds all that drives and tolerances can do together: half widths |s| + t. */
static void reach_of(const armtol_answer *answer, size_t pose, double reach[])
{
    for (size_t k = 0; k < answer->n_columns; k++) {
        reach[k] = fabs(armtol_answer_shifts(answer, pose)[k]) + armtol_answer_bounded(answer, pose)[k];
    }
}

/* workspace: for norms, where there are any. */
static void predict(armtol_answer *answer, double reach[], double workspace[])
{
    for (size_t pose = 0; pose < answer->n_poses; pose++) {
        reach_of(answer, pose, reach);
        double *remainder = answer->remainders + 6 * pose, rounding[6];
        armtol_remainder(armtol_answer_matrix(answer, pose), answer->n_columns, reach, remainder);
        armtol_rounding(armtol_answer_links(answer, pose), answer->n_links, &answer->tool, reach, rounding);
        for (size_t i = 0; i < 6; i++) {
            remainder[i] += rounding[i];
            predict_component(answer, pose, i, &answer->components[i]);
            answer->components[i].rounding = fmax(answer->components[i].rounding, rounding[i]);
        }
        answer_predict_norms(answer, pose, rounding, workspace);
    }
}

static bool get_memory(armtol_answer *answer)
{
    const size_t n = answer->n_columns, n_poses = answer->n_poses;
    answer->tolerances = calloc(n, sizeof *answer->tolerances);
    answer->bounded = calloc(n_poses, n * sizeof *answer->bounded);
    answer->shifts = calloc(n_poses, n * sizeof *answer->shifts);
    answer->moments = calloc(n_poses, answer->n_links * sizeof *answer->moments);
    answer->arrivals = calloc(n_poses, answer->n_links * sizeof *answer->arrivals);
    answer->droops = calloc(n_poses, 6 * sizeof *answer->droops);
    answer->remainders = calloc(n_poses, 6 * sizeof *answer->remainders);
    answer->given = calloc(n, sizeof *answer->given);
    answer->held = calloc(n, sizeof *answer->held);
    answer->discs = calloc(n, sizeof *answer->discs);
    answer->parts = calloc(answer->n_links, sizeof *answer->parts);
    answer->spreads = calloc(n, sizeof *answer->spreads);
    answer->factors = calloc(n, sizeof *answer->factors);
    answer->leaders = calloc(n, sizeof *answer->leaders);
    return answer->tolerances != NULL && answer->bounded != NULL && answer->shifts != NULL && answer->moments != NULL &&
           answer->arrivals != NULL && answer->droops != NULL && answer->remainders != NULL &&
           answer->given != NULL && answer->held != NULL && answer->discs != NULL && answer->parts != NULL &&
           answer->spreads != NULL && answer->factors != NULL && answer->leaders != NULL;
}

/* What is said of a column counts in every pose; where a drive has told it, in the poses in which that is less. */
static void set_tolerance(armtol_answer *answer, size_t column, double tolerance, bool driven)
{
    const double least = driven ? answer->tolerances[column] : 0;
    answer->tolerances[column] = fmax(tolerance, least);
    for (size_t pose = 0; pose < answer->n_poses; pose++) {
        double *bounded = &answer->bounded[pose * answer->n_columns + column];
        const double drive = driven ? *bounded : 0;
        *bounded = isfinite(answer->tolerances[column]) ? fmax(tolerance, drive) : 0;
    }
}

static void take_given(armtol_answer *answer, const armtol_question *question)
{
    for (size_t k = 0; k < answer->n_columns; k++) {
        const bool driven = answer->given[k];
        if (question->tolerances != NULL) {
            set_tolerance(answer, k, question->tolerances[k], driven);
        } else if (driven || question_gives(question, k)) {
            set_tolerance(answer, k, question_least(question, k), driven);
            answer->given[k] = true;
        }
    }
}

static void take_discs(armtol_answer *answer, const armtol_question *question)
{
    for (size_t k = 0; k < answer->n_columns && question->discs != NULL; k++) {
        answer->discs[k] = question->discs[k];
        if (answer->discs[k]) {
            answer->factors[k] = answer->factors[k + 1] = DISC_FACTOR;
        }
    }
}

static armtol_fault find_others(armtol_answer *answer, const armtol_question *question)
{
    const armtol_fault fault = answer_find_tolerances(answer, question);
    for (size_t k = 0; k < answer->n_columns && fault.status == ARMTOL_OK; k++) {
        if (!answer->given[k]) {
            set_tolerance(answer, k, answer->tolerances[k], false);
        }
    }
    return fault;
}

/* The drives' and the question's own, and the largest that keep to the accuracy beside them. */
static armtol_fault take_tolerances(armtol_answer *answer, const armtol_question *question)
{
    armtol_fault fault = question_check_columns(question, answer->n_columns);
    if (fault.status == ARMTOL_OK) {
        fault = answer_take_drives(answer, question);
    }
    if (fault.status == ARMTOL_OK) {
        answer_find_droops(answer); /* by what drives shift alone */
        answer_take_spreads(answer, question);
        take_given(answer, question);
        take_discs(answer, question);
    }
    return fault.status == ARMTOL_OK && question->tolerances == NULL ? find_others(answer, question) : fault;
}

static armtol_fault conclude(armtol_answer *answer, const armtol_question *question)
{
    double *reach = calloc(answer->n_columns, sizeof *reach);
    const size_t n_discs = discs_count(answer->discs, answer->n_columns);
    double *workspace = calloc(norm_discs_workspace(answer->n_columns, n_discs), sizeof *workspace);
    if (reach == NULL || workspace == NULL) {
        free(reach);
        free(workspace);
        return fault_of(ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
    }
    answer_make_parts(answer, question);
    predict(answer, reach, workspace);
    free(reach);
    free(workspace);
    return fault_of(ARMTOL_OK, ARMTOL_ABOUT_NOTHING, 0);
}

static void take_accuracy(armtol_answer *answer, const armtol_question *question)
{
    for (size_t i = 0; i < 6; i++) {
        answer->accuracy[i] = question->accuracy != NULL ? question->accuracy[i] : (double)INFINITY;
    }
    answer_take_norms(answer, question);
}

static armtol_fault fill(armtol_answer *answer, const armtol_question *question)
{
    armtol_fault fault = question_check(question);
    if (fault.status == ARMTOL_OK) {
        take_accuracy(answer, question);
        fault = answer_place(answer, question);
    }
    if (fault.status == ARMTOL_OK && !get_memory(answer)) {
        fault = fault_of(ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
    }
    if (fault.status == ARMTOL_OK) {
        fault = take_tolerances(answer, question);
    }
    if (fault.status == ARMTOL_OK) {
        fault = conclude(answer, question);
    }
    return fault;
}

armtol_status armtol_answer_create(const armtol_question *question, armtol_answer **answer, armtol_fault *fault)
{
    armtol_fault found = fault_of(ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
    *answer = calloc(1, sizeof **answer);
    if (*answer != NULL) {
        (*answer)->method = question->method;
        (*answer)->sigma = question->sigma;
        (*answer)->delta = (double)NAN;
        found = fill(*answer, question);
    }
    if (found.status != ARMTOL_OK) {
        armtol_answer_destroy(*answer);
        *answer = NULL;
    }
    if (fault != NULL) {
        *fault = found;
    }
    return found.status;
}

void armtol_answer_destroy(armtol_answer *answer)
{
    if (answer != NULL) {
        free(answer->columns);
        free(answer->links);
        free(answer->matrices);
        free(answer->tolerances);
        free(answer->bounded);
        free(answer->shifts);
        free(answer->moments);
        free(answer->arrivals);
        free(answer->droops);
        free(answer->remainders);
        free(answer->given);
        free(answer->held);
        free(answer->held_directions);
        free(answer->discs);
        free(answer->parts);
        free(answer->spreads);
        free(answer->factors);
        free(answer->leaders);
        free(answer);
    }
}
