#include "lib/engine/verification_parts.h"

#include "armtol/share_interval.h"
#include "armtol/tally.h"
#include "lib/engine/check.h"
#include "lib/engine/corner_search.h"
#include "lib/engine/draw.h"
#include "lib/engine/parts.h"
#include "lib/norms/answer_norms.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/* In thousandths. */
static const unsigned shares[ARMTOL_QUANTILES] = {500, 900, 990, 999};

static size_t measures_of(const armtol_answer *answer)
{
    return 6 + answer->n_norms;
}

static double accuracy_of(const armtol_answer *answer, size_t measure)
{
    return measure < 6 ? answer->accuracy[measure] : answer->norms[measure - 6].limit;
}

/* Where the tolerances leave it without a bound, what was drawn counts what has none as exact. */
static bool is_unbounded(const armtol_answer *answer, size_t measure)
{
    return isinf(answer_predicted(answer, measure)->worst);
}

armtol_fault verification_check(const armtol_answer *answer)
{
    size_t i = 0;
    while (i < measures_of(answer) && !(is_unbounded(answer, i) && isfinite(accuracy_of(answer, i)))) {
        i++;
    }
    return fault_of(i < measures_of(answer) ? ARMTOL_UNBOUNDED : ARMTOL_OK,
                    i < 6 ? ARMTOL_ABOUT_ACCURACY : ARMTOL_ABOUT_NORM, i < 6 ? i : i - 6);
}

/* The length of an arm's chain, stretched and built: neither it nor the arm as meant can reach farther. */
static double reach_of(const armtol_answer *answer)
{
    double reach = answer_lever(answer);
    for (size_t k = 0; k < answer->n_columns; k++) {
        double most = 0;
        for (size_t pose = 0; pose < answer->n_poses; pose++) {
            most = fmax(most, armtol_answer_bounded(answer, pose)[k] + fabs(armtol_answer_shifts(answer, pose)[k]));
        }
        reach += armtol_parameter_is_length(answer->columns[k].parameter) ? most : 0;
    }
    return fmin(2 * reach, DBL_MAX);
}

/*
 * No arm's magnitude is larger; nor is it more than twice what the arm reaches, or for a rotation vector half a turn,
 * in any direction: where the remainder is large, or infinite.
 */
static double range_of(const armtol_answer *answer, size_t i)
{
    const armtol_predicted *predicted = answer_predicted(answer, i);
    const bool is_length = i < 6 ? i < 3 : armtol_norm_is_length(answer->norms[i - 6].components);
    return fmin(predicted->worst + predicted->remainder, is_length ? reach_of(answer) : 3.14159265358979323846);
}

void verification_limits(const armtol_answer *answer, tally_limits *limits)
{
    limits->n_measures = measures_of(answer);
    for (size_t i = 0; i < limits->n_measures; i++) {
        limits->components[i] = i < 6 ? 0 : answer->norms[i - 6].components;
        limits->range[i] = range_of(answer, i);
        limits->accuracy[i] = accuracy_of(answer, i);
        limits->beyond[i] = accuracy_of(answer, i) + answer_predicted(answer, i)->remainder;
    }
}

static void report_measure(const tally *tally, const tally_limits *limits, size_t i, armtol_verified *of)
{
    of->worst_drawn = fmax(tally->worst[i], 0);
    of->worst_arm = tally->worst_arm[i];
    for (size_t n = 0; n < ARMTOL_QUANTILES; n++) {
        of->quantiles[n] = tally_quantile(tally, limits, i, shares[n]);
    }
}

/* What was drawn without the parameters that it depends on says nothing. */
static void forget_measure(armtol_verified *of)
{
    *of = (armtol_verified){.worst_drawn = (double)NAN, .worst_corner = (double)NAN};
    for (size_t n = 0; n < ARMTOL_QUANTILES; n++) {
        of->quantiles[n] = (double)NAN;
    }
}

void verification_report(const armtol_answer *answer, const tally *tally, const tally_limits *limits,
                         armtol_verification *found)
{
    const armtol_share_interval interval = armtol_share_interval_95(tally->within, tally->drawn);
    found->drawn = tally->drawn;
    found->within = tally->within;
    found->beyond = tally->beyond;
    found->share_low = interval.low;
    found->share_high = interval.high;
    for (size_t n = 0; n < ARMTOL_QUANTILES; n++) {
        found->probabilities[n] = shares[n] / 1000.0;
    }
    for (size_t i = 0; i < measures_of(answer); i++) {
        armtol_verified *of = i < 6 ? &found->components[i] : &found->norms[i - 6];
        if (is_unbounded(answer, i)) {
            forget_measure(of);
        } else {
            report_measure(tally, limits, i, of);
        }
    }
}

/* Corners; *all says whether none was left out. */
static armtol_status search(const armtol_answer *answer, const armtol_draw *draw, armtol_verification *found, bool *all)
{
    double *workspace = calloc(answer->n_columns, SEARCH_WORKSPACE * sizeof *workspace);
    if (workspace == NULL) {
        return ARMTOL_NO_MEMORY;
    }
    *all = search_corners(answer, draw, workspace, found);
    free(workspace);
    return ARMTOL_OK;
}

static armtol_status draw_range(const armtol_answer *answer, const armtol_draw *draw, uint64_t first, tally *tally)
{
    tally_limits limits;
    verification_limits(answer, &limits);
    return draw_arms(answer, draw, first, &limits, tally);
}

static void report(const armtol_answer *answer, const tally *tally, armtol_verification *found)
{
    tally_limits limits;
    verification_limits(answer, &limits);
    verification_report(answer, tally, &limits, found);
}

static armtol_status search_and_draw(const armtol_answer *answer, const armtol_draw *draw, tally *tally,
                                     armtol_verification *found)
{
    armtol_draw arms = *draw;
    bool all;
    armtol_status status = search(answer, draw, found, &all);
    if (status == ARMTOL_OK) {
        arms.samples = all ? draw->samples : 0;
        status = draw_range(answer, &arms, 0, tally);
    }
    if (status == ARMTOL_OK) {
        report(answer, tally, found);
    }
    return status;
}

static armtol_status ended_with(armtol_fault ended, armtol_fault *fault)
{
    if (fault != NULL) {
        *fault = ended;
    }
    return ended.status;
}

static armtol_fault fault_of_work(armtol_status status)
{
    return fault_of(status, status == ARMTOL_NO_MEMORY ? ARMTOL_ABOUT_NOTHING : ARMTOL_ABOUT_TOLERANCES, 0);
}

armtol_status armtol_verify(const armtol_answer *answer, const armtol_draw *draw, armtol_verification *found,
                            armtol_fault *fault)
{
    *found = (armtol_verification){0};
    armtol_fault ended = verification_check(answer);
    if (ended.status == ARMTOL_OK) {
        tally *tally = malloc(sizeof *tally);
        ended = fault_of_work(tally != NULL ? search_and_draw(answer, draw, tally, found) : ARMTOL_NO_MEMORY);
        free(tally);
    }
    return ended_with(ended, fault);
}

armtol_status armtol_tally_draw(const armtol_answer *answer, const armtol_draw *draw, uint64_t first,
                                armtol_tally *tally, armtol_fault *fault)
{
    armtol_fault ended = verification_check(answer);
    if (ended.status == ARMTOL_OK) {
        armtol_tally_clear(tally); /* what is drawn leaves the measures alone that the answer has not */
        ended = fault_of_work(draw_range(answer, draw, first, tally));
    }
    return ended_with(ended, fault);
}

armtol_status armtol_tally_verify(const armtol_answer *answer, const armtol_draw *draw, const armtol_tally *tally,
                                  armtol_verification *found, armtol_fault *fault)
{
    bool all;
    *found = (armtol_verification){0};
    armtol_fault ended = verification_check(answer);
    if (ended.status == ARMTOL_OK) {
        ended = fault_of_work(search(answer, draw, found, &all));
    }
    if (ended.status == ARMTOL_OK) {
        report(answer, tally, found);
    }
    return ended_with(ended, fault);
}
