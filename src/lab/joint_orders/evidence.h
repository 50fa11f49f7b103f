#ifndef ARMTOL_LAB_JOINT_ORDERS_EVIDENCE_H
#define ARMTOL_LAB_JOINT_ORDERS_EVIDENCE_H

#include "lab/joint_orders/family.h"
#include "lab/published.h"

enum { MOST_CASES = 4, MOST_VALUES = MOST_CASES * MOST_JOINTS };

/* The joint values that the paper prints for one program: a bit each, case by case, of a set of values. */
typedef struct evidence {
    size_t n_cases, n_joints;
    double wishes[MOST_CASES][MOST_WISH];
    const published_number *numbers[MOST_VALUES]; /* those of the list it was read from */
    double printed[MOST_VALUES];                  /* as printed_of has them */
} evidence;

/* The evidence for a family. False, after a message, where it is not complete. */
bool evidence_find(const published_list *list, const family *family, evidence *evidence);

size_t evidence_count(const evidence *evidence);

/* Solves all cases, q one case behind the other; returns the values that the configuration misses, a bit each. */
unsigned long evidence_misses(const evidence *evidence, const family *family, const configuration *how,
                              double q[MOST_VALUES]);

#endif
