#include "armtol/tables/arm_row.h"

#include "armtol/tables/degrees.h"
#include "armtol/tables/expression.h"
#include "console/message.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The row at hand. */
typedef struct row_reader {
    const cell_row *cells;
    const arm_columns *columns;
    angle_unit angle_unit;
    size_t index;
    arm_entry entry;
} row_reader;

static bool is_known(const row_reader *reader, arm_column column)
{
    const size_t place = reader->columns->place[column];
    return place != NO_PLACE && place < reader->cells->n && !cell_is_unknown(&reader->cells->cells[place]);
}

static bool check_length(const row_reader *reader)
{
    const cell_row *cells = reader->cells;
    if (cells->n > reader->columns->n) {
        cells_message(cells, reader->columns->n, "a cell too many; the head row names %zu columns", reader->columns->n);
        return false;
    }
    if (cells->separator == CELLS_BLANKS && cells->n < reader->columns->n) {
        cells_message(cells, cells->n, "%zu cells, but the head row names %zu columns; expected a - for what is not "
                                       "known", cells->n, reader->columns->n);
        return false;
    }
    return true;
}

/* ---- one cell ---- */

/* A tab sets cells of tables apart; a spreadsheet's word for a value that it could not work out is no name. */
static bool read_name(row_reader *reader, size_t place)
{
    const char *name = reader->cells->cells[place].text;
    if (*name == '#' || strchr(name, '\t') != NULL) {
        cells_message(reader->cells, place, "name: %s %s", message_quote(name, &(quoted){""}),
                      *name == '#' ? "begins with #" : "has a tab in it");
        return false;
    }
    reader->entry.name = name;
    return true;
}

static bool read_kind(row_reader *reader, size_t place)
{
    const cell *cell = &reader->cells->cells[place];
    armtol_kind kind = 0;
    while (kind < ARMTOL_KIND_COUNT && !cell_is(cell, armtol_kind_name(kind))) {
        kind++;
    }
    reader->entry.link.kind = kind;
    if (kind == ARMTOL_KIND_COUNT && !cell_is(cell, "auto")) {
        cells_message(reader->cells, place, "unknown kind %s; expected npr, npp, ppr, ppp or auto",
                      message_quote(cell->text, &(quoted){""}));
        return false;
    }
    return true;
}

static bool read_joint(row_reader *reader, size_t place)
{
    static const struct {
        const char *name;
        armtol_joint joint;
    } names[] = {{"theta", ARMTOL_REVOLUTE}, {"revolute", ARMTOL_REVOLUTE},
                 {"d", ARMTOL_PRISMATIC},    {"prismatic", ARMTOL_PRISMATIC},
                 {"fixed", ARMTOL_FIXED}};
    const cell *cell = &reader->cells->cells[place];
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (cell_is(cell, names[i].name)) {
            reader->entry.link.joint = names[i].joint;
            return true;
        }
    }
    cells_message(reader->cells, place, "unknown joint %s; expected theta (revolute), d (prismatic) or fixed",
                  message_quote(cell->text, &(quoted){""}));
    return false;
}

/* A joint without an end: the least value may be -inf, the largest inf. */
static bool is_endless(arm_column column, const char *text, double *value)
{
    const bool sign = *text == '-' || *text == '+', negative = *text == '-';
    const bool infinite = strcasecmp(text + sign, "inf") == 0 || strcasecmp(text + sign, "infinity") == 0;
    *value = negative ? -(double)INFINITY : (double)INFINITY;
    return infinite && column == (negative ? COLUMN_LOW : COLUMN_HIGH);
}

static bool wrong_number(const row_reader *reader, arm_column column, size_t place, const char *fault)
{
    cells_message(reader->cells, place, "%s: %s %s", arm_column_name(column),
                  message_quote(reader->cells->cells[place].text, &(quoted){""}), fault);
    return false;
}

/* Of degrees, pi is a number that nobody means. */
static bool read_expression(row_reader *reader, arm_column column, size_t place, cell_number *number)
{
    bool has_pi;
    const number_fault fault = expression_parse(number->text, &number->value, &has_pi);
    if (fault != NUMBER_FINE) {
        return wrong_number(reader, column, place, number_fault_text(fault));
    }
    const bool fine = !has_pi || reader->angle_unit == UNIT_RADIAN || column == COLUMN_MULTIPLIER;
    return fine || wrong_number(reader, column, place, "has pi in it, and the table is in degrees");
}

static bool read_plain(const row_reader *reader, arm_column column, size_t place, number_fault fault,
                       cell_number *number)
{
    if (fault == NUMBER_NOT_FINITE && is_endless(column, number->text, &number->value)) {
        fault = NUMBER_FINE;
    }
    return fault == NUMBER_FINE || wrong_number(reader, column, place, number_fault_text(fault));
}

/* Stiffness and bits, which stand for numbers that they must not make infinite. */
static bool check_other_word(const row_reader *reader, arm_column column, size_t place, double value)
{
    enum { MOST_BITS = 64 };
    const bool bits = column == COLUMN_BITS;
    const bool fine = bits ? value >= 1 && value <= MOST_BITS && value == floor(value) : isfinite(1 / value);
    return fine || wrong_number(reader, column, place,
                                bits ? "is no whole number from 1 to 64" : "is not greater than zero");
}

static bool read_number(row_reader *reader, arm_column column, size_t place)
{
    cell_number number;
    const number_fault fault = cells_number(reader->cells, place, &number);
    const bool fine = fault == NUMBER_NONE && is_expression(number.text)
                          ? read_expression(reader, column, place, &number)
                          : read_plain(reader, column, place, fault, &number);
    if (!fine) {
        return false;
    }
    if (column >= COLUMN_BACKLASH && column <= COLUMN_MASS && number.value < 0) {
        return wrong_number(reader, column, place, "is negative");
    }
    if (column == COLUMN_SIGN && number.value != 1 && number.value != -1) {
        return wrong_number(reader, column, place, "is neither 1 nor -1");
    }
    if ((column == COLUMN_BITS || column == COLUMN_STIFFNESS) &&
        !check_other_word(reader, column, place, number.value)) {
        return false;
    }
    *arm_column_number(column, &reader->entry) = number.value;
    return true;
}

/* Which row it is, is looked at when all are there. */
static bool read_couple(row_reader *reader, size_t place)
{
    enum { MOST_DIGITS = 6 };
    const char *text = reader->cells->cells[place].text;
    const size_t digits = strspn(text, "0123456789");
    if (digits > MOST_DIGITS || text[digits] != '\0') {
        return wrong_number(reader, COLUMN_COUPLE, place, "is not the number of a row");
    }
    reader->entry.motion.follows = (size_t)strtoul(text, NULL, 10);
    return true;
}

static bool read_cell(row_reader *reader, arm_column column)
{
    const size_t place = reader->columns->place[column];
    if (!is_known(reader, column)) {
        if (!arm_column_is_optional(column)) {
            cells_message(reader->cells, place, "no value for \"%s\"", arm_column_name(column));
        }
        return arm_column_is_optional(column);
    }
    switch (column) {
    case COLUMN_NAME:
        return read_name(reader, place);
    case COLUMN_KIND:
        return read_kind(reader, place);
    case COLUMN_JOINT:
        return read_joint(reader, place);
    case COLUMN_COUPLE:
        return read_couple(reader, place);
    default:
        return read_number(reader, column, place);
    }
}

/* ---- the row as a whole ---- */

/*
 * The number was fine in degrees, and is read once more: with one rounding from the text to radians. Of an expression
 * the text is that of its value.
 */
static void convert(row_reader *reader, arm_column column)
{
    cell_number number;
    double *const value = arm_column_number(column, &reader->entry);
    const number_fault fault = cells_number(reader->cells, reader->columns->place[column], &number);
    if (fault == NUMBER_NONE) {
        snprintf(number.text, sizeof number.text, "%.17g", *value);
    }
    *value = isfinite(*value) ? degrees_parse(number.text) : *value;
}

static void convert_angles(row_reader *reader)
{
    for (arm_column column = 0; column < ARM_COLUMNS; column++) {
        if (arm_column_is_angle(column, reader->entry.link.joint) && is_known(reader, column)) {
            convert(reader, column);
        }
    }
    if (reader->entry.link.joint == ARMTOL_REVOLUTE) { /* of a degree: a radian is stiffer by as much as it is larger */
        reader->entry.stiffness *= 180 / 3.14159265358979323846;
    }
}

/* A fixed link may be of any kind: the kind only says which of its parameters can be in error. */
static bool check_kind(const row_reader *reader)
{
    const armtol_kind kind = reader->entry.link.kind;
    const bool prismatic = kind == ARMTOL_NPP || kind == ARMTOL_PPP;
    const bool given = kind < ARMTOL_KIND_COUNT, fixed = reader->entry.link.joint == ARMTOL_FIXED;
    if (given && !fixed && prismatic != (reader->entry.link.joint == ARMTOL_PRISMATIC)) {
        cells_message(reader->cells, reader->columns->place[COLUMN_KIND],
                      "a link whose joint is %s cannot be %s; expected %s", arm_joint_name(reader->entry.link.joint),
                      armtol_kind_name(kind), prismatic ? "npr or ppr" : "npp or ppp");
        return false;
    }
    return true;
}

/*
 * What is said of a motion or drive that is not there, or that would count for nothing, is a mistake elsewhere in the
 * row.
 */
static bool check_fixed(const row_reader *reader)
{
    const bool fixed = reader->entry.link.joint == ARMTOL_FIXED;
    for (arm_column column = 0; column < ARM_COLUMNS; column++) {
        if (fixed && (arm_column_is_motion(column) || arm_column_is_drive(column)) && is_known(reader, column)) {
            cells_message(reader->cells, reader->columns->place[column],
                          "a fixed link has no %s; expected - or an empty cell", arm_column_name(column));
            return false;
        }
    }
    return true;
}

/* A dash could mean a minus. */
static bool check_sign(const row_reader *reader)
{
    const size_t place = reader->columns->place[COLUMN_SIGN];
    const bool dash = place < reader->cells->n && !is_known(reader, COLUMN_SIGN) &&
                      reader->cells->cells[place].text[0] != '\0';
    return !dash || reader->entry.link.joint == ARMTOL_FIXED ||
           wrong_number(reader, COLUMN_SIGN, place, "is neither 1 nor -1");
}

static bool check_couple(const row_reader *reader)
{
    if (is_known(reader, COLUMN_COUPLE) && reader->entry.motion.follows == reader->index) {
        cells_message(reader->cells, reader->columns->place[COLUMN_COUPLE],
                      "couple: the joint follows that of row %zu, which is its own", reader->index);
        return false;
    }
    for (arm_column column = COLUMN_MULTIPLIER; column <= COLUMN_OFFSET; column++) {
        if (is_known(reader, column) && !is_known(reader, COLUMN_COUPLE)) {
            cells_message(reader->cells, reader->columns->place[column],
                          "%s without couple; expected the number of the row whose joint this one follows",
                          arm_column_name(column));
            return false;
        }
    }
    return true;
}

static bool say_twice(const row_reader *reader, arm_column column, arm_column other)
{
    cells_message(reader->cells, reader->columns->place[column], "%s beside %s; expected one of the two",
                  arm_column_name(column), arm_column_name(other));
    return false;
}

static bool check_words(const row_reader *reader)
{
    const bool compliance = is_known(reader, COLUMN_COMPLIANCE), stiffness = is_known(reader, COLUMN_STIFFNESS);
    const size_t *place = reader->columns->place;
    if (compliance && stiffness) {
        return say_twice(reader, COLUMN_STIFFNESS, COLUMN_COMPLIANCE);
    }
    if (is_known(reader, COLUMN_RESOLUTION) && is_known(reader, COLUMN_BITS)) {
        return say_twice(reader, COLUMN_BITS, COLUMN_RESOLUTION);
    }
    if (is_known(reader, COLUMN_BITS) && reader->entry.link.joint == ARMTOL_PRISMATIC) {
        cells_message(reader->cells, place[COLUMN_BITS], "bits are those of a turn; expected resolution");
        return false;
    }
    if (is_known(reader, COLUMN_MOMENT) && !compliance && !stiffness) {
        cells_message(reader->cells, place[COLUMN_MOMENT], "moment without compliance; only their product counts");
        return false;
    }
    return true;
}

static bool check_drive(const row_reader *reader)
{
    if (reader->entry.drive.low > reader->entry.drive.high) {
        cells_message(reader->cells, reader->columns->place[COLUMN_LOW], "low is above high");
        return false;
    }
    return check_words(reader);
}

/* The place of a center of mass says nothing without the mass. */
static bool check_mass(const row_reader *reader)
{
    for (arm_column column = COLUMN_COM_X; column < ARM_COLUMNS; column++) {
        if (is_known(reader, column) && !is_known(reader, COLUMN_MASS)) {
            cells_message(reader->cells, reader->columns->place[column], "%s without mass", arm_column_name(column));
            return false;
        }
    }
    return true;
}

static bool check_row(const row_reader *reader)
{
    return check_kind(reader) && check_fixed(reader) && check_sign(reader) && check_couple(reader) &&
           check_drive(reader) && check_mass(reader);
}

bool arm_row_read(const cell_row *cells, const arm_columns *columns, angle_unit angle_unit, size_t index,
                  arm_entry *entry, file_place *couple)
{
    row_reader reader = {
        .cells = cells,
        .columns = columns,
        .angle_unit = angle_unit,
        .index = index,
        .entry = {.link = {.kind = ARMTOL_KIND_COUNT},
                  .drive = armtol_drive_unknown,
                  .motion = {.follows = index, .multiplier = 1, .sign = 1}},
    };
    bool fine = check_length(&reader);
    for (size_t i = 0; fine && i < columns->n; i++) {
        fine = read_cell(&reader, columns->order[i]);
    }
    if (!fine) {
        return false;
    }
    if (angle_unit == UNIT_DEGREE) {
        convert_angles(&reader);
    }
    const size_t place = columns->place[COLUMN_COUPLE];
    *couple = (file_place){cells->path, cells->line, place < cells->n ? cells->cells[place].column : cells->end_column};
    arm_entry_settle(&reader.entry);
    *entry = reader.entry;
    return check_row(&reader);
}
