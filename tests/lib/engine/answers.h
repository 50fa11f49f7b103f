#ifndef TEST_ANSWERS_H
#define TEST_ANSWERS_H

#include "armtol/answer.h"

/* The answer to a question that has one, to be destroyed. */
armtol_answer *answer_of(const armtol_question *question);

/* That there is none, and why. */
void check_refused(const armtol_question *question, armtol_status status, armtol_subject about, size_t number);

#endif
