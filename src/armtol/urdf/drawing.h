#ifndef ARMTOL_URDF_DRAWING_H
#define ARMTOL_URDF_DRAWING_H

#include "armtol/urdf/tree.h"

#include <stdbool.h>
#include <stdio.h>

/* What numbers are shown in: so many of the unit to a metre, to a radian; and what it is called. */
typedef struct urdf_units {
    double per_metre, per_radian;
    const char *length, *angle;
} urdf_units;

/*
 * The links of a connected tree, each one indented below the one that it hangs from, with its joint, the joint's type,
 * its limits and what it follows. False after a message.
 */
bool urdf_tree_draw(const urdf_tree *tree, const urdf_units *units, FILE *stream);

#endif
