#ifndef ARMTOL_LAB_REPRODUCE_COMPARE_H
#define ARMTOL_LAB_REPRODUCE_COMPARE_H

#include "lab/published.h"

typedef enum verdict {
    VERDICT_AGREES,
    VERDICT_AGREES_WITHOUT_SIGN, /* where the paper prints none */
    VERDICT_DIFFERS,
    VERDICT_MISSING /* the files have no such label */
} verdict;

typedef struct comparison {
    verdict verdict;
    char computed[32]; /* the first of a range that differs, else the first; empty where missing */
} comparison;

/*
 * Compare a published number with the files' text, to its last printed digit, as text. Of a range [i..j] every
 * one has to agree.
 */
comparison compare_number(const published_number *number, const char *files);

/* Whether the number is reproduced, with its sign or where the paper prints none without. */
bool compare_agrees(const comparison *comparison);

#endif
