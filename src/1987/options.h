#ifndef ARMTOL_1987_OPTIONS_H
#define ARMTOL_1987_OPTIONS_H

#include "1987/program.h"

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

/* What --list-errata, --help or --version print on standard output. */
void options_answer(action action, const program *program);

#endif
