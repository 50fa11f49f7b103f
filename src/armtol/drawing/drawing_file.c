#include "armtol/drawing/drawing_file.h"

#include "armtol/names/link_name.h"
#include "armtol/tables/cells.h"
#include "console/list_room.h"
#include "console/message.h"
#include "console/word.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- what a link has ---- */

static const char *const split_names[] = {"-", "a", "d", "even"};

enum { SPLITS = sizeof split_names / sizeof split_names[0] };

const char *drawing_split_name(drawing_split split)
{
    return split_names[split];
}

bool drawing_is_parallel(const armtol_link *link)
{
    return link->kind == ARMTOL_PPR || link->kind == ARMTOL_PPP;
}

/* Whether it can be in error and no motor moves it. */
static bool is_made(const armtol_link *link, armtol_parameter parameter)
{
    size_t count;
    const armtol_parameter *parameters = armtol_kind_parameters(link->kind, &count);
    bool counts = false;
    for (size_t i = 0; i < count; i++) {
        counts = counts || parameters[i] == parameter;
    }
    return counts && !armtol_joint_moves(link->joint, parameter);
}

/* The axis of a slide is a direction without a place: unless it is parallel to the next it has no distance. */
static bool has_distance(const armtol_link *link)
{
    return link->joint != ARMTOL_PRISMATIC || drawing_is_parallel(link);
}

static bool can_split(const armtol_link *link, drawing_split split)
{
    const bool a = has_distance(link) && is_made(link, ARMTOL_A), d = has_distance(link) && is_made(link, ARMTOL_D);
    return split == DRAWING_SPLIT_A ? a : split == DRAWING_SPLIT_D ? d : split == DRAWING_SPLIT_EVEN && a && d;
}

bool drawing_splits_evenly(const armtol_link *link)
{
    return can_split(link, DRAWING_SPLIT_EVEN);
}

drawing_split drawing_only_split(const armtol_link *link)
{
    const bool a = can_split(link, DRAWING_SPLIT_A), d = can_split(link, DRAWING_SPLIT_D);
    return a == d ? DRAWING_SPLIT_NONE : a ? DRAWING_SPLIT_A : DRAWING_SPLIT_D;
}

/* ---- columns ---- */

/* All that is at work while a file is read. */
typedef struct reader reader;

/* What a row may say, each in a column of its name. */
typedef struct field {
    const char *name;
    bool needed; /* in the head row */
    bool (*take)(const reader *reader, size_t place, drawing_row *row); /* the cell there; false after a message */
} field;

enum { FIELD_LINK, FIELD_DISTANCE, FIELD_ANGLE, FIELD_SPLIT, FIELD_UNIT, FIELDS };

struct reader {
    const drawing_view *view;
    drawing *drawing;
    text_lines text;
    cell_row row;
    size_t places[FIELDS]; /* SIZE_MAX for a column that the file does not have */
};

/* The cell of a column; NULL where the row has none, or an empty one. */
static const cell *cell_at(const reader *reader, size_t place)
{
    const bool there = place < reader->row.n && reader->row.cells[place].text[0] != '\0';
    return there ? &reader->row.cells[place] : NULL;
}

static bool take_link(const reader *reader, size_t place, drawing_row *row)
{
    const armtol_arm *arm = reader->view->arm;
    const cell *cell = cell_at(reader, place);
    const char *text = cell != NULL ? cell->text : "";
    const bool whole = text[strspn(text, "0123456789")] == '\0';
    row->link = cell == NULL ? arm->n_links : whole ? (size_t)strtoul(text, NULL, 10) : link_named(arm, text);
    if (row->link >= arm->n_links) {
        cells_message(&reader->row, place, "link %s: expected a whole number from 0 to %zu, the last link%s",
                      message_quote(text, &(quoted){""}), arm->n_links - 1,
                      links_have_names(arm) ? ", or the name of one" : "");
    }
    return row->link < arm->n_links;
}

/* A number >= 0, below `most`; nan where nothing is said. */
static bool take_size(const reader *reader, size_t place, const char *name, double most, double *value)
{
    const cell *cell = cell_at(reader, place);
    cell_number number;
    *value = (double)NAN;
    if (cell == NULL || cell_is_unknown(cell)) {
        return true;
    }
    const char *text = message_quote(cell->text, &(quoted){""});
    const number_fault fault = cells_number(&reader->row, place, &number);
    if (fault != NUMBER_FINE) {
        cells_message(&reader->row, place, "%s: %s %s", name, text, number_fault_text(fault));
    } else if (number.value < 0) {
        cells_message(&reader->row, place, "%s: %s is negative", name, text);
    } else if (number.value >= most) {
        cells_message(&reader->row, place, "%s: %s is not less than a right angle", name, text);
    } else {
        *value = number.value;
    }
    return !isnan(*value);
}

static bool take_distance(const reader *reader, size_t place, drawing_row *row)
{
    return take_size(reader, place, "distance", (double)INFINITY, &row->distance);
}

static bool take_angle(const reader *reader, size_t place, drawing_row *row)
{
    return take_size(reader, place, "angle", reader->view->right_angle, &row->angle);
}

/* The link and the distance are known by now. */
static bool check_split(const reader *reader, size_t place, const drawing_row *row)
{
    const armtol_arm *arm = reader->view->arm;
    const armtol_link *link = &arm->links[row->link];
    const char *words = link_words(arm, row->link, &(link_text){""});
    if (isnan(row->distance)) {
        if (row->split != DRAWING_SPLIT_NONE) {
            cells_message(&reader->row, place, "split %s of %s without a distance", drawing_split_name(row->split),
                          words);
        }
        return row->split == DRAWING_SPLIT_NONE;
    }
    const bool any = can_split(link, DRAWING_SPLIT_A) || can_split(link, DRAWING_SPLIT_D);
    const bool fine = can_split(link, row->split);
    if (!any) {
        cells_message(&reader->row, reader->places[FIELD_DISTANCE], "%s, of kind %s, has no distance that is made; "
                      "expected -", words, armtol_kind_name(link->kind));
    } else if (!fine) {
        const drawing_split only = drawing_only_split(link);
        cells_message(&reader->row, place, "split %s of %s, of kind %s: expected %s", drawing_split_name(row->split),
                      words, armtol_kind_name(link->kind),
                      only == DRAWING_SPLIT_NONE ? "a, d or even" : drawing_split_name(only));
    }
    return fine;
}

static bool take_split(const reader *reader, size_t place, drawing_row *row)
{
    const cell *cell = cell_at(reader, place);
    size_t split = 0;
    if (cell != NULL && !cell_is_unknown(cell)) {
        while (split < SPLITS && !cell_is(cell, split_names[split])) {
            split++;
        }
        if (split == SPLITS) {
            cells_message(&reader->row, place, "split: unknown word %s; expected a, d or even",
                          message_quote(cell->text, &(quoted){""}));
            return false;
        }
    }
    row->split = (drawing_split)split;
    if (split == DRAWING_SPLIT_NONE && !isnan(row->distance)) {
        row->split = drawing_only_split(&reader->view->arm->links[row->link]);
    }
    return check_split(reader, place, row);
}

/* A table made in other units than it is read in would be wrong without a word. */
static bool take_unit(const reader *reader, size_t place, drawing_row *row)
{
    char expected[WORD];
    const cell *cell = cell_at(reader, place);
    (void)row;
    snprintf(expected, sizeof expected, "%s %s", reader->view->length_unit, reader->view->angle_unit);
    if (cell == NULL || cell_is(cell, expected)) {
        return true;
    }
    cells_message(&reader->row, place, "unit %s; expected %s, as on the command line",
                  message_quote(cell->text, &(quoted){""}), expected);
    return false;
}

/* In the order in which the cells of a row are looked at, whatever order its columns have. */
static const field fields[FIELDS] = {
    [FIELD_LINK] = {"link", true, take_link},          [FIELD_DISTANCE] = {"distance", false, take_distance},
    [FIELD_ANGLE] = {"angle", false, take_angle},      [FIELD_SPLIT] = {"split", false, take_split},
    [FIELD_UNIT] = {"unit", false, take_unit},
};

/* ---- the head row ---- */

static bool find_field(reader *reader, size_t field)
{
    const cell_row *row = &reader->row;
    for (size_t i = 0; i < row->n; i++) {
        if (cell_is(&row->cells[i], fields[field].name)) {
            if (reader->places[field] != SIZE_MAX) {
                cells_message(row, i, "a second column \"%s\"", fields[field].name);
                return false;
            }
            reader->places[field] = i;
        }
    }
    const bool fine = reader->places[field] != SIZE_MAX || !fields[field].needed;
    if (!fine) {
        cells_message(row, 0, "the head row has no column \"%s\"; expected link, distance, angle, split",
                      fields[field].name);
    }
    return fine;
}

static bool read_head(reader *reader)
{
    const line_result result = cells_next(&reader->row, &reader->text, CELLS_ANY);
    if (result == LINE_NONE) {
        message("%s: no table; expected a head row with link, distance, angle, split", reader->text.path);
    }
    bool fine = result == LINE_THERE;
    for (size_t field = 0; fine && field < FIELDS; field++) {
        fine = find_field(reader, field);
    }
    if (fine && reader->places[FIELD_DISTANCE] == SIZE_MAX && reader->places[FIELD_ANGLE] == SIZE_MAX) {
        cells_message(&reader->row, 0, "the head row has neither \"distance\" nor \"angle\"");
        fine = false;
    }
    return fine;
}

/* ---- rows ---- */

static bool keep_row(reader *reader, const drawing_row *row)
{
    drawing *drawing = reader->drawing;
    for (size_t i = 0; i < drawing->n_rows; i++) {
        if (drawing->rows[i].link == row->link) {
            cells_message(&reader->row, 0, "%s a second time; the first is in line %zu",
                          link_words(reader->view->arm, row->link, &(link_text){""}), drawing->rows[i].line);
            return false;
        }
    }
    drawing_row *rows = list_room(drawing->rows, drawing->n_rows, &drawing->room, sizeof *rows);
    if (rows == NULL) {
        return false;
    }
    drawing->rows = rows;
    rows[drawing->n_rows++] = *row;
    return true;
}

static bool take_row(reader *reader)
{
    drawing_row row = {.line = reader->row.line};
    bool fine = true;
    for (size_t field = 0; fine && field < FIELDS; field++) {
        fine = fields[field].take(reader, reader->places[field], &row);
    }
    return fine && keep_row(reader, &row);
}

static bool read_rows(reader *reader)
{
    const char separator = reader->row.separator;
    line_result result = cells_next(&reader->row, &reader->text, separator);
    while (result == LINE_THERE && take_row(reader)) {
        result = cells_next(&reader->row, &reader->text, separator);
    }
    return result == LINE_NONE;
}

bool drawing_read(FILE *stream, const char *path, const drawing_view *view, drawing *drawing)
{
    reader reader = {.view = view, .drawing = drawing};
    *drawing = (struct drawing){.n_rows = 0};
    for (size_t field = 0; field < FIELDS; field++) {
        reader.places[field] = SIZE_MAX;
    }
    text_lines_start(&reader.text, stream, path);
    cells_start(&reader.row);
    const bool fine = read_head(&reader) && read_rows(&reader);
    text_lines_free(&reader.text);
    cells_free(&reader.row);
    return fine;
}

void drawing_free(drawing *drawing)
{
    free(drawing->rows);
}
