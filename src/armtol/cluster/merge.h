#ifndef ARMTOL_CLUSTER_MERGE_H
#define ARMTOL_CLUSTER_MERGE_H

#include "armtol/ask/options.h"
#include "armtol/cluster/tally_file.h"

/* All arms of a verification, or rows of a map, from the tallies of its shards. */
typedef struct merged {
    const char *path; /* of the tally with the first of them, and its head: */
    tally_head head;
    tally_content content;
} merged;

/*
 * Add up the tallies. EXIT_OK, or an exit code after a message for each that is cut, damaged, of something else, there
 * twice, or missing; nothing is then to be freed.
 */
int merge_files(char *const paths[], size_t n_paths, merged *merged);
void merged_free(merged *merged);

/* Whether the command that is in the tallies asks for what is in them; false after a message. */
bool merged_is_asked(const merged *merged, const cli_options *options);

/* Whether what that command asks for now has the fingerprints of the tallies; false after a message. */
bool merged_is_of(const merged *merged, const uint64_t fingerprints[]);

#endif
