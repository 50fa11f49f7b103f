#ifndef ARMTOL_FORMS_WRAP_H
#define ARMTOL_FORMS_WRAP_H

#include "console/message.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/*
 * Prose for people: lines break between words, at 80 columns. Words are set apart by single blanks; one that is longer
 * than a line stays whole.
 */
typedef struct wrap {
    FILE *stream;
    size_t indent; /* of the lines after the first */
    size_t column;
    bool fresh; /* no word stands in the line */
} wrap;

/* The blanks before the first line, and before all others. */
void wrap_start(wrap *wrap, FILE *stream, size_t first, size_t indent);

/* More of it, printf-like, a blank before the first word unless a line begins; up to 6,000 bytes at a time. */
void wrap_say(wrap *wrap, const char *format, ...) LIKE_PRINTF(2, 3);

/* Ends the line. */
void wrap_end(wrap *wrap);

#endif
