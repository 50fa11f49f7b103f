#ifndef TEST_FAULTED_H
#define TEST_FAULTED_H

#include "faults/fault.h"
#include "support/process.h"

/*
 * Runs of a program in which something goes wrong at a place that is told exactly. The program is started once, and
 * forks where its main would begin, so that a run takes a fraction of a millisecond: thousands of places can be tried.
 * What stands in a test's way fails the test. Every test calls faulted_end.
 */

typedef struct faulted_setup {
    const char *program;
    const char *const *arguments; /* up to a NULL, without the program's name */
    const char *folder;           /* to run in */
    const char *input;            /* what standard input holds; NULL: nothing */
} faulted_setup;

typedef struct faulted_run {
    int status; /* exit status, or 128 and the signal that ended or stopped it */
    fault_outcome outcome;
    text output, errors;
} faulted_run;

void faulted_start(const faulted_setup *setup);

/* From the beginning of main to its end, or until it is stopped; then on to its end. */
void faulted_try(const fault *fault, faulted_run *run);
void faulted_resume(faulted_run *run);

void faulted_end(void);

/* How many runs there have been, in which something went wrong or not. */
long faulted_count(void);

/* The last line on standard error is the program's message; `words` are in it, if not NULL. */
void faulted_check_message(const faulted_run *run, const char *name, const char *words, const char *what);

#endif
