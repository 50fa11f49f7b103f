#ifndef PROGRAM_SESSION_H
#define PROGRAM_SESSION_H

#include "options.h"
#include "outfile.h"
#include "program.h"

/* A run as in 1987: ask, compute, write the four files. Returns the program's exit code. */
int session_run(const program *program, const options *options, const folder *folder);

#endif
