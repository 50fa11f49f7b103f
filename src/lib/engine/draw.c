#include "lib/engine/draw.h"

#include "armtol/sampler.h"

#include <math.h>
#include <pthread.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum {
    BLOCK = 4096, /* arms that a thread takes at a time, in one pose; in several, fewer */
    LEAST_BLOCK = 64
};

/* What all threads share. */
typedef struct work {
    const armtol_draw *draw;
    const armtol_sampler *samplers; /* one a pose */
    size_t n_poses;
    const tally_limits *limits;
    uint64_t block;
    pthread_mutex_t mutex;
    uint64_t begin, end; /* the first arm, and the one behind the last */
    uint64_t next; /* the first arm that nobody has taken; under the mutex, as `stopped` */
    bool stopped;
} work;

typedef struct worker {
    work *work;
    pthread_t thread;
    tally tally;
    double errors[6 * TALLY_MOST];
    double magnitudes[TALLY_MEASURES * TALLY_MOST]; /* the largest of all poses */
} worker;

static void keep_larger(double *most, double magnitude, bool first)
{
    *most = !first && magnitude < *most ? *most : magnitude;
}

/* Of each arm the norm of these components. */
static void measure_norm(const double errors[], size_t count, unsigned components, bool first, double magnitudes[])
{
    for (size_t j = 0; j < count; j++) {
        double error[6];
        for (size_t i = 0; i < 6; i++) {
            error[i] = errors[i * count + j];
        }
        keep_larger(&magnitudes[j], armtol_norm_of(error, components), first);
    }
}

static void draw_chunk(worker *worker, uint64_t first, size_t count)
{
    const work *work = worker->work;
    for (size_t pose = 0; pose < work->n_poses; pose++) {
        armtol_sampler_draw(&work->samplers[pose], first, count, worker->errors);
        for (size_t i = 0; i < 6 * count; i++) {
            keep_larger(&worker->magnitudes[i], fabs(worker->errors[i]), pose == 0);
        }
        for (size_t i = 6; i < work->limits->n_measures; i++) {
            measure_norm(worker->errors, count, work->limits->components[i], pose == 0, worker->magnitudes + i * count);
        }
    }
    tally_add(&worker->tally, work->limits, first, count, worker->magnitudes);
}

static void draw_block(worker *worker, uint64_t first, uint64_t count)
{
    for (uint64_t done = 0; done < count; done += TALLY_MOST) {
        draw_chunk(worker, first + done, count - done < TALLY_MOST ? (size_t)(count - done) : TALLY_MOST);
    }
}

/* The next block, or false where there is none. */
static bool take_block(work *work, uint64_t *first, uint64_t *count)
{
    pthread_mutex_lock(&work->mutex);
    const uint64_t left = work->stopped ? 0 : work->end - work->next;
    *first = work->next;
    *count = left < work->block ? left : work->block;
    work->next += *count;
    pthread_mutex_unlock(&work->mutex);
    return *count > 0;
}

static void stop(work *work)
{
    pthread_mutex_lock(&work->mutex);
    work->stopped = true;
    pthread_mutex_unlock(&work->mutex);
}

static void *run_worker(void *context)
{
    worker *worker = context;
    uint64_t first, count;
    while (take_block(worker->work, &first, &count)) {
        draw_block(worker, first, count);
    }
    return NULL;
}

/* The part of the caller's thread, which also lets the caller look on. */
static void run_first_worker(worker *worker)
{
    const armtol_draw *draw = worker->work->draw;
    uint64_t first, count;
    while (take_block(worker->work, &first, &count)) {
        draw_block(worker, first, count);
        if (draw->progress != NULL &&
            !draw->progress(draw->context, first + count - worker->work->begin, draw->samples)) {
            stop(worker->work);
        }
    }
}

static worker *worker_new(work *work)
{
    worker *worker = malloc(sizeof *worker);
    if (worker != NULL) {
        worker->work = work;
        tally_start(&worker->tally, work->limits->n_measures);
    }
    return worker;
}

/* Starts another thread; NULL where it cannot be had. */
static worker *start_thread(work *work)
{
    worker *worker = worker_new(work);
    if (worker != NULL && pthread_create(&worker->thread, NULL, run_worker, worker) != 0) {
        free(worker);
        worker = NULL;
    }
    return worker;
}

/* Signals come to the program's own threads: these are started with all of them blocked. */
static size_t start_threads(work *work, worker *others[], size_t n_others)
{
    sigset_t all, before;
    size_t started = 0;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    while (started < n_others && (others[started] = start_thread(work)) != NULL) {
        started++;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return started;
}

/* No more threads than there are blocks. */
static size_t other_threads(const work *work, size_t n_threads)
{
    const uint64_t blocks = work->draw->samples / work->block + (work->draw->samples % work->block != 0);
    const uint64_t threads = n_threads < blocks ? n_threads : blocks;
    return threads > 0 ? (size_t)threads - 1 : 0;
}

static armtol_status run_workers(work *work, tally *tally)
{
    const size_t n_others = other_threads(work, work->draw->n_threads);
    worker *first = worker_new(work), **others = calloc(n_others + 1, sizeof *others);
    if (first == NULL || others == NULL) {
        free(first);
        free(others);
        return ARMTOL_NO_MEMORY;
    }
    const size_t started = start_threads(work, others, n_others);
    run_first_worker(first);
    memcpy(tally, &first->tally, tally_size(&first->tally));
    for (size_t i = 0; i < started; i++) {
        pthread_join(others[i]->thread, NULL);
        tally_merge(tally, &others[i]->tally);
        free(others[i]);
    }
    free(first);
    free(others);
    return ARMTOL_OK;
}

/* The arm as drives, loads and means shift it, about which arms are drawn. */
static void shift_links(const armtol_answer *answer, size_t pose, armtol_link shifted[])
{
    const double *shifts = armtol_answer_shifts(answer, pose);
    memcpy(shifted, armtol_answer_links(answer, pose), answer->n_links * sizeof *shifted);
    for (size_t k = 0; k < answer->n_columns; k++) {
        *armtol_link_parameter(&shifted[answer->columns[k].link], answer->columns[k].parameter) += shifts[k];
    }
}

armtol_status draw_start_sampler(const armtol_answer *answer, size_t pose, const double tolerances[], uint64_t seed,
                                 armtol_link shifted[], armtol_sampled_link links[], armtol_sampler *sampler)
{
    const armtol_link *meant = armtol_answer_links(answer, pose);
    if (answer->shifted) {
        shift_links(answer, pose, shifted);
    }
    const armtol_status status =
        armtol_sampler_start(sampler, links, answer->shifted ? shifted : meant, answer->n_links,
                             tolerances, answer->n_columns, &answer->tool, seed);
    if (status == ARMTOL_OK) {
        armtol_sampler_discs(sampler, links, answer->discs);
    }
    if (status == ARMTOL_OK && answer->shifted) {
        armtol_sampler_aim(sampler, meant);
    }
    if (status == ARMTOL_OK) {
        armtol_sampler_spread(sampler, links, answer->spreads);
    }
    return status;
}

static armtol_status start_samplers(const armtol_answer *answer, uint64_t seed, armtol_sampler samplers[],
                                    armtol_sampled_link links[])
{
    armtol_link *shifted = calloc(answer->n_links, sizeof *shifted);
    armtol_status status = shifted != NULL ? ARMTOL_OK : ARMTOL_NO_MEMORY;
    for (size_t pose = 0; pose < answer->n_poses && status == ARMTOL_OK; pose++) {
        status = draw_start_sampler(answer, pose, armtol_answer_bounded(answer, pose), seed, shifted,
                                    links + pose * answer->n_links, &samplers[pose]);
    }
    free(shifted);
    return status;
}

static uint64_t block_of(size_t n_poses)
{
    return n_poses > BLOCK / LEAST_BLOCK ? LEAST_BLOCK : BLOCK / n_poses;
}

static armtol_status draw_with(const armtol_answer *answer, const armtol_draw *draw, uint64_t first,
                               const tally_limits *limits, armtol_sampler samplers[], armtol_sampled_link links[],
                               tally *tally)
{
    work work = {
        .draw = draw,
        .samplers = samplers,
        .n_poses = answer->n_poses,
        .limits = limits,
        .block = block_of(answer->n_poses),
        .begin = first,
        .end = first + draw->samples,
        .next = first,
    };
    armtol_status status = start_samplers(answer, draw->seed, samplers, links);
    if (status == ARMTOL_OK) {
        pthread_mutex_init(&work.mutex, NULL);
        status = run_workers(&work, tally);
        pthread_mutex_destroy(&work.mutex);
    }
    return status;
}

armtol_status draw_arms(const armtol_answer *answer, const armtol_draw *draw, uint64_t first,
                        const tally_limits *limits, tally *tally)
{
    armtol_sampler *samplers = calloc(answer->n_poses, sizeof *samplers);
    armtol_sampled_link *links = calloc(answer->n_poses, answer->n_links * sizeof *links);
    const armtol_status status = samplers != NULL && links != NULL
                                     ? draw_with(answer, draw, first, limits, samplers, links, tally)
                                     : ARMTOL_NO_MEMORY;
    free(samplers);
    free(links);
    return status;
}
