#include "console/table.h"

#include "console/list_room.h"
#include "console/message.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

bool table_format_parse(const char *name, table_format *format)
{
    static const char *const names[FORMAT_COUNT] = {"text", "markdown", "tsv"};
    for (int i = 0; i < FORMAT_COUNT; i++) {
        if (strcmp(name, names[i]) == 0) {
            *format = (table_format)i;
            return true;
        }
    }
    message("--format: unknown format %s; expected text, markdown or tsv", message_quote(name, &(quoted){""}));
    return false;
}

void table_start(table *table, size_t n_columns)
{
    table->n_columns = n_columns < TABLE_COLUMNS ? n_columns : TABLE_COLUMNS;
    table->n_rows = table->room = 0;
    table->rows = NULL;
}

void table_free(table *table)
{
    free(table->rows);
    table_start(table, 0);
}

table_row *table_add(table *table, const char *first_cell)
{
    table_row *rows = list_room(table->rows, table->n_rows, &table->room, sizeof *rows);
    if (rows == NULL) {
        return NULL;
    }
    table->rows = rows;
    table_row *row = &table->rows[table->n_rows++];
    memset(row, 0, sizeof *row);
    table_set(row, 0, "%s", first_cell);
    return row;
}

bool table_add_head(table *table, const char *const cells[])
{
    table_row *row = table_add(table, cells[0]);
    for (size_t j = 1; row != NULL && j < table->n_columns; j++) {
        table_set(row, j, "%s", cells[j]);
    }
    return row != NULL;
}

void table_set(table_row *row, size_t column, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (column < TABLE_COLUMNS) {
        vsnprintf(row->cells[column], TABLE_CELL, format, arguments);
    }
    va_end(arguments);
}

void table_print_title(const char *title, const char *remark, table_format format, FILE *stream)
{
    static const char *const before[FORMAT_COUNT] = {"\n", "\n### ", "# "};
    static const char *const between[FORMAT_COUNT] = {"\n", "\n\n", "\n# "};
    static const char *const after[FORMAT_COUNT] = {"\n\n", "\n\n", "\n"};
    fprintf(stream, "%s%s", before[format], title);
    if (remark != NULL) {
        fprintf(stream, "%s%s", between[format], remark);
    }
    fputs(after[format], stream);
}

static int width_of(const table *table, size_t column)
{
    size_t width = 3; /* what Markdown's rule needs */
    for (size_t i = 0; i < table->n_rows; i++) {
        const size_t length = strlen(table->rows[i].cells[column]);
        width = length > width ? length : width;
    }
    return (int)width;
}

static void print_row(const table *table, const table_row *row, table_format format, FILE *stream)
{
    static const char *const begin[FORMAT_COUNT] = {"  ", "| ", ""};
    static const char *const between[FORMAT_COUNT] = {"  ", " | ", "\t"};
    static const char *const end[FORMAT_COUNT] = {"\n", " |\n", "\n"};
    fputs(begin[format], stream);
    for (size_t j = 0; j < table->n_columns; j++) {
        const int width = format == FORMAT_TSV ? 0 : width_of(table, j);
        fprintf(stream, j == 0 ? "%-*s" : "%*s", width, row->cells[j]);
        fputs(j + 1 < table->n_columns ? between[format] : end[format], stream);
    }
}

/* Markdown's line below the head: a colon aligns a column to the right. */
static void print_rule(const table *table, FILE *stream)
{
    for (size_t j = 0; j < table->n_columns; j++) {
        fputc('|', stream);
        for (int i = width_of(table, j) + (j == 0 ? 2 : 1); i > 0; i--) {
            fputc('-', stream);
        }
        fputs(j == 0 ? "" : ":", stream);
    }
    fputs("|\n", stream);
}

void table_print(const table *table, table_format format, FILE *stream)
{
    for (size_t i = 0; i < table->n_rows; i++) {
        print_row(table, &table->rows[i], format, stream);
        if (i == 0 && format == FORMAT_MARKDOWN) {
            print_rule(table, stream);
        }
    }
}
