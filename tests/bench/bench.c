/*
 * How long the library takes for one pose and for one sample of the Intelledex 605T, beside a loop written by
 * hand for that arm. Every case is measured in many short rounds, all cases in turn: the least of a case is
 * what the machine can do, the median tells how much others were in the way.
 */

#include "bench/cases.h"
#include "bench/enclosure.h"
#include "bench/two_threads.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { ROUNDS = 40 };
#define ROUND_NS 5e6

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec * 1e9 + (double)time.tv_nsec;
}

/* The least ns a piece in one round. */
static double round_of(const bench_case *measured)
{
    const double end = now() + ROUND_NS;
    double least = 1e99;
    for (double start = now(); start < end;) {
        measured->run();
        const double stop = now();
        const double each = (stop - start) / (double)measured->pieces;
        least = each < least ? each : least;
        start = stop;
    }
    return least;
}

static int ascending(const void *one, const void *other)
{
    const double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

static void print_case(const bench_case *measured, const double times[ROUNDS], double textbook)
{
    printf("  %-58s %8.1f %8.1f %8.2f\n", measured->name, times[0], times[ROUNDS / 2], times[0] / textbook);
}

static void measure(const char *what, const bench_case cases[], size_t n)
{
    static double times[BENCH_CASES][ROUNDS];
    for (int round = 0; round < ROUNDS; round++) {
        for (size_t i = 0; i < n; i++) {
            times[i][round] = round_of(&cases[i]);
        }
    }
    printf("%-60s %8s %8s %8s\n", what, "least ns", "median", "ratio");
    for (size_t i = 0; i < n; i++) {
        qsort(times[i], ROUNDS, sizeof times[i][0], ascending);
        print_case(&cases[i], times[i], times[0][0]);
    }
    printf("\n");
}

int main(void)
{
    if (!cases_start()) {
        fprintf(stderr, "armtol_bench: the library and the loops written by hand do not agree\n");
        return EXIT_FAILURE;
    }
    printf("compiled for %s; ratio: of the first line of its table\n\n", cases_compiled_for());
    measure("A with its bounds, a pose", pose_cases, pose_case_count);
    measure("a map of 1000000 poses, slice by slice, a pose", map_cases, map_case_count);
    measure("exact error of the tool, a sample", sample_cases, sample_case_count);
    two_threads gain;
    if (!two_threads_gain(&gain)) {
        fprintf(stderr, "armtol_bench: cannot start a thread\n");
        return EXIT_FAILURE;
    }
    printf("two threads draw %.2f times as many samples as one by the clock, %.2f by processor time\n\n", gain.by_clock,
           gain.by_processor);
    if (!enclosure_print()) {
        fprintf(stderr, "armtol_bench: the largest error of a region is not enclosed\n");
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
