#include "armtol/answer.h"

#include "armtol/corners.h"
#include "lib/engine/check.h"
#include "lib/engine/find.h"
#include "lib/engine/parts.h"
#include "lib/engine/place.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* What sees a parameter without a bound has none either; elsewhere such a parameter counts as exact. */
static void predict_component(const armtol_answer *answer, size_t pose, size_t i, double remainder,
                              armtol_predicted *component)
{
    const double *matrix = armtol_answer_matrix(answer, pose);
    const double worst = armtol_worst_error(matrix, answer->n_columns, i, answer->tolerances);
    const double deviation = armtol_rss_error(matrix, answer->n_columns, i, answer->tolerances) / sqrt(3);
    if (worst > component->worst) {
        component->worst_pose = pose;
    }
    component->worst = fmax(component->worst, worst);
    component->deviation = fmax(component->deviation, deviation);
    component->remainder = fmax(component->remainder, isinf(worst) ? worst : remainder);
}

static void predict(armtol_answer *answer)
{
    for (size_t pose = 0; pose < answer->n_poses; pose++) {
        double remainder[6];
        armtol_remainder(armtol_answer_matrix(answer, pose), answer->n_columns, answer->bounded, remainder);
        for (size_t i = 0; i < 6; i++) {
            predict_component(answer, pose, i, remainder[i], &answer->components[i]);
        }
    }
}

static bool get_memory(armtol_answer *answer)
{
    answer->tolerances = calloc(answer->n_columns, sizeof *answer->tolerances);
    answer->bounded = calloc(answer->n_columns, sizeof *answer->bounded);
    answer->parts = calloc(answer->n_links, sizeof *answer->parts);
    return answer->tolerances != NULL && answer->bounded != NULL && answer->parts != NULL;
}

/* The question's own, or the largest that keep to its accuracy. */
static armtol_fault take_tolerances(armtol_answer *answer, const armtol_question *question)
{
    armtol_fault fault = question_check_columns(question, answer->n_columns);
    if (fault.status == ARMTOL_OK && question->tolerances == NULL) {
        fault = answer_find_tolerances(answer, question);
    } else if (fault.status == ARMTOL_OK) {
        memcpy(answer->tolerances, question->tolerances, answer->n_columns * sizeof *answer->tolerances);
    }
    return fault;
}

static void conclude(armtol_answer *answer, const armtol_question *question)
{
    for (size_t k = 0; k < answer->n_columns; k++) {
        answer->bounded[k] = isfinite(answer->tolerances[k]) ? answer->tolerances[k] : 0;
    }
    for (size_t i = 0; i < 6; i++) {
        answer->accuracy[i] = question->accuracy != NULL ? question->accuracy[i] : (double)INFINITY;
    }
    answer_make_parts(answer, question);
    predict(answer);
}

static armtol_fault fill(armtol_answer *answer, const armtol_question *question)
{
    armtol_fault fault = question_check(question);
    if (fault.status == ARMTOL_OK) {
        fault = answer_place(answer, question);
    }
    if (fault.status == ARMTOL_OK && !get_memory(answer)) {
        fault = fault_of(ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
    }
    if (fault.status == ARMTOL_OK) {
        fault = take_tolerances(answer, question);
    }
    if (fault.status == ARMTOL_OK) {
        conclude(answer, question);
    }
    return fault;
}

armtol_status armtol_answer_create(const armtol_question *question, armtol_answer **answer, armtol_fault *fault)
{
    armtol_fault found = fault_of(ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
    *answer = calloc(1, sizeof **answer);
    if (*answer != NULL) {
        (*answer)->method = question->method;
        (*answer)->delta = (double)NAN;
        found = fill(*answer, question);
    }
    if (found.status != ARMTOL_OK) {
        armtol_answer_destroy(*answer);
        *answer = NULL;
    }
    if (fault != NULL) {
        *fault = found;
    }
    return found.status;
}

void armtol_answer_destroy(armtol_answer *answer)
{
    if (answer != NULL) {
        free(answer->columns);
        free(answer->links);
        free(answer->matrices);
        free(answer->tolerances);
        free(answer->bounded);
        free(answer->parts);
        free(answer);
    }
}
