#include "armtol/engine/answer.h"

#include "armtol/engine/parts.h"
#include "console/exit_code.h"
#include "console/message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- tolerances, by the three methods ---- */

/* What the optimum is found with, a place a row of all poses. */
typedef struct rows {
    double *limits, *multipliers, *workspace;
} rows;

static bool get_rows(rows *rows, size_t n_rows, size_t n_columns)
{
    *rows = (struct rows){
        .limits = calloc(n_rows, sizeof(double)),
        .multipliers = calloc(n_rows, sizeof(double)),
        .workspace = calloc(armtol_allocation_workspace(n_rows, n_columns), sizeof(double)),
    };
    return rows->limits != NULL && rows->multipliers != NULL && rows->workspace != NULL;
}

static void free_rows(rows *rows)
{
    free(rows->limits);
    free(rows->multipliers);
    free(rows->workspace);
}

/*
 * Method rss: an error that is even within its tolerance t has the standard deviation t / sqrt(3), so that sigma
 * standard deviations of a component are within its limit when the root of the summed squares is within
 * limit sqrt(3) / sigma.
 */
static double limit_of(const request *request, size_t row)
{
    const double limit = request->accuracy[row % 6];
    return request->options->method == METHOD_RSS ? limit * sqrt(3) / request->options->sigma : limit;
}

static armtol_status solve(const request *request, const rows *rows, size_t n_rows, answer *answer)
{
    const armtol_sum sum = request->options->method == METHOD_RSS ? ARMTOL_ROOT_SUM_SQUARES : ARMTOL_WORST_CASE;
    for (size_t i = 0; i < n_rows; i++) {
        rows->limits[i] = limit_of(request, i);
    }
    const armtol_status status =
        armtol_allocate(sum, request->posed.matrices, n_rows, request->posed.n_columns, rows->limits,
                        request->weights, answer->tolerances, rows->multipliers, rows->workspace);
    for (size_t i = 0; i < n_rows && status == ARMTOL_OK; i++) {
        answer->components[i % 6].binds += rows->multipliers[i];
    }
    return status;
}

/* False, after a message, where memory is short. */
static bool optimise(const request *request, answer *answer, armtol_status *status)
{
    const size_t n_rows = 6 * request->posed.n_poses;
    rows rows;
    const bool enough = get_rows(&rows, n_rows, request->posed.n_columns);
    if (enough) {
        *status = solve(request, &rows, n_rows, answer);
    } else {
        out_of_memory();
    }
    free_rows(&rows);
    return enough;
}

/* The report's bounds, shared out evenly. */
static armtol_status share_sphere(const request *request, answer *answer)
{
    const posed_arm *posed = &request->posed;
    const size_t n = posed->n_columns;
    armtol_status status = ARMTOL_OK;
    answer->delta = request->delta;
    if (isnan(answer->delta)) {
        status = armtol_sphere_delta(posed->matrices, posed->n_poses, n, posed->columns, request->accuracy,
                                     parts_lever(posed), &answer->delta);
    }
    if (status == ARMTOL_OK) {
        status = armtol_sphere_bounds(posed->matrices, posed->n_poses, n, posed->columns, request->accuracy,
                                      answer->delta, &answer->bounds);
    }
    if (status == ARMTOL_OK) {
        armtol_sphere_tolerances(posed->columns, n, &answer->bounds, answer->tolerances);
    }
    return status;
}

/* An exit code. What has no tolerances, a delta too large say, is wrong input; that none are found is not. */
static int find_tolerances(const request *request, answer *answer)
{
    armtol_status status;
    if (request->options->method == METHOD_SPHERE) {
        status = share_sphere(request, answer);
    } else if (!optimise(request, answer, &status)) {
        return EXIT_FAILED;
    }
    if (status == ARMTOL_OK) {
        return EXIT_OK;
    }
    message("no tolerances: %s", armtol_status_text(status));
    return status == ARMTOL_NOT_SOLVED ? EXIT_FAILED : EXIT_WRONG;
}

/* ---- what follows from them ---- */

/* What sees a parameter without a bound has none either; elsewhere such a parameter counts as exact. */
static void predict_component(const posed_arm *posed, const double tolerances[], size_t pose, size_t i,
                              double remainder, predicted *component)
{
    const double *matrix = posed_arm_matrix(posed, pose);
    const double worst = armtol_worst_error(matrix, posed->n_columns, i, tolerances);
    const double deviation = armtol_rss_error(matrix, posed->n_columns, i, tolerances) / sqrt(3);
    if (worst > component->worst) {
        component->worst_pose = pose;
    }
    component->worst = fmax(component->worst, worst);
    component->deviation = fmax(component->deviation, deviation);
    component->remainder = fmax(component->remainder, isinf(worst) ? worst : remainder);
}

static void predict(const posed_arm *posed, answer *answer)
{
    for (size_t pose = 0; pose < posed->n_poses; pose++) {
        double remainder[6];
        armtol_remainder(posed_arm_matrix(posed, pose), posed->n_columns, answer->bounded, remainder);
        for (size_t i = 0; i < 6; i++) {
            predict_component(posed, answer->tolerances, pose, i, remainder[i], &answer->components[i]);
        }
    }
}

static bool get_memory(answer *answer, const posed_arm *posed)
{
    answer->tolerances = calloc(posed->n_columns, sizeof *answer->tolerances);
    answer->bounded = calloc(posed->n_columns, sizeof *answer->bounded);
    answer->parts = calloc(posed->n_links, sizeof *answer->parts);
    return answer->tolerances != NULL && answer->bounded != NULL && answer->parts != NULL;
}

static int fill(const request *request, answer *answer)
{
    const posed_arm *posed = &request->posed;
    if (request->tolerances == NULL) {
        const int code = find_tolerances(request, answer);
        if (code != EXIT_OK) {
            return code;
        }
    } else {
        memcpy(answer->tolerances, request->tolerances, posed->n_columns * sizeof *answer->tolerances);
    }
    for (size_t k = 0; k < posed->n_columns; k++) {
        answer->bounded[k] = isfinite(answer->tolerances[k]) ? answer->tolerances[k] : 0;
    }
    parts_make(request, answer->tolerances, answer->parts);
    predict(posed, answer);
    return EXIT_OK;
}

int answer_make(answer *answer, const request *request)
{
    *answer = (struct answer){.delta = (double)NAN};
    if (!get_memory(answer, &request->posed)) {
        out_of_memory();
        answer_free(answer);
        return EXIT_FAILED;
    }
    const int code = fill(request, answer);
    if (code != EXIT_OK) {
        answer_free(answer);
    }
    return code;
}

void answer_free(answer *answer)
{
    free(answer->tolerances);
    free(answer->bounded);
    free(answer->parts);
}
