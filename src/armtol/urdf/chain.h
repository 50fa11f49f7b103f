#ifndef ARMTOL_URDF_CHAIN_H
#define ARMTOL_URDF_CHAIN_H

#include "armtol/urdf/tree.h"

#include <stdbool.h>
#include <stddef.h>

/* The joints on the way from one link down to another. */
typedef struct urdf_chain {
    size_t base, tip; /* links */
    size_t n_joints;
    size_t *joints; /* from the base on; freed by urdf_chain_free */
} urdf_chain;

/*
 * In a tree that is connected. NULL for base: the only root; NULL for tip: the only leaf below the base.
 * False after a message; there is then nothing to be freed.
 */
bool urdf_chain_find(const urdf_tree *tree, const char *base, const char *tip, urdf_chain *chain);
void urdf_chain_free(urdf_chain *chain);

#endif
