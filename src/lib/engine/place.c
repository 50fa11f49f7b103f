#include "lib/engine/place.h"

#include "armtol/tool_matrix.h"
#include "lib/engine/check.h"
#include "lib/engine/drives.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static bool get_memory(armtol_answer *answer)
{
    answer->columns = calloc(answer->n_columns, sizeof *answer->columns);
    answer->links = calloc(answer->n_poses, answer->n_links * sizeof *answer->links);
    answer->matrices = calloc(answer->n_poses, 6 * answer->n_columns * sizeof *answer->matrices);
    return answer->columns != NULL && answer->links != NULL && answer->matrices != NULL;
}

static armtol_status place(armtol_answer *answer, const armtol_question *question, size_t pose)
{
    const armtol_arm *arm = question->arm;
    const size_t n = answer->n_columns, n_joints = answer->n_joints;
    const double none = 0, *q = n_joints > 0 ? question->q + pose / answer->n_loads * n_joints : &none;
    armtol_link *links = answer->links + pose * answer->n_links;
    const armtol_status status = armtol_arm_place(arm, q, n_joints, links);
    if (status != ARMTOL_OK) {
        return status;
    }
    double *matrix = answer->matrices + pose * 6 * n;
    const armtol_status made = armtol_tool_matrix(links, answer->n_links, &answer->tool, matrix, n);
    armtol_tool_matrix_clear(links, answer->n_links, &answer->tool, matrix, n);
    return made;
}

/* Loads do not move the arm as it is meant: what one of them has is a copy of what the first has. */
static void copy_place(armtol_answer *answer, size_t pose)
{
    const size_t n = answer->n_links, size = 6 * answer->n_columns;
    memcpy(answer->links + pose * n, answer->links + (pose - 1) * n, n * sizeof *answer->links);
    memcpy(answer->matrices + pose * size, answer->matrices + (pose - 1) * size, size * sizeof *answer->matrices);
}

armtol_fault answer_place(armtol_answer *answer, const armtol_question *question)
{
    const armtol_arm *arm = question->arm;
    answer->n_links = arm->n_links;
    answer->n_joints = armtol_arm_joint_count(arm);
    answer->n_columns = armtol_column_count(arm->links, arm->n_links);
    answer->n_loads = question_load_count(question);
    answer->n_poses = question->n_poses * answer->n_loads;
    answer->tool = question->tool;
    if (!get_memory(answer)) {
        return fault_of(ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
    }
    armtol_columns(arm->links, arm->n_links, answer->columns, answer->n_columns); /* the links are known to be fine */
    armtol_status status = ARMTOL_OK;
    size_t pose = 0;
    while (pose < answer->n_poses && (status = place(answer, question, pose)) == ARMTOL_OK) {
        for (pose++; pose % answer->n_loads != 0; pose++) {
            copy_place(answer, pose);
        }
    }
    return fault_of(status, ARMTOL_ABOUT_POSE, pose / answer->n_loads);
}

const armtol_link *armtol_answer_links(const armtol_answer *answer, size_t pose)
{
    return answer->links + pose * answer->n_links;
}

const double *armtol_answer_matrix(const armtol_answer *answer, size_t pose)
{
    return answer->matrices + pose * 6 * answer->n_columns;
}

const double *armtol_answer_bounded(const armtol_answer *answer, size_t pose)
{
    return answer->bounded + pose * answer->n_columns;
}

const double *armtol_answer_shifts(const armtol_answer *answer, size_t pose)
{
    return answer->shifts + pose * answer->n_columns;
}

double armtol_answer_shift(const armtol_answer *answer, size_t pose, size_t component)
{
    const double *row = armtol_answer_matrix(answer, pose) + component * answer->n_columns;
    const double *shifts = armtol_answer_shifts(answer, pose);
    double sum = 0;
    for (size_t k = 0; k < answer->n_columns; k++) {
        sum += row[k] * shifts[k];
    }
    return sum;
}

void armtol_answer_frame(const armtol_answer *answer, size_t pose, armtol_transform *frame)
{
    armtol_tool_frame(armtol_answer_links(answer, pose), answer->n_links, &answer->tool, frame);
}

void armtol_answer_tool(const armtol_answer *answer, size_t pose, double point[3])
{
    armtol_transform frame;
    armtol_answer_frame(answer, pose, &frame);
    for (int i = 0; i < 3; i++) {
        point[i] = frame.m[i][3];
    }
}
