#ifndef ARMTOL_LIB_SPREAD_ANSWER_SPREAD_H
#define ARMTOL_LIB_SPREAD_ANSWER_SPREAD_H

#include "armtol/answer.h"
#include "lib/private_names.h"

/*
 * What parameter errors do by their true variances. Errors of a group are one error: its part is the sum of theirs,
 * signs included, and belongs to the first of its columns, which leads it.
 */

/* The question's spreads and what follows from them, for an answer with memory for them. */
void answer_take_spreads(armtol_answer *answer, const armtol_question *question);

/*
 * What a column, and all that it leads, does along a row at its tolerance, in units of the deviation of an error that
 * is uniform within 1: sqrt 3 standard deviations. 0 for a column that another one leads.
 */
double spread_part(const armtol_answer *answer, const double row[], const double tolerances[], size_t column);

/* The root of the sum of the squares of all parts. */
double spread_rss(const armtol_answer *answer, const double row[], const double tolerances[]);

/* A column that has an error in common with another and is still to be found: n_columns where there is none. */
size_t spread_shared(const armtol_answer *answer);

#endif
