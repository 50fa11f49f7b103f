#ifndef ARMTOL_LAB_YIELD_CASE_H
#define ARMTOL_LAB_YIELD_CASE_H

#include "lab/published.h"
#include "lab/yield/arm_draws.h"
#include "lab/yield/options.h"

#include <stdbool.h>
#include <stddef.h>

/* Two sets of tolerances for one case: with all errata of 1987 kept, and with none. */
typedef enum tolerance_set { SET_PUBLISHED, SET_CORRECTED, SET_COUNT } tolerance_set;

/* A component of the tool's error at the two corners that its row of A points to, and what A says of both. */
typedef struct row_corners {
    double prediction; /* to first order, a magnitude */
    double high, low;
} row_corners;

/* One of the six corners of the linear components. */
typedef struct corner {
    size_t row; /* of A, 0 to 2 */
    int sign;
    double largest;  /* linear component there */
    double distance; /* of the tool point from where it should be */
} corner;

/* Arms built to one set of tolerances. Lengths in mm, angles in radians. */
typedef struct set_result {
    double length, angle; /* the shares of one parameter */
    arm_draws draws;
    row_corners rows[6];
    corner worst;     /* the one with the largest linear component */
    double farthest;  /* that the tool point gets from its place, climbing on from all twelve corners */
    double remainder; /* what the linear components can differ from the predictions by, at most */
    bool all_within;  /* no arm of the set can miss the accuracy (guarantee_holds) */
} set_result;

typedef struct yield_case {
    char program[16];
    int case_number;
    double accuracy[6];
    set_result sets[SET_COUNT];
} yield_case;

/*
 * The case that begins at number `first`. The true arm is that of the corrected tables at the corrected joint
 * values, for both sets. EXIT_OK, or another exit code after a message.
 */
int yield_case_run(const published_list *list, size_t first, const yield_options *options,
                   yield_case *result);

#endif
