#ifndef ARMTOL_1987_HELP_H
#define ARMTOL_1987_HELP_H

#include "1987/options.h"
#include "1987/program.h"

/* What --list-errata, --help or --version print on standard output. */
void help_print(action action, const program *program);

#endif
