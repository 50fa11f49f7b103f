#ifndef ARMTOL_LIB_ARRIVALS_ONE_ARM_H
#define ARMTOL_LIB_ARRIVALS_ONE_ARM_H

#include "lib/arrivals/sources.h"
#include "lib/private_names.h"

#include <stddef.h>
#include <stdint.h>

/* Where an arm comes to a pose: its accuracy and its repeatability there (note 1 of arrivals.h). */
typedef struct arrival_measure {
    double accuracy, repeatability;
} arrival_measure;

/*
 * One arm at one pose.
 *
 * Given:
 *    sources, n   what is of each arrival
 *    still        where the tool point is without it, less where it should be
 *    key          of the draws, an arm's and pose's own
 *    n_links      of the arm
 *    cycles       at least 2
 *
 * Returned:
 *    ways         3 * cycles places of no further use
 */
arrival_measure arrival_cycles(const arrival_source sources[], size_t n, const double still[3], uint64_t key,
                               size_t n_links, size_t cycles, double ways[]);

#endif
