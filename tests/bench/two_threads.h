#ifndef BENCH_TWO_THREADS_H
#define BENCH_TWO_THREADS_H

/*
 * How many times as many samples two threads draw as one, in the best of several rounds; 0 where none starts.
 */
double two_threads_gain(void);

#endif
