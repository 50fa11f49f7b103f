#include "lib/engine/corner_search.h"

#include "armtol/corners.h"
#include "lib/norms/discs.h"

#include <math.h>

/* One component or norm in one pose, and a place for the errors of an arm. */
typedef struct search {
    const armtol_answer *answer;
    const armtol_link *links;
    const double *row, *bounded; /* the row of A, or in the norm's worst direction */
    double *middle, *half;       /* of the box that is climbed in: where discs are, they are held */
    size_t pose, component;
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
    return armtol_climb(search->links, answer->n_links, &answer->tool, search->middle, search->half,
                        answer->n_columns, magnitude, search, search->errors);
}

/* What is as meant is put off: it may take two such errors to do something. False where none is as meant. */
static bool put_off(const search *search)
{
    bool some = false;
    for (size_t k = 0; k < search->answer->n_columns; k++) {
        const bool at_middle = search->errors[k] == search->middle[k] && search->half[k] > 0;
        some = some || at_middle;
        search->errors[k] += at_middle ? search->half[k] : 0;
    }
    return some;
}

/* Discs stay on the point of their rim that does most to first order: one has no corners to climb to. */
static void take_corner(const search *search, const double shifts[], int sign)
{
    const armtol_answer *answer = search->answer;
    discs_corner(search->row, answer->n_columns, sign, search->bounded, answer->discs, search->errors);
    for (size_t k = 0; k < answer->n_columns; k++) {
        const bool held = discs_have(answer->discs, k);
        search->errors[k] += shifts[k];
        search->middle[k] = held ? search->errors[k] : shifts[k];
        search->half[k] = held ? 0 : search->bounded[k];
    }
}

static double worst_of_both_corners(const search *search)
{
    double most = 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        take_corner(search, armtol_answer_shifts(search->answer, search->pose), sign);
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

/* workspace: three places a column. */
static search search_of(const armtol_answer *answer, size_t pose, const double row[], double workspace[])
{
    return (search){.answer = answer,
                    .pose = pose,
                    .links = armtol_answer_links(answer, pose),
                    .row = row,
                    .bounded = armtol_answer_bounded(answer, pose),
                    .errors = workspace,
                    .middle = workspace + answer->n_columns,
                    .half = workspace + 2 * answer->n_columns};
}

/* A pose that cannot do worse than another did need not be searched. */
static bool search_component(const armtol_answer *answer, const armtol_draw *draw, size_t pose, size_t i,
                             double workspace[], double *worst)
{
    const double *matrix = armtol_answer_matrix(answer, pose);
    search search = search_of(answer, pose, matrix + i * answer->n_columns, workspace);
    const double prediction = fabs(armtol_answer_shift(answer, pose, i)) +
                              discs_worst(search.row, answer->n_columns, search.bounded, answer->discs);
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
static bool search_norm(const armtol_answer *answer, const armtol_draw *draw, size_t i, double workspace[],
                        double *worst)
{
    const armtol_predicted_norm *norm = &answer->norms[i];
    double *const row = workspace + 3 * answer->n_columns;
    search search = search_of(answer, norm->of.worst_pose, row, workspace);
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

bool search_corners(const armtol_answer *answer, const armtol_draw *draw, double workspace[],
                    armtol_verification *found)
{
    bool all = true;
    for (size_t i = 0; i < 6 * answer->n_poses && all; i++) {
        all = search_component(answer, draw, i / 6, i % 6, workspace, &found->components[i % 6].worst_corner);
    }
    for (size_t i = 0; i < answer->n_norms && all; i++) {
        all = search_norm(answer, draw, i, workspace, &found->norms[i].worst_corner);
    }
    return all;
}
