#include "lab/yield/arm_draws.h"

#include "armtol/sampler.h"

#include <stdlib.h>

const size_t quantile_percents[QUANTILE_COUNT] = {10, 50, 90, 99};

/* The sizes of error of every arm. */
typedef struct sizes {
    double *linear, *angular, *distance;
} sizes;

void arm_draws_errors(const drawn_arm *arm, const double tolerances[], uint64_t seed, size_t i,
                      double errors[])
{
    for (size_t k = 0; k < arm->n_columns; k++) {
        errors[k] = tolerances[k] * armtol_sampler_uniform(seed, (uint64_t)i * arm->n_columns + k);
    }
}

/* Returns how many are within. */
static size_t draw_all(const drawn_arm *arm, const double tolerances[], const double accuracy[6],
                       uint64_t seed, size_t samples, double errors[], sizes *sizes)
{
    size_t within = 0;
    for (size_t i = 0; i < samples; i++) {
        double error[6];
        arm_draws_errors(arm, tolerances, seed, i, errors);
        drawn_arm_error(arm, errors, error);
        within += error_is_within(error, accuracy);
        sizes->linear[i] = error_largest(error);
        sizes->angular[i] = error_largest(error + 3);
        sizes->distance[i] = error_norm(error);
    }
    return within;
}

static int ascending(const void *one, const void *other)
{
    const double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

/* Sorts the values. */
static error_spread spread_of(double values[], size_t n)
{
    error_spread spread;
    qsort(values, n, sizeof *values, ascending);
    for (int i = 0; i < QUANTILE_COUNT; i++) {
        spread.quantiles[i] = values[(n * quantile_percents[i] + 99) / 100 - 1];
    }
    spread.worst = values[n - 1];
    return spread;
}

bool arm_draws_make(const drawn_arm *arm, const double tolerances[], const double accuracy[6], uint64_t seed,
                    size_t samples, arm_draws *draws)
{
    double *errors = calloc(arm->n_columns, sizeof *errors);
    double *block = calloc(samples, 3 * sizeof *block);
    const bool fine = errors != NULL && block != NULL;
    if (fine) {
        sizes sizes = {block, block + samples, block + 2 * samples};
        draws->samples = samples;
        draws->within = draw_all(arm, tolerances, accuracy, seed, samples, errors, &sizes);
        draws->linear = spread_of(sizes.linear, samples);
        draws->angular = spread_of(sizes.angular, samples);
        draws->distance = spread_of(sizes.distance, samples);
    }
    free(errors);
    free(block);
    return fine;
}
