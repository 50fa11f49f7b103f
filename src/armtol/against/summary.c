#include "armtol/against/against.h"

#include "console/exit_code.h"

#include <math.h>
#include <stdlib.h>

against_size against_size_of(const double error[6])
{
    const double *const w = error + 3;
    return (against_size){{sqrt(error[0] * error[0] + error[1] * error[1] + error[2] * error[2]),
                           sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2])}};
}

static double product_of(const double one[3], const double other[3])
{
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
}

static void add_difference(against_share *share, const double explained[6], const double error[6])
{
    const against_size alone = against_size_of(explained);
    for (size_t half = 0; half < 2; half++) {
        share->largest[half] = fmax(share->largest[half], alone.size[half]);
        share->share[half] += product_of(explained + 3 * half, error + 3 * half);
    }
}

static void add_pose(against *against, size_t pose, against_summary *summary, double squares[2])
{
    double error[6];
    against_pose(against, pose, error);
    const against_size whole = against_size_of(error);
    for (size_t half = 0; half < 2; half++) {
        squares[half] += whole.size[half] * whole.size[half];
        summary->mean[half] += whole.size[half];
        if (whole.size[half] > summary->largest[half]) {
            summary->largest[half] = whole.size[half];
            summary->worst[half] = pose;
        }
    }
    for (size_t k = 0; k < against->n_differences; k++) {
        add_difference(&summary->shares[k], against->explained + 6 * k, error);
    }
}

static int by_share(const void *one, const void *other)
{
    const against_share *a = one, *b = other;
    if (a->share[0] != b->share[0]) {
        return a->share[0] < b->share[0] ? 1 : -1;
    }
    return a->difference < b->difference ? -1 : 1;
}

/* Of the squared error of all poses; what is left of the whole is what the differences do together. */
static void divide(against_summary *summary, size_t n_differences, const double squares[2])
{
    for (size_t half = 0; half < 2; half++) {
        double left = 1;
        for (size_t k = 0; k < n_differences; k++) {
            double *const share = &summary->shares[k].share[half];
            *share = squares[half] > 0 ? *share / squares[half] : (double)NAN;
            left -= *share;
        }
        summary->together[half] = squares[half] > 0 ? left : (double)NAN;
    }
}

bool against_summarise(against *against, against_summary *summary)
{
    const size_t n_poses = against->request->question.n_poses;
    double squares[2] = {0, 0};
    *summary = (against_summary){.shares = calloc(against->n_differences + 1, sizeof *summary->shares)};
    if (summary->shares == NULL) {
        out_of_memory();
        return false;
    }
    for (size_t k = 0; k < against->n_differences; k++) {
        summary->shares[k].difference = k;
    }
    for (size_t pose = 0; pose < n_poses; pose++) {
        add_pose(against, pose, summary, squares);
    }
    for (size_t half = 0; half < 2; half++) {
        summary->mean[half] /= (double)n_poses;
    }
    divide(summary, against->n_differences, squares);
    qsort(summary->shares, against->n_differences, sizeof *summary->shares, by_share);
    return true;
}
