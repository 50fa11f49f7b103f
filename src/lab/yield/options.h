#ifndef ARMTOL_LAB_YIELD_OPTIONS_H
#define ARMTOL_LAB_YIELD_OPTIONS_H

#include "console/table.h"
#include "lab/yield/column_tolerances.h"

#include <stddef.h>
#include <stdint.h>

typedef enum yield_action { YIELD_RUN, YIELD_HELP, YIELD_VERSION } yield_action;

typedef struct yield_options {
    yield_action action;
    size_t samples; /* arms to draw for each case and set of tolerances */
    uint64_t seed;
    length_reading reading;
    table_format format;
    const char *published; /* the table of the paper's numbers */
} yield_options;

/* EXIT_OK, or EXIT_WRONG after a message. */
int yield_options_parse(int argc, char *argv[], yield_options *options);

void yield_options_help(void);

#endif
