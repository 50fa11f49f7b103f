#include "lib/engine/corner_search.h"

#include "armtol/corners.h"

#include <math.h>

/* One component in one pose, and a place for the errors of an arm. */
typedef struct search {
    const armtol_answer *answer;
    const armtol_link *links;
    const double *matrix, *bounded, *shifts;
    size_t component;
    double *errors;
} search;

static double magnitude(const double error[6], const void *component)
{
    return fabs(error[*(const size_t *)component]);
}

static double climb(const search *search)
{
    const armtol_answer *answer = search->answer;
    return armtol_climb(search->links, answer->n_links, &answer->tool, search->shifts, search->bounded,
                        answer->n_columns, magnitude, &search->component, search->errors);
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
        armtol_corner(search->matrix, answer->n_columns, search->component, sign, search->bounded, search->errors);
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

static bool search_pose(const armtol_answer *answer, const armtol_draw *draw, size_t pose, double errors[],
                        armtol_verified components[6])
{
    const double *matrix = armtol_answer_matrix(answer, pose);
    const double *bounded = armtol_answer_bounded(answer, pose), *remainder = answer->remainders + 6 * pose;
    for (size_t i = 0; i < 6; i++) {
        const double prediction = fabs(armtol_answer_shift(answer, pose, i)) +
                                  armtol_worst_error(matrix, answer->n_columns, i, bounded);
        /* a pose that cannot do worse than another did need not be searched */
        if (prediction + remainder[i] > components[i].worst_corner) {
            const search search = {.answer = answer,
                                   .links = armtol_answer_links(answer, pose),
                                   .matrix = matrix,
                                   .bounded = bounded,
                                   .shifts = armtol_answer_shifts(answer, pose),
                                   .component = i,
                                   .errors = errors};
            if (!goes_on(draw)) {
                return false;
            }
            components[i].worst_corner = fmax(components[i].worst_corner, worst_of_both_corners(&search));
        }
    }
    return true;
}

bool search_corners(const armtol_answer *answer, const armtol_draw *draw, double errors[],
                    armtol_verified components[6])
{
    bool all = true;
    for (size_t pose = 0; pose < answer->n_poses && all; pose++) {
        all = search_pose(answer, draw, pose, errors, components);
    }
    return all;
}
