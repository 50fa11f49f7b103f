#include "armtol/engine/verification.h"

#include "armtol/engine/verification_corners.h"
#include "armtol/engine/verification_draw.h"
#include "armtol/engine/verification_tally.h"
#include "console/exit_code.h"
#include "console/share_interval.h"

#include "armtol/corners.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

const double verification_quantiles[VERIFICATION_QUANTILES] = {0.5, 0.9, 0.99, 0.999};

/* No arm's magnitude is larger, nor does a rotation vector turn by more than half a turn. */
static double range_of(const verified_component *component, bool linear)
{
    return fmin(component->prediction + component->remainder, linear ? DBL_MAX : 3.14159265358979323846);
}

static void set_limits(const verification_task *task, const verified_component components[6],
                       tally_limits *limits)
{
    for (size_t i = 0; i < 6; i++) {
        limits->range[i] = range_of(&components[i], i < 3);
        limits->accuracy[i] = task->accuracy != NULL ? task->accuracy[i] : (double)INFINITY;
        limits->beyond[i] = limits->accuracy[i] + components[i].remainder;
    }
}

static void report(const tally *tally, const tally_limits *limits, verification *result)
{
    const share_interval interval = share_interval_95(tally->within, tally->drawn);
    result->drawn = tally->drawn;
    result->within = tally->within;
    result->beyond = tally->beyond;
    result->share_low = interval.low;
    result->share_high = interval.high;
    for (size_t i = 0; i < 6; i++) {
        verified_component *component = &result->components[i];
        component->worst_drawn = fmax(tally->worst[i], 0);
        component->worst_arm = tally->worst_arm[i];
        for (size_t n = 0; n < VERIFICATION_QUANTILES; n++) {
            const unsigned thousandths = (unsigned)lround(1000 * verification_quantiles[n]);
            component->quantiles[n] = tally_quantile(tally, limits, i, thousandths);
        }
    }
}

static bool draw_and_report(const verification_task *task, verification *result)
{
    tally_limits limits;
    tally *all = malloc(sizeof *all);
    if (all == NULL) {
        out_of_memory();
        return false;
    }
    set_limits(task, result->components, &limits);
    const bool fine = verification_draw(task, &limits, all);
    if (fine) {
        report(all, &limits, result);
    }
    free(all);
    return fine;
}

static bool is_unbounded(const verification_task *task, size_t component)
{
    for (size_t pose = 0; pose < task->n_poses; pose++) {
        const double *matrix = task->matrices + pose * 6 * task->n_columns;
        if (isinf(armtol_worst_error(matrix, task->n_columns, component, task->tolerances))) {
            return true;
        }
    }
    return false;
}

/* What was drawn without the parameters that it depends on says nothing. */
static void forget_unbounded(const verification_task *task, verified_component components[6])
{
    for (size_t i = 0; i < 6; i++) {
        if (is_unbounded(task, i)) {
            components[i] = (verified_component){
                .prediction = (double)INFINITY,
                .rss = (double)INFINITY,
                .remainder = (double)INFINITY,
                .worst_drawn = (double)NAN,
                .worst_corner = (double)NAN,
            };
            for (size_t n = 0; n < VERIFICATION_QUANTILES; n++) {
                components[i].quantiles[n] = (double)NAN;
            }
        }
    }
}

/* The tolerances without those that are infinite; NULL, after a message, where memory is short. */
static double *bounded(const verification_task *task)
{
    double *tolerances = malloc((task->n_columns + 1) * sizeof *tolerances);
    if (tolerances == NULL) {
        out_of_memory();
        return NULL;
    }
    for (size_t k = 0; k < task->n_columns; k++) {
        tolerances[k] = isinf(task->tolerances[k]) ? 0 : task->tolerances[k];
    }
    return tolerances;
}

bool verification_run(const verification_task *task, verification *result)
{
    verification_task finite = *task;
    double *tolerances = bounded(task);
    if (tolerances == NULL) {
        return false;
    }
    finite.tolerances = tolerances;
    const bool fine = verification_corners(&finite, result->components) && draw_and_report(&finite, result);
    free(tolerances);
    if (fine) {
        forget_unbounded(task, result->components);
    }
    return fine;
}
