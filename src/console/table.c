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

/* Text, cut at its tabs, into the cells behind those of the last row. */
#ifdef __GNUC__
__attribute__((format(printf, 2, 0)))
#endif
static void take_cells(table *table, const char *format, va_list arguments)
{
    char text[TABLE_COLUMNS * TABLE_CELL];
    vsnprintf(text, sizeof text, format, arguments);
    const char *at = text;
    bool more = !table->failed;
    while (more && table->n_cells < TABLE_COLUMNS) {
        word_take(&at, "\t", table->rows[table->n_rows - 1].cells[table->n_cells++]);
        more = *at++ != '\0';
    }
    table->n_columns = table->n_rows == 1 ? table->n_cells : table->n_columns;
}

void table_add(table *table, const char *format, ...)
{
    table_row *rows = table->failed ? NULL : list_room(table->rows, table->n_rows, &table->room, sizeof *rows);
    table->failed = rows == NULL;
    if (rows != NULL) {
        va_list arguments;
        table->rows = rows;
        table->rows[table->n_rows++] = (table_row){{""}};
        table->n_cells = 0;
        va_start(arguments, format);
        take_cells(table, format, arguments);
        va_end(arguments);
    }
}

void table_add_cells(table *table, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    take_cells(table, format, arguments);
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

bool table_finish(table *table, const char *title, const char *remark, table_format format, FILE *stream)
{
    const bool fine = !table->failed;
    if (fine && title != NULL) {
        table_print_title(title, remark, format, stream);
    }
    for (size_t i = 0; i < table->n_rows && fine; i++) {
        print_row(table, &table->rows[i], format, stream);
        if (i == 0 && format == FORMAT_MARKDOWN) {
            print_rule(table, stream);
        }
    }
    free(table->rows);
    *table = (struct table)TABLE_EMPTY;
    return fine;
}
