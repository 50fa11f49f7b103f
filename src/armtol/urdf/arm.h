#ifndef ARMTOL_URDF_ARM_H
#define ARMTOL_URDF_ARM_H

#include "armtol/tables/arm_model.h"
#include "armtol/urdf/chain.h"

#include <stdbool.h>

/* The arm that a chain is, by armtol_links_of_axes. False after a message; *model then holds nothing. */
bool urdf_arm_make(const urdf_tree *tree, const urdf_chain *chain, arm_model *model);

#endif
