#ifndef ARMTOL_ENGINE_ANSWER_H
#define ARMTOL_ENGINE_ANSWER_H

#include "armtol/ask/request.h"

#include <stdbool.h>

/* What whoever makes a link, and its joint, has to keep to. nan where there is nothing to keep to. */
typedef struct part {
    double distance; /* between the axes of the link, Eq. (4.32) */
    double angle;    /* the smallest of the link's angles that no motor moves */
    double motor;    /* the joint's */
    double drive;    /* how far the drive of the joint is off: backlash and compliance, Eqs (4.33), (4.34) */
} part;

/* One component of the tool's error, the largest of all poses. Magnitudes; infinite where nothing bounds them. */
typedef struct predicted {
    double worst;     /* sum over |A| t */
    double deviation; /* the standard deviation, every error being even within its tolerance */
    double remainder; /* what the exact error can differ from A's by */
    double binds;     /* the share of the optimum that this component's limit holds down */
    size_t worst_pose;
} predicted;

typedef struct answer {
    double *tolerances; /* n_columns, infinity for a parameter that no bounded component sees */
    double *bounded;    /* the same with 0 for infinity */
    part *parts;        /* n_links */
    predicted components[6];
    armtol_bounds bounds; /* method sphere only, as is delta */
    double delta;
} answer;

/* EXIT_OK, or an exit code after a message; nothing is then to be freed. */
int answer_make(answer *answer, const request *request);
void answer_free(answer *answer);

#endif
