#include "lib/engine/find.h"

#include "armtol/optimum.h"
#include "armtol/sphere.h"
#include "lib/engine/check.h"
#include "lib/engine/parts.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/* ---- worst and rss: the optimum ---- */

/* What it is found with, a place a row of all poses or a column. */
typedef struct rows {
    double *limits, *multipliers, *weights, *workspace;
} rows;

static bool get_rows(rows *rows, size_t n_rows, size_t n_columns)
{
    *rows = (struct rows){
        .limits = calloc(n_rows, sizeof(double)),
        .multipliers = calloc(n_rows, sizeof(double)),
        .weights = calloc(n_columns, sizeof(double)),
        .workspace = calloc(armtol_optimum_workspace(n_rows, n_columns), sizeof(double)),
    };
    return rows->limits != NULL && rows->multipliers != NULL && rows->weights != NULL && rows->workspace != NULL;
}

static void free_rows(rows *rows)
{
    free(rows->limits);
    free(rows->multipliers);
    free(rows->weights);
    free(rows->workspace);
}

/*
 * Method rss: an error that is even within its tolerance t has the standard deviation t / sqrt(3), so that sigma
 * standard deviations of a component are within its limit when the root of the summed squares is within
 * limit sqrt(3) / sigma.
 */
static double limit_of(const armtol_question *question, size_t row)
{
    const double limit = question->accuracy[row % 6];
    return question->method == ARMTOL_METHOD_RSS ? limit * sqrt(3) / question->sigma : limit;
}

static armtol_status solve(armtol_answer *answer, const armtol_question *question, const rows *rows, size_t n_rows)
{
    const armtol_sum sum = question->method == ARMTOL_METHOD_RSS ? ARMTOL_ROOT_SUM_SQUARES : ARMTOL_WORST_CASE;
    for (size_t i = 0; i < n_rows; i++) {
        rows->limits[i] = limit_of(question, i);
    }
    for (size_t k = 0; k < answer->n_columns; k++) {
        rows->weights[k] = question->weights != NULL ? question->weights[k] : 1;
    }
    const armtol_status status =
        armtol_optimum(sum, answer->matrices, n_rows, answer->n_columns, rows->limits, rows->weights,
                        answer->tolerances, rows->multipliers, rows->workspace);
    for (size_t i = 0; i < n_rows && status == ARMTOL_OK; i++) {
        answer->components[i % 6].binds += rows->multipliers[i];
    }
    return status;
}

static armtol_status optimise(armtol_answer *answer, const armtol_question *question)
{
    const size_t n_rows = 6 * answer->n_poses;
    rows rows;
    const armtol_status status = get_rows(&rows, n_rows, answer->n_columns)
                                     ? solve(answer, question, &rows, n_rows)
                                     : ARMTOL_NO_MEMORY;
    free_rows(&rows);
    return status;
}

/* ---- sphere: the report's bounds, shared out evenly ---- */

static armtol_status share_sphere(armtol_answer *answer, const armtol_question *question)
{
    const size_t n = answer->n_columns;
    armtol_status status = ARMTOL_OK;
    answer->delta = question->delta;
    if (question->delta == 0) {
        status = armtol_sphere_delta(answer->matrices, answer->n_poses, n, answer->columns, question->accuracy,
                                     answer_lever(answer), &answer->delta);
    }
    if (status == ARMTOL_OK) {
        status = armtol_sphere_bounds(answer->matrices, answer->n_poses, n, answer->columns, question->accuracy,
                                      answer->delta, &answer->bounds);
    }
    if (status == ARMTOL_OK) {
        armtol_sphere_tolerances(answer->columns, n, &answer->bounds, answer->tolerances);
    }
    return status;
}

armtol_fault answer_find_tolerances(armtol_answer *answer, const armtol_question *question)
{
    const armtol_status status = question->method == ARMTOL_METHOD_SPHERE ? share_sphere(answer, question)
                                                                          : optimise(answer, question);
    return fault_of(status, status == ARMTOL_NO_MEMORY ? ARMTOL_ABOUT_NOTHING : ARMTOL_ABOUT_METHOD, 0);
}
