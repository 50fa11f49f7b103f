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
    bool begun;             /* the first word has been read */
    bool waiting;           /* for what is not there yet */
    size_t looked_at;       /* bytes that were read without waiting */
    char line[READER_LINE]; /* interactive only, as is what follows */
    size_t at;
    bool ended; /* the input ended in the middle of the line */
} reader;

typedef enum read_result {
    READ_WORD,
    READ_LINE_ENDS, /* interactive only: the line has no more words */
    READ_TOO_LONG,  /* a word of READER_WORD characters or more; its beginning is given */
    READ_END,       /* end of input */
    READ_FAILED     /* errno says why */
} read_result;

void reader_start(reader *reader, FILE *stream, bool interactive);

/* The next word, cut to fit. A byte order mark before the first one, which editors write, is no part of it. */
read_result reader_next(reader *reader, char word[READER_WORD]);

/*
 * From now on words are read as far as they are there, and not without end: READER_LINE bytes at most. Whoever holds
 * the other end of a pipe may be waiting for this program to end.
 */
void reader_wait_no_more(reader *reader);

/* Interactive only: whether the user has typed something that was not asked for yet. */
bool reader_is_ahead(const reader *reader);

/* Interactive only: read the next line. READ_LINE_ENDS where there was one, else READ_END or READ_FAILED. */
read_result reader_load_line(reader *reader);

/* Interactive only: the number of words that are left on the line; and a way to drop them. */
size_t reader_words_left(const reader *reader);
void reader_drop_line(reader *reader);

#endif
