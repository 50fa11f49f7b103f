#ifndef ARMTOL_URDF_MASSES_H
#define ARMTOL_URDF_MASSES_H

#include "armtol/loads.h"
#include "armtol/transform.h"
#include "armtol/urdf/chain.h"

/* Where a link of the tree is, all joints at 0: in the base's coordinates, and behind how many of the chain's axes. */
typedef struct urdf_carried {
    bool known;
    size_t axis; /* 0: the base carries it, or nothing of the chain does */
    armtol_transform at;
} urdf_carried;

/*
 * The masses of an arm's links, from those of the tree: what hangs from the chain beside it or behind its tip is
 * carried along, joints outside the chain at 0. carried has a place a link of the tree; those of the chain are known.
 * masses has n_links places; *any says whether there is one that is not 0. False after a message, where memory is
 * short.
 */
bool urdf_masses_make(const urdf_tree *tree, urdf_carried carried[], const armtol_link links[], size_t n_links,
                      armtol_mass masses[], bool *any);

#endif
