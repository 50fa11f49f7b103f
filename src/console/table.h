#ifndef ARMTOL_CONSOLE_TABLE_H
#define ARMTOL_CONSOLE_TABLE_H

#include "console/word.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/*
 * A table of texts, to be printed for people, as Markdown or as tab-separated values. Cells are UTF-8, without tabs and
 * without Markdown's bars: nothing is escaped. Widths are counted in characters.
 */

typedef enum table_format { FORMAT_TEXT, FORMAT_MARKDOWN, FORMAT_TSV, FORMAT_COUNT } table_format;

enum { TABLE_COLUMNS = 16, TABLE_CELL = WORD };

typedef struct table_row {
    char cells[TABLE_COLUMNS][TABLE_CELL];
} table_row;

typedef struct table {
    table_row *rows; /* the first is the head */
    size_t n_rows, room;
    size_t n_columns; /* cells of the head */
    size_t n_cells;   /* of the last row, so far */
    int widths[TABLE_COLUMNS]; /* of the columns, in characters, when it is printed */
    size_t n_more;    /* columns behind the first that say what a row is about too */
    bool cut_first;   /* the ends of long cells of the first column may go, to keep a text within a line */
    bool failed;      /* memory was short: a message has said so, and nothing is added any more */
} table;

/* "text", "markdown" or "tsv", the argument of --format; false, after a message, for any other. */
bool table_format_parse(const char *name, table_format *format);

/* A table has no rows yet, nor anything to free. */
#define TABLE_EMPTY {.rows = NULL}

/*
 * A new row, and more cells behind those of the last row: printf's text, cut into cells at its tabs. What is too long
 * for a cell is cut, what is more than TABLE_COLUMNS left out. The first row is the head; cells that it does not have
 * are not printed.
 */
void table_add(table *table, const char *format, ...)
#ifdef __GNUC__
    __attribute__((format(printf, 2, 3)))
#endif
    ;
void table_add_cells(table *table, const char *format, ...)
#ifdef __GNUC__
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/* What stands above a table: its title and, unless it is NULL, a line on what is below. */
void table_print_title(const char *title, const char *remark, table_format format, FILE *stream);

/*
 * Print a table, below its title unless that is NULL, and free it: the first column to the left, the others to the
 * right. As text a wider table than 80 characters comes in parts below each other, each with the columns that say what
 * a row is about: no line is longer, unless these and one more are. False where a row had found no memory: nothing is
 * printed.
 */
bool table_finish(table *table, const char *title, const char *remark, table_format format, FILE *stream);

#endif
