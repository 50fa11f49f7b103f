#ifndef ARMTOL_CONSOLE_TABLE_H
#define ARMTOL_CONSOLE_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/*
 * A table of texts, to be printed for people, as Markdown or as tab-separated values. Cells are plain ASCII, without
 * tabs and without Markdown's bars: nothing is escaped.
 */

typedef enum table_format { FORMAT_TEXT, FORMAT_MARKDOWN, FORMAT_TSV, FORMAT_COUNT } table_format;

enum { TABLE_COLUMNS = 12, TABLE_CELL = 64 };

typedef struct table_row {
    char cells[TABLE_COLUMNS][TABLE_CELL];
} table_row;

typedef struct table {
    size_t n_columns;
    size_t n_rows, room;
    table_row *rows; /* the first is the head */
} table;

/* "text", "markdown" or "tsv", the argument of --format; false, after a message, for any other. */
bool table_format_parse(const char *name, table_format *format);

/* n_columns is at most TABLE_COLUMNS. */
void table_start(table *table, size_t n_columns);
void table_free(table *table);

/*
 * A new row, to be used until the next is added, its cells empty but for the first; and the head, a row with all of
 * its cells. NULL and false, after a message, where memory is short.
 */
table_row *table_add(table *table, const char *first_cell);
bool table_add_head(table *table, const char *const cells[]);

/* printf into a cell; what is too long is cut. */
void table_set(table_row *row, size_t column, const char *format, ...)
#ifdef __GNUC__
    __attribute__((format(printf, 3, 4)))
#endif
    ;

/* What stands above a table: its title and, unless it is NULL, a line on what is below. */
void table_print_title(const char *title, const char *remark, table_format format, FILE *stream);

/* The first column to the left, the others to the right. */
void table_print(const table *table, table_format format, FILE *stream);

#endif
