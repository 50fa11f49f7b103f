#ifndef ARMTOL_LIB_REGION_POSE_SEARCH_H
#define ARMTOL_LIB_REGION_POSE_SEARCH_H

#include "lib/private_names.h"
#include "lib/region/where.h"

/* Poses of a region, one at a time: values of a chain's variables. */
typedef struct pose_search {
    const chain *chain;
    const armtol_region *region;
    corner_box box;
    corner_space space;
    size_t *at;
    double *tried, *moved, *step; /* chain->n_variables */
    double *jacobian;      /* 6 x n_variables */
    uint64_t state;        /* of the generator */
} pose_search;

/* Reads the chain as it is measured at each call. False where memory is short. */
bool pose_search_make(pose_search *search, const chain *chain, const armtol_region *region);
void pose_search_free(pose_search *search);

/* The error there. */
double pose_error(pose_search *search, const double variables[]);

bool pose_is_in_region(pose_search *search, const double variables[]);

/* Move joints within the chain's ranges until the tool is where the region has it, if that comes about. */
bool pose_into_region(pose_search *search, double variables[]);

/* How far the tool moves for a unit of each variable; with a cone, its turning counted by the reach. */
void pose_levers(pose_search *search, const double variables[], double levers[]);

/* A pose drawn from the ranges and moved into the region; false where that did not come about. */
bool pose_draw(pose_search *search, double variables[]);

/*
 * Turn one joint within the range (lows, then highs) to where the moment of a loaded drive is 0, the drive and the load
 * case by their place in load_space's ranges; false where no joint does that.
 */
bool pose_balance(pose_search *search, size_t which, const double range[], double variables[]);

/* Move to where the error is larger, step by step, within the region. The error there. */
double pose_climb(pose_search *search, double variables[]);

#endif
