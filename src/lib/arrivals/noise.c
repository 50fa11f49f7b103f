#include "armtol/arrivals.h"

#include "armtol/optimum.h"
#include "lib/engine/check.h"
#include "lib/engine/drives.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/*
 * Method
 *    With T the trace of the covariance of the arrivals, RP <= normal sqrt T (arrivals.h; the proof is in
 *    docs/iso9283.md). T is a sum of squares, a share a joint, so that the noises have the optimum of root sum squares:
 *    a row a pose, of the lengths that the joints move the tool by, and as its limit what steps and plays leave.
 */

/* sqrt(2 / pi) + 3 sqrt(1 - 2 / pi) */
static const double normal = 2.606315385770126;

static bool moves(const armtol_answer *answer, size_t link)
{
    return answer->links[link].joint != ARMTOL_FIXED;
}

/* How far the tool point goes for 1 of a joint. */
static double way_of(const armtol_answer *answer, size_t pose, size_t link)
{
    const double *from = armtol_answer_matrix(answer, pose) + answer_motor_column(answer, link);
    const double x = from[0], y = from[answer->n_columns], z = from[2 * answer->n_columns];
    return sqrt(x * x + y * y + z * z);
}

/* The deviation of a joint that has this noise. */
static double deviation_of(const armtol_drive_arrival *off, double noise)
{
    return sqrt(noise * noise + (off->step * off->step + off->play * off->play) / 3);
}

double armtol_arrivals_bound(const armtol_answer *answer, size_t pose, const double noise[], double shares[])
{
    double trace = 0;
    for (size_t i = 0; i < answer->n_links; i++) {
        const armtol_drive_arrival *off = &answer->arrivals[pose * answer->n_links + i];
        const double way = moves(answer, i) ? way_of(answer, pose, i) : 0;
        const double part = way > 0 ? way * deviation_of(off, noise != NULL ? noise[i] : off->noise) : 0;
        shares[i] = part * part;
        trace += shares[i];
    }
    for (size_t i = 0; i < answer->n_links && trace > 0; i++) {
        shares[i] /= trace;
    }
    return normal * sqrt(trace);
}

/* ---- the largest noises ---- */

typedef struct work {
    size_t n_rows, n;             /* poses; joints that move, of which these are the links: */
    size_t *links;                /* n */
    double *shares;               /* n_links */
    double *matrix;               /* n_rows x n */
    double *limits, *multipliers; /* n_rows */
    double *weights, *noises;     /* n */
    double *space;
} work;

static bool get_memory(work *work, const armtol_answer *answer)
{
    work->n_rows = answer->n_poses;
    for (size_t i = 0; i < answer->n_links; i++) {
        work->n += moves(answer, i);
    }
    work->links = calloc(work->n + 1, sizeof *work->links);
    work->shares = calloc(answer->n_links + 1, sizeof *work->shares);
    work->matrix = calloc(work->n_rows, (work->n + 1) * sizeof *work->matrix);
    work->limits = calloc(work->n_rows, sizeof *work->limits);
    work->multipliers = calloc(work->n_rows, sizeof *work->multipliers);
    work->weights = calloc(work->n + 1, sizeof *work->weights);
    work->noises = calloc(work->n + 1, sizeof *work->noises);
    work->space = calloc(armtol_optimum_workspace(work->n_rows, work->n) + 1, sizeof *work->space);
    return work->links != NULL && work->shares != NULL && work->matrix != NULL && work->limits != NULL &&
           work->multipliers != NULL && work->weights != NULL && work->noises != NULL && work->space != NULL;
}

static void free_memory(work *work)
{
    free(work->links);
    free(work->shares);
    free(work->matrix);
    free(work->limits);
    free(work->multipliers);
    free(work->weights);
    free(work->noises);
    free(work->space);
}

/* The joints; one that the links do not count what it moves of has no place in A. */
static armtol_fault find_joints(work *work, const armtol_answer *answer)
{
    size_t n = 0;
    for (size_t i = 0; i < answer->n_links; i++) {
        if (moves(answer, i)) {
            if (answer_motor_column(answer, i) == answer->n_columns) {
                return fault_of(ARMTOL_BAD_LOAD, ARMTOL_ABOUT_DRIVES, i);
            }
            work->weights[n] = 1;
            work->links[n++] = i;
        }
    }
    return fault_of(ARMTOL_OK, ARMTOL_ABOUT_NOTHING, 0);
}

/* none: n_links zeros. */
static armtol_fault find_rows(work *work, const armtol_answer *answer, double wish, const double none[])
{
    for (size_t pose = 0; pose < work->n_rows; pose++) {
        const double used = armtol_arrivals_bound(answer, pose, none, work->shares) / wish;
        if (!(used < 1)) {
            return fault_of(ARMTOL_NOTHING_LEFT, ARMTOL_ABOUT_POSE, pose);
        }
        work->limits[pose] = wish / normal * sqrt((1 - used) * (1 + used));
        for (size_t j = 0; j < work->n; j++) {
            work->matrix[pose * work->n + j] = way_of(answer, pose, work->links[j]);
        }
    }
    return fault_of(ARMTOL_OK, ARMTOL_ABOUT_NOTHING, 0);
}

static armtol_fault find_noises(work *work, const armtol_answer *answer, double wish, double noise[])
{
    armtol_fault fault = find_joints(work, answer);
    if (fault.status == ARMTOL_OK) {
        fault = find_rows(work, answer, wish, noise);
    }
    if (fault.status != ARMTOL_OK || work->n == 0) {
        return fault;
    }
    const armtol_status status =
        armtol_optimum(ARMTOL_ROOT_SUM_SQUARES, work->matrix, work->n_rows, work->n, work->limits, work->weights,
                       work->noises, work->multipliers, work->space);
    for (size_t j = 0; j < work->n && status == ARMTOL_OK; j++) {
        noise[work->links[j]] = work->noises[j];
    }
    return fault_of(status, status == ARMTOL_OK ? ARMTOL_ABOUT_NOTHING : ARMTOL_ABOUT_METHOD, 0);
}

static armtol_fault allot(const armtol_answer *answer, double wish, double noise[])
{
    work work = {.n = 0};
    if (!(wish > 0) || isinf(wish)) {
        return fault_of(ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_ACCURACY, 0);
    }
    const armtol_fault fault = get_memory(&work, answer) ? find_noises(&work, answer, wish, noise)
                                                         : fault_of(ARMTOL_NO_MEMORY, ARMTOL_ABOUT_NOTHING, 0);
    free_memory(&work);
    return fault;
}

armtol_status armtol_arrivals_noise(const armtol_answer *answer, double wish, double noise[], armtol_fault *fault)
{
    for (size_t i = 0; i < answer->n_links; i++) {
        noise[i] = 0;
    }
    const armtol_fault found = allot(answer, wish, noise);
    if (fault != NULL) {
        *fault = found;
    }
    return found.status;
}
