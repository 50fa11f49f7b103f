#ifndef ARMTOL_REGION_REGION_WORDS_H
#define ARMTOL_REGION_REGION_WORDS_H

#include "armtol/ask/units.h"
#include "armtol/region.h"

#include <stdio.h>

/* A region as people write it (docs/region.md), in inside units, and the memory that it is in. */
typedef struct region_words {
    armtol_region region;
    double *low, *high; /* a joint that moves by itself */
    bool *named;        /* likewise: its range was given */
    armtol_block block;
    armtol_ring ring;
    armtol_path path;
    armtol_cone cone;
    double *points;
    unsigned taken; /* a bit for each kind of item that was read */
    bool has_cone_angle;
    char elbow[16]; /* as typed, or empty */
} region_words;

/*
 * What --region says: items with ; between them or, without a sign =, a file of them. Joints that are not named have
 * the arm's limits, and an angle without limits one turn about 0. False after a message; to be freed in any case.
 */
bool region_words_take(const char *text, const armtol_arm *arm, const units *units, bool ignore_limits,
                       region_words *words);

/* The same of a file that is open; path is for messages. */
bool region_words_read(FILE *stream, const char *path, const armtol_arm *arm, const units *units, bool ignore_limits,
                       region_words *words);

void region_words_free(region_words *words);

#endif
