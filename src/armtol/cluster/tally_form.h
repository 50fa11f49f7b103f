#ifndef ARMTOL_CLUSTER_TALLY_FORM_H
#define ARMTOL_CLUSTER_TALLY_FORM_H

#include "armtol/cluster/shard_range.h"
#include "armtol/tally.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What a tally can be of, arms that were drawn or rows of a map, and what becomes of it in memory. */

/* What is known of a point of a map: sums of these, but that a point that a search found was not searched in vain. */
enum { ROWS_REACHED = 1, ROWS_FOUND = 2 /* by a search */, ROWS_IN_VAIN = 4 };

/* Rows of a map, in inside units. Of a point that is not reached no value and no joint value is looked at. */
typedef struct tally_rows {
    size_t n_points, n_joints; /* of all rows together; of a point */
    uint64_t *points;          /* n_points: the above */
    double *values;            /* n_points, infinite where nothing bounds it */
    double *q;                 /* n_points x n_joints */
} tally_rows;

/* What one tally or several hold. To be freed with tally_content_free; none is all 0. */
typedef struct tally_content {
    armtol_tally *arms;
    tally_rows rows;
} tally_content;

void tally_content_free(tally_content *content);

struct tally_head;

enum { TALLY_NUMBERS = 2, TALLY_SUBJECTS = 8 };

typedef struct tally_form {
    const char *one, *many; /* "arm", "arms": the line with the number of them all has this name */
    const char *number;     /* "number of arms" */
    uint64_t most;          /* of them */
    size_t n_numbers;       /* lines with a number each, and what differs where such a number does */
    const char *numbers[TALLY_NUMBERS], *meanings[TALLY_NUMBERS];
    size_t n_subjects;      /* of the fingerprints */
    const char *(*subject)(size_t number);
    const char *misfit; /* what to say of contents that do not fit their head */

    /* Whether a head's numbers can be. */
    bool (*is_sound)(const struct tally_head *head);
    /* Contents without anything, for so many arms or rows. False where memory is short. */
    bool (*start)(tally_content *content, const struct tally_head *head, uint64_t count);
    /* Named arrays, as of armtol_tally_member_at; of numbers that are nan nothing is written. */
    size_t (*member_count)(void);
    armtol_tally_member (*member)(const tally_content *content, size_t number);
    /* Whether members that were read can be those of the head's shard. */
    bool (*fits)(const tally_content *content, const struct tally_head *head);
    /* Puts a shard, and its head, into what was started for all of them. */
    void (*add)(tally_content *into, const tally_content *part, const struct tally_head *head);
} tally_form;

extern const tally_form tally_of_arms, tally_of_rows;

/* What a tally of rows can have of points, and of joint values, all shards together. */
enum { ROWS_MOST_POINTS = 1000000, ROWS_MOST_VALUES = 1 << 27 };

/* Its numbers, behind the number of rows. */
enum { ROWS_POINTS, ROWS_JOINTS };

/* The subjects of its fingerprints. */
enum { ROWS_ARM, ROWS_POSE, ROWS_PLANE, ROWS_VALUE, ROWS_TOOL, ROWS_TOLERANCES, ROWS_LOADS, ROWS_ACCURACY,
       ROWS_SUBJECTS };

#endif
