#ifndef ARMTOL_CLUSTER_ARMS_H
#define ARMTOL_CLUSTER_ARMS_H

#include "armtol/ask/request.h"
#include "armtol/cluster/merge.h"

/* The shard of the command line, of arms that are drawn: as shard_run. */
int arms_shard(const request *request, const armtol_answer *answer, size_t n_threads);

/* Whether the answer is the one that the merged arms were drawn for; false after a message. */
bool arms_are_of(const merged *merged, const armtol_answer *answer);

#endif
