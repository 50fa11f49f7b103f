#ifndef ARMTOL_LIB_INVERSE_CHAIN_H
#define ARMTOL_LIB_INVERSE_CHAIN_H

#include "armtol/inverse.h"
#include "lib/private_names.h"

/* A link, ready to be placed: what its joint adds to theta or d is factor q[driver] + offset. */
typedef struct chain_link {
    armtol_joint joint;
    double a, d, theta;
    double sin_alpha, cos_alpha, sin_beta, cos_beta;
    size_t driver;
    double factor, offset;
} chain_link;

/* A joint that moves by itself. */
typedef struct chain_joint {
    double unit;      /* of its steps: 1, or for a slide the arm's size */
    double low, high; /* its limits, and those of what follows it */
    double near;
    bool slides;
    bool turns; /* a whole turn of it changes nothing */
} chain_joint;

/* An arm, and the room in which its tool is placed. */
typedef struct chain {
    size_t n_links, n_joints;
    double size, offset[3];
    chain_link *links;
    chain_joint *joints;
    double *axes;     /* n_links x 6: the z axis of the frame before each link, and its origin */
    double *jacobian; /* 6 x n_joints */
} chain;

/* What is wanted of the tool; how far it is off: (displacement / size; rotation vector), and the sum of the squares. */
typedef struct chain_goal {
    const armtol_wish *wish;
    size_t n_rows; /* 6, or 3 where the axes are free */
    double away;   /* how far the wish is, in sizes of the arm; 1 where it is nearer */
} chain_goal;

typedef struct chain_error {
    double e[6]; /* from where the tool is to where it should be */
    double square;
} chain_error;

/* Where joint values bring the tool; the axes of the links are kept for chain_differentiate. */
void chain_place(const chain *chain, const double q[], armtol_transform *tool);

/* How far a tool is from the goal. */
void chain_compare(const chain *chain, const chain_goal *goal, const armtol_transform *tool, chain_error *error);

/*
 * The Jacobian of the tool that was placed last: displacement / size, then rotation, for a unit of each joint. It is
 * minus the derivative of the displacement's error; of the rotation vector's it is only nearly that, but e'J is minus
 * the gradient of the square all the same, for a rotation vector is left in place by its own rotation.
 */
void chain_differentiate(const chain *chain, const armtol_transform *tool);

#endif
