#ifndef ARMTOL_URDF_URDF_H
#define ARMTOL_URDF_URDF_H

#include "armtol/tables/arm_model.h"
#include "armtol/urdf/drawing.h"

#include <stdbool.h>
#include <stdio.h>

/*
 * The chain from link base to link tip of a robot in Unified Robot Description Format, by the rules of
 * armtol/axes.h; docs/urdf.md describes what is read. NULL for base: the root of the tree; NULL for tip: the
 * only leaf below the base that a joint moves. Metres, shown in radians; joint limits are in the drives. path is for
 * messages ("FILE:LINE:COLUMN: ..."). False after a message; *model then holds nothing.
 * Without the XML library that reads it (urdf_is_built_in false) every call ends with a message that says how
 * to get it.
 */
bool urdf_read(FILE *stream, const char *path, const char *base, const char *tip, arm_model *model);

/* Draw the tree of links (drawing.h) on `drawn`. False after a message. */
bool urdf_draw(FILE *stream, const char *path, const urdf_units *units, FILE *drawn);

bool urdf_is_built_in(void);

#endif
