#include "armtol/engine/verification_corners.h"

#include "armtol/corners.h"
#include "armtol/tool_error.h"
#include "console/exit_code.h"

#include <math.h>
#include <stdlib.h>

/* One component in one pose, and a place for the errors of an arm. */
typedef struct search {
    const verification_task *task;
    const armtol_link *links;
    const double *matrix;
    size_t component;
    double *errors;
} search;

static double magnitude(const search *search)
{
    const verification_task *task = search->task;
    double error[6] = {0};
    armtol_tool_error(search->links, task->n_links, search->errors, task->n_columns, &task->tool, error);
    return fabs(error[search->component]);
}

/* Give one error the sign that makes more of the component, if any does. Returns what it is then. */
static double climb_one(const search *search, double most, size_t k)
{
    static const double least_gain = 1e-9; /* less may be rounding, and not end */
    const double tolerance = search->task->tolerances[k];
    for (int sign = -1; sign <= 1; sign += 2) {
        const double before = search->errors[k];
        if (before == sign * tolerance) {
            continue;
        }
        search->errors[k] = sign * tolerance;
        const double changed = magnitude(search);
        if (changed > most * (1 + least_gain)) {
            most = changed;
        } else {
            search->errors[k] = before;
        }
    }
    return most;
}

static double climb(const search *search)
{
    enum { MOST_ROUNDS = 100 }; /* two or three do, where errors are small */
    double most = magnitude(search), before = -1;
    for (int round = 0; round < MOST_ROUNDS && most > before; round++) {
        before = most;
        for (size_t k = 0; k < search->task->n_columns; k++) {
            most = climb_one(search, most, k);
        }
    }
    return most;
}

/* What is as meant is put off: it may take two such errors to do something. False where none is as meant. */
static bool put_off(const verification_task *task, double errors[])
{
    bool some = false;
    for (size_t k = 0; k < task->n_columns; k++) {
        some = some || (errors[k] == 0 && task->tolerances[k] > 0);
        errors[k] = errors[k] == 0 ? task->tolerances[k] : errors[k];
    }
    return some;
}

static double worst_of_both_corners(const search *search)
{
    const verification_task *task = search->task;
    double most = 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        armtol_corner(search->matrix, task->n_columns, search->component, sign, task->tolerances,
                      search->errors);
        most = fmax(most, climb(search));
        if (put_off(task, search->errors)) {
            most = fmax(most, climb(search));
        }
    }
    return most;
}

static void visit_pose(const verification_task *task, size_t pose, double errors[],
                       verified_component components[6])
{
    const double *matrix = task->matrices + pose * 6 * task->n_columns;
    double remainder[6];
    armtol_remainder(matrix, task->n_columns, task->tolerances, remainder);
    for (size_t i = 0; i < 6; i++) {
        verified_component *component = &components[i];
        const double prediction = armtol_worst_error(matrix, task->n_columns, i, task->tolerances);
        const double rss = armtol_rss_error(matrix, task->n_columns, i, task->tolerances);
        component->prediction = fmax(component->prediction, prediction);
        component->rss = fmax(component->rss, rss);
        component->remainder = fmax(component->remainder, remainder[i]);
        /* a pose that cannot do worse than another did need not be searched */
        if (prediction + remainder[i] > component->worst_corner) {
            const search search = {task, task->poses + pose * task->n_links, matrix, i, errors};
            component->worst_corner = fmax(component->worst_corner, worst_of_both_corners(&search));
        }
    }
}

bool verification_corners(const verification_task *task, verified_component components[6])
{
    double *errors = calloc(task->n_columns, sizeof *errors);
    if (errors == NULL) {
        out_of_memory();
        return false;
    }
    for (size_t i = 0; i < 6; i++) {
        components[i] = (verified_component){0};
    }
    for (size_t pose = 0; pose < task->n_poses; pose++) {
        visit_pose(task, pose, errors, components);
    }
    free(errors);
    return true;
}
