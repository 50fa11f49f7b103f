#ifndef ARMTOL_TELL_FINDINGS_H
#define ARMTOL_TELL_FINDINGS_H

#include "armtol/answer.h"
#include "armtol/arrivals.h"
#include "armtol/ask/request.h"
#include "armtol/budget.h"
#include "armtol/region.h"
#include "armtol/verification.h"

#include <stdbool.h>

/* What noise drives may have: of every link, in inside units. */
typedef struct noises {
    double *largest, *shares; /* shares: room for armtol_arrivals_bound */
    double bound;             /* of RP with the noise that drives have, the largest of all poses */
} noises;

/* All that there is to tell. NULL for what was not asked for. */
typedef struct findings {
    const request *request;
    const armtol_answer *answer;
    const armtol_budget *budget;
    const armtol_verification *verification;
    const armtol_arrivals *arrivals;
    const noises *noises;
    const armtol_region_answer *region; /* whose answer it then is */
} findings;

/* One parameter of one link, in the user's units. */
typedef struct parameter_row {
    size_t link;
    const char *name; /* the link's; NULL where it has none */
    const char *kind, *parameter;
    const char *role; /* "motor" or "machining" */
    const char *unit;
    double nominal;   /* in the pose; of several poses, at joint value 0 */
    double tolerance; /* infinity for one that does not matter */
    bool given;       /* by a drive or by --given */
    bool drawn;       /* by --drawing */
    bool in_disc;     /* with the link's other angle: the tolerance is the disc's radius */
    distribution_text distribution;
    double shift;      /* the mean of its error */
    const char *group; /* its group's name; "" for one by itself */
    double held;      /* the share of the optimum that its range holds; negative for its least */
} parameter_row;

parameter_row findings_parameter(const findings *findings, size_t column);

/* Whether something is said of how errors are distributed; whether of any mean. */
bool findings_are_spread(const findings *findings);
bool findings_are_shifted(const findings *findings);

/* What is told of an error is its six components and, behind them, norms: measures. */
size_t findings_measures(const findings *findings);
const char *findings_name(const findings *findings, size_t measure);
const armtol_predicted *findings_predicted(const findings *findings, size_t measure);
const armtol_verified *findings_verified(const findings *findings, size_t measure);
bool findings_is_length(const findings *findings, size_t measure);

/* Whether a norm, from 0, was asked for as ap. */
bool findings_is_ap(const findings *findings, size_t norm);

/* Infinity for one that is free, nan where no accuracy is asked for. */
double findings_accuracy(const findings *findings, size_t measure);

/* What loads and sigma standard deviations come to, of a norm in its worst direction. */
double findings_sigmas(const findings *findings, size_t measure);

/* Of the budget: a row's share in it, and those of all motors, all loads and all means. */
double findings_share(const armtol_budget_row *row, size_t measure);
double findings_motors(const armtol_budget *budget, size_t measure);
double findings_loads(const armtol_budget *budget, size_t measure);
double findings_shifts(const armtol_budget *budget, size_t measure);

/* The pose, from 0, that holds it down or, where none does, in which it is largest. */
size_t findings_pose(const findings *findings, size_t measure);

/* Its number in the user's units. */
double findings_shown(const findings *findings, size_t measure, double value);

/* How far the droops of a pose's loads are apart, component by component, in the user's units. */
void findings_load_difference(const findings *findings, size_t pose, double difference[6]);

/* Of an enclosure: its name, whether it is a length, and by what part of `low` it is open. */
const char *findings_enclosure_name(const armtol_enclosure *enclosure);
bool findings_enclosure_is_length(const armtol_enclosure *enclosure);
double findings_gap(const armtol_enclosure *enclosure);

#endif
