#include "lib/engine/corner_search.h"

#include "armtol/corners.h"

#include <math.h>

/* One component or norm in one pose, and a place for the errors of an arm. */
typedef struct search {
    const armtol_answer *answer;
    const armtol_link *links;
    const double *row, *bounded, *shifts; /* the row of A, or in the norm's worst direction */
    size_t component;
    unsigned norm; /* its components; 0 where it is none */
    double *errors;
} search;

static double magnitude(const double error[6], const void *context)
{
    const search *search = context;
    return search->norm != 0 ? armtol_norm_of(error, search->norm) : fabs(error[search->component]);
}

static double climb(const search *search)
{
    const armtol_answer *answer = search->answer;
    return armtol_climb(search->links, answer->n_links, &answer->tool, search->shifts, search->bounded,
                        answer->n_columns, magnitude, search, search->errors);
}

/* What is as meant is put off: it may take two such errors to do something. False where none is as meant. */
static bool put_off(const search *search)
{
    bool some = false;
    for (size_t k = 0; k < search->answer->n_columns; k++) {
        const bool at_middle = search->errors[k] == search->shifts[k] && search->bounded[k] > 0;
        some = some || at_middle;
        search->errors[k] += at_middle ? search->bounded[k] : 0;
    }
    return some;
}

static double worst_of_both_corners(const search *search)
{
    const armtol_answer *answer = search->answer;
    double most = 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        armtol_corner(search->row, answer->n_columns, 0, sign, search->bounded, search->errors);
        for (size_t k = 0; k < answer->n_columns; k++) {
            search->errors[k] += search->shifts[k];
        }
        most = fmax(most, climb(search));
        if (put_off(search)) {
            most = fmax(most, climb(search));
        }
    }
    return most;
}

static bool goes_on(const armtol_draw *draw)
{
    return draw->progress == NULL || draw->progress(draw->context, 0, draw->samples);
}

static search search_of(const armtol_answer *answer, size_t pose, const double row[], double errors[])
{
    return (search){.answer = answer,
                    .links = armtol_answer_links(answer, pose),
                    .row = row,
                    .bounded = armtol_answer_bounded(answer, pose),
                    .shifts = armtol_answer_shifts(answer, pose),
                    .errors = errors};
}

/* A pose that cannot do worse than another did need not be searched. */
static bool search_component(const armtol_answer *answer, const armtol_draw *draw, size_t pose, size_t i,
                             double errors[], double *worst)
{
    const double *matrix = armtol_answer_matrix(answer, pose);
    search search = search_of(answer, pose, matrix + i * answer->n_columns, errors);
    const double prediction =
        fabs(armtol_answer_shift(answer, pose, i)) + armtol_worst_error(matrix, answer->n_columns, i, search.bounded);
    if (!(prediction + answer->remainders[6 * pose + i] > *worst)) {
        return true;
    }
    if (!goes_on(draw)) {
        return false;
    }
    search.component = i;
    *worst = fmax(*worst, worst_of_both_corners(&search));
    return true;
}

/* Only where its first order is largest: which corner that is takes longer to find than what it comes to. */
static bool search_norm(const armtol_answer *answer, const armtol_draw *draw, size_t i, double errors[], double *worst)
{
    const armtol_predicted_norm *norm = &answer->norms[i];
    double *const row = errors + answer->n_columns;
    search search = search_of(answer, norm->of.worst_pose, row, errors);
    if (isinf(norm->of.worst)) {
        return true;
    }
    if (!goes_on(draw)) {
        return false;
    }
    armtol_norm_row(armtol_answer_matrix(answer, norm->of.worst_pose), answer->n_columns, norm->worst_direction, row);
    search.norm = norm->components;
    *worst = worst_of_both_corners(&search);
    return true;
}

bool search_corners(const armtol_answer *answer, const armtol_draw *draw, double errors[], armtol_verification *found)
{
    bool all = true;
    for (size_t i = 0; i < 6 * answer->n_poses && all; i++) {
        all = search_component(answer, draw, i / 6, i % 6, errors, &found->components[i % 6].worst_corner);
    }
    for (size_t i = 0; i < answer->n_norms && all; i++) {
        all = search_norm(answer, draw, i, errors, &found->norms[i].worst_corner);
    }
    return all;
}
