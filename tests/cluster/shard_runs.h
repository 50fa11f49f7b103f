#ifndef TEST_SHARD_RUNS_H
#define TEST_SHARD_RUNS_H

#include "support/process.h"

enum { SHARD_WORDS = 48 };

/* The words, up to a NULL, behind those that are there. */
void join(const char *words[SHARD_WORDS], const char *const more[]);

/* armtol with that question, of that shard; first: what comes before the question, NULL for nothing. */
void draw_shard(process *process, const char *folder, const char *first, const char *const question[],
                const char *shard, const char *tally);

void merge(process *process, const char *folder, const char *const tallies[]);

/* Merging fails, and says this, and no more than that of several lines where it is the last. */
void check_refused(const char *folder, const char *const tallies[], const char *words);

string path_in(const char *folder, const char *name);

#endif
