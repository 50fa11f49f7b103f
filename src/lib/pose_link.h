#ifndef ARMTOL_LIB_POSE_LINK_H
#define ARMTOL_LIB_POSE_LINK_H

#include "armtol/poses.h"

#include <stdint.h>

#define NO_COLUMN SIZE_MAX

/* The link's own part of what is prepared; its columns from *column on, which is moved on behind them. */
armtol_pose_link pose_link_of(const armtol_link *link, size_t *column);

/* Where its parameters' columns are, NO_COLUMN for what the kind does not count. */
void columns_of_link(armtol_kind kind, size_t *column, size_t columns[ARMTOL_PARAMETER_COUNT]);

/* The sine and cosine of one angle, as the kernels have them. */
void sine_cosine_of(double angle, double *sine, double *cosine);

#endif
