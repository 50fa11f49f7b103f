#ifndef ARMTOL_URDF_FOLLOWER_H
#define ARMTOL_URDF_FOLLOWER_H

#include "armtol/urdf/tree.h"

#include <stdbool.h>
#include <stddef.h>

/*
 * value = multiplier x the value of the axis `leader` + offset; its own number, 1 and 0 for an axis that follows none.
 */
typedef struct urdf_follower {
    size_t leader;
    double multiplier, offset;
} urdf_follower;

/*
 * Which axes of a chain follow which, by the <mimic> of their joints; followers has n_axes places. Who follows a
 * follower follows its leader. A joint whose leader is not in the chain, or not in the file, has a value of its own.
 * False after a message: a ring, short memory.
 */
bool urdf_followers_find(const urdf_tree *tree, const size_t joints[], size_t n_axes, urdf_follower followers[]);

#endif
