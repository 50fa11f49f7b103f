#ifndef ARMTOL_LIB_ENGINE_DRIVES_H
#define ARMTOL_LIB_ENGINE_DRIVES_H

#include "armtol/answer.h"
#include "lib/private_names.h"

/* The loading of a question, and how many load cases that are. */
const armtol_loading *question_loading(const armtol_question *question);
size_t question_load_count(const armtol_question *question);

/* Whether the drives, and what loads them, are what they should be. */
armtol_fault question_check_drives(const armtol_question *question);

/*
 * What the drives of a placed answer make of their motors, Eq. (4.20), in every pose and load: moments, shifts, and the
 * half widths, in `bounded`, and what of them is of each arrival; `given` and the largest in `tolerances`. Moments
 * alone where the question leaves the drives apart.
 */
armtol_fault answer_take_drives(armtol_answer *answer, const armtol_question *question);

/* Where the shifts take the tool. */
void answer_find_droops(armtol_answer *answer);

/* The column of a link's motor; n_columns for a fixed link. */
size_t answer_motor_column(const armtol_answer *answer, size_t link);

/* How far a link's drive is off, the most in any pose and load; nan where it is not known. */
double answer_drive_error(const armtol_answer *answer, const armtol_question *question, size_t link);

#endif
