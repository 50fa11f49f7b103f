#ifndef ARMTOL_MAP_RUN_H
#define ARMTOL_MAP_RUN_H

#include "armtol/ask/request.h"
#include "armtol/cluster/merge.h"

/*
 * The map that a request asks for: found, written and printed; or a shard of it alone, into its tally. With merged, of
 * what others found. An exit code.
 */
int map_run(const request *request, const merged *merged);

#endif
