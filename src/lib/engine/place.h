#ifndef ARMTOL_LIB_ENGINE_PLACE_H
#define ARMTOL_LIB_ENGINE_PLACE_H

#include "armtol/answer.h"
#include "lib/private_names.h"

/*
 * Columns, placed links and A of every pose, of a question that was checked. Memory is the answer's, also in a failure.
 */
armtol_fault answer_place(armtol_answer *answer, const armtol_question *question);

#endif
