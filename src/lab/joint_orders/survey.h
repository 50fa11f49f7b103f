#ifndef ARMTOL_LAB_JOINT_ORDERS_SURVEY_H
#define ARMTOL_LAB_JOINT_ORDERS_SURVEY_H

#include "lab/joint_orders/evidence.h"
#include "lab/joint_orders/family.h"

#include <stdint.h>

/* The configurations of a family, held against the evidence. */

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
