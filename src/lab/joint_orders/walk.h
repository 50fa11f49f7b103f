#ifndef ARMTOL_LAB_JOINT_ORDERS_WALK_H
#define ARMTOL_LAB_JOINT_ORDERS_WALK_H

#include "lab/joint_orders/family.h"

/*
 * From configuration to configuration, for some wishes at once: a step is done anew only where it, or one
 * before it, looks at a choice that has changed. The answers are those of family_solve.
 */
typedef struct walk {
    const family *family;
    const double (*wishes)[MOST_WISH];
    size_t n_wishes;
    progress *found; /* by each step, for each wish */
    configuration at;
    bool started;
} walk;

/* False where memory is short; there is nothing to free then. The wishes have to last. */
bool walk_start(walk *walk, const family *family, const double wishes[][MOST_WISH], size_t n_wishes);
void walk_free(walk *walk);

void walk_to(walk *walk, const configuration *configuration);

/* The joint values for a wish. */
const double *walk_joints(const walk *walk, size_t wish);

#endif
