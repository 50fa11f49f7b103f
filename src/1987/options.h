#ifndef ARMTOL_1987_OPTIONS_H
#define ARMTOL_1987_OPTIONS_H

#include "armtol/errata.h"

typedef enum action { ACTION_RUN, ACTION_LIST_ERRATA, ACTION_HELP, ACTION_VERSION } action;

typedef struct options {
    action action;
    const char *folder;
    int run;
    armtol_errata errata;
} options;

/* EXIT_OK, or EXIT_WRONG after a message. */
int options_parse(int argc, char *argv[], options *options);

#endif
