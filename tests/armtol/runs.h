#ifndef TEST_RUNS_H
#define TEST_RUNS_H

#include "support/process.h"

/* Runs of the program armtol in a folder, without input; what they printed is in *process. */
void run(process *process, const char *folder, const char *const arguments[]);

/* One that has to be right: status 0, and nothing on standard error. */
void run_well(process *process, const char *folder, const char *const arguments[]);

/* The words stand somewhere on its standard output. */
void check_says(const process *process, const char *words);

#endif
