#ifndef BENCH_CASES_H
#define BENCH_CASES_H

#include "armtol/sampler.h"

#include <stdbool.h>
#include <stddef.h>

/* Something to be measured: run does so many pieces. */
typedef struct bench_case {
    const char *name;
    void (*run)(void);
    size_t pieces;
} bench_case;

enum { BENCH_CASES = 8 };

/* The first of each is the loop written by hand. */
extern const bench_case pose_cases[], sample_cases[], map_cases[]; /* of maps: A alone in blocks */
extern const size_t pose_case_count, sample_case_count, map_case_count;

/* Prepares the cases, and whether the library and the loops written by hand agree. */
bool cases_start(void);

/* "this machine" or "any machine". */
const char *cases_compiled_for(void);

/* The sampler with tolerances as they are common, ready when the cases are. */
const armtol_sampler *cases_sampler(void);

#endif
