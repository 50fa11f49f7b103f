#ifndef ARMTOL_LIB_ENGINE_PARTS_H
#define ARMTOL_LIB_ENGINE_PARTS_H

#include "armtol/answer.h"
#include "lib/private_names.h"

/* What every link and joint has to keep to when the parameters keep to the answer's tolerances: answer.h, note 1. */
void answer_make_parts(armtol_answer *answer, const armtol_question *question);

/* The arm's length, for the choice of delta: answer.h, note 2. */
double answer_lever(const armtol_answer *answer);

#endif
