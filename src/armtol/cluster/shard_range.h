#ifndef ARMTOL_CLUSTER_SHARD_RANGE_H
#define ARMTOL_CLUSTER_SHARD_RANGE_H

#include <stdint.h>

/* Consecutive arms of a verification, or rows of a map. */
typedef struct shard_range {
    uint64_t first, count;
} shard_range;

/* Those of shard number 1 to n of so many: each is in one shard, and no shard has two more than another. */
shard_range shard_range_of(uint64_t shard, uint64_t n_shards, uint64_t total);

#endif
