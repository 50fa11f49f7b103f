#ifndef ARMTOL_LAB_YIELD_ARM_DRAWS_H
#define ARMTOL_LAB_YIELD_ARM_DRAWS_H

#include "lab/yield/drawn_arm.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The shares of arms that quantiles are given for, in percent. */
enum { QUANTILE_COUNT = 4 };
extern const size_t quantile_percents[QUANTILE_COUNT];

/* What came of a size of error over all arms drawn. */
typedef struct error_spread {
    double quantiles[QUANTILE_COUNT]; /* the least that this share of the arms does not exceed */
    double worst;
} error_spread;

typedef struct arm_draws {
    size_t samples;
    size_t within;         /* arms of which all six components keep to the accuracy */
    error_spread linear;   /* of an arm's largest linear component */
    error_spread angular;  /* of its largest angular component */
    error_spread distance; /* of its tool point from where it should be */
} arm_draws;

/*
 * Draw arms, samples > 0, with every error uniform within its column's tolerance. Arm i is the same however
 * many are drawn, and takes the same part of each tolerance whatever the tolerances. False where memory is
 * short.
 */
bool arm_draws_make(const drawn_arm *arm, const double tolerances[], const double accuracy[6], uint64_t seed,
                    size_t samples, arm_draws *draws);

/* The errors of arm i, one a column. */
void arm_draws_errors(const drawn_arm *arm, const double tolerances[], uint64_t seed, size_t i,
                      double errors[]);

#endif
