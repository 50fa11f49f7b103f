#ifndef ARMTOL_LIB_NORMS_ANSWER_NORMS_H
#define ARMTOL_LIB_NORMS_ANSWER_NORMS_H

#include "armtol/answer.h"
#include "lib/private_names.h"

/* The norms that are asked about: of what components, and up to what limits. */
void answer_take_norms(armtol_answer *answer, const armtol_question *question);

/*
 * What the answer's tolerances make of its norms in a pose, the most of all so far; `rounding` is that of the six
 * components there (armtol_rounding), and workspace that of norm_discs_worst.
 */
void answer_predict_norms(armtol_answer *answer, size_t pose, const double rounding[6], double workspace[]);

/*
 * What is told of an error is its components and, behind them, its norms: measures 0 to 5, and from 6 on. Of each the
 * prediction, and the row that says what parameter errors do to it where that is told: A's, or u'A in the direction
 * that is the norm's worst or, by method rss, its widest.
 */
const armtol_predicted *answer_predicted(const armtol_answer *answer, size_t measure);
size_t answer_told_pose(const armtol_answer *answer, size_t measure);
void answer_told_row(const armtol_answer *answer, size_t measure, double row[]);

#endif
