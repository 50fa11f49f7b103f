#ifndef ARMTOL_CLUSTER_COVERAGE_H
#define ARMTOL_CLUSTER_COVERAGE_H

#include "armtol/cluster/tally_file.h"

#include <stdbool.h>
#include <stddef.h>

/* The arms, or rows, of one tally. */
typedef struct covered {
    shard_range range;
    uint64_t n_shards; /* in that many shards it was split */
    const char *path;
} covered;

/*
 * Whether each of those that the head counts is in one range; else false, after a message for each range that meets
 * another one and for each that is missing, with the shards that would fill it. Puts the ranges in order.
 */
bool coverage_check(covered ranges[], size_t n_ranges, const tally_head *head);

#endif
