#ifndef ARMTOL_TELL_TEXT_TABLES_H
#define ARMTOL_TELL_TEXT_TABLES_H

#include "armtol/tell/findings.h"

#include <stdbool.h>

/* The tables that people are shown, on standard output. False after a message, where memory is short. */
bool text_parameters(const findings *findings);
bool text_parts(const findings *findings);
bool text_grades(const findings *findings);
bool text_components(const findings *findings);
bool text_loads(const findings *findings);
bool text_region(const findings *findings);
bool text_budget(const findings *findings);
bool text_verification(const findings *findings);
bool text_noises(const findings *findings);
bool text_arrivals(const findings *findings);

/* Of norms the directions in which they are largest, and in which they hold. */
void text_norms(const findings *findings);

#endif
