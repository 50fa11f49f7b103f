#include "armtol/engine/verification_draw.h"

#include "armtol/engine/verification_interrupt.h"
#include "armtol/sampler.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "console/progress.h"

#include <math.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>

enum {
    BLOCK = 4096, /* arms that a thread takes at a time, in one pose; in several, fewer */
    LEAST_BLOCK = 64
};

/* What all threads share. */
typedef struct work {
    const armtol_sampler *samplers; /* one a pose */
    size_t n_poses;
    const tally_limits *limits;
    uint64_t samples, block;
    pthread_mutex_t mutex;
    uint64_t next; /* the first arm that nobody has taken; under the mutex, as `stopped` */
    bool stopped;
} work;

typedef struct worker {
    work *work;
    pthread_t thread;
    tally tally;
    double errors[6 * TALLY_MOST];
    double magnitudes[6 * TALLY_MOST];
} worker;

static void draw_chunk(worker *worker, uint64_t first, size_t count)
{
    const work *work = worker->work;
    for (size_t pose = 0; pose < work->n_poses; pose++) {
        armtol_sampler_draw(&work->samplers[pose], first, count, worker->errors);
        for (size_t i = 0; i < 6 * count; i++) {
            const double magnitude = fabs(worker->errors[i]);
            const bool less = pose > 0 && magnitude < worker->magnitudes[i];
            worker->magnitudes[i] = less ? worker->magnitudes[i] : magnitude;
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
    const uint64_t left = work->stopped ? 0 : work->samples - work->next;
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

/* The part of the thread that the program began with: it also sees to interrupts and the bar. */
static void run_first_worker(worker *worker)
{
    progress progress;
    uint64_t first, count;
    progress_start(&progress, "arms", worker->work->samples);
    while (take_block(worker->work, &first, &count)) {
        draw_block(worker, first, count);
        progress_show(&progress, first + count);
        if (interrupt_came()) {
            stop(worker->work);
        }
    }
    progress_end(&progress);
}

static worker *worker_new(work *work)
{
    worker *worker = malloc(sizeof *worker);
    if (worker != NULL) {
        worker->work = work;
        tally_start(&worker->tally);
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

/* Interrupts come to the first thread: the others are started with them blocked. */
static size_t start_threads(work *work, worker *others[], size_t n_others)
{
    sigset_t interrupts, before;
    size_t started = 0;
    sigemptyset(&interrupts);
    sigaddset(&interrupts, SIGINT);
    pthread_sigmask(SIG_BLOCK, &interrupts, &before);
    while (started < n_others && (others[started] = start_thread(work)) != NULL) {
        started++;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return started;
}

/* No more threads than there are blocks. */
static size_t other_threads(const work *work, size_t n_threads)
{
    const uint64_t blocks = work->samples / work->block + (work->samples % work->block != 0);
    const uint64_t threads = n_threads < blocks ? n_threads : blocks;
    return threads > 0 ? (size_t)threads - 1 : 0;
}

static bool run_workers(work *work, size_t n_threads, tally *tally)
{
    const size_t n_others = other_threads(work, n_threads);
    worker *first = worker_new(work), **others = calloc(n_others + 1, sizeof *others);
    if (first == NULL || others == NULL) {
        free(first);
        free(others);
        out_of_memory();
        return false;
    }
    struct sigaction before;
    interrupt_watch(&before);
    const size_t started = start_threads(work, others, n_others);
    run_first_worker(first);
    *tally = first->tally;
    for (size_t i = 0; i < started; i++) {
        pthread_join(others[i]->thread, NULL);
        tally_merge(tally, &others[i]->tally);
        free(others[i]);
    }
    interrupt_restore(&before);
    free(first);
    free(others);
    return true;
}

static bool start_samplers(const verification_task *task, armtol_sampler samplers[],
                           armtol_sampled_link links[])
{
    for (size_t pose = 0; pose < task->n_poses; pose++) {
        const size_t first = pose * task->n_links;
        const armtol_status status =
            armtol_sampler_start(&samplers[pose], links + first, task->poses + first, task->n_links,
                                 task->tolerances, task->n_columns, &task->tool, task->seed);
        if (status != ARMTOL_OK) {
            message("cannot draw arms: %s", armtol_status_text(status));
            return false;
        }
    }
    return true;
}

static uint64_t block_of(size_t n_poses)
{
    return n_poses > BLOCK / LEAST_BLOCK ? LEAST_BLOCK : BLOCK / (n_poses > 0 ? n_poses : 1);
}

static bool draw_with(const verification_task *task, const tally_limits *limits, armtol_sampler samplers[],
                      armtol_sampled_link links[], tally *tally)
{
    work work = {
        .samplers = samplers,
        .n_poses = task->n_poses,
        .limits = limits,
        .samples = task->samples,
        .block = block_of(task->n_poses),
    };
    if (!start_samplers(task, samplers, links)) {
        return false;
    }
    pthread_mutex_init(&work.mutex, NULL);
    const bool fine = run_workers(&work, task->n_threads, tally);
    pthread_mutex_destroy(&work.mutex);
    return fine;
}

bool verification_draw(const verification_task *task, const tally_limits *limits, tally *tally)
{
    armtol_sampler *samplers = calloc(task->n_poses, sizeof *samplers);
    armtol_sampled_link *links = calloc(task->n_poses * task->n_links, sizeof *links);
    bool fine = samplers != NULL && links != NULL;
    if (fine) {
        fine = draw_with(task, limits, samplers, links, tally);
    } else {
        out_of_memory();
    }
    free(samplers);
    free(links);
    return fine;
}
