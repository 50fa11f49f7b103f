#include "lab/yield/case.h"

#include "console/exit_code.h"
#include "console/message.h"
#include "lab/recompute.h"
#include "lab/yield/column_tolerances.h"
#include "lab/yield/drawn_arm.h"
#include "lab/yield/guarantee.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What the steps below share: an arm, A of it, the tolerances of a set, and a place for errors. */
typedef struct box {
    const drawn_arm *arm;
    const double *matrix;
    double *tolerances;
    double *errors;
} box;

/* One corner of a row: the row's own component there. Keeps in *result what is the worst so far. */
static double visit_corner(const box *box, size_t row, int sign, set_result *result)
{
    double error[6];
    armtol_corner(box->matrix, box->arm->n_columns, row, sign, box->tolerances, box->errors);
    drawn_arm_error(box->arm, box->errors, error);
    if (row < 3 && error_largest(error) > result->worst.largest) {
        result->worst = (corner){row, sign, error_largest(error), error_norm(error)};
    }
    result->farthest = fmax(result->farthest, drawn_arm_farthest(box->arm, box->tolerances, box->errors));
    return error[row];
}

static void visit_corners(const box *box, const double accuracy[6], set_result *result)
{
    result->worst = (corner){0, 1, 0, 0};
    result->farthest = 0;
    for (size_t i = 0; i < 6; i++) {
        result->rows[i] = (row_corners){
            .prediction = armtol_worst_error(box->matrix, box->arm->n_columns, i, box->tolerances),
            .high = visit_corner(box, i, 1, result),
            .low = visit_corner(box, i, -1, result),
        };
    }
    result->remainder = guarantee_remainder(box->arm, box->tolerances);
    result->all_within = guarantee_holds(box->arm, box->matrix, box->tolerances, accuracy);
}

/* Build arms to the tolerances of `made`, as drawn in `drawn`. */
static bool run_set(const analysis *drawn, const analysis *made, const yield_options *options,
                    const drawn_arm *arm, set_result *result)
{
    const size_t n = arm->n_columns;
    double *block = calloc(n, 8 * sizeof *block);
    bool fine = block != NULL;
    if (fine) {
        double *matrix = block + 2 * n;
        const box box = {arm, matrix, block, block + n};
        memcpy(matrix, drawn->matrix, 6 * n * sizeof *matrix);
        armtol_tool_matrix_clear(arm->links, arm->n_links, &armtol_tool_origin, matrix, n);
        column_tolerances(made, options->reading, box.tolerances);
        result->length = made->shares.distance;
        result->angle = made->shares.angle;
        visit_corners(&box, drawn->tolerances, result);
        fine = arm_draws_make(arm, box.tolerances, drawn->tolerances, options->seed, options->samples,
                              &result->draws);
    }
    free(block);
    return fine;
}

static int run_sets(const analysis *published, const analysis *corrected, const yield_options *options,
                    yield_case *result)
{
    const drawn_arm arm = {corrected->links, corrected->robot->n_links, corrected->columns,
                           corrected->n_columns};
    const bool fine = run_set(corrected, published, options, &arm, &result->sets[SET_PUBLISHED]) &&
                      run_set(corrected, corrected, options, &arm, &result->sets[SET_CORRECTED]);
    if (!fine) {
        out_of_memory();
    }
    return fine ? EXIT_OK : EXIT_FAILED;
}

int yield_case_run(const published_list *list, size_t first, const yield_options *options,
                   yield_case *result)
{
    analysis published, corrected;
    if (!recompute(list, first, &armtol_errata_1987, NULL, &published)) {
        return EXIT_WRONG;
    }
    if (!recompute(list, first, &armtol_errata_none, NULL, &corrected)) {
        analysis_free(&published);
        return EXIT_WRONG;
    }
    memcpy(result->program, list->numbers[first].program, sizeof result->program);
    result->case_number = list->numbers[first].case_number;
    memcpy(result->accuracy, corrected.tolerances, sizeof result->accuracy);
    const int code = run_sets(&published, &corrected, options, result);
    analysis_free(&published);
    analysis_free(&corrected);
    return code;
}
