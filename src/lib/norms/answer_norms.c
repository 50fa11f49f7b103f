#include "lib/norms/answer_norms.h"

#include "lib/norms/norm_discs.h"
#include "lib/norms/spread_norm.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

void answer_take_norms(armtol_answer *answer, const armtol_question *question)
{
    answer->n_norms = question->n_norms;
    for (size_t i = 0; i < answer->n_norms; i++) {
        answer->norms[i].components = question->norms[i].components;
        answer->norms[i].limit = question->norms[i].limit;
    }
}

/* Whether some component of the norm depends on a parameter without a bound. */
static bool is_unbounded(const armtol_answer *answer, size_t pose, unsigned components)
{
    const double *matrix = armtol_answer_matrix(answer, pose);
    bool unbounded = false;
    for (size_t i = 0; i < 6; i++) {
        for (size_t k = 0; k < answer->n_columns && (components >> i & 1) != 0; k++) {
            unbounded = unbounded || (isinf(answer->tolerances[k]) && matrix[i * answer->n_columns + k] != 0);
        }
    }
    return unbounded;
}

static double shift_of(const armtol_answer *answer, size_t pose, unsigned components)
{
    double shift[6];
    for (size_t i = 0; i < 6; i++) {
        shift[i] = armtol_answer_shift(answer, pose, i);
    }
    return armtol_norm_of(shift, components);
}

/* What rounding makes of the components, and of the root of their squares. */
static double rounding_of(const armtol_predicted_norm *norm, const double rounding[6])
{
    return armtol_norm_of(rounding, norm->components) + 8 * DBL_EPSILON * norm->of.worst;
}

static void forget_bounds(armtol_predicted_norm *norm, size_t pose)
{
    armtol_predicted *of = &norm->of;
    of->worst_pose = isinf(of->worst) ? of->worst_pose : pose;
    of->deviation_pose = isinf(of->deviation) ? of->deviation_pose : pose;
    of->worst = of->deviation = of->remainder = norm->spread = (double)INFINITY;
    memset(norm->worst_direction, 0, sizeof norm->worst_direction);
    memset(norm->spread_direction, 0, sizeof norm->spread_direction);
}

static void predict_worst(const armtol_answer *answer, size_t pose, armtol_predicted_norm *norm, double workspace[])
{
    const double *matrix = armtol_answer_matrix(answer, pose), *bounded = armtol_answer_bounded(answer, pose);
    double direction[6];
    const double worst = norm_discs_worst(matrix, answer->n_columns, norm->components,
                                          armtol_answer_shifts(answer, pose), bounded, answer->discs, direction,
                                          workspace);
    if (worst > norm->of.worst) {
        norm->of.worst = worst;
        norm->of.worst_pose = pose;
        memcpy(norm->worst_direction, direction, sizeof direction);
    }
}

static void predict_spread(const armtol_answer *answer, size_t pose, armtol_predicted_norm *norm)
{
    const double *bounded = armtol_answer_bounded(answer, pose);
    double direction[6];
    const double deviation = spread_norm(answer, pose, norm->components, NULL, bounded, 1 / sqrt(3), direction);
    const double spread = spread_norm(answer, pose, norm->components, armtol_answer_shifts(answer, pose), bounded,
                                      answer->sigma / sqrt(3), direction);
    norm->of.deviation = fmax(norm->of.deviation, deviation);
    if (spread > norm->spread) {
        norm->spread = spread;
        norm->of.deviation_pose = pose;
        memcpy(norm->spread_direction, direction, sizeof direction);
    }
}

static void predict_norm(const armtol_answer *answer, size_t pose, const double rounding[6],
                         armtol_predicted_norm *norm, double workspace[])
{
    norm->of.shift = fmax(norm->of.shift, shift_of(answer, pose, norm->components));
    if (is_unbounded(answer, pose, norm->components)) {
        forget_bounds(norm, pose);
    } else {
        predict_worst(answer, pose, norm, workspace);
        predict_spread(answer, pose, norm);
    }
    const double of_rounding = rounding_of(norm, rounding);
    const double remainder = armtol_norm_of(answer->remainders + 6 * pose, norm->components);
    norm->of.rounding = isinf(of_rounding) ? norm->of.rounding : fmax(norm->of.rounding, of_rounding);
    norm->of.remainder = fmax(norm->of.remainder, remainder + 8 * DBL_EPSILON * norm->of.worst);
}

void answer_predict_norms(armtol_answer *answer, size_t pose, const double rounding[6], double workspace[])
{
    for (size_t i = 0; i < answer->n_norms; i++) {
        predict_norm(answer, pose, rounding, &answer->norms[i], workspace);
    }
}

const armtol_predicted *answer_predicted(const armtol_answer *answer, size_t measure)
{
    return measure < 6 ? &answer->components[measure] : &answer->norms[measure - 6].of;
}

size_t answer_told_pose(const armtol_answer *answer, size_t measure)
{
    const armtol_predicted *of = answer_predicted(answer, measure);
    return answer->method == ARMTOL_METHOD_RSS ? of->deviation_pose : of->worst_pose;
}

void answer_told_row(const armtol_answer *answer, size_t measure, double row[])
{
    const double *matrix = armtol_answer_matrix(answer, answer_told_pose(answer, measure));
    if (measure < 6) {
        memcpy(row, matrix + measure * answer->n_columns, answer->n_columns * sizeof *row);
        return;
    }
    const armtol_predicted_norm *norm = &answer->norms[measure - 6];
    armtol_norm_row(matrix, answer->n_columns,
                    answer->method == ARMTOL_METHOD_RSS ? norm->spread_direction : norm->worst_direction, row);
}
