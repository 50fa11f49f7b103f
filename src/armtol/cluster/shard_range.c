#include "armtol/cluster/shard_range.h"

shard_range shard_range_of(uint64_t shard, uint64_t n_shards, uint64_t total)
{
    const uint64_t each = total / n_shards, longer = total % n_shards, before = shard - 1;
    return (shard_range){
        .first = before * each + (before < longer ? before : longer),
        .count = each + (before < longer),
    };
}
