#ifndef ARMTOL_LAB_JOINT_ORDERS_OPTIONS_H
#define ARMTOL_LAB_JOINT_ORDERS_OPTIONS_H

#include "lab/joint_orders/tables.h"

typedef enum orders_action { ORDERS_RUN, ORDERS_HELP, ORDERS_VERSION } orders_action;

typedef struct orders_options {
    orders_action action;
    table_format format;
    bool show[PART_COUNT];
    restriction given[FAMILIES];
    const char *published; /* the table of the paper's numbers */
} orders_options;

/* EXIT_OK, or EXIT_WRONG after a message. */
int orders_options_parse(int argc, char *argv[], orders_options *options);

void orders_options_help(void);

#endif
