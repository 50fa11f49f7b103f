#include "lib/engine/verification_parts.h"

#include "armtol/share_interval.h"
#include "lib/engine/check.h"
#include "lib/engine/corner_search.h"
#include "lib/engine/draw.h"
#include "lib/engine/parts.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* In thousandths. */
static const unsigned shares[ARMTOL_QUANTILES] = {500, 900, 990, 999};

/* Where the tolerances leave the component without a bound, what was drawn counts what has none as exact. */
static bool is_unbounded(const armtol_answer *answer, size_t component)
{
    return isinf(answer->components[component].worst);
}

armtol_fault verification_check(const armtol_answer *answer)
{
    size_t i = 0;
    while (i < 6 && !(is_unbounded(answer, i) && isfinite(answer->accuracy[i]))) {
        i++;
    }
    return fault_of(i < 6 ? ARMTOL_UNBOUNDED : ARMTOL_OK, ARMTOL_ABOUT_ACCURACY, i);
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
 * No arm's magnitude is larger; nor is it more than twice what the arm reaches, or for a rotation vector half a turn:
 * where the remainder is large, or infinite.
 */
static double range_of(const armtol_answer *answer, size_t i)
{
    const armtol_predicted *predicted = &answer->components[i];
    return fmin(predicted->worst + predicted->remainder, i < 3 ? reach_of(answer) : 3.14159265358979323846);
}

void verification_limits(const armtol_answer *answer, tally_limits *limits)
{
    for (size_t i = 0; i < 6; i++) {
        limits->range[i] = range_of(answer, i);
        limits->accuracy[i] = answer->accuracy[i];
        limits->beyond[i] = answer->accuracy[i] + answer->components[i].remainder;
    }
}

static void report_component(const tally *tally, const tally_limits *limits, size_t i, armtol_verified *component)
{
    component->worst_drawn = fmax(tally->worst[i], 0);
    component->worst_arm = tally->worst_arm[i];
    for (size_t n = 0; n < ARMTOL_QUANTILES; n++) {
        component->quantiles[n] = tally_quantile(tally, limits, i, shares[n]);
    }
}

/* What was drawn without the parameters that it depends on says nothing. */
static void forget_component(armtol_verified *component)
{
    *component = (armtol_verified){.worst_drawn = (double)NAN, .worst_corner = (double)NAN};
    for (size_t n = 0; n < ARMTOL_QUANTILES; n++) {
        component->quantiles[n] = (double)NAN;
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
    for (size_t i = 0; i < 6; i++) {
        if (is_unbounded(answer, i)) {
            forget_component(&found->components[i]);
        } else {
            report_component(tally, limits, i, &found->components[i]);
        }
    }
}

static armtol_status search_and_draw(const armtol_answer *answer, const armtol_draw *draw, double errors[],
                                     tally *tally, armtol_verification *found)
{
    armtol_draw arms = *draw;
    tally_limits limits;
    if (!search_corners(answer, draw, errors, found->components)) {
        arms.samples = 0;
    }
    verification_limits(answer, &limits);
    const armtol_status status = draw_arms(answer, &arms, 0, &limits, tally);
    if (status == ARMTOL_OK) {
        verification_report(answer, tally, &limits, found);
    }
    return status;
}

static armtol_fault verify(const armtol_answer *answer, const armtol_draw *draw, armtol_verification *found)
{
    const armtol_fault unbounded = verification_check(answer);
    if (unbounded.status != ARMTOL_OK) {
        return unbounded;
    }
    double *errors = calloc(answer->n_columns, sizeof *errors);
    tally *tally = malloc(sizeof *tally);
    const armtol_status status =
        errors != NULL && tally != NULL ? search_and_draw(answer, draw, errors, tally, found) : ARMTOL_NO_MEMORY;
    free(errors);
    free(tally);
    return fault_of(status, status == ARMTOL_NO_MEMORY ? ARMTOL_ABOUT_NOTHING : ARMTOL_ABOUT_TOLERANCES, 0);
}

armtol_status armtol_verify(const armtol_answer *answer, const armtol_draw *draw, armtol_verification *found,
                            armtol_fault *fault)
{
    *found = (armtol_verification){0};
    const armtol_fault ended = verify(answer, draw, found);
    if (fault != NULL) {
        *fault = ended;
    }
    return ended.status;
}
