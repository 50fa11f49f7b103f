#include "armtol/tables/arm_row.h"

#include "armtol/tables/degrees.h"
#include "console/message.h"

#include <math.h>
#include <strings.h>

/* The row at hand. */
typedef struct arm_row {
    const cell_row *cells;
    const arm_columns *columns;
    bool kind_given;
    arm_entry entry;
} arm_row;

static bool is_known(const arm_row *row, arm_column column)
{
    const size_t place = row->columns->place[column];
    return place != NO_PLACE && place < row->cells->n && !cell_is_unknown(&row->cells->cells[place]);
}

static bool check_length(const arm_row *row)
{
    const cell_row *cells = row->cells;
    if (cells->n > row->columns->n) {
        cells_message(cells, row->columns->n, "a cell too many; the head row names %zu columns", row->columns->n);
        return false;
    }
    if (cells->separator == CELLS_BLANKS && cells->n < row->columns->n) {
        cells_message(cells, cells->n, "%zu cells, but the head row names %zu columns; expected a - for what is not "
                                       "known", cells->n, row->columns->n);
        return false;
    }
    return true;
}

/* ---- one cell ---- */

static bool read_kind(arm_row *row, size_t place)
{
    const cell *cell = &row->cells->cells[place];
    armtol_kind kind = 0;
    while (kind < ARMTOL_KIND_COUNT && !cell_is(cell, armtol_kind_name(kind))) {
        kind++;
    }
    row->kind_given = kind < ARMTOL_KIND_COUNT;
    row->entry.link.kind = kind;
    if (!row->kind_given && !cell_is(cell, "auto")) {
        cells_message(row->cells, place, "unknown kind %s; expected npr, npp, ppr, ppp or auto",
                      message_quote(cell->text, &(quoted){""}));
        return false;
    }
    return true;
}

static bool read_joint(arm_row *row, size_t place)
{
    static const struct {
        const char *name;
        armtol_joint joint;
    } names[] = {{"theta", ARMTOL_REVOLUTE}, {"revolute", ARMTOL_REVOLUTE},
                 {"d", ARMTOL_PRISMATIC},    {"prismatic", ARMTOL_PRISMATIC},
                 {"fixed", ARMTOL_FIXED}};
    const cell *cell = &row->cells->cells[place];
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (cell_is(cell, names[i].name)) {
            row->entry.link.joint = names[i].joint;
            return true;
        }
    }
    cells_message(row->cells, place, "unknown joint %s; expected theta (revolute), d (prismatic) or fixed",
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

/* Stiffness and bits, which stand for numbers that they must not make infinite. */
static bool check_other_word(const arm_row *row, arm_column column, size_t place, double value)
{
    enum { MOST_BITS = 64 };
    const bool bits = column == COLUMN_BITS;
    if (bits ? value >= 1 && value <= MOST_BITS && value == floor(value) : isfinite(1 / value)) {
        return true;
    }
    cells_message(row->cells, place, "%s: %s is %s", arm_column_name(column),
                  message_quote(row->cells->cells[place].text, &(quoted){""}),
                  bits ? "no whole number from 1 to 64" : "not greater than zero");
    return false;
}

static bool read_number(arm_row *row, arm_column column, size_t place)
{
    cell_number number;
    number_fault fault = cells_number(row->cells, place, &number);
    if (fault == NUMBER_NOT_FINITE && is_endless(column, number.text, &number.value)) {
        fault = NUMBER_FINE;
    }
    if (fault != NUMBER_FINE) {
        cells_message(row->cells, place, "%s: %s %s", arm_column_name(column),
                      message_quote(row->cells->cells[place].text, &(quoted){""}), number_fault_text(fault));
        return false;
    }
    if (column >= COLUMN_BACKLASH && column <= COLUMN_MASS && number.value < 0) {
        cells_message(row->cells, place, "%s: %s is negative", arm_column_name(column),
                      message_quote(row->cells->cells[place].text, &(quoted){""}));
        return false;
    }
    if ((column == COLUMN_BITS || column == COLUMN_STIFFNESS) && !check_other_word(row, column, place, number.value)) {
        return false;
    }
    *arm_column_number(column, &row->entry) = number.value;
    return true;
}

static bool read_cell(arm_row *row, arm_column column)
{
    const size_t place = row->columns->place[column];
    if (!is_known(row, column)) {
        if (!arm_column_is_optional(column)) {
            cells_message(row->cells, place, "no value for \"%s\"", arm_column_name(column));
        }
        return arm_column_is_optional(column);
    }
    switch (column) {
    case COLUMN_KIND:
        return read_kind(row, place);
    case COLUMN_JOINT:
        return read_joint(row, place);
    default:
        return read_number(row, column, place);
    }
}

/* ---- the row as a whole ---- */

/* The number was fine in degrees, and is read once more: with one rounding from the text to radians. */
static void convert(arm_row *row, arm_column column)
{
    cell_number number;
    if (cells_number(row->cells, row->columns->place[column], &number) == NUMBER_FINE) {
        *arm_column_number(column, &row->entry) = degrees_parse(number.text);
    }
}

static void convert_angles(arm_row *row)
{
    for (arm_column column = 0; column < ARM_COLUMNS; column++) {
        if (arm_column_is_angle(column, row->entry.link.joint) && is_known(row, column)) {
            convert(row, column);
        }
    }
    if (row->entry.link.joint == ARMTOL_REVOLUTE) { /* of a degree: a radian is stiffer by as much as it is larger */
        row->entry.stiffness *= 180 / 3.14159265358979323846;
    }
}

/* A fixed link may be of any kind: the kind only says which of its parameters can be in error. */
static bool check_kind(const arm_row *row)
{
    const armtol_kind kind = row->entry.link.kind;
    const bool prismatic = kind == ARMTOL_NPP || kind == ARMTOL_PPP;
    if (row->entry.link.joint != ARMTOL_FIXED && prismatic != (row->entry.link.joint == ARMTOL_PRISMATIC)) {
        cells_message(row->cells, row->columns->place[COLUMN_KIND],
                      "a link whose joint is %s cannot be %s; expected %s", arm_joint_name(row->entry.link.joint),
                      armtol_kind_name(kind), prismatic ? "npr or ppr" : "npp or ppp");
        return false;
    }
    return true;
}

static bool say_twice(const arm_row *row, arm_column column, arm_column other)
{
    cells_message(row->cells, row->columns->place[column], "%s beside %s; expected one of the two", arm_column_name(column),
                  arm_column_name(other));
    return false;
}

static bool check_words(const arm_row *row)
{
    const bool compliance = is_known(row, COLUMN_COMPLIANCE), stiffness = is_known(row, COLUMN_STIFFNESS);
    if (compliance && stiffness) {
        return say_twice(row, COLUMN_STIFFNESS, COLUMN_COMPLIANCE);
    }
    if (is_known(row, COLUMN_RESOLUTION) && is_known(row, COLUMN_BITS)) {
        return say_twice(row, COLUMN_BITS, COLUMN_RESOLUTION);
    }
    if (is_known(row, COLUMN_BITS) && row->entry.link.joint == ARMTOL_PRISMATIC) {
        cells_message(row->cells, row->columns->place[COLUMN_BITS], "bits are those of a turn; expected resolution");
        return false;
    }
    if (is_known(row, COLUMN_MOMENT) && !compliance && !stiffness) {
        cells_message(row->cells, row->columns->place[COLUMN_MOMENT], "moment without compliance; only their product counts");
        return false;
    }
    return true;
}

/* What is said of a drive that is not there, or that would count for nothing, is a mistake elsewhere in the row. */
static bool check_drive(const arm_row *row)
{
    for (arm_column column = 0; column < ARM_COLUMNS; column++) {
        if (row->entry.link.joint == ARMTOL_FIXED && arm_column_is_drive(column) && is_known(row, column)) {
            cells_message(row->cells, row->columns->place[column],
                          "a fixed link has no %s; expected - or an empty cell", arm_column_name(column));
            return false;
        }
    }
    if (row->entry.drive.low > row->entry.drive.high) {
        cells_message(row->cells, row->columns->place[COLUMN_LOW], "low is above high");
        return false;
    }
    return check_words(row);
}

/* The place of a center of mass says nothing without the mass. */
static bool check_mass(const arm_row *row)
{
    for (arm_column column = COLUMN_COM_X; column < ARM_COLUMNS; column++) {
        if (is_known(row, column) && !is_known(row, COLUMN_MASS)) {
            cells_message(row->cells, row->columns->place[column], "%s without mass", arm_column_name(column));
            return false;
        }
    }
    return true;
}

bool arm_row_read(const cell_row *cells, const arm_columns *columns, angle_unit angle_unit, arm_entry *entry)
{
    arm_row row = {.cells = cells, .columns = columns, .entry = {.drive = armtol_drive_unknown}};
    bool fine = check_length(&row);
    for (size_t i = 0; fine && i < columns->n; i++) {
        fine = read_cell(&row, columns->order[i]);
    }
    if (!fine) {
        return false;
    }
    if (angle_unit == UNIT_DEGREE) {
        convert_angles(&row);
    }
    if (!row.kind_given) {
        row.entry.link.kind = row.entry.link.joint == ARMTOL_PRISMATIC ? ARMTOL_NPP : ARMTOL_NPR;
    }
    arm_entry_settle(&row.entry);
    row.entry.kind_given = row.kind_given;
    *entry = row.entry;
    return check_kind(&row) && check_drive(&row) && check_mass(&row);
}
