#ifndef ARMTOL_LAB_YIELD_TABLES_H
#define ARMTOL_LAB_YIELD_TABLES_H

#include "lab/yield/case.h"

/* Print what came of all cases, several tables each under a title of its own. False after a message. */
bool yield_tables_print(const yield_case cases[], size_t n_cases, const yield_options *options);

#endif
