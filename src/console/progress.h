#ifndef ARMTOL_CONSOLE_PROGRESS_H
#define ARMTOL_CONSOLE_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

/*
 * A bar on standard error, redrawn in place and wiped in the end: for people who wait. Nothing at all where
 * standard error is no terminal, and nothing in the first second.
 */
typedef struct progress {
    bool terminal;
    const char *what; /* that is counted: "arms" */
    uint64_t total;
    double started, shown; /* seconds of a clock that only goes on; when it was last drawn */
    int width;             /* of the bar that is there, 0 where none is */
} progress;

void progress_start(progress *progress, const char *what, uint64_t total);

/* May be called often: it looks at the clock, and draws ten times a second. */
void progress_show(progress *progress, uint64_t done);

/* The same with a text in the place of the bar, for work of which nobody knows how much is left. */
void progress_say(progress *progress, const char *text);

void progress_end(progress *progress);

#endif
