#ifndef ARMTOL_LAB_JOINT_ORDERS_LISTS_H
#define ARMTOL_LAB_JOINT_ORDERS_LISTS_H

#include "console/table.h"
#include "lab/joint_orders/survey.h"

/* The parts of the output that are no tables, on standard output. */

void print_family(const survey *survey, table_format format);
void print_all_that_fit(const survey *survey, table_format format);

#endif
