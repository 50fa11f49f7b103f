#ifndef ARMTOL_MAP_FOUND_H
#define ARMTOL_MAP_FOUND_H

#include "armtol/cluster/tally_form.h"
#include "armtol/map/plan.h"

#include <stdbool.h>
#include <stddef.h>

/* The map of a plan: for every point what was found, in inside units. */
typedef struct map_found {
    double *q;        /* a value a joint; nan where the point was not reached */
    unsigned char *marks; /* as of armtol_map_poses */
    double *values;   /* nan where it was not reached, infinite where nothing bounds it */
    size_t n_reached;
    size_t n_seams;   /* pairs of neighbours between which the arm changes its branch */
    size_t n_values;  /* those that are finite */
    size_t least, most; /* the points of the least and the largest of these, the first of several */
} map_found;

/* What of a map is searched and asked for here, and what others found of it. */
typedef struct map_share {
    size_t first, count;     /* the points, whole rows */
    unsigned char *searched; /* what is known of each point of the map, as of armtol_map_search; added to */
    const tally_rows *known; /* all rows of the map; NULL for none */
} map_share;

/*
 * share NULL: all of it. Of points beyond a share there are joint values where no search was needed, and no values; the
 * counts are then of no use. With a bar for those who wait; Ctrl-C ends it. EXIT_OK, or an exit code after a message;
 * nothing is then to be freed.
 */
int map_find(const map_plan *plan, const map_share *share, map_found *found);
void map_found_free(map_found *found);

/*
 * Whether a point was reached; whether the arm changes its branch between it and its neighbour to the right, and above.
 */
bool map_is_reached(const map_found *found, size_t point);
bool map_is_seam_next(const map_plan *plan, const map_found *found, size_t point);
bool map_is_seam_above(const map_plan *plan, const map_found *found, size_t point);

/* The values of the joints in a point, in the user's units, n_joints of them. */
double map_joint_shown(const map_plan *plan, const map_found *found, size_t point, size_t joint);

/* Whether the map's values are better when they are large. */
bool map_is_of_tolerances(const map_plan *plan);

/* The point of the worst value: of tolerances the least. */
size_t map_worst_point(const map_plan *plan, const map_found *found);

#endif
