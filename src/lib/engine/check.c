#include "lib/engine/check.h"

#include "lib/engine/drives.h"

#include <math.h>
#include <stdbool.h>

armtol_fault fault_of(armtol_status status, armtol_subject about, size_t number)
{
    const bool fine = status == ARMTOL_OK;
    return (armtol_fault){status, fine ? ARMTOL_ABOUT_NOTHING : about, fine ? 0 : number};
}

static bool is_positive(double value)
{
    return value > 0 && isfinite(value);
}

static bool is_whole(const armtol_question *question)
{
    const armtol_arm *arm = question->arm;
    const bool asks = question->accuracy != NULL || question->n_norms > 0 || question->tolerances != NULL;
    return arm != NULL && question->n_poses > 0 && asks &&
           (question->q != NULL || armtol_arm_joint_count(arm) == 0);
}

static bool is_method(const armtol_question *question)
{
    return (size_t)question->method < ARMTOL_METHOD_COUNT &&
           (question->method != ARMTOL_METHOD_RSS || is_positive(question->sigma));
}

static armtol_fault check_norms(const armtol_question *question)
{
    if (question->n_norms > 0 && question->method == ARMTOL_METHOD_SPHERE && question->tolerances == NULL) {
        return fault_of(ARMTOL_BAD_NORM, ARMTOL_ABOUT_METHOD, 0);
    }
    for (size_t i = 0; i < question->n_norms; i++) {
        if (i == ARMTOL_MOST_NORMS || !armtol_norm_is_known(question->norms[i].components)) {
            return fault_of(ARMTOL_BAD_NORM, ARMTOL_ABOUT_NORM, i);
        }
        if (!(question->norms[i].limit > 0)) {
            return fault_of(ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_NORM, i);
        }
    }
    return fault_of(ARMTOL_OK, ARMTOL_ABOUT_NOTHING, 0);
}

armtol_fault question_check(const armtol_question *question)
{
    if (!is_whole(question)) {
        return fault_of(ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0);
    }
    if (!is_method(question)) {
        return fault_of(ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_METHOD, 0);
    }
    for (size_t i = 0; i < 6 && question->accuracy != NULL; i++) {
        if (!(question->accuracy[i] > 0)) {
            return fault_of(ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_ACCURACY, i);
        }
    }
    const armtol_fault fault = check_norms(question);
    if (fault.status != ARMTOL_OK) {
        return fault;
    }
    const armtol_status status = armtol_arm_check(question->arm);
    return status == ARMTOL_OK ? question_check_drives(question) : fault_of(status, ARMTOL_ABOUT_ARM, 0);
}

double question_least(const armtol_question *question, size_t column)
{
    return question->least != NULL ? question->least[column] : 0;
}

double question_largest(const armtol_question *question, size_t column)
{
    return question->largest != NULL ? question->largest[column] : (double)INFINITY;
}

bool question_gives(const armtol_question *question, size_t column)
{
    return question_least(question, column) == question_largest(question, column);
}

double question_weight(const armtol_question *question, size_t column)
{
    return question->weights != NULL ? question->weights[column] : 1;
}

static bool is_range(const armtol_question *question, size_t column)
{
    const double least = question_least(question, column);
    return least >= 0 && isfinite(least) && least <= question_largest(question, column);
}

/* Whether a column is an alpha with the beta of the same link behind it. */
static bool has_beta_behind(const armtol_arm *arm, size_t column)
{
    size_t count = 0, left = column;
    const armtol_parameter *parameters = NULL;
    for (size_t i = 0; i < arm->n_links && left >= count; i++) {
        left -= count;
        parameters = armtol_kind_parameters(arm->links[i].kind, &count);
    }
    return left + 1 < count && parameters[left] == ARMTOL_ALPHA && parameters[left + 1] == ARMTOL_BETA;
}

/* Both are given, with the same tolerance. */
static bool is_disc(const armtol_question *question, size_t k)
{
    if (!has_beta_behind(question->arm, k)) {
        return false;
    }
    if (question->tolerances != NULL) {
        return question->tolerances[k] == question->tolerances[k + 1] && isfinite(question->tolerances[k]);
    }
    return question_gives(question, k) && question_gives(question, k + 1) &&
           question_least(question, k) == question_least(question, k + 1);
}

/* Whether a column's spread can be that of an error, and is that of its group. */
static bool is_spread(const armtol_question *question, size_t column)
{
    const armtol_error_spread *of = &question->spreads[column];
    size_t k = 0;
    while (of->group != 0 && question->spreads[k].group != of->group) {
        k++;
    }
    const armtol_error_spread *first = of->group != 0 ? &question->spreads[k] : of;
    return armtol_spread_is_known(of) && of->distribution == first->distribution &&
           (of->distribution != ARMTOL_NORMAL || of->sigmas == first->sigmas);
}

/* What is even in a disc has no other distribution, and no group. */
static bool is_even_in_disc(const armtol_question *question, size_t column)
{
    const bool *discs = question->discs;
    const bool in_disc = discs != NULL && (discs[column] || (column > 0 && discs[column - 1]));
    const armtol_error_spread *of = &question->spreads[column];
    return !in_disc || (of->distribution == ARMTOL_UNIFORM && of->group == 0);
}

armtol_fault question_check_columns(const armtol_question *question, size_t n_columns)
{
    for (size_t k = 0; k < n_columns; k++) {
        if (!is_positive(question_weight(question, k))) {
            return fault_of(ARMTOL_BAD_WEIGHT, ARMTOL_ABOUT_WEIGHTS, k);
        }
        if (question->tolerances != NULL && !(question->tolerances[k] >= 0)) {
            return fault_of(ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_TOLERANCES, k);
        }
        if (!is_range(question, k)) {
            return fault_of(ARMTOL_BAD_RANGE, ARMTOL_ABOUT_RANGES, k);
        }
        if (question->discs != NULL && question->discs[k] && !is_disc(question, k)) {
            return fault_of(ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_DISCS, k);
        }
        if (question->spreads != NULL && (!is_spread(question, k) || !is_even_in_disc(question, k))) {
            return fault_of(ARMTOL_BAD_SPREAD, ARMTOL_ABOUT_SPREADS, k);
        }
    }
    return fault_of(ARMTOL_OK, ARMTOL_ABOUT_NOTHING, 0);
}
