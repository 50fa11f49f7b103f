#ifndef PROGRAM_HELP_H
#define PROGRAM_HELP_H

#include "options.h"
#include "program.h"

/* What --list-errata, --help or --version print on standard output. */
void help_print(action action, const program *program);

#endif
