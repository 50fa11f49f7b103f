#ifndef ARMTOL_LIB_REGION_ARCS_H
#define ARMTOL_LIB_REGION_ARCS_H

#include "lib/private_names.h"
#include "lib/region/chain.h"

/*
 * The corners of a polygon about an arc: its two ends, and where the tangents at those and at points between meet.
 * The arc is in their convex hull. Of a slide the corners are the ends of its travel, and what has one value has one
 * corner.
 */
enum { ARC_CORNERS = 8 };

typedef struct arc {
    size_t count;
    double x[ARC_CORNERS], y[ARC_CORNERS]; /* cosine and sine times `stretch`; of a slide 1 and 0, of theta as it is */
    double d[ARC_CORNERS];
    double values[ARC_CORNERS]; /* of the variable, there or where the corner is nearest to the arc */
    double stretch;             /* how far out the furthest corner lies */
} arc;

/* Of an angle of the direction, from low to high, with so many tangents between the ends: 0 makes the ends meet. */
void arc_of_angle(double low, double high, size_t between, arc *arc);

/* Of a link, its variable from low to high. */
void arc_of_link(const chain_link *link, double low, double high, size_t between, arc *arc);

/* How many tangents between the ends an arc of this half width is given. */
size_t arc_tangents(double half);

#endif
