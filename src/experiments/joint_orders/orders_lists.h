#ifndef EXPERIMENTS_ORDERS_LISTS_H
#define EXPERIMENTS_ORDERS_LISTS_H

#include "survey.h"
#include "table.h"

/* The parts of the output that are no tables, on standard output. */

void print_family(const survey *survey, table_format format);
void print_all_that_fit(const survey *survey, table_format format);

#endif
