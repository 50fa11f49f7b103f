#ifndef ARMTOL_DRAWING_DRAWN_H
#define ARMTOL_DRAWING_DRAWN_H

#include "armtol/answer.h"
#include "armtol/drawing/drawing_file.h"

/* From what drawings say to tolerances of parameters, and back. Lengths are the arm's and angles radians. */

/* What is made of tolerances, n_columns each: a column of A of the arm. */
typedef struct drawn {
    double *tolerances; /* of those that a drawing says something of; others stay */
    bool *drawn;        /* whether it does */
    bool *discs;        /* question.h */
} drawn;

void drawn_take(const drawing *drawing, const armtol_arm *arm, const armtol_column columns[], size_t n_columns,
                const drawn *into);

/*
 * What a drawing of a link may say for its parameters to keep to an answer's tolerances; distance and angle are nan
 * where there is nothing to say or nothing to keep to. A link of which a and d are both made gets an even split, unless
 * one of them is to be exact.
 */
drawing_row drawn_row(const armtol_answer *answer, const armtol_arm *arm, size_t number);

#endif
