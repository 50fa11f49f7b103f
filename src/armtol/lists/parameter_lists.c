#include "armtol/lists/lists.h"

#include "armtol/names/link_name.h"
#include "armtol/tables/cells.h"
#include "console/exit_code.h"
#include "console/file_message.h"
#include "console/message.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { FIELD_LINK, FIELD_PARAMETER, FIELD_VALUE, FIELDS };

/* All that is at work while a file is read. */
typedef struct parameter_reader {
    const parameter_table *table;
    bool infinite_allowed;
    double *values;
    size_t *lines; /* n_columns: the line that a value is from; 0 where there is none yet */
    text_lines text;
    cell_row row;
    const char *names[FIELDS];
    size_t places[FIELDS]; /* of the wanted columns */
    size_t unit_place;     /* of the column `unit`; beyond every row where there is none */
} parameter_reader;

/* ---- the head row ---- */

static bool find_field(parameter_reader *reader, int field)
{
    const cell_row *row = &reader->row;
    bool found = false;
    for (size_t i = 0; i < row->n; i++) {
        if (cell_is(&row->cells[i], reader->names[field])) {
            if (found) {
                cells_message(row, i, "a second column \"%s\"", reader->names[field]);
                return false;
            }
            reader->places[field] = i;
            found = true;
        }
    }
    if (!found) {
        cells_message(row, 0, "the head row has no column \"%s\"; expected link, parameter, %s",
                      reader->names[field], reader->table->value);
    }
    return found;
}

static bool read_head(parameter_reader *reader)
{
    const line_result result = cells_next(&reader->row, &reader->text, CELLS_ANY);
    if (result == LINE_NONE) {
        message("%s: no table; expected a head row with link, parameter, %s", reader->text.path, reader->table->value);
    }
    bool fine = result == LINE_THERE;
    for (int field = 0; fine && field < FIELDS; field++) {
        fine = find_field(reader, field);
    }
    for (size_t i = 0; i < reader->row.n; i++) {
        reader->unit_place = cell_is(&reader->row.cells[i], "unit") ? i : reader->unit_place;
    }
    return fine;
}

/* ---- a row ---- */

static size_t link_count(const parameter_table *table)
{
    return table->n_columns > 0 ? table->columns[table->n_columns - 1].link + 1 : 0;
}

static bool has_all_fields(const parameter_reader *reader)
{
    for (int field = 0; field < FIELDS; field++) {
        const size_t place = reader->places[field];
        if (place >= reader->row.n || reader->row.cells[place].text[0] == '\0') {
            cells_message(&reader->row, place, "no value for \"%s\"", reader->names[field]);
            return false;
        }
    }
    return true;
}

static bool read_link(const parameter_reader *reader, size_t *link)
{
    const armtol_arm *arm = reader->table->arm;
    const size_t place = reader->places[FIELD_LINK], n_links = link_count(reader->table);
    const char *text = reader->row.cells[place].text;
    const bool whole = text[strspn(text, "0123456789")] == '\0';
    *link = whole ? (size_t)strtoul(text, NULL, 10) : link_named(arm, text); /* what is too large is strtoul's largest
    **/
    if (*link >= n_links) {
        cells_message(&reader->row, place, "link %s: expected a whole number from 0 to %zu, the last link%s",
                      message_quote(text, &(quoted){""}), n_links - 1,
                      links_have_names(arm) ? ", or the name of one" : "");
    }
    return *link < n_links;
}

/* "theta, d, a, alpha": what the link's kind counts. */
static void list_parameters(armtol_kind kind, char *text, size_t size)
{
    size_t count, length = 0;
    const armtol_parameter *parameters = armtol_kind_parameters(kind, &count);
    for (size_t i = 0; i < count && length < size; i++) {
        length += (size_t)snprintf(text + length, size - length, "%s%s", i > 0 ? ", " : "",
                                   armtol_parameter_name(parameters[i]));
    }
}

/* The column of A. */
static bool find_column(const parameter_reader *reader, size_t link, size_t *column)
{
    const parameter_table *table = reader->table;
    const cell *cell = &reader->row.cells[reader->places[FIELD_PARAMETER]];
    for (size_t k = 0; k < table->n_columns; k++) {
        if (table->columns[k].link == link && cell_is(cell, armtol_parameter_name(table->columns[k].parameter))) {
            *column = k;
            return true;
        }
    }
    char parameters[64];
    list_parameters(table->arm->links[link].kind, parameters, sizeof parameters);
    cells_message(&reader->row, reader->places[FIELD_PARAMETER],
                  "%s, of kind %s, has no parameter %s; expected %s", link_words(table->arm, link, &(link_text){""}),
                  armtol_kind_name(table->arm->links[link].kind), message_quote(cell->text, &(quoted){""}), parameters);
    return false;
}

static bool read_value(const parameter_reader *reader, double *value)
{
    const size_t place = reader->places[FIELD_VALUE];
    const cell *cell = &reader->row.cells[place];
    quoted quote;
    cell_number number;
    if (reader->infinite_allowed && (cell_is_unknown(cell) || cell_is(cell, "inf"))) {
        *value = (double)INFINITY;
        return true;
    }
    const number_fault fault = cells_number(&reader->row, place, &number);
    if (fault != NUMBER_FINE) {
        cells_message(&reader->row, place, "%s: %s %s", reader->table->value, message_quote(cell->text, &quote),
                      number_fault_text(fault));
        return false;
    }
    if (!(number.value > 0 || (reader->table->zero_allowed && number.value == 0) || reader->table->signed_allowed)) {
        cells_message(&reader->row, place, "%s: %s is %s", reader->table->value, message_quote(cell->text, &quote),
                      reader->table->zero_allowed ? "negative" : "not greater than zero");
        return false;
    }
    *value = number.value;
    return true;
}

/* A table made in other units than it is read in would be wrong without a word. */
static bool check_unit(const parameter_reader *reader, size_t column)
{
    const parameter_table *table = reader->table;
    const bool is_length = armtol_parameter_is_length(table->columns[column].parameter);
    const char *expected = is_length ? table->length_unit : table->angle_unit;
    const size_t place = reader->unit_place;
    if (expected == NULL || place >= reader->row.n || cell_is(&reader->row.cells[place], expected)) {
        return true;
    }
    cells_message(&reader->row, place, "unit %s; expected %s, as on the command line",
                  message_quote(reader->row.cells[place].text, &(quoted){""}), expected);
    return false;
}

static bool take_row(parameter_reader *reader)
{
    size_t link, column;
    if (!has_all_fields(reader) || !read_link(reader, &link) || !find_column(reader, link, &column) ||
        !check_unit(reader, column)) {
        return false;
    }
    if (reader->lines[column] > 0) {
        cells_message(&reader->row, 0, "%s of %s a second time; the first is in line %zu",
                      armtol_parameter_name(reader->table->columns[column].parameter),
                      link_words(reader->table->arm, link, &(link_text){""}), reader->lines[column]);
        return false;
    }
    reader->lines[column] = reader->row.line;
    return read_value(reader, &reader->values[column]);
}

static bool read_rows(parameter_reader *reader)
{
    const char separator = reader->row.separator;
    line_result result = cells_next(&reader->row, &reader->text, separator);
    while (result == LINE_THERE && take_row(reader)) {
        result = cells_next(&reader->row, &reader->text, separator);
    }
    return result == LINE_NONE;
}

static bool read_all(parameter_reader *reader)
{
    return read_head(reader) && read_rows(reader);
}

bool parameters_read(FILE *stream, const char *path, const parameter_table *table, bool infinite_allowed,
                     double values[])
{
    parameter_reader reader = {
        .table = table, .infinite_allowed = infinite_allowed, .values = values,
        .names = {"link", "parameter", table->value},
        .lines = calloc(table->n_columns + 1, sizeof *reader.lines),
        .unit_place = SIZE_MAX,
    };
    if (reader.lines == NULL) {
        out_of_memory();
        return false;
    }
    text_lines_start(&reader.text, stream, path);
    cells_start(&reader.row);
    const bool fine = read_all(&reader);
    text_lines_free(&reader.text);
    cells_free(&reader.row);
    free(reader.lines);
    return fine;
}
