/* Any value, by an answer a pose. */

#include "armtol/answer.h"
#include "armtol/corners.h"
#include "lib/engine/check.h"
#include "lib/map/values.h"
#include "lib/norms/discs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The question that is put for each pose, with what of it is not the caller's. */
typedef struct put {
    armtol_question question;
    armtol_arm arm;
    armtol_drive *drives;
    double *exact; /* no tolerances at all */
    armtol_map map;
} put;

/*
 * What a drive leaves open at each arrival. How far it gives way does not change from arrival to arrival; the play has
 * been counted whole to either side since nothing says where its zero was set, and that does not change either.
 */
static armtol_drive at_arrival(const armtol_drive *drive)
{
    armtol_drive taken = *drive;
    taken.compliance = 0;
    taken.backlash /= 2;
    return taken;
}

static bool take_stiff_drives(put *put)
{
    const armtol_arm *arm = put->question.arm;
    put->drives = calloc(arm->n_links, sizeof *put->drives);
    for (size_t i = 0; put->drives != NULL && i < arm->n_links; i++) {
        put->drives[i] = at_arrival(&arm->drives[i]);
    }
    put->arm = *arm;
    put->arm.drives = put->drives;
    put->question.arm = &put->arm;
    return put->drives != NULL;
}

/* The arm's links are not known to be fine: of those that are not there are no columns. */
static bool leave_tolerances_out(put *put)
{
    const size_t n = armtol_column_count(put->question.arm->links, put->question.arm->n_links);
    put->exact = calloc(n + 1, sizeof *put->exact);
    put->question.tolerances = put->exact;
    put->question.accuracy = put->question.least = put->question.largest = NULL;
    put->question.discs = NULL;
    return put->exact != NULL;
}

static bool prepare(put *put, const armtol_question *question, const armtol_map *map)
{
    *put = (struct put){.question = *question, .map = *map};
    put->question.n_poses = 1;
    if (map->value != ARMTOL_MAP_TOLERANCE) { /* what the errors are held against changes none of them */
        put->question.norms = NULL;
        put->question.n_norms = 0;
    }
    bool fine = true;
    if (map->value == ARMTOL_MAP_DROOP || map->value == ARMTOL_MAP_REPEATABILITY) {
        put->question.drives_apart = false;
        fine = leave_tolerances_out(put);
    }
    return fine && (map->value != ARMTOL_MAP_REPEATABILITY || take_stiff_drives(put));
}

/* What sees a tolerance without a bound has none either. */
static double of_component(const put *put, const armtol_answer *answer, size_t pose, size_t i)
{
    const double *matrix = armtol_answer_matrix(answer, pose);
    const size_t n = answer->n_columns;
    if (put->map.value == ARMTOL_MAP_DROOP) {
        return fabs(answer->droops[6 * pose + i]);
    }
    if (!isfinite(armtol_worst_error(matrix, n, i, answer->tolerances))) {
        return (double)INFINITY;
    }
    const double half = discs_worst(matrix + i * n, n, armtol_answer_bounded(answer, pose), answer->discs);
    return put->map.value == ARMTOL_MAP_REPEATABILITY ? half : fabs(armtol_answer_shift(answer, pose, i)) + half;
}

static double of_load(const put *put, const armtol_answer *answer, size_t pose)
{
    const size_t component = put->map.component, first = component == ARMTOL_MAP_POSITION ? 0 : 3;
    if (component < 6) {
        return of_component(put, answer, pose, component);
    }
    double squares = 0;
    for (size_t i = first; i < first + 3; i++) {
        const double part = of_component(put, answer, pose, i);
        squares += part * part;
    }
    return sqrt(squares);
}

static double least_tolerance(const put *put, const armtol_answer *answer)
{
    double least = (double)INFINITY;
    for (size_t k = 0; k < answer->n_columns; k++) {
        least = put->map.columns[k] ? fmin(least, answer->tolerances[k]) : least;
    }
    return least;
}

static double value_of(const put *put, const armtol_answer *answer)
{
    double most = 0;
    if (put->map.value == ARMTOL_MAP_TOLERANCE) {
        return least_tolerance(put, answer);
    }
    for (size_t pose = 0; pose < answer->n_poses; pose++) {
        most = fmax(most, of_load(put, answer, pose));
    }
    return most;
}

static armtol_fault answer_one(const put *put, double *value)
{
    armtol_answer *answer;
    armtol_fault fault;
    const armtol_status status = armtol_answer_create(&put->question, &answer, &fault);
    if (status == ARMTOL_NOTHING_LEFT) {
        *value = 0;
        return fault_of(ARMTOL_OK, ARMTOL_ABOUT_NOTHING, 0);
    }
    if (status == ARMTOL_OK) {
        *value = value_of(put, answer);
        armtol_answer_destroy(answer);
    }
    return fault;
}

static armtol_fault answer_all(put *put, const armtol_question *question, double values[])
{
    const size_t n_joints = armtol_arm_joint_count(question->arm);
    armtol_fault fault = question_check(&put->question); /* where no pose can be reached too */
    for (size_t pose = 0; pose < question->n_poses && fault.status == ARMTOL_OK; pose++) {
        put->question.q = n_joints > 0 ? question->q + pose * n_joints : NULL;
        values[pose] = (double)NAN;
        if (!map_is_left_out(put->question.q, n_joints)) {
            fault = answer_one(put, &values[pose]);
            fault.number = fault.about == ARMTOL_ABOUT_POSE ? pose : fault.number;
        }
    }
    return fault;
}

armtol_fault map_answers(const armtol_question *question, const armtol_map *map, double values[])
{
    put put;
    armtol_fault fault = fault_of(ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
    if (prepare(&put, question, map)) {
        fault = answer_all(&put, question, values);
    }
    free(put.drives);
    free(put.exact);
    return fault;
}
