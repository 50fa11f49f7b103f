#ifndef ARMTOL_LIB_NORMS_CUTS_H
#define ARMTOL_LIB_NORMS_CUTS_H

#include "armtol/answer.h"
#include "lib/private_names.h"

#include <stdbool.h>

/*
 * A norm asks for as many limits as there are unit vectors u: of u'A in the place of a row of A. The optimum of a few
 * of them is found, the direction that it violates most becomes one more, until none is violated.
 */
typedef struct cut {
    size_t norm, pose;
    double direction[6];
} cut;

typedef struct cuts {
    cut *cuts;
    double *rows; /* count x n_columns: u'A of each */
    size_t count, room;
    double *workspace, *trial; /* of norm_discs_worst; two places a column */
} cuts;

/* Along the axes of each norm that asks for something, in each pose: they bound what it does. False without memory. */
bool cuts_start(cuts *cuts, const armtol_answer *answer);
void cuts_free(cuts *cuts);

/* What tolerances come to in a pose with what loads shift, by the method's sum, and along which direction most. */
double cuts_norm(const cuts *cuts, const armtol_answer *answer, size_t norm, size_t pose, const double tolerances[],
                 double direction[6]);

/* Whether a column that is marked does anything to the norm in the pose. */
bool cuts_is_seen(const armtol_answer *answer, size_t norm, size_t pose, const bool columns[]);

/*
 * Cuts for the tolerances, one a column, of which those that are not `asked` are what they are in the answer's poses:
 * one for every norm and pose that they exceed. *added says how many. False without memory.
 */
bool cuts_add(cuts *cuts, const armtol_answer *answer, const bool asked[], const double tolerances[], size_t *added);

/* What those that are asked have to be multiplied by for no norm to be exceeded at all. */
double cuts_factor(const cuts *cuts, const armtol_answer *answer, const bool asked[], const double tolerances[]);

/* The directions that hold, of each cut its share of the optimum, for the answer. False without memory. */
bool cuts_note(const cuts *cuts, armtol_answer *answer, const double shares[]);

#endif
