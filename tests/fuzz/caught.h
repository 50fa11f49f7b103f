#ifndef FUZZ_CAUGHT_H
#define FUZZ_CAUGHT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/*
 * Standard error in memory: what a program says is looked at and not shown. It takes a C library whose stderr and
 * stdin are variables that can be set (glibc); sanitizers and libFuzzer write to the descriptor and stay visible.
 */

/* Once, before the first input: from now on standard error is caught, and messages have this program's name. */
void caught_start(const char *program);

/* Before each input. */
void caught_forget(void);

/* What has been said since, a zero behind it; and its length. */
const char *caught_text(void);
size_t caught_length(void);

/* Nothing was said. */
bool caught_nothing(void);

/*
 * One message was said and nothing else: one line that begins with the program's name, fit for a terminal. What goes
 * wrong is told once, and it is told.
 */
bool caught_one_message(void);

/* An input, to be read as a file; the caller closes it. */
FILE *caught_file(const void *bytes, size_t length);

#endif
