#include "armtol/cluster/tally_file.h"

#include <stdlib.h>
#include <string.h>

shard_range tally_head_range(const tally_head *head)
{
    return shard_range_of(head->shard, head->n_shards, head->total);
}

const char *tally_head_difference(const tally_head *one, const tally_head *other)
{
    if (strcmp(one->version, other->version) != 0) {
        return "version of armtol";
    }
    if (one->total != other->total) {
        return "number of arms";
    }
    if (one->seed != other->seed) {
        return "seed";
    }
    for (size_t i = 0; i < ARMTOL_TALLY_SUBJECT_COUNT; i++) {
        if (one->fingerprints[i] != other->fingerprints[i]) {
            return armtol_tally_subject_name((armtol_tally_subject)i);
        }
    }
    return NULL;
}

void tally_head_free(tally_head *head)
{
    for (size_t i = 0; i < head->n_words; i++) {
        free(head->words[i]);
    }
    free(head->words);
    head->words = NULL;
    head->n_words = 0;
}

uint64_t tally_checksum(uint64_t checksum, const char text[], size_t length)
{
    for (size_t i = 0; i < length; i++) {
        checksum = (checksum ^ (unsigned char)text[i]) * 0x100000001b3u;
    }
    return checksum;
}
