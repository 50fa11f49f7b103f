#ifndef ARMTOL_LIB_ENGINE_CHECK_H
#define ARMTOL_LIB_ENGINE_CHECK_H

#include "armtol/question.h"
#include "lib/private_names.h"

#include <stdbool.h>

/* A fault is about something, and then the rest of the work is not done. */
armtol_fault fault_of(armtol_status status, armtol_subject about, size_t number);

/* Whether the question has what it needs: its members, and its arm's links. */
armtol_fault question_check(const armtol_question *question);

/* Whether the values that it has a column of A are what they should be. */
armtol_fault question_check_columns(const armtol_question *question, size_t n_columns);

/* The range of a column's tolerance, and whether it is one value. */
double question_least(const armtol_question *question, size_t column);
double question_largest(const armtol_question *question, size_t column);
bool question_gives(const armtol_question *question, size_t column);

double question_weight(const armtol_question *question, size_t column);

#endif
