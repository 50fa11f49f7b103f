#include "armtol/cluster/coverage.h"

#include "console/message.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

static int by_first(const void *one, const void *other)
{
    const covered *a = one, *b = other;
    return a->range.first < b->range.first ? -1 : a->range.first > b->range.first;
}

/* The first shard of so many that begins there or later; n_shards + 1 where none does. */
static uint64_t shard_from(uint64_t first, uint64_t n_shards, uint64_t total)
{
    uint64_t shard = 1;
    while (shard <= n_shards && shard_range_of(shard, n_shards, total).first < first) {
        shard++;
    }
    return shard;
}

/* With the shards that fill the gap, where such as the neighbour's do: "--shard 2/4", or "--shard 2/4 to 3/4". */
static void say_missing(uint64_t first, uint64_t end, uint64_t n_shards, const tally_head *head)
{
    char shards[120] = "";
    const uint64_t total = head->total;
    const uint64_t from = shard_from(first, n_shards, total), to = shard_from(end, n_shards, total) - 1;
    const bool fit = from <= to && shard_range_of(from, n_shards, total).first == first &&
                     (end == total || shard_range_of(to + 1, n_shards, total).first == end);
    if (fit) {
        const int length = snprintf(shards, sizeof shards, ", --shard %" PRIu64 "/%" PRIu64, from, n_shards);
        if (to > from) {
            snprintf(shards + length, sizeof shards - (size_t)length, " to %" PRIu64 "/%" PRIu64, to, n_shards);
        }
    }
    message("%s %" PRIu64 " to %" PRIu64 " of %" PRIu64 " are missing; expected a tally that has them%s",
            head->form->many, first, end - 1, total, shards);
}

static void say_doubled(const covered *one, const covered *other, const tally_form *form)
{
    message("%s and %s have the same %s, from %" PRIu64 " on; expected every %s in one tally", one->path, other->path,
            form->many, other->range.first, form->one);
}

bool coverage_check(covered ranges[], size_t n_ranges, const tally_head *head)
{
    bool fine = true;
    const covered *last = NULL; /* the one that reaches farthest */
    uint64_t end = 0;           /* up to where */
    qsort(ranges, n_ranges, sizeof *ranges, by_first);
    for (size_t i = 0; i < n_ranges; i++) {
        const shard_range range = ranges[i].range;
        if (last != NULL && range.first < end) {
            say_doubled(last, &ranges[i], head->form);
            fine = false;
        } else if (range.first > end) {
            say_missing(end, range.first, ranges[i].n_shards, head);
            fine = false;
        }
        if (range.first + range.count > end) {
            end = range.first + range.count;
            last = &ranges[i];
        }
    }
    if (end < head->total) {
        say_missing(end, head->total, ranges[n_ranges - 1].n_shards, head);
    }
    return fine && end == head->total;
}
