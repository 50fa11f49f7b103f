#ifndef ARMTOL_URDF_PARSE_H
#define ARMTOL_URDF_PARSE_H

#include "armtol/urdf/tree.h"

#include <stdio.h>

/*
 * Read the links and joints of a URDF into a tree that has been started; what else the file holds is passed
 * over. False after a message.
 */
bool urdf_parse(FILE *stream, urdf_tree *tree);

#endif
