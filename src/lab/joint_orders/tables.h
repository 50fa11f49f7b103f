#ifndef ARMTOL_LAB_JOINT_ORDERS_TABLES_H
#define ARMTOL_LAB_JOINT_ORDERS_TABLES_H

#include "console/table.h"
#include "lab/joint_orders/survey.h"

/* The parts of the output, in their order. */
typedef enum orders_part {
    PART_FAMILY,    /* the choices and their options */
    PART_HISTOGRAM, /* how many configurations give how many values */
    PART_CHOICES,   /* what the values say of each option */
    PART_MARGINS,   /* how near each value is to the edge of its last digit */
    PART_OPEN,      /* how much the configurations that fit differ elsewhere */
    PART_MISSES,    /* the configurations with one wrong value */
    PART_ALL,       /* every configuration that fits */
    PART_COUNT
} orders_part;

extern const char *const orders_part_names[PART_COUNT];

/* Print a part on standard output. False, after a message, where that failed. */
bool orders_print(orders_part part, const survey surveys[FAMILIES], table_format format);

#endif
