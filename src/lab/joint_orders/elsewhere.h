#ifndef ARMTOL_LAB_JOINT_ORDERS_ELSEWHERE_H
#define ARMTOL_LAB_JOINT_ORDERS_ELSEWHERE_H

#include "lab/joint_orders/family.h"

/* What configurations say of other positions than the paper's. Joint values are compared as printed. */

/*
 * Wish i, in floats, that joint values between -3 and 3 lead to (a prismatic joint's: -300 and 300). The same
 * on every machine.
 */
void elsewhere_wish(const family *family, size_t i, double wish[MOST_WISH]);

/* One configuration and the default, over n_wishes wishes. */
typedef struct elsewhere_difference {
    size_t n_other; /* wishes for which some joint value has another digit */
    size_t n_far;   /* wishes for which some joint value is more than 10 units of the last digit away */
} elsewhere_difference;

elsewhere_difference elsewhere_compare_one(const family *family, const configuration *how, size_t n_wishes);

/* Many configurations and the default. */
typedef struct elsewhere_spread {
    size_t n_answers;           /* how many different sets of answers they give */
    size_t n_same;              /* configurations that have the default's answers to all wishes */
    size_t least, median, most; /* wishes for which one has another digit than the default */
} elsewhere_spread;

/* False, after a message, where memory is short. */
bool elsewhere_compare_all(const family *family, const configuration configurations[], size_t n, size_t n_wishes,
                           elsewhere_spread *spread);

#endif
