#ifndef ARMTOL_CLUSTER_SHARD_H
#define ARMTOL_CLUSTER_SHARD_H

#include "armtol/ask/request.h"

/*
 * The shard of the command line: its arms are drawn, and its tally is written whole or not at all. Where that tally is
 * there already nothing is drawn. Says on standard output which it was. EXIT_OK, or an exit code after a message.
 */
int shard_run(const request *request, const armtol_answer *answer, size_t n_threads);

#endif
