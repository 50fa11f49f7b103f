#ifndef ARMTOL_CLUSTER_TALLY_FILE_H
#define ARMTOL_CLUSTER_TALLY_FILE_H

#include "armtol/cluster/tally_form.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/*
 * What one shard came to as a text file, the same on all machines: docs/cluster.md has its form. What it is of stands
 * before its contents, and a checksum behind them.
 */

enum { TALLY_VERSION = 32, TALLY_WORD_MOST = 16384 };

/* What a tally is of. */
typedef struct tally_head {
    const tally_form *form;
    char version[TALLY_VERSION]; /* of armtol */
    char **words;                /* of the command, without the program's name; a NULL behind them */
    size_t n_words;
    uint64_t shard, n_shards; /* shard 1 to n_shards */
    uint64_t total;           /* arms, or rows, of all shards */
    uint64_t numbers[TALLY_NUMBERS], fingerprints[TALLY_SUBJECTS]; /* as many as the form has */
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
 * Read a tally of any form. Where it is whole the head is to be freed; else the head is not, after a message, and the
 * content is of no use, but to be freed, as it always is.
 */
tally_result tally_file_read(FILE *stream, const char *path, tally_head *head, tally_content *content);

/* A tally, for outfile_write_at. */
typedef struct tally_written {
    const tally_head *head;
    const tally_content *content;
} tally_written;

/* Writes the tally_written that data points to. What cannot be written shows in the stream. */
void tally_file_write(FILE *stream, const void *data);

/* FNV-1a: goes on from a checksum, the first being TALLY_CHECKSUM_START. */
#define TALLY_CHECKSUM_START 0xcbf29ce484222325u
uint64_t tally_checksum(uint64_t checksum, const char text[], size_t length);

#endif
