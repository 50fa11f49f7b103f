#ifndef ARMTOL_BUDGET_H
#define ARMTOL_BUDGET_H

#include "armtol/answer.h"
#include "armtol/interface.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/* Who sees to a parameter. */
typedef enum armtol_role {
    ARMTOL_MACHINING, /* whoever makes the link */
    ARMTOL_MOTOR,     /* whoever drives the joint: the parameter that it moves */
    ARMTOL_LOAD,      /* what shifts the joint: moments, and the play on their side */
    ARMTOL_SHIFT,     /* the mean of its parameters' errors (spread.h), where that is not 0 */
    ARMTOL_ROLE_COUNT
} armtol_role;

/* "machining", "motor", "load", "shift"; "?" for a value that is none. */
const char *armtol_role_name(armtol_role role);

/* The role of a link's parameter. */
armtol_role armtol_role_of(const armtol_link *link, armtol_parameter parameter);

/* Where the error comes from: what one link's making, its motor or its load has to do with each component of it. */
typedef struct armtol_budget_row {
    size_t link;
    armtol_role role;
    double shares[6]; /* of the component's predicted error, 0 to 1; below 0 for what lessens that of others */
    double norm_shares[ARMTOL_MOST_NORMS]; /* likewise of the norms of the answer */
} armtol_budget_row;

typedef struct armtol_budget {
    size_t n_rows;           /* four a link at most */
    armtol_budget_row *rows; /* in link order, making, motor, load, shift; those of nothing left out */
    double motors[6];        /* the share of all motors; that of all making is what they all leave of 1 */
    double loads[6];         /* the share of all loads */
    double shifts[6];        /* the share of all means */
    double norm_motors[ARMTOL_MOST_NORMS], norm_loads[ARMTOL_MOST_NORMS]; /* likewise of norms */
    double norm_shifts[ARMTOL_MOST_NORMS];
} armtol_budget;

/*
 * Share out the predicted error of every component among those who see to it.
 *
 * Given:
 *    answer     the tolerances and A; NULL is not allowed
 *
 * Returned:
 *    *budget    the shares, to be freed with armtol_budget_destroy; NULL after an error
 *
 * Notes:
 * 1) The shares are those of the worst case, |A s| + |A| t. With method rss they are those of |A s| + sigma deviation,
 *    the second term shared out by the variances, v (A t)^2; of a group by the covariances of its columns with the
 *    whole group, which are below 0 for a column that lessens what the others do. Alpha and beta in a disc (note 7 of
 *    answer.h) are one source, of the making of their link.
 * 2) Each component in the pose whose error is printed: where its worst case is largest (worst_pose) or, with method
 *    rss, its deviation (deviation_pose).
 * 3) A norm is shared out along the direction that it is largest in: worst_direction, with method rss spread_direction.
 * 4) All shares are 0 for a component that nothing moves, and nan for one that nothing bounds.
 *
 * Errors:
 *    ARMTOL_NO_MEMORY
 */
armtol_status armtol_budget_create(const armtol_answer *answer, armtol_budget **budget);

/* budget may be NULL. */
void armtol_budget_destroy(armtol_budget *budget);

ARMTOL_INTERFACE_END

#endif
