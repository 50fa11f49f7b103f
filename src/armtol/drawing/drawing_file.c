#include "armtol/drawing/drawing_file.h"

#include "armtol/drawing/named.h"
#include "armtol/names/link_name.h"
#include "armtol/seat.h"
#include "armtol/tables/arm_model.h"
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

#define RIGHT_ANGLE 1.57079632679489661923

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

/* Whether any distance is made. */
static bool can_be_off(const armtol_link *link)
{
    return can_split(link, DRAWING_SPLIT_A) || can_split(link, DRAWING_SPLIT_D);
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

enum {
    FIELD_LINK,
    FIELD_SIDE,
    FIELD_DISTANCE,
    FIELD_ANGLE,
    FIELD_SEAT,
    FIELD_POSITION,
    FIELD_PLAY,
    FIELD_SPLIT,
    FIELD_UNIT,
    FIELDS
};

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

/* What a number of a column is. */
typedef struct number_wanted {
    const char *name;
    double most; /* it is less */
    double (*named)(const char *name, double size, const char **why); /* NULL where no names are known */
    double size; /* of named.h */
    double unit; /* of what that gives, in the file's */
} number_wanted;

/* The cell's number or, where it has none, what its name stands for; nan, and why, where it is neither. */
static double number_at(const reader *reader, size_t place, const number_wanted *wanted, const char **why)
{
    cell_number number;
    const number_fault fault = cells_number(&reader->row, place, &number);
    if (fault == NUMBER_FINE) {
        return number.value;
    }
    *why = number_fault_text(fault);
    const double value = wanted->named == NULL ? (double)NAN
                                               : wanted->named(reader->row.cells[place].text, wanted->size, why);
    *why = isnan(value) ? *why : NULL;
    return value * wanted->unit;
}

/* A number >= 0, below `most`; nan where nothing is said. */
static bool take_size(const reader *reader, size_t place, const number_wanted *wanted, double *value)
{
    const cell *cell = cell_at(reader, place);
    *value = (double)NAN;
    if (cell == NULL || cell_is_unknown(cell)) {
        return true;
    }
    const char *why = NULL;
    const double number = number_at(reader, place, wanted, &why);
    if (number < 0) {
        why = "is negative";
    } else if (number >= wanted->most) {
        why = "is not less than a right angle";
    }
    if (why == NULL) {
        *value = number;
    } else {
        cells_message(&reader->row, place, "%s: %s %s", wanted->name, message_quote(cell->text, &(quoted){""}), why);
    }
    return why == NULL;
}

static double millimetres(const reader *reader)
{
    return arm_model_millimetres(reader->view->length);
}

/* The nominal distance of the axes, in mm. */
static double distance_meant(const reader *reader, size_t number)
{
    const armtol_link *link = &reader->view->arm->links[number];
    const double d = drawing_is_parallel(link) ? 0 : link->d;
    return sqrt(link->a * link->a + d * d) * arm_model_millimetres(reader->view->arm->unit);
}

/* A plain length, which has no names. */
static bool take_length(const reader *reader, size_t place, const char *name, double *value)
{
    return take_size(reader, place, &(number_wanted){.name = name, .most = (double)INFINITY}, value);
}

static bool take_side(const reader *reader, size_t place, drawing_row *row)
{
    return take_length(reader, place, "side", &row->side);
}

static bool take_distance(const reader *reader, size_t place, drawing_row *row)
{
    char name[128] = "distance";
    if (row->is_other && !can_be_off(&reader->view->arm->links[row->link])) {
        row->distance = (double)NAN;
        return true;
    }
    if (row->is_other) { /* which link it is nobody can see */
        snprintf(name, sizeof name, "distance of %s", link_words(reader->view->arm, row->link, &(link_text){""}));
    }
    const number_wanted wanted = {name, (double)INFINITY, named_length, distance_meant(reader, row->link),
                                  1 / millimetres(reader)};
    return take_size(reader, place, &wanted, &row->distance);
}

static bool take_angle(const reader *reader, size_t place, drawing_row *row)
{
    const double most = reader->view->right_angle, side = row->side * millimetres(reader);
    const number_wanted wanted = {"angle", most, named_angle, side, most / RIGHT_ANGLE};
    return take_size(reader, place, &wanted, &row->angle);
}

/* ---- seats ---- */

static bool take_seat(const reader *reader, size_t place, drawing_row *row)
{
    const bool fine = take_length(reader, place, "seat", &row->seat);
    if (fine && row->seat == 0) {
        cells_message(&reader->row, place, "seat: the two seats are 0 apart");
    }
    return fine && row->seat != 0;
}

static bool take_position(const reader *reader, size_t place, drawing_row *row)
{
    const number_wanted wanted = {"position", (double)INFINITY, named_position, 0, 1 / millimetres(reader)};
    const bool fine = take_size(reader, place, &wanted, &row->position);
    if (fine && isnan(row->seat) != isnan(row->position)) {
        cells_message(&reader->row, place, "seat and position go together");
    }
    return fine && isnan(row->seat) == isnan(row->position);
}

/* What the seat adds to what is said of the link: a slide's axis has no place to be off. */
static bool add_seat(const reader *reader, drawing_row *row)
{
    const armtol_link *link = &reader->view->arm->links[row->link];
    const armtol_seat errors = armtol_seat_errors(row->seat, row->position, row->play);
    if (can_be_off(link)) {
        row->distance = (isnan(row->distance) ? 0 : row->distance) + errors.offset;
    }
    row->angle = (isnan(row->angle) ? 0 : row->angle) + errors.angle * (reader->view->right_angle / RIGHT_ANGLE);
    const bool fine = row->angle < reader->view->right_angle && !isinf(row->distance);
    if (!fine) {
        cells_message(&reader->row, reader->places[FIELD_SEAT],
                      "seat: with it the link may be off by a right angle or more, or by too large a number");
    }
    return fine;
}

static bool take_play(const reader *reader, size_t place, drawing_row *row)
{
    if (!take_length(reader, place, "play", &row->play)) {
        return false;
    }
    if (isnan(row->seat)) {
        if (!isnan(row->play)) {
            cells_message(&reader->row, place, "play without a seat");
        }
        return isnan(row->play);
    }
    row->play = isnan(row->play) ? 0 : row->play;
    return add_seat(reader, row);
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
    const bool fine = can_split(link, row->split);
    if (!can_be_off(link)) {
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
    const armtol_link *link = &reader->view->arm->links[row->link];
    row->split = row->is_other && !can_split(link, (drawing_split)split) ? DRAWING_SPLIT_NONE : (drawing_split)split;
    if (row->split == DRAWING_SPLIT_NONE && !isnan(row->distance)) {
        row->split = drawing_only_split(link);
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
    [FIELD_LINK] = {"link", true, take_link},
    [FIELD_SIDE] = {"side", false, take_side},
    [FIELD_DISTANCE] = {"distance", false, take_distance},
    [FIELD_ANGLE] = {"angle", false, take_angle},
    [FIELD_SEAT] = {"seat", false, take_seat},
    [FIELD_POSITION] = {"position", false, take_position},
    [FIELD_PLAY] = {"play", false, take_play},
    [FIELD_SPLIT] = {"split", false, take_split},
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
    if (fine && reader->places[FIELD_DISTANCE] == SIZE_MAX && reader->places[FIELD_ANGLE] == SIZE_MAX &&
        reader->places[FIELD_SEAT] == SIZE_MAX) {
        cells_message(&reader->row, 0, "the head row has neither \"distance\" nor \"angle\" nor \"seat\"");
        fine = false;
    }
    return fine;
}

/* ---- rows ---- */

/* NULL where nothing was said of the link. */
static const drawing_row *row_of(const drawing *drawing, size_t link)
{
    size_t i = 0;
    while (i < drawing->n_rows && drawing->rows[i].link != link) {
        i++;
    }
    return i < drawing->n_rows ? &drawing->rows[i] : NULL;
}

static bool keep_row(reader *reader, const drawing_row *row)
{
    drawing *drawing = reader->drawing;
    const drawing_row *before = row_of(drawing, row->link);
    if (before != NULL) {
        cells_message(&reader->row, 0, "%s a second time; the first is in line %zu",
                      link_words(reader->view->arm, row->link, &(link_text){""}), before->line);
        return false;
    }
    drawing_row *rows = list_room(drawing->rows, drawing->n_rows, &drawing->room, sizeof *rows);
    if (rows == NULL) {
        return false;
    }
    drawing->rows = rows;
    rows[drawing->n_rows++] = *row;
    return true;
}

/* The fields of the row at hand from the first one on. */
static bool take_fields(reader *reader, size_t first, drawing_row row)
{
    bool fine = true;
    for (size_t field = first; fine && field < FIELDS; field++) {
        fine = fields[field].take(reader, reader->places[field], &row);
    }
    return fine && keep_row(reader, &row);
}

static bool take_others(reader *reader)
{
    const drawing *drawing = reader->drawing;
    const size_t n_links = reader->view->arm->n_links;
    bool fine = true;
    for (size_t i = 0; i < drawing->n_rows; i++) {
        if (drawing->rows[i].is_other) { /* nothing is left for a second one */
            cells_message(&reader->row, 0, "others a second time; the first is in line %zu", drawing->rows[i].line);
            return false;
        }
    }
    for (size_t link = 0; fine && link < n_links; link++) {
        const drawing_row row = {.line = reader->row.line, .link = link, .is_other = true};
        fine = row_of(drawing, link) != NULL || take_fields(reader, FIELD_LINK + 1, row);
    }
    return fine;
}

static bool take_row(reader *reader)
{
    const cell *link = cell_at(reader, reader->places[FIELD_LINK]);
    return link != NULL && cell_is(link, "others")
               ? take_others(reader)
               : take_fields(reader, FIELD_LINK, (drawing_row){.line = reader->row.line});
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
