#include "armtol/budget.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

const char *armtol_role_name(armtol_role role)
{
    static const char *const names[ARMTOL_ROLE_COUNT] = {"machining", "motor", "load"};
    return (size_t)role < ARMTOL_ROLE_COUNT ? names[role] : "?";
}

armtol_role armtol_role_of(const armtol_link *link, armtol_parameter parameter)
{
    return armtol_joint_moves(link->joint, parameter) ? ARMTOL_MOTOR : ARMTOL_MACHINING;
}

/* The place of the row that a column counts for, as long as every link has one of each role. */
static size_t row_of(const armtol_answer *answer, size_t column)
{
    const armtol_column *at = &answer->columns[column];
    return ARMTOL_ROLE_COUNT * at->link + armtol_role_of(&answer->links[at->link], at->parameter);
}

static size_t load_row_of(const armtol_answer *answer, size_t column)
{
    return ARMTOL_ROLE_COUNT * answer->columns[column].link + ARMTOL_LOAD;
}

/* Where the error is that is told. */
static size_t pose_of(const armtol_answer *answer, size_t i)
{
    const armtol_predicted *component = &answer->components[i];
    return answer->method == ARMTOL_METHOD_RSS ? component->deviation_pose : component->worst_pose;
}

/* What a column's tolerance puts into a component: a magnitude, or its square. */
static double contribution(const armtol_answer *answer, size_t column, size_t i)
{
    const size_t pose = pose_of(answer, i);
    const double *matrix = armtol_answer_matrix(answer, pose);
    const double error = fabs(matrix[i * answer->n_columns + column]) * armtol_answer_bounded(answer, pose)[column];
    return answer->method == ARMTOL_METHOD_RSS ? error * error : error;
}

/* What its shift does, positive where it adds to the whole. */
static double contribution_of_load(const armtol_answer *answer, size_t column, size_t i)
{
    const size_t pose = pose_of(answer, i);
    const double part = armtol_answer_matrix(answer, pose)[i * answer->n_columns + column] *
                        armtol_answer_shifts(answer, pose)[column];
    return armtol_answer_shift(answer, pose, i) < 0 ? -part : part;
}

static double share_of(double part, double total)
{
    return isinf(total) ? (double)NAN : total > 0 ? part / total : 0;
}

/* The two terms of a component's error: what loads do, and what tolerances do, whose shares are of the sum of parts. */
typedef struct terms {
    double load, spread, parts;
} terms;

static terms terms_of(const armtol_answer *answer, size_t i)
{
    const bool unbounded = isinf(answer->components[i].worst);
    terms terms = {.load = fabs(armtol_answer_shift(answer, pose_of(answer, i), i))};
    for (size_t k = 0; k < answer->n_columns; k++) {
        terms.parts += contribution(answer, k, i);
    }
    terms.spread = answer->method == ARMTOL_METHOD_RSS ? answer->sigma * sqrt(terms.parts / 3) : terms.parts;
    terms.spread = unbounded ? (double)INFINITY : terms.spread;
    return terms;
}

static void add_column(armtol_budget *budget, const armtol_answer *answer, const terms *terms, size_t k, size_t i)
{
    armtol_budget_row *row = &budget->rows[row_of(answer, k)];
    const double total = terms->load + terms->spread;
    const double of_spread = share_of(contribution(answer, k, i), isinf(total) ? total : terms->parts);
    const double share = terms->load > 0 ? of_spread * share_of(terms->spread, total) : of_spread;
    const double load = share_of(contribution_of_load(answer, k, i), total);
    row->shares[i] += share;
    budget->motors[i] += row->role == ARMTOL_MOTOR ? share : 0;
    budget->rows[load_row_of(answer, k)].shares[i] += load;
    budget->loads[i] += load;
}

static void add_component(armtol_budget *budget, const armtol_answer *answer, size_t i)
{
    const terms terms = terms_of(answer, i);
    for (size_t k = 0; k < answer->n_columns; k++) {
        add_column(budget, answer, &terms, k, i);
    }
}

static bool is_shifted(const armtol_answer *answer, size_t column)
{
    bool shifted = false;
    for (size_t pose = 0; pose < answer->n_poses; pose++) {
        shifted = shifted || armtol_answer_shifts(answer, pose)[column] != 0;
    }
    return shifted;
}

/* Only the rows that some column counts for are kept. */
static void drop_empty_rows(armtol_budget *budget, const armtol_answer *answer)
{
    for (size_t k = 0; k < answer->n_columns; k++) {
        budget->rows[row_of(answer, k)].link = answer->columns[k].link;
        if (is_shifted(answer, k)) {
            budget->rows[load_row_of(answer, k)].link = answer->columns[k].link;
        }
    }
    for (size_t i = 0; i < ARMTOL_ROLE_COUNT * answer->n_links; i++) {
        if (budget->rows[i].link < answer->n_links) {
            budget->rows[budget->n_rows++] = budget->rows[i];
        }
    }
}

static void fill(armtol_budget *budget, const armtol_answer *answer)
{
    for (size_t i = 0; i < ARMTOL_ROLE_COUNT * answer->n_links; i++) {
        budget->rows[i] = (armtol_budget_row){.link = SIZE_MAX, .role = (armtol_role)(i % ARMTOL_ROLE_COUNT)};
    }
    for (size_t i = 0; i < 6; i++) {
        add_component(budget, answer, i);
    }
    drop_empty_rows(budget, answer);
}

armtol_status armtol_budget_create(const armtol_answer *answer, armtol_budget **budget)
{
    *budget = calloc(1, sizeof **budget);
    if (*budget == NULL) {
        return ARMTOL_NO_MEMORY;
    }
    (*budget)->rows = calloc(answer->n_links, ARMTOL_ROLE_COUNT * sizeof *(*budget)->rows);
    if ((*budget)->rows == NULL) {
        armtol_budget_destroy(*budget);
        *budget = NULL;
        return ARMTOL_NO_MEMORY;
    }
    fill(*budget, answer);
    return ARMTOL_OK;
}

void armtol_budget_destroy(armtol_budget *budget)
{
    if (budget != NULL) {
        free(budget->rows);
        free(budget);
    }
}
