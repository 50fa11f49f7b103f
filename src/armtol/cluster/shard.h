#ifndef ARMTOL_CLUSTER_SHARD_H
#define ARMTOL_CLUSTER_SHARD_H

#include "armtol/ask/options.h"
#include "armtol/cluster/tally_file.h"

/* One shard: what it is of, and who draws it. */
typedef struct shard {
    const tally_head *head;
    tally_content *content; /* nothing yet; to be freed by the caller */
    int (*draw)(const struct shard *shard); /* puts the contents there; an exit code, after a message */
    const void *asked;                      /* for it */
} shard;

/* The head of the command line's shard, but for its numbers and fingerprints. Its words are the options'. */
tally_head shard_head(const cli_options *options, const tally_form *form, uint64_t total);

/*
 * The shard is drawn, and its tally is written whole or not at all. Where that tally is there already nothing is
 * drawn. Says on standard output which it was. EXIT_OK, or an exit code after a message.
 */
int shard_run(const shard *shard, const char *path);

#endif
