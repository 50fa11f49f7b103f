#ifndef ARMTOL_URDF_CHAIN_H
#define ARMTOL_URDF_CHAIN_H

#include "armtol/urdf/tree.h"

#include <stdbool.h>
#include <stddef.h>

/*
 * The joints on the way from one link to another: up to the link from which both hang, where that is not the first of
 * them, then down.
 */
typedef struct urdf_chain {
    size_t base, tip; /* links */
    size_t n_up;      /* the first of the joints, which are gone through from the child to the parent */
    size_t n_joints;
    size_t *joints; /* from the base on; freed by urdf_chain_free */
} urdf_chain;

/*
 * In a tree that is connected. NULL for base: the only root; NULL for tip: the only leaf that a joint moves, below the
 * base. False after a message; there is then nothing to be freed.
 */
bool urdf_chain_find(const urdf_tree *tree, const char *base, const char *tip, urdf_chain *chain);
void urdf_chain_free(urdf_chain *chain);

#endif
