#include "armtol/tables/cells.h"

#include "console/file_message.h"
#include "console/list_room.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

void cells_start(cell_row *row)
{
    *row = (cell_row){.cells = NULL};
}

void cells_free(cell_row *row)
{
    free(row->cells);
    cells_start(row);
}

/* ---- what a character means ---- */

static bool is_blank(char separator, char c)
{
    return c == ' ' || (c == '\t' && separator != '\t');
}

/* A # begins a comment, but for a spreadsheet's word for a value that it could not work out. */
static bool begins_comment(const char *text)
{
    static const char *const faults[] = {"#REF!", "#N/A", "#VALUE!", "#NAME?", "#DIV/0!", "#NUM!", "#NULL!"};
    bool fault = false;
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        fault = fault || strncmp(text, faults[i], strlen(faults[i])) == 0;
    }
    return *text == '#' && !fault;
}

static bool ends_row(const char *text)
{
    return *text == '\0' || begins_comment(text);
}

static bool ends_cell(char separator, const char *text)
{
    return *text == separator || (separator == CELLS_BLANKS && *text == '\t') || ends_row(text);
}

static char separator_of(const char *text)
{
    static const char separators[] = "\t;,";
    size_t found = strlen(separators);
    bool inside = false;
    for (; *text != '\0' && (inside || !begins_comment(text)); text++) {
        inside = inside != (*text == '"');
        const char *separator = inside ? NULL : strchr(separators, *text);
        if (separator != NULL && (size_t)(separator - separators) < found) {
            found = (size_t)(separator - separators);
        }
    }
    return separators[found] != '\0' ? separators[found] : CELLS_BLANKS;
}

/* ---- cutting a line up ---- */

typedef struct cursor {
    cell_row *row;
    char *at;
    size_t column;
} cursor;

static void move(cursor *cursor, char *to)
{
    cursor->column += text_characters(cursor->at, to);
    cursor->at = to;
}

static void skip_blanks(cursor *cursor)
{
    while (is_blank(cursor->row->separator, *cursor->at)) {
        move(cursor, cursor->at + 1);
    }
}

static bool append(cell_row *row, const cell *cell)
{
    struct cell *cells = list_room(row->cells, row->n, &row->room, sizeof *cells);
    if (cells != NULL) {
        row->cells = cells;
        row->cells[row->n++] = *cell;
    }
    return cells != NULL;
}

static void wrong(const cursor *cursor, size_t column, const char *fault)
{
    const file_place place = {cursor->row->path, cursor->row->line, column};
    file_message(&place, "%s", fault);
}

/* Moves behind the cell; where its text ends. */
static char *take_plain(cursor *cursor)
{
    const char separator = cursor->row->separator;
    char *const begin = cursor->at, *end = begin;
    while (!ends_cell(separator, end)) {
        end++;
    }
    move(cursor, end);
    while (end > begin && is_blank(separator, end[-1])) {
        end--;
    }
    return end;
}

/* The same for a quoted cell, whose text moves together where quotes are doubled. NULL after a message. */
static char *take_quoted(cursor *cursor)
{
    const char separator = cursor->row->separator;
    const size_t column = cursor->column;
    char *end = cursor->at + 1;
    move(cursor, cursor->at + 1);
    while (*cursor->at != '\0' && (*cursor->at != '"' || cursor->at[1] == '"')) {
        *end++ = *cursor->at;
        move(cursor, cursor->at + (*cursor->at == '"' ? 2 : 1));
    }
    if (*cursor->at == '\0') {
        wrong(cursor, column, "the quoted cell does not end on this line");
        return NULL;
    }
    move(cursor, cursor->at + 1);
    const bool ends = ends_cell(separator, cursor->at);
    skip_blanks(cursor);
    if (!ends && !ends_cell(separator, cursor->at)) {
        wrong(cursor, cursor->column, "text behind the quoted cell; expected a separator or the end of the line");
        return NULL;
    }
    return end;
}

static bool take_cell(cursor *cursor)
{
    const bool quoted = *cursor->at == '"';
    const cell cell = {cursor->at + quoted, cursor->column, quoted};
    char *end = quoted ? take_quoted(cursor) : take_plain(cursor);
    if (end == NULL || !append(cursor->row, &cell)) {
        return false;
    }
    if (*cursor->at == cursor->row->separator) {
        move(cursor, cursor->at + 1);
    }
    skip_blanks(cursor);
    *end = '\0';
    return true;
}

static void cut(cell_row *row, size_t n)
{
    if (n < row->n) {
        row->n = n;
        row->end_column = row->cells[n].column;
    }
}

static void drop_empty_end(cell_row *row)
{
    size_t n = row->n;
    while (n > 0 && row->cells[n - 1].text[0] == '\0') {
        n--;
    }
    cut(row, n);
}

bool cells_split(cell_row *row, text_lines *lines, char *text, char separator)
{
    row->path = lines->path;
    row->line = lines->number;
    row->separator = separator == CELLS_ANY ? separator_of(text) : separator;
    row->n = 0;
    cursor cursor = {row, text, 1 + text_characters(lines->text, text)};
    skip_blanks(&cursor);
    while (!ends_row(cursor.at)) {
        if (!take_cell(&cursor)) {
            return false;
        }
    }
    row->end_column = cursor.column;
    drop_empty_end(row);
    return true;
}

void cells_drop_comment(cell_row *row)
{
    for (size_t i = 0; i < row->n; i++) {
        if (begins_comment(row->cells[i].text)) {
            cut(row, i);
        }
    }
    drop_empty_end(row);
}

line_result cells_next(cell_row *row, text_lines *lines, char separator)
{
    line_result result;
    do {
        result = text_lines_next(lines);
        if (result == LINE_THERE && !cells_split(row, lines, lines->text, separator)) {
            return LINE_WRONG;
        }
        if (result == LINE_THERE) {
            cells_drop_comment(row);
        }
    } while (result == LINE_THERE && row->n == 0);
    return result;
}

bool cells_each(FILE *stream, const char *path, cell_row_taker *take, void *context)
{
    text_lines lines;
    cell_row row;
    line_result result;
    text_lines_start(&lines, stream, path);
    cells_start(&row);
    do {
        result = cells_next(&row, &lines, CELLS_ANY);
    } while (result == LINE_THERE && take(&row, context));
    text_lines_free(&lines);
    cells_free(&row);
    return result == LINE_NONE;
}

/* ---- what is in a cell ---- */

void cells_message(const cell_row *row, size_t index, const char *format, ...)
{
    const file_place place = {row->path, row->line, index < row->n ? row->cells[index].column : row->end_column};
    va_list arguments;
    va_start(arguments, format);
    file_message_list(&place, format, arguments);
    va_end(arguments);
}

bool cell_is(const cell *cell, const char *word)
{
    return strcasecmp(cell->text, word) == 0;
}

bool cell_is_unknown(const cell *cell)
{
    const size_t minus = number_typeset_minus(cell->text);
    return cell->text[0] == '\0' || cell_is(cell, "-") || (minus > 0 && cell->text[minus] == '\0');
}

number_fault cells_number(const cell_row *row, size_t index, cell_number *number)
{
    const bool decimal_comma = row->separator == '\t' || row->separator == ';';
    size_t length = 0;
    for (const char *from = row->cells[index].text; *from != '\0'; length++) {
        if (length == sizeof number->text - 1) {
            return NUMBER_TOO_LONG;
        }
        const size_t minus = number_typeset_minus(from);
        number->text[length] = minus > 0 ? '-' : *from == ',' && decimal_comma ? '.' : *from;
        from += minus > 0 ? minus : 1;
    }
    number->text[length] = '\0';
    return number_parse(number->text, &number->value);
}
