#include "lib/inverse/search.h"

#include "lib/inverse/damped.h"
#include "lib/pi.h"

#include <math.h>
#include <string.h>

enum { MOST_STEPS = 100, MOST_APPROACHES = 100 };

/* Of the damping: at first, at the least (what rounding leaves of a sum of six squares is below), and the end. */
#define DAMPING_FIRST 0.1
#define DAMPING_LEAST 1e-12
#define DAMPING_MOST 1e6

/* An error whose square is below is rounding; one that a step makes less by a smaller share has come to a rest. */
#define SQUARE_DONE 1e-27
#define SHARE_LEAST 1e-3

static void hold_none(const search *search)
{
    for (size_t j = 0; j < search->chain->n_joints; j++) {
        search->held[j] = false;
    }
}

/* Hold joints at their limits whose way leads out; whether another one is now. */
static bool hold_at_limits(const search *search, const double q[], const double way[])
{
    bool more = false;
    for (size_t j = 0; j < search->chain->n_joints; j++) {
        const chain_joint *joint = &search->chain->joints[j];
        const bool out = (way[j] < 0 && q[j] <= joint->low) || (way[j] > 0 && q[j] >= joint->high);
        more = more || (out && !search->held[j]);
        search->held[j] = search->held[j] || out;
    }
    return more;
}

static double clamped(const chain_joint *joint, double value)
{
    return fmin(fmax(value, joint->low), joint->high);
}

static void take_step(const search *search, bool limited, const double q[], double share)
{
    for (size_t j = 0; j < search->chain->n_joints; j++) {
        const chain_joint *joint = &search->chain->joints[j];
        const double value = q[j] + share * joint->unit * search->step[j];
        search->trial[j] = limited ? clamped(joint, value) : value;
    }
}

static void find_step(const search *search, bool limited, double damping, const double q[], const double e[])
{
    const chain *chain = search->chain;
    hold_none(search);
    do {
        damped_step(chain->jacobian, search->goal.n_rows, chain->n_joints, search->held, damping, e, search->step);
    } while (limited && hold_at_limits(search, q, search->step));
}

bool search_is_there(const search *search, const chain_error *error)
{
    const double *e = error->e;
    const double distance = e[0] * e[0] + e[1] * e[1] + e[2] * e[2], most = search->within * search->within;
    const double away = search->goal.away;
    return distance <= most * away * away && error->square - distance <= most;
}

void search_descend(const search *search, bool limited, double q[], chain_error *error)
{
    const chain *chain = search->chain;
    double damping = DAMPING_FIRST;
    armtol_transform tool;
    chain_error next;
    chain_place(chain, q, &tool);
    chain_compare(chain, &search->goal, &tool, error);
    chain_differentiate(chain, &tool);
    for (int i = 0; i < MOST_STEPS && error->square > SQUARE_DONE && damping <= DAMPING_MOST; i++) {
        find_step(search, limited, damping, q, error->e);
        take_step(search, limited, q, 1);
        chain_place(chain, search->trial, &tool);
        chain_compare(chain, &search->goal, &tool, &next);
        if (!(next.square < error->square)) {
            damping *= 8;
            continue;
        }
        const bool rests = next.square > (1 - SHARE_LEAST) * error->square;
        memcpy(q, search->trial, chain->n_joints * sizeof *q);
        *error = next;
        chain_differentiate(chain, &tool);
        damping = fmax(damping / 8, DAMPING_LEAST);
        if (rests) {
            return;
        }
    }
}

double search_from_near(const chain *chain, const double q[])
{
    double sum = 0;
    for (size_t j = 0; j < chain->n_joints; j++) {
        const double off = (q[j] - chain->joints[j].near) / chain->joints[j].unit;
        sum += off * off;
    }
    return sqrt(sum);
}

/* By whole turns: nearest to `near` (half a turn off: above it), then within the limits where it can be. */
static double unwound(const chain_joint *joint, double value)
{
    const double turn = 2 * PI, slack = 1e-9;
    value += turn * ceil((joint->near - value) / turn - 0.5 - slack);
    if (value > joint->high + slack) {
        value -= turn * ceil((value - joint->high - slack) / turn);
    } else if (value < joint->low - slack) {
        value += turn * ceil((joint->low - slack - value) / turn);
    }
    return value;
}

static bool keeps_to_limits(const chain_joint *joint, double value)
{
    return fabs(value - clamped(joint, value)) <= 1e-12 * joint->unit;
}

bool search_is_within(const chain *chain, const double q[])
{
    bool within = true;
    for (size_t j = 0; j < chain->n_joints; j++) {
        within = within && keeps_to_limits(&chain->joints[j], q[j]);
    }
    return within;
}

/* Whether all joints are within their limits then; those beyond by rounding are put on them. */
static bool unwind(const chain *chain, double q[])
{
    for (size_t j = 0; j < chain->n_joints; j++) {
        const chain_joint *joint = &chain->joints[j];
        q[j] = joint->turns ? unwound(joint, q[j]) : q[j];
        q[j] = keeps_to_limits(joint, q[j]) ? clamped(joint, q[j]) : q[j];
    }
    return search_is_within(chain, q);
}

/* What of a pull on the joints leaves the tool where it is: pull - J'(JJ' + l)^-1 J pull. */
static void find_standing_step(const search *search, bool limited, const double q[])
{
    const chain *chain = search->chain;
    const size_t n = chain->n_joints;
    hold_none(search);
    do {
        double moved[6] = {0};
        for (size_t i = 0; i < search->goal.n_rows; i++) {
            for (size_t j = 0; j < n; j++) {
                moved[i] += search->held[j] ? 0 : chain->jacobian[i * n + j] * search->pull[j];
            }
        }
        damped_step(chain->jacobian, search->goal.n_rows, n, search->held, DAMPING_LEAST, moved, search->step);
        for (size_t j = 0; j < n; j++) {
            search->step[j] = search->held[j] ? 0 : search->pull[j] - search->step[j];
        }
    } while (limited && hold_at_limits(search, q, search->step));
}

static double length_of_steps(const double steps[], size_t n)
{
    double sum = 0;
    for (size_t j = 0; j < n; j++) {
        sum += steps[j] * steps[j];
    }
    return sqrt(sum);
}

bool search_bring_within(const search *search, double q[], chain_error *error)
{
    const chain *chain = search->chain;
    const size_t n = chain->n_joints;
    if (unwind(chain, q)) {
        return true;
    }
    for (size_t j = 0; j < n; j++) {
        search->pull[j] = (clamped(&chain->joints[j], q[j]) - q[j]) / chain->joints[j].unit;
    }
    find_standing_step(search, false, q);
    if (length_of_steps(search->step, n) < 0.01 * length_of_steps(search->pull, n)) {
        return false;
    }
    for (size_t j = 0; j < n; j++) {
        q[j] = clamped(&chain->joints[j], q[j]);
    }
    search_descend(search, true, q, error);
    return search_is_there(search, error);
}

/* A share of the step, or less of it, so that q is nearer than `far` and there again. The share taken, or 0. */
static double take_standing_step(const search *search, double q[], double share, double far, chain_error *error)
{
    const size_t size = search->chain->n_joints * sizeof *q;
    chain_error next;
    memcpy(search->last, search->step, size); /* going downhill takes steps of its own */
    for (int tries = 0; tries < 3; tries++) {
        memcpy(search->step, search->last, size);
        take_step(search, true, q, share);
        memcpy(search->pull, search->trial, size);
        search_descend(search, true, search->pull, &next);
        if (search_is_there(search, &next) && search_from_near(search->chain, search->pull) < far) {
            memcpy(q, search->pull, size);
            *error = next;
            return share;
        }
        share /= 4;
    }
    return 0;
}

/*
 * Which share of a step to take where `share` of the last one has been taken: the secant's, by which the part of the
 * step along the last one would have vanished (Barzilai and Borwein).
 */
static double next_share(const search *search, double share)
{
    double square = 0, change = 0;
    for (size_t j = 0; j < search->chain->n_joints; j++) {
        square += search->last[j] * search->last[j];
        change += search->last[j] * (search->last[j] - search->step[j]);
    }
    return change > share * square / 4 ? share * square / change : 4;
}

void search_approach(const search *search, double q[], chain_error *error)
{
    const chain *chain = search->chain;
    const size_t n = chain->n_joints;
    armtol_transform tool;
    double share = 0;
    for (int i = 0; i < MOST_APPROACHES; i++) {
        const double far = search_from_near(chain, q);
        chain_place(chain, q, &tool);
        chain_differentiate(chain, &tool);
        for (size_t j = 0; j < n; j++) {
            search->pull[j] = (chain->joints[j].near - q[j]) / chain->joints[j].unit;
        }
        find_standing_step(search, true, q);
        if (!(length_of_steps(search->step, n) > 1e-7 * far)) {
            return;
        }
        share = take_standing_step(search, q, i == 0 ? 1 : next_share(search, share), far, error);
        if (share == 0) {
            return;
        }
    }
}
