#include "armtol/budget.h"

#include "lib/norms/answer_norms.h"
#include "lib/norms/discs.h"
#include "lib/spread/answer_spread.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

const char *armtol_role_name(armtol_role role)
{
    static const char *const names[ARMTOL_ROLE_COUNT] = {"machining", "motor", "load", "shift"};
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

/* The row of what shifts the column: ARMTOL_LOAD or ARMTOL_SHIFT. */
static size_t shift_row_of(const armtol_answer *answer, size_t column, armtol_role role)
{
    return ARMTOL_ROLE_COUNT * answer->columns[column].link + role;
}

/* What a column is shifted by in that role. */
static double shift_of(const armtol_answer *answer, size_t pose, size_t column, armtol_role role)
{
    const double mean = answer->spreads[column].shift;
    return role == ARMTOL_SHIFT ? mean : armtol_answer_shifts(answer, pose)[column] - mean;
}

/* What is shared out: a component or a norm, where it is told. */
typedef struct told {
    const armtol_answer *answer;
    size_t measure, pose;
    const double *row; /* A's, or along the norm's direction */
    bool unbounded;
    double shift;
} told;

static told told_of(const armtol_answer *answer, size_t measure, double row[])
{
    told told = {.answer = answer, .measure = measure, .pose = answer_told_pose(answer, measure), .row = row};
    const double *shifts = armtol_answer_shifts(answer, told.pose);
    answer_told_row(answer, measure, row);
    told.unbounded = isinf(answer_predicted(answer, measure)->worst);
    for (size_t k = 0; k < answer->n_columns; k++) {
        told.shift += row[k] * shifts[k];
    }
    return told;
}

/* What a column's tolerance puts into it: a magnitude, or its covariance with its group: by itself, a square. */
static double contribution(const told *told, size_t column)
{
    const armtol_answer *answer = told->answer;
    const double *bounded = armtol_answer_bounded(answer, told->pose);
    if (answer->method != ARMTOL_METHOD_RSS) {
        return discs_worst_part(told->row, column, bounded, answer->discs);
    }
    return told->row[column] * bounded[column] * answer->factors[column] *
           spread_part(answer, told->row, bounded, answer->leaders[column]);
}

/* What its shift in that role does, positive where it adds to the whole. */
static double contribution_of_shift(const told *told, size_t column, armtol_role role)
{
    const double part = told->row[column] * shift_of(told->answer, told->pose, column, role);
    return told->shift < 0 ? -part : part;
}

static double share_of(double part, double total)
{
    return isinf(total) ? (double)NAN : total > 0 ? part / total : 0;
}

/* The two terms of an error: what shifts do, and what tolerances do, whose shares are of the sum of parts. */
typedef struct terms {
    double shift, spread, parts;
} terms;

static terms terms_of(const told *told)
{
    terms terms = {.shift = fabs(told->shift)};
    for (size_t k = 0; k < told->answer->n_columns; k++) {
        terms.parts += contribution(told, k);
    }
    const bool rss = told->answer->method == ARMTOL_METHOD_RSS;
    terms.spread = rss ? told->answer->sigma * sqrt(fmax(terms.parts, 0) / 3) : terms.parts;
    terms.spread = told->unbounded ? (double)INFINITY : terms.spread;
    return terms;
}

static double *place_of(double components[6], double norms[ARMTOL_MOST_NORMS], size_t measure)
{
    return measure < 6 ? &components[measure] : &norms[measure - 6];
}

static void add_shift(armtol_budget *budget, const told *told, double total, size_t k, armtol_role role)
{
    const size_t m = told->measure;
    armtol_budget_row *row = &budget->rows[shift_row_of(told->answer, k, role)];
    const double share = share_of(contribution_of_shift(told, k, role), total);
    *place_of(row->shares, row->norm_shares, m) += share;
    if (role == ARMTOL_LOAD) {
        *place_of(budget->loads, budget->norm_loads, m) += share;
    } else {
        *place_of(budget->shifts, budget->norm_shifts, m) += share;
    }
}

static void add_column(armtol_budget *budget, const told *told, const terms *terms, size_t k)
{
    const size_t m = told->measure;
    armtol_budget_row *row = &budget->rows[row_of(told->answer, k)];
    const double total = terms->shift + terms->spread;
    const double of_spread = share_of(contribution(told, k), isinf(total) ? total : terms->parts);
    const double share = terms->shift > 0 ? of_spread * share_of(terms->spread, total) : of_spread;
    *place_of(row->shares, row->norm_shares, m) += share;
    *place_of(budget->motors, budget->norm_motors, m) += row->role == ARMTOL_MOTOR ? share : 0;
    add_shift(budget, told, total, k, ARMTOL_LOAD);
    add_shift(budget, told, total, k, ARMTOL_SHIFT);
}

static void add_measure(armtol_budget *budget, const armtol_answer *answer, size_t measure, double row[])
{
    const told told = told_of(answer, measure, row);
    const terms terms = terms_of(&told);
    for (size_t k = 0; k < answer->n_columns; k++) {
        add_column(budget, &told, &terms, k);
    }
}

static bool is_shifted(const armtol_answer *answer, size_t column, armtol_role role)
{
    bool shifted = false;
    for (size_t pose = 0; pose < answer->n_poses; pose++) {
        shifted = shifted || shift_of(answer, pose, column, role) != 0;
    }
    return shifted;
}

/* Only the rows that some column counts for are kept. */
static void drop_empty_rows(armtol_budget *budget, const armtol_answer *answer)
{
    for (size_t k = 0; k < answer->n_columns; k++) {
        budget->rows[row_of(answer, k)].link = answer->columns[k].link;
        for (armtol_role role = ARMTOL_LOAD; role < ARMTOL_ROLE_COUNT; role++) {
            if (is_shifted(answer, k, role)) {
                budget->rows[shift_row_of(answer, k, role)].link = answer->columns[k].link;
            }
        }
    }
    for (size_t i = 0; i < ARMTOL_ROLE_COUNT * answer->n_links; i++) {
        if (budget->rows[i].link < answer->n_links) {
            budget->rows[budget->n_rows++] = budget->rows[i];
        }
    }
}

static void fill(armtol_budget *budget, const armtol_answer *answer, double row[])
{
    for (size_t i = 0; i < ARMTOL_ROLE_COUNT * answer->n_links; i++) {
        budget->rows[i] = (armtol_budget_row){.link = SIZE_MAX, .role = (armtol_role)(i % ARMTOL_ROLE_COUNT)};
    }
    for (size_t measure = 0; measure < 6 + answer->n_norms; measure++) {
        add_measure(budget, answer, measure, row);
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
    double *row = calloc(answer->n_columns, sizeof *row);
    if ((*budget)->rows == NULL || row == NULL) {
        armtol_budget_destroy(*budget);
        free(row);
        *budget = NULL;
        return ARMTOL_NO_MEMORY;
    }
    fill(*budget, answer, row);
    free(row);
    return ARMTOL_OK;
}

void armtol_budget_destroy(armtol_budget *budget)
{
    if (budget != NULL) {
        free(budget->rows);
        free(budget);
    }
}
