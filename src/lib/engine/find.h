#ifndef ARMTOL_LIB_ENGINE_FIND_H
#define ARMTOL_LIB_ENGINE_FIND_H

#include "armtol/answer.h"
#include "lib/private_names.h"

/*
 * The tolerances of a placed answer, by the question's method; with the optimum, what binds; with the sphere, its
 * radii.
 */
armtol_fault answer_find_tolerances(armtol_answer *answer, const armtol_question *question);

#endif
