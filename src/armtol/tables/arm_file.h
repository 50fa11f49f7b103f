#ifndef ARMTOL_TABLES_ARM_FILE_H
#define ARMTOL_TABLES_ARM_FILE_H

#include "armtol/tables/arm_head.h"

#include <stdbool.h>
#include <stdio.h>

/*
 * The table of an arm, as people type it and as spreadsheets write it; docs/arm-files.md describes it.
 * path is for messages ("FILE:LINE:COLUMN: ..."). False after a message; *model then holds nothing.
 */
bool arm_file_read(FILE *stream, const char *path, arm_model *model);

/*
 * The arm in that form, so that reading it gives the same arm to the bit, in either order. False after a message:
 * memory is short, and only Craig's order needs any.
 */
bool arm_file_write(const armtol_arm *arm, row_order order, angle_unit angle_unit, FILE *stream);

#endif
