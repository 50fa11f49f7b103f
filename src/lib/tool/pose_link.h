#ifndef ARMTOL_LIB_TOOL_POSE_LINK_H
#define ARMTOL_LIB_TOOL_POSE_LINK_H

#include "armtol/poses.h"
#include "lib/private_names.h"

#include <stdint.h>

#define NO_COLUMN SIZE_MAX

/* What is prepared of a link. Its columns are counted from *column on, which is moved on behind them. */
armtol_pose_link pose_link_of(const armtol_link *link, size_t *column);

/* Where the columns of a link's parameters are, NO_COLUMN for what the kind does not count. */
void columns_of_link(armtol_kind kind, size_t *column, size_t columns[ARMTOL_PARAMETER_COUNT]);

#endif
