#ifndef ARMTOL_ENGINE_VERIFICATION_H
#define ARMTOL_ENGINE_VERIFICATION_H

#include "armtol/error_matrix.h"
#include "armtol/link.h"
#include "armtol/tool_point.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/*
 * What is drawn and held against what. Poses are placed links, one after the other; an arm is the same in all
 * of them. Errors are uniform within the tolerances. A parameter with an infinite tolerance is not drawn, and
 * is exact for the components that do not depend on it (corners.h); of one that does there is nothing to say,
 * and it must not be one that accuracy counts.
 */
typedef struct verification_task {
    const armtol_link *poses; /* n_poses x n_links */
    size_t n_poses;           /* at least one */
    size_t n_links;
    const double *matrices; /* n_poses x 6 x n_columns, A of each pose (tool_matrix.h) */
    const double *tolerances;
    size_t n_columns;
    armtol_tool_point tool;
    const double *accuracy; /* six, infinity for a free row; NULL where none is asked for */
    uint64_t samples;
    uint64_t seed;
    size_t n_threads; /* at most, this one among them */
} verification_task;

enum { VERIFICATION_QUANTILES = 4 };
extern const double verification_quantiles[VERIFICATION_QUANTILES]; /* 0.5, 0.9, 0.99, 0.999 */

/*
 * One component of the tool's error, magnitudes, the largest of all poses. A quantile is what that share of
 * the arms does not exceed, rounded up by no more than 1/4096 of prediction + remainder (of half a turn,
 * where that is less), and never above worst_drawn. Of a component that depends on a parameter with an infinite
 * tolerance the predictions and the remainder are infinity and what was drawn and found nan.
 */
typedef struct verified_component {
    double prediction; /* |A| t */
    double rss;        /* root of the sum of (A t)^2 */
    double remainder;  /* what the exact error can differ from a prediction by; infinity where not bounded */
    double quantiles[VERIFICATION_QUANTILES];
    double worst_drawn;
    uint64_t worst_arm;  /* the first arm that had it, as armtol_sampler_parameters counts them */
    double worst_corner; /* exact error in the corners that A's signs point to, and climbing on from them */
} verified_component;

typedef struct verification {
    uint64_t drawn;  /* fewer than asked for where it was interrupted */
    uint64_t within; /* every component in every pose keeps to the accuracy; all, where none is asked for */
    uint64_t beyond; /* some component exceeds its accuracy by more than its remainder */
    double share_low, share_high; /* 95 % interval of the share within */
    verified_component components[6];
} verification;

/*
 * Draw and search. Shows a progress bar on standard error where that is a terminal and it takes longer than a
 * second; an interrupt (SIGINT) ends the drawing, not the program, and a second one the program. The result
 * depends on the task alone, to the bit, and not on the number of threads, unless interrupted. False after a
 * message: memory, or what armtol_sampler_start refuses. Threads that cannot be had are done without.
 */
bool verification_run(const verification_task *task, verification *result);

#endif
