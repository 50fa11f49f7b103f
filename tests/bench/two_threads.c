#include "bench/two_threads.h"

#include "bench/cases.h"

#include <pthread.h>
#include <time.h>

enum { ARMS = 4096, BLOCKS = 100, ROUNDS = 25 };

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

typedef struct share {
    uint64_t first;
    volatile double last; /* read, so that nothing is left out */
    double errors[6 * ARMS];
} share;

static share shares[2] = {{.first = 0}, {.first = (uint64_t)ARMS * BLOCKS}};

static void *draw_share(void *of)
{
    share *const mine = of;
    for (uint64_t block = 0; block < BLOCKS; block++) {
        armtol_sampler_draw(cases_sampler(), mine->first + block * ARMS, ARMS, mine->errors);
        mine->last = mine->errors[ARMS - 1];
    }
    return NULL;
}

/* Seconds that both shares take, one after the other or at once; 0 where no thread starts. */
static double both_shares(bool at_once)
{
    const double start = now();
    pthread_t other;
    if (at_once) {
        if (pthread_create(&other, NULL, draw_share, &shares[1]) != 0) {
            return 0;
        }
    } else {
        draw_share(&shares[1]);
    }
    draw_share(&shares[0]);
    if (at_once) {
        pthread_join(other, NULL);
    }
    return now() - start;
}

double two_threads_gain(void)
{
    double best[2] = {1e99, 1e99};
    for (int round = 0; round < ROUNDS; round++) {
        for (int threads = 0; threads < 2; threads++) {
            const double seconds = both_shares(threads == 1);
            if (seconds == 0) {
                return 0;
            }
            best[threads] = seconds < best[threads] ? seconds : best[threads];
        }
    }
    return best[0] / best[1];
}
