#include "bench/two_threads.h"

#include "bench/cases.h"

#include <pthread.h>
#include <time.h>

enum { ARMS = 4096, BLOCKS = 10, ROUNDS = 250 };

/* Seconds of that clock. */
static double now(clockid_t clock)
{
    struct timespec time;
    clock_gettime(clock, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

typedef struct share {
    uint64_t first;
    double seconds;       /* of a processor */
    volatile double last; /* read, so that nothing is left out */
    double errors[6 * ARMS];
} share;

static share shares[2] = {{.first = 0}, {.first = (uint64_t)ARMS * BLOCKS}};

static void *draw_share(void *of)
{
    share *const mine = of;
    const double start = now(CLOCK_THREAD_CPUTIME_ID);
    for (uint64_t block = 0; block < BLOCKS; block++) {
        armtol_sampler_draw(cases_sampler(), mine->first + block * ARMS, ARMS, mine->errors);
        mine->last = mine->errors[ARMS - 1];
    }
    mine->seconds = now(CLOCK_THREAD_CPUTIME_ID) - start;
    return NULL;
}

/* Seconds that both shares take, one after the other or at once; false where no thread starts. */
static bool both_shares(bool at_once, two_threads *taken)
{
    const double start = now(CLOCK_MONOTONIC);
    pthread_t other;
    if (at_once) {
        if (pthread_create(&other, NULL, draw_share, &shares[1]) != 0) {
            return false;
        }
    } else {
        draw_share(&shares[1]);
    }
    draw_share(&shares[0]);
    if (at_once) {
        pthread_join(other, NULL);
    }
    const double one = shares[0].seconds, two = shares[1].seconds;
    taken->by_clock = now(CLOCK_MONOTONIC) - start;
    taken->by_processor = !at_once ? one + two : one > two ? one : two;
    return true;
}

static void keep_least(double *least, double other)
{
    *least = other < *least ? other : *least;
}

bool two_threads_gain(two_threads *gain)
{
    two_threads best[2] = {{1e99, 1e99}, {1e99, 1e99}};
    for (int round = 0; round < ROUNDS; round++) {
        for (int threads = 0; threads < 2; threads++) {
            two_threads taken;
            if (!both_shares(threads == 1, &taken)) {
                return false;
            }
            keep_least(&best[threads].by_clock, taken.by_clock);
            keep_least(&best[threads].by_processor, taken.by_processor);
        }
    }
    gain->by_clock = best[0].by_clock / best[1].by_clock;
    gain->by_processor = best[0].by_processor / best[1].by_processor;
    return true;
}
