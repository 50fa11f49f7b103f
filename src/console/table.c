#include "console/table.h"

#include "console/list_room.h"
#include "console/message.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 80 };

bool table_format_parse(const char *name, table_format *format)
{
    static const char *const names[FORMAT_COUNT] = {"text", "markdown", "tsv"};
    const size_t i = word_among(name, names, FORMAT_COUNT);
    if (i == FORMAT_COUNT) {
        message("--format: unknown format %s; expected text, markdown or tsv", message_quote(name, &(quoted){""}));
        return false;
    }
    *format = (table_format)i;
    return true;
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

/* Of UTF-8: all but the first byte of a character are 10xxxxxx. */
static size_t characters_of(const char *text)
{
    size_t count = 0;
    for (; *text != '\0'; text++) {
        count += ((unsigned char)*text & 0xc0) != 0x80;
    }
    return count;
}

static void measure(table *table)
{
    for (size_t j = 0; j < table->n_columns; j++) {
        table->widths[j] = 3; /* what Markdown's rule needs */
        for (size_t i = 0; i < table->n_rows; i++) {
            const int length = (int)characters_of(table->rows[i].cells[j]);
            table->widths[j] = length > table->widths[j] ? length : table->widths[j];
        }
    }
}

/* The columns that say what a row is about, the first and n_more, and those from `begin` on up to `end`. */
typedef struct table_part {
    size_t begin, end;
} table_part;

static void print_row(const table *table, const table_row *row, table_part part, table_format format, FILE *stream)
{
    static const char *const begin[FORMAT_COUNT] = {"  ", "| ", ""};
    static const char *const between[FORMAT_COUNT] = {"  ", " | ", "\t"};
    static const char *const end[FORMAT_COUNT] = {"\n", " |\n", "\n"};
    fputs(begin[format], stream);
    for (size_t j = 0; j < part.end; j = j == table->n_more ? part.begin : j + 1) {
        const char *cell = row->cells[j];
        const int more = (int)(strlen(cell) - characters_of(cell)); /* printf counts bytes */
        const int width = format == FORMAT_TSV ? 0 : table->widths[j] + more;
        fprintf(stream, j == 0 ? "%-*s" : "%*s", width, cell);
        fputs(j + 1 < part.end ? between[format] : end[format], stream);
    }
}

/* Markdown's line below the head: a colon aligns a column to the right. */
static void print_rule(const table *table, FILE *stream)
{
    for (size_t j = 0; j < table->n_columns; j++) {
        fputc('|', stream);
        for (int i = table->widths[j] + (j == 0 ? 2 : 1); i > 0; i--) {
            fputc('-', stream);
        }
        fputs(j == 0 ? "" : ":", stream);
    }
    fputs("|\n", stream);
}

static void print_rows(const table *table, table_part part, table_format format, FILE *stream)
{
    for (size_t i = 0; i < table->n_rows; i++) {
        print_row(table, &table->rows[i], part, format, stream);
        if (i == 0 && format == FORMAT_MARKDOWN) {
            print_rule(table, stream);
        }
    }
}

/* The columns from `begin` on that a line of text has room for, one at the least. */
static table_part part_from(const table *table, size_t begin)
{
    table_part part = {begin, begin};
    int width = 0;
    for (size_t j = 0; j <= table->n_more; j++) {
        width += 2 + table->widths[j];
    }
    do {
        width += 2 + table->widths[part.end++];
    } while (part.end < table->n_columns && width + 2 + table->widths[part.end] <= LINE);
    return part;
}

static int width_of_all(const table *table)
{
    int width = 0;
    for (size_t j = 0; j < table->n_columns; j++) {
        width += 2 + table->widths[j];
    }
    return width;
}

/* To so many characters, the last two of them dots. */
static void cut_cell(char *cell, int characters)
{
    char *end = cell;
    if (characters_of(cell) <= (size_t)characters) {
        return;
    }
    for (int i = 0; i < characters - 2; i++) {
        for (end++; ((unsigned char)*end & 0xc0) == 0x80; end++) {
        }
    }
    strcpy(end, "..");
}

/* If a line has room for the table then. */
static void cut_first(table *table)
{
    enum { LEAST = 8 };
    const int width = table->widths[0] - (width_of_all(table) - LINE);
    for (size_t i = 0; i < table->n_rows && width >= LEAST && table->cut_first; i++) {
        cut_cell(table->rows[i].cells[0], width);
    }
    measure(table);
}

/* A table that is wider than a line comes in parts below each other. */
static void print_parts(const table *table, FILE *stream)
{
    const size_t first = table->n_more + 1;
    for (table_part part = {first, first}; part.end < table->n_columns;) {
        fputs(part.end > first ? "\n" : "", stream);
        part = part_from(table, part.end);
        print_rows(table, part, FORMAT_TEXT, stream);
    }
}

bool table_finish(table *table, const char *title, const char *remark, table_format format, FILE *stream)
{
    const bool fine = !table->failed;
    measure(table);
    if (fine && title != NULL) {
        table_print_title(title, remark, format, stream);
    }
    if (fine && format == FORMAT_TEXT && table->n_columns > table->n_more + 1) {
        cut_first(table);
        print_parts(table, stream);
    } else if (fine) {
        print_rows(table, (table_part){table->n_more + 1, table->n_columns}, format, stream);
    }
    free(table->rows);
    *table = (struct table)TABLE_EMPTY;
    return fine;
}
