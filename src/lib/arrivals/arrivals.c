#include "armtol/arrivals.h"

#include "lib/arrivals/one_arm.h"
#include "lib/arrivals/sources.h"
#include "lib/engine/check.h"
#include "lib/engine/draw.h"
#include "lib/spread/splitmix.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/*
 * Method
 *    Block by block of arms, all poses of a block: where the arms are by the sampler, and their arrivals one arm after
 *    the other. Both numbers of every arm and pose are kept, and sorted in the end. A draw is splitmix64's, by its
 *    number behind a key of the arm and pose; the key of the seed is another one than the sampler's.
 */

enum { BLOCK = 64 };

/* In thousandths. */
static const unsigned shares[ARMTOL_ARRIVAL_QUANTILES] = {500, 900, 950, 990};

/* What is kept of the arms, one series of `samples` a number: of a pose, or of all. */
typedef struct series {
    double *accuracies, *repeatabilities;
} series;

typedef struct work {
    const armtol_answer *answer;
    const armtol_draw *draw;
    size_t cycles, samples;
    uint64_t key;
    armtol_sampler *samplers;    /* one a pose */
    armtol_sampled_link *links;  /* n_poses x n_links */
    armtol_link *shifted;        /* n_links */
    double *making;              /* n_columns */
    arrival_source *sources;     /* n_poses x n_links */
    size_t *n_sources;           /* n_poses */
    double *ways;                /* 3 x cycles */
    double *kept;                /* (n_poses + 1) x 2 x samples */
} work;

/* ---- memory ---- */

static bool get_memory(work *work)
{
    const armtol_answer *answer = work->answer;
    const size_t n_poses = answer->n_poses, n_links = answer->n_links;
    work->samplers = calloc(n_poses, sizeof *work->samplers);
    work->links = calloc(n_poses, n_links * sizeof *work->links);
    work->shifted = calloc(n_links, sizeof *work->shifted);
    work->making = calloc(answer->n_columns, sizeof *work->making);
    work->sources = calloc(n_poses, n_links * sizeof *work->sources);
    work->n_sources = calloc(n_poses, sizeof *work->n_sources);
    work->ways = calloc(work->cycles, 3 * sizeof *work->ways);
    const bool counted = work->draw->samples < SIZE_MAX / (2 * sizeof *work->kept);
    work->samples = counted ? (size_t)work->draw->samples : 0;
    work->kept = counted ? calloc(n_poses + 1, (2 * work->samples + 1) * sizeof *work->kept) : NULL;
    return work->samplers != NULL && work->links != NULL && work->shifted != NULL && work->making != NULL &&
           work->sources != NULL && work->n_sources != NULL && work->ways != NULL && work->kept != NULL;
}

static void free_memory(work *work)
{
    free(work->samplers);
    free(work->links);
    free(work->shifted);
    free(work->making);
    free(work->sources);
    free(work->n_sources);
    free(work->ways);
    free(work->kept);
}

/* The series of a pose; n_poses is that of all. */
static series series_of(const work *work, size_t pose)
{
    double *first = work->kept + 2 * pose * work->samples;
    return (series){first, first + work->samples};
}

/* ---- drawing ---- */

static armtol_status start(work *work)
{
    const armtol_answer *answer = work->answer;
    armtol_status status = ARMTOL_OK;
    for (size_t pose = 0; pose < answer->n_poses && status == ARMTOL_OK; pose++) {
        arrival_sources_making(answer, pose, work->making);
        status = draw_start_sampler(answer, pose, work->making, work->draw->seed, work->shifted,
                                    work->links + pose * answer->n_links, &work->samplers[pose]);
        work->n_sources[pose] = arrival_sources_of(answer, pose, work->sources + pose * answer->n_links);
    }
    return status;
}

static void draw_pose(work *work, size_t pose, size_t first, size_t count)
{
    const armtol_answer *answer = work->answer;
    const series of = series_of(work, pose), all = series_of(work, answer->n_poses);
    double errors[6 * BLOCK];
    armtol_sampler_draw(&work->samplers[pose], first, count, errors);
    for (size_t j = 0; j < count; j++) {
        const size_t arm = first + j;
        const double still[3] = {errors[j], errors[count + j], errors[2 * count + j]};
        const uint64_t number = (uint64_t)arm * answer->n_poses + pose;
        const arrival_measure measure =
            arrival_cycles(work->sources + pose * answer->n_links, work->n_sources[pose], still,
                           splitmix_mix(work->key + SPLITMIX_STEP * (number + 1)), answer->n_links, work->cycles,
                           work->ways);
        of.accuracies[arm] = measure.accuracy;
        of.repeatabilities[arm] = measure.repeatability;
        all.accuracies[arm] = fmax(all.accuracies[arm], measure.accuracy);
        all.repeatabilities[arm] = fmax(all.repeatabilities[arm], measure.repeatability);
    }
}

/* How many arms have been drawn. */
static size_t draw_arms_of(work *work)
{
    const armtol_draw *draw = work->draw;
    size_t done = 0;
    bool goes_on = true;
    while (done < work->samples && goes_on) {
        const size_t count = work->samples - done < BLOCK ? work->samples - done : BLOCK;
        for (size_t pose = 0; pose < work->answer->n_poses; pose++) {
            draw_pose(work, pose, done, count);
        }
        done += count;
        goes_on = draw->progress == NULL || draw->progress(draw->context, done, draw->samples);
    }
    return done;
}

/* ---- what is told ---- */

static int by_size(const void *one, const void *other)
{
    const double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

/* The values are sorted. */
static armtol_over_arms over_arms(double values[], size_t n)
{
    armtol_over_arms over = {.largest = (double)NAN};
    for (size_t i = 0; i < n; i++) {
        if (!(values[i] <= over.largest)) {
            over.largest = values[i];
            over.largest_arm = i;
        }
    }
    qsort(values, n, sizeof *values, by_size);
    for (size_t i = 0; i < ARMTOL_ARRIVAL_QUANTILES; i++) {
        over.quantiles[i] = n > 0 ? values[((uint64_t)n * shares[i] + 999) / 1000 - 1] : (double)NAN;
    }
    return over;
}

static bool has_bound(const armtol_answer *answer)
{
    return isfinite(answer->components[0].worst) && isfinite(answer->components[1].worst) &&
           isfinite(answer->components[2].worst);
}

static armtol_repeated repeated_of(const work *work, size_t pose, size_t drawn)
{
    const series of = series_of(work, pose);
    armtol_repeated repeated = {.repeatability = over_arms(of.repeatabilities, drawn)};
    repeated.accuracy = over_arms(of.accuracies, has_bound(work->answer) ? drawn : 0);
    return repeated;
}

static void report(const work *work, size_t drawn, armtol_arrivals *arrivals)
{
    arrivals->drawn = drawn;
    arrivals->cycles = work->cycles;
    arrivals->n_poses = work->answer->n_poses;
    for (size_t i = 0; i < ARMTOL_ARRIVAL_QUANTILES; i++) {
        arrivals->probabilities[i] = shares[i] / 1000.0;
    }
    for (size_t pose = 0; pose < arrivals->n_poses; pose++) {
        arrivals->poses[pose] = repeated_of(work, pose, drawn);
    }
    arrivals->all = repeated_of(work, arrivals->n_poses, drawn);
}

static armtol_status run(work *work, armtol_arrivals *arrivals)
{
    armtol_status status = get_memory(work) ? start(work) : ARMTOL_NO_MEMORY;
    if (status == ARMTOL_OK) {
        report(work, draw_arms_of(work), arrivals);
    }
    free_memory(work);
    return status;
}

static armtol_status make(const armtol_answer *answer, const armtol_draw *draw, size_t cycles,
                          armtol_arrivals *arrivals)
{
    /* the seed mixed twice, the first time as the sampler's */
    const uint64_t key = splitmix_mix(~splitmix_mix(draw->seed));
    arrivals->poses = calloc(answer->n_poses, sizeof *arrivals->poses);
    return arrivals->poses != NULL
               ? run(&(work){.answer = answer, .draw = draw, .cycles = cycles, .key = key}, arrivals)
               : ARMTOL_NO_MEMORY;
}

static armtol_fault create(const armtol_answer *answer, const armtol_draw *draw, size_t cycles,
                           armtol_arrivals **arrivals)
{
    if (cycles < 2) {
        return fault_of(ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0);
    }
    *arrivals = calloc(1, sizeof **arrivals);
    const armtol_status status = *arrivals != NULL ? make(answer, draw, cycles, *arrivals) : ARMTOL_NO_MEMORY;
    const bool about = status != ARMTOL_OK && status != ARMTOL_NO_MEMORY;
    return fault_of(status, about ? ARMTOL_ABOUT_TOLERANCES : ARMTOL_ABOUT_NOTHING, 0);
}

armtol_status armtol_arrivals_create(const armtol_answer *answer, const armtol_draw *draw, size_t cycles,
                                     armtol_arrivals **arrivals, armtol_fault *fault)
{
    *arrivals = NULL;
    const armtol_fault found = create(answer, draw, cycles, arrivals);
    if (found.status != ARMTOL_OK) {
        armtol_arrivals_destroy(*arrivals);
        *arrivals = NULL;
    }
    if (fault != NULL) {
        *fault = found;
    }
    return found.status;
}

void armtol_arrivals_destroy(armtol_arrivals *arrivals)
{
    if (arrivals != NULL) {
        free(arrivals->poses);
        free(arrivals);
    }
}
