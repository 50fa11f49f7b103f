#ifndef ARMTOL_LIB_REGION_WHERE_H
#define ARMTOL_LIB_REGION_WHERE_H

#include "lib/private_names.h"
#include "lib/region/corner_sum.h"

/* What a region asks of the tool, apart from the joints. */
bool where_asks(const armtol_region *region);

/* Whether the tool is there, to `slack` lengths and 1e-9 of a radian; `tool` is z of its frame. */
bool where_holds(const armtol_region *region, const double point[3], const double tool[3], double slack);

/*
 * Whether the tool is nowhere there in a box of joints: of all points in the convex hull of those at its corners.
 * `outward` is what rounding and corners can make of a length.
 */
bool where_excludes(const armtol_region *region, const corner_space *space, size_t count, double outward, double reach);

/* From the point, and z of the tool, to the nearest that the region asks for. */
void where_nearest(const armtol_region *region, const double point[3], const double tool[3], double to_point[3],
                   double to_tool[3]);

#endif
