#ifndef ARMTOL_CLUSTER_TALLY_FILE_H
#define ARMTOL_CLUSTER_TALLY_FILE_H

#include "armtol/cluster/shard_range.h"
#include "armtol/tally.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/*
 * The counts of one shard as a text file, the same on all machines: docs/cluster.md has its form. What it is of stands
 * before the counts, and a checksum behind them.
 */

enum { TALLY_VERSION = 32, TALLY_WORD_MOST = 16384 };

/* What a tally is of. */
typedef struct tally_head {
    char version[TALLY_VERSION]; /* of armtol */
    char **words;                /* of the command, without the program's name; a NULL behind them */
    size_t n_words;
    uint64_t shard, n_shards; /* shard 1 to n_shards */
    uint64_t total;           /* arms of all shards */
    uint64_t seed;
    uint64_t fingerprints[ARMTOL_TALLY_SUBJECT_COUNT];
} tally_head;

shard_range tally_head_range(const tally_head *head);

/* NULL where two tallies may be added up; else in what they differ: "seed". */
const char *tally_head_difference(const tally_head *one, const tally_head *other);

/* Of a head that was read. */
void tally_head_free(tally_head *head);

typedef enum tally_result {
    TALLY_WHOLE,
    TALLY_DAMAGED,   /* a tally that is cut, or changed */
    TALLY_NONE,      /* no tally of this form: another file */
    TALLY_UNREADABLE /* the machine failed: memory, the disk */
} tally_result;

/*
 * Read a tally. Where it is whole the head is to be freed; else nothing is, after a message, and the tally is of no
 * use.
 */
tally_result tally_file_read(FILE *stream, const char *path, tally_head *head, armtol_tally *tally);

/* A head and its counts, for outfile_write_at. */
typedef struct tally_content {
    const tally_head *head;
    armtol_tally *tally;
} tally_content;

/* Writes the tally_content that data points to. What cannot be written shows in the stream. */
void tally_file_write(FILE *stream, const void *data);

/* FNV-1a: goes on from a checksum, the first being TALLY_CHECKSUM_START. */
#define TALLY_CHECKSUM_START 0xcbf29ce484222325u
uint64_t tally_checksum(uint64_t checksum, const char text[], size_t length);

#endif
