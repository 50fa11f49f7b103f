#ifndef ARMTOL_TABLES_TEXT_LINES_H
#define ARMTOL_TABLES_TEXT_LINES_H

#include <stddef.h>
#include <stdio.h>

/* A line may have this many bytes: a pose of a thousand joints, and room beside. */
enum { TEXT_LINE_MOST = 65536 };

/*
 * The lines of a text file, whatever they end in (LF, CRLF, CR, the end of the file), without the byte order mark
 * that spreadsheets put before the first. They are UTF-8 without control characters other than tabs; another file is
 * refused.
 */
typedef struct text_lines {
    FILE *stream;
    const char *path; /* for messages */
    size_t number;    /* of the line at hand, from 1; 0 before the first */
    char *text;       /* the line at hand, without its end; the caller may cut it up */
    size_t length;
    size_t room;
} text_lines;

/* What there is to have. */
typedef enum line_result {
    LINE_THERE,
    LINE_NONE,  /* the end of the file */
    LINE_WRONG  /* a message has been given */
} line_result;

void text_lines_start(text_lines *lines, FILE *stream, const char *path);
void text_lines_free(text_lines *lines);

/* The next line, which takes the place of the one before. */
line_result text_lines_next(text_lines *lines);

/* What a line may not have becomes question marks, and so do tabs: for a name of a file. */
void text_make_printable(char *text);

/* How many characters the UTF-8 text has up to `end`. */
size_t text_characters(const char *text, const char *end);

#endif
