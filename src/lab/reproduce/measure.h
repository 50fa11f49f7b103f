#ifndef ARMTOL_LAB_REPRODUCE_MEASURE_H
#define ARMTOL_LAB_REPRODUCE_MEASURE_H

#include "console/table.h"
#include "lab/published.h"

#include <stdbool.h>

/*
 * What the errata do to the paper's numbers, computed in this process by the library. Each prints its tables on
 * standard output; false, after a message, where that failed.
 */

/* For each case: the bounds with one erratum corrected, and with one alone kept. */
bool measure_errata(const published_list *list, table_format format);

/* For each case: the bounds on the way from 1987 to everything corrected, an erratum at a time. */
bool measure_walk(const published_list *list, table_format format);

/* Every published number for float and double storage, 3.14159 and pi. */
bool measure_portability(const published_list *list, table_format format);

#endif
