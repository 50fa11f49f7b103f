#ifndef ARMTOL_LIB_REGION_CORNER_SUM_H
#define ARMTOL_LIB_REGION_CORNER_SUM_H

#include "lib/private_names.h"
#include "lib/region/load_sum.h"

/* The corners of a box of variables: of the direction's two angles, and of each link. */
typedef struct corner_box {
    arc directions[CHAIN_DIRECTIONS];
    arc *links; /* chain->n_links */
    size_t count; /* of all choices of a corner in each */
    size_t of_links; /* of a corner in each link */
    double stretch;
    bool is_pose; /* not a box: what is said of it is of this pose */
} corner_box;

/* Memory to work in, for boxes of up to `most` choices. */
typedef struct corner_space {
    size_t most;
    size_t *before;   /* a link: choices of the direction and of the links up to it */
    size_t *after;    /* a link: choices of the links behind it */
    vectors *behind;  /* a link: for each of those the tool point, from the link's end and along its turned frame */
    vectors *moments; /* likewise, errors along the tool's axes: the moment; behind is then the force */
    vectors points, tools; /* choices of all links: the tool point, and z of the tool, in the base's frame */
    vectors *forces;       /* 1 + a link: choices of the direction, and of the links so far too */
    double *sums, *parts;
    load_space loads;      /* where the chain has any */
    double *memory;
} corner_space;

enum { CORNERS_MOST = 1 << 16 };

/* False where memory is short. Freed all the same. */
bool corner_space_make(corner_space *space, const chain *chain, size_t most);
void corner_space_free(corner_space *space);

/* The corners of low to high, no more choices than most; false where that cannot be. box->links has its places. */
bool corner_box_of(const chain *chain, const double low[], const double high[], size_t most, corner_box *box);

/* The corners of one pose: one each. */
void corner_box_at(const chain *chain, const double variables[], corner_box *box);

/* Where the tool is at all corners of the links: space->points and, where turned_too, space->tools. */
void corners_place(const chain *chain, const corner_box *box, bool turned_too, corner_space *space);

/* The largest of the sum at all corners, and at which it is: in each of 2 + n_links. */
double corners_largest(const chain *chain, const corner_box *box, corner_space *space, size_t at[]);

#endif
