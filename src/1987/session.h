#ifndef ARMTOL_1987_SESSION_H
#define ARMTOL_1987_SESSION_H

#include "1987/options.h"
#include "1987/program.h"
#include "files/outfile.h"

/* A run as in 1987: ask, compute, write the four files. Returns the program's exit code. */
int session_run(const program *program, const options *options, const folder *folder);

#endif
