#ifndef BENCH_TWO_THREADS_H
#define BENCH_TWO_THREADS_H

#include <stdbool.h>

typedef struct two_threads {
    double by_clock;     /* means something where both processors are idle */
    double by_processor; /* of the thread that takes longer; as if each thread had a processor all the time */
} two_threads;

/* How many times as many samples two threads draw as one in the same time; false where no thread starts. */
bool two_threads_gain(two_threads *gain);

#endif
