#ifndef TEST_SAID_H
#define TEST_SAID_H

#include <stddef.h>
#include <stdio.h>

/* Files made of a string, and what a routine says on standard error. A failure stops the test. */

/* A file that holds these bytes, to be read from its start; the caller closes it. */
FILE *stream_of(const char *bytes, size_t length);

typedef struct said {
    char text[4000];
} said;

/* What goes to standard error between these two. */
void said_begin(void);
void said_end(said *said);

#endif
