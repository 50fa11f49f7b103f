#ifndef ARMTOL_LIB_ARRIVALS_SOURCES_H
#define ARMTOL_LIB_ARRIVALS_SOURCES_H

#include "armtol/answer.h"
#include "lib/private_names.h"

#include <stddef.h>

/* A joint that is off otherwise at each arrival. */
typedef struct arrival_source {
    armtol_drive_arrival off;
    double way[3]; /* the tool point's for 1 of the joint's parameter, to first order */
    size_t link;
} arrival_source;

/* Those of a pose of the answer, n_links places for them. How many there are. */
size_t arrival_sources_of(const armtol_answer *answer, size_t pose, arrival_source sources[]);

/* Of every column what is left of its tolerance for what is of the arm: n_columns. */
void arrival_sources_making(const armtol_answer *answer, size_t pose, double tolerances[]);

#endif
