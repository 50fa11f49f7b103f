#include "armtol/lists/parameter_rows.h"

#include "armtol/names/link_name.h"
#include "console/exit_code.h"
#include "console/file_message.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- the head row ---- */

/* Where there is none of that name its place is beyond every row. */
static bool find_field(parameter_rows *rows, int field)
{
    const cell_row *row = &rows->row;
    bool found = false;
    rows->places[field] = SIZE_MAX;
    for (size_t i = 0; i < row->n; i++) {
        if (cell_is(&row->cells[i], rows->names[field])) {
            if (found) {
                cells_message(row, i, "a second column \"%s\"", rows->names[field]);
                return false;
            }
            rows->places[field] = i;
            found = true;
        }
    }
    if (!found && !rows->optional[field]) {
        cells_message(row, 0, "the head row has no column \"%s\"; expected link, parameter, %s",
                      rows->names[field], rows->table->value);
    }
    return found || rows->optional[field];
}

static bool read_head(parameter_rows *rows)
{
    const line_result result = cells_next(&rows->row, &rows->text, CELLS_ANY);
    if (result == LINE_NONE) {
        message("%s: no table; expected a head row with link, parameter, %s", rows->text.path, rows->table->value);
    }
    bool fine = result == LINE_THERE && rows->settle(rows);
    for (int field = 0; fine && field < rows->n_fields; field++) {
        fine = find_field(rows, field);
    }
    for (size_t i = 0; i < rows->row.n; i++) {
        rows->unit_place = cell_is(&rows->row.cells[i], "unit") ? i : rows->unit_place;
    }
    return fine;
}

/* ---- a row ---- */

static size_t link_count(const parameter_table *table)
{
    return table->n_columns > 0 ? table->columns[table->n_columns - 1].link + 1 : 0;
}

static bool has_all_fields(const parameter_rows *rows)
{
    for (int field = 0; field < rows->n_fields; field++) {
        const size_t place = rows->places[field];
        if (rows->optional[field]) {
            continue;
        }
        if (place >= rows->row.n || rows->row.cells[place].text[0] == '\0') {
            cells_message(&rows->row, place, "no value for \"%s\"", rows->names[field]);
            return false;
        }
    }
    return true;
}

static bool read_link(const parameter_rows *rows, size_t *link)
{
    const armtol_arm *arm = rows->table->arm;
    const size_t place = rows->places[FIELD_LINK], n_links = link_count(rows->table);
    const char *text = rows->row.cells[place].text;
    const bool whole = text[strspn(text, "0123456789")] == '\0';
    *link = whole ? (size_t)strtoul(text, NULL, 10) : link_named(arm, text); /* what is too large is strtoul's largest
    **/
    if (*link >= n_links) {
        cells_message(&rows->row, place, "link %s: expected a whole number from 0 to %zu, the last link%s",
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
static bool find_column(const parameter_rows *rows, size_t link, size_t *column)
{
    const parameter_table *table = rows->table;
    const cell *cell = &rows->row.cells[rows->places[FIELD_PARAMETER]];
    for (size_t k = 0; k < table->n_columns; k++) {
        if (table->columns[k].link == link && cell_is(cell, armtol_parameter_name(table->columns[k].parameter))) {
            *column = k;
            return true;
        }
    }
    char parameters[64];
    list_parameters(table->arm->links[link].kind, parameters, sizeof parameters);
    cells_message(&rows->row, rows->places[FIELD_PARAMETER],
                  "%s, of kind %s, has no parameter %s; expected %s", link_words(table->arm, link, &(link_text){""}),
                  armtol_kind_name(table->arm->links[link].kind), message_quote(cell->text, &(quoted){""}), parameters);
    return false;
}

/* A table made in other units than it is read in would be wrong without a word. */
static bool check_unit(const parameter_rows *rows, size_t column)
{
    const parameter_table *table = rows->table;
    const bool is_length = armtol_parameter_is_length(table->columns[column].parameter);
    const char *expected = is_length ? table->length_unit : table->angle_unit;
    const size_t place = rows->unit_place;
    if (expected == NULL || place >= rows->row.n || cell_is(&rows->row.cells[place], expected)) {
        return true;
    }
    cells_message(&rows->row, place, "unit %s; expected %s, as on the command line",
                  message_quote(rows->row.cells[place].text, &(quoted){""}), expected);
    return false;
}

static bool take_row(parameter_rows *rows)
{
    size_t link, column;
    if (!has_all_fields(rows) || !read_link(rows, &link) || !find_column(rows, link, &column) ||
        !check_unit(rows, column)) {
        return false;
    }
    if (rows->lines[column] > 0) {
        cells_message(&rows->row, 0, "%s of %s a second time; the first is in line %zu",
                      armtol_parameter_name(rows->table->columns[column].parameter),
                      link_words(rows->table->arm, link, &(link_text){""}), rows->lines[column]);
        return false;
    }
    rows->lines[column] = rows->row.line;
    return rows->take(rows, column);
}

static bool read_rows(parameter_rows *rows)
{
    const char separator = rows->row.separator;
    line_result result = cells_next(&rows->row, &rows->text, separator);
    while (result == LINE_THERE && take_row(rows)) {
        result = cells_next(&rows->row, &rows->text, separator);
    }
    return result == LINE_NONE;
}

bool parameter_rows_each(parameter_rows *rows, FILE *stream, const char *path)
{
    rows->names[FIELD_LINK] = "link";
    rows->names[FIELD_PARAMETER] = "parameter";
    rows->unit_place = SIZE_MAX;
    rows->lines = calloc(rows->table->n_columns + 1, sizeof *rows->lines);
    if (rows->lines == NULL) {
        out_of_memory();
        return false;
    }
    text_lines_start(&rows->text, stream, path);
    cells_start(&rows->row);
    const bool fine = read_head(rows) && read_rows(rows);
    text_lines_free(&rows->text);
    cells_free(&rows->row);
    free(rows->lines);
    return fine;
}

const cell *parameter_rows_cell(const parameter_rows *rows, int field)
{
    const size_t place = rows->places[field];
    const bool there = place < rows->row.n && !cell_is_unknown(&rows->row.cells[place]);
    return there ? &rows->row.cells[place] : NULL;
}

bool parameter_rows_number(const parameter_rows *rows, int field, double *value)
{
    const size_t place = rows->places[field];
    cell_number number;
    const number_fault fault = cells_number(&rows->row, place, &number);
    if (fault != NUMBER_FINE) {
        cells_message(&rows->row, place, "%s: %s %s", rows->names[field],
                      message_quote(rows->row.cells[place].text, &(quoted){""}), number_fault_text(fault));
        return false;
    }
    *value = number.value;
    return true;
}
