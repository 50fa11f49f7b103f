#ifndef ARMTOL_LIB_INVERSE_SEARCH_H
#define ARMTOL_LIB_INVERSE_SEARCH_H

#include "lib/inverse/chain.h"

/* One wish of an arm, and room for the way of one start to it: n_joints of each. */
typedef struct search {
    const chain *chain;
    chain_goal goal;
    double within; /* how far off still counts as there */
    double *trial, *step, *pull, *last;
    bool *held;
} search;

/* Whether the tool is there. */
bool search_is_there(const search *search, const chain_error *error);

/* Go from q downhill to where the error is least, by damped least squares; `limited`: q keeps to the joints' limits. */
void search_descend(const search *search, bool limited, double q[], chain_error *error);

/*
 * Turn joints by whole turns to within their limits, to where `near` is nearest. Where one stays beyond, and could move
 * while the tool stands, q is put on the limits and goes downhill from there within them. Whether q is there in the end
 * and within. The Jacobian is that of q.
 */
bool search_bring_within(const search *search, double q[], chain_error *error);

/* Where joints can move while the tool stands: to where `near` is nearest. q is there, and stays so. */
void search_approach(const search *search, double q[], chain_error *error);

/* Whether joints keep to their limits as they are, but for rounding. */
bool search_is_within(const chain *chain, const double q[]);

/* The root of the sum of squares of what q is off from `near`, each joint in its unit. */
double search_from_near(const chain *chain, const double q[]);

#endif
