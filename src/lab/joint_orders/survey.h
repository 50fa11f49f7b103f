#ifndef ARMTOL_LAB_JOINT_ORDERS_SURVEY_H
#define ARMTOL_LAB_JOINT_ORDERS_SURVEY_H

#include "lab/joint_orders/family.h"
#include "lab/published.h"

#include <stdint.h>

/* The configurations of a family, held against the joint values that the paper prints. */

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

/* Of the configurations to which a choice matters, those with one option. */
typedef struct option_tally {
    uint64_t configurations;
    uint64_t all;         /* that give all values */
    uint64_t all_but_one;
    size_t best;
} option_tally;

/* A wrong digit that is all that some configurations have wrong. */
typedef struct closest_miss {
    size_t value;   /* its place in the evidence */
    double printed; /* what they give, as printed_of has it */
    uint64_t configurations;
    configuration nearest; /* the one with fewest changes from the default */
} closest_miss;

typedef struct survey {
    const family *family;
    evidence evidence;
    uint64_t configurations;
    uint64_t by_score[MOST_VALUES + 1]; /* how many give so many values */
    option_tally tallies[MOST_CHOICES][MOST_OPTIONS];
    configuration *all; /* that give all values, from the default on */
    size_t n_all, all_room;
    closest_miss *misses; /* in the order in which they were met */
    size_t n_misses, misses_room;
} survey;

/* Of no configurations yet. False, after a message, where the list lacks evidence for the family. */
bool survey_start(survey *survey, const published_list *list, const family *family);

/* Add those that are allowed. False, after a message, where memory is short. */
bool survey_run(survey *survey, const restriction *given);
void survey_free(survey *survey);

/* How many pairs, one configuration of each family, give so many values together: by_score has a place for each. */
void survey_pairs(const survey *one, const survey *other, uint64_t by_score[2 * MOST_VALUES + 1]);

#endif
