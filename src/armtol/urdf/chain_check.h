#ifndef ARMTOL_URDF_CHAIN_CHECK_H
#define ARMTOL_URDF_CHAIN_CHECK_H

#include "armtol/urdf/chain.h"

#include <stdbool.h>

/*
 * Whether the joints of a chain are fit for an arm: a fault of one of them matters now, and none may be planar or
 * floating. False after a message.
 */
bool urdf_chain_check(const urdf_tree *tree, const urdf_chain *chain);

/* Warnings of what is only improbable: lengths that must be millimetres, rpy that must be degrees. */
void urdf_chain_warn(const urdf_tree *tree, const urdf_chain *chain);

#endif
