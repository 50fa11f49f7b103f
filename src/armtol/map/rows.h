#ifndef ARMTOL_MAP_ROWS_H
#define ARMTOL_MAP_ROWS_H

#include "armtol/cluster/merge.h"
#include "armtol/map/found.h"

/* The shard of the command line, of rows of the plan: as shard_run. */
int rows_shard(const map_plan *plan);

/*
 * The map that merged rows are of: what they do not know of it is found here. As map_find; also a message where the
 * plan is not the one that the rows are of.
 */
int rows_merge(const map_plan *plan, const merged *merged, map_found *found);

#endif
