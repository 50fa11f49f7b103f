#ifndef ARMTOL_TABLES_CELLS_H
#define ARMTOL_TABLES_CELLS_H

#include "armtol/tables/text_lines.h"
#include "console/message.h"
#include "console/number.h"

#include <stdbool.h>
#include <stddef.h>

/*
 * Rows of cells, as people type them and as spreadsheets write them. Commas, semicolons or tabs stand between two
 * cells, or any number of blanks. A cell in double quotes holds what it likes but the end of a line, a quote doubled.
 * A # begins a comment that ends with the line; within quotes it is text, but for a quoted cell that begins with it:
 * a spreadsheet puts a comment into quotes that has a separator in it. Empty cells at the end of a row do not count.
 */

/* CELLS_ANY: the first of tab, semicolon, comma that a row has outside quotes and comments; else blanks. */
enum { CELLS_ANY = 0, CELLS_BLANKS = ' ', CELLS_WHOLE = '\n' /* nothing sets cells apart: there is one */ };

typedef struct cell {
    char *text; /* without its quotes and the blanks around; in the line that it is from */
    size_t column;    /* where it begins, in characters from 1 */
    bool quoted;
} cell;

typedef struct cell_row {
    const char *path; /* for messages, as is the line */
    size_t line;
    char separator;
    size_t end_column; /* where a cell more would begin */
    size_t n;
    cell *cells;
    size_t room;
} cell_row;

void cells_start(cell_row *row);
void cells_free(cell_row *row);

/*
 * Cut up a part of the line at hand, from `text` to its end. False after a message. The cells are in the line: they are
 * gone with it.
 */
bool cells_split(cell_row *row, text_lines *lines, char *text, char separator);

/* Take a comment in quotes off the end of the row. */
void cells_drop_comment(cell_row *row);

/* The next row that has a cell, without any comment. */
line_result cells_next(cell_row *row, text_lines *lines, char separator);

/* Takes a row; false, after a message, where it is wrong. */
typedef bool cell_row_taker(const cell_row *row, void *context);

/* Give every row of a file to the taker. False after a message. */
bool cells_each(FILE *stream, const char *path, cell_row_taker *take, void *context);

/* file_message at a cell of the row; where the row has no such cell, at its end. */
void cells_message(const cell_row *row, size_t index, const char *format, ...) LIKE_PRINTF(3, 4);

/* Whether it is this word; capitals do not matter. */
bool cell_is(const cell *cell, const char *word);

/* Empty or a dash. */
bool cell_is_unknown(const cell *cell);

/* Room for the text of a number as number_parse takes it. */
typedef struct cell_number {
    char text[512];
    double value;
} cell_number;

/*
 * The number in a cell. Between semicolons or tabs it may have a decimal comma, anywhere a minus sign that is the
 * typesetter's (spreadsheets and web pages have them) and not the keyboard's.
 */
number_fault cells_number(const cell_row *row, size_t index, cell_number *number);

#endif
