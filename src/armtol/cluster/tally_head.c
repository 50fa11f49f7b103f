#include "armtol/cluster/tally_file.h"

#include <stdlib.h>
#include <string.h>

shard_range tally_head_range(const tally_head *head)
{
    return shard_range_of(head->shard, head->n_shards, head->total);
}

const char *tally_head_difference(const tally_head *one, const tally_head *other)
{
    const tally_form *form = one->form;
    if (strcmp(one->version, other->version) != 0) {
        return "version of armtol";
    }
    if (form != other->form) {
        return "kind";
    }
    if (one->total != other->total) {
        return form->number;
    }
    for (size_t i = 0; i < form->n_numbers; i++) {
        if (one->numbers[i] != other->numbers[i]) {
            return form->meanings[i];
        }
    }
    for (size_t i = 0; i < form->n_subjects; i++) {
        if (one->fingerprints[i] != other->fingerprints[i]) {
            return form->subject(i);
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
