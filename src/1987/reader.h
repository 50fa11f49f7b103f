#ifndef ARMTOL_1987_READER_H
#define ARMTOL_1987_READER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { READER_LINE = 4096, READER_WORD = 512 };

/*
 * Words from a stream, separated by white space as scanf sees it. From a terminal they come a line at a time,
 * so that a caller can tell where an answer ended and drop what is left of a wrong one.
 */
typedef struct reader {
    FILE *stream;
    bool interactive;
    char line[READER_LINE]; /* interactive only, as is what follows */
    size_t at;
} reader;

typedef enum read_result {
    READ_WORD,
    READ_LINE_ENDS, /* interactive only: the line has no more words */
    READ_TOO_LONG,  /* a word of READER_WORD characters or more; its beginning is given */
    READ_END,       /* end of input */
    READ_FAILED     /* errno says why */
} read_result;

void reader_start(reader *reader, FILE *stream, bool interactive);

/* The next word, cut to fit. */
read_result reader_next(reader *reader, char word[READER_WORD]);

/* Interactive only: read the next line. READ_LINE_ENDS where there was one, else READ_END or READ_FAILED. */
read_result reader_load_line(reader *reader);

/* Interactive only: the number of words that are left on the line; and a way to drop them. */
size_t reader_words_left(const reader *reader);
void reader_drop_line(reader *reader);

#endif
