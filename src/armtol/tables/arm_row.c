#include "armtol/tables/arm_row.h"

#include "armtol/tables/degrees.h"
#include "console/message.h"

#include "armtol/axes.h"

#include <math.h>
#include <strings.h>

/* The row at hand. */
typedef struct arm_row {
    const cell_row *cells;
    const arm_columns *columns;
    bool kind_given;
    armtol_link link;
    armtol_drive drive;
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
    row->link.kind = kind;
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
            row->link.joint = names[i].joint;
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
    if (column >= COLUMN_BACKLASH && number.value < 0) {
        cells_message(row->cells, place, "%s: %s is negative", arm_column_name(column),
                      message_quote(row->cells->cells[place].text, &(quoted){""}));
        return false;
    }
    *arm_column_number(column, &row->link, &row->drive) = number.value;
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
        *arm_column_number(column, &row->link, &row->drive) = degrees_parse(number.text);
    }
}

static void convert_angles(arm_row *row)
{
    for (arm_column column = 0; column < ARM_COLUMNS; column++) {
        if (arm_column_is_angle(column, row->link.joint) && is_known(row, column)) {
            convert(row, column);
        }
    }
}

/* A fixed link may be of any kind: the kind only says which of its parameters can be in error. */
static bool check_kind(const arm_row *row)
{
    const armtol_kind kind = row->link.kind;
    const bool prismatic = kind == ARMTOL_NPP || kind == ARMTOL_PPP;
    if (row->link.joint != ARMTOL_FIXED && prismatic != (row->link.joint == ARMTOL_PRISMATIC)) {
        cells_message(row->cells, row->columns->place[COLUMN_KIND],
                      "a link whose joint is %s cannot be %s; expected %s", arm_joint_name(row->link.joint),
                      armtol_kind_name(kind), prismatic ? "npr or ppr" : "npp or ppp");
        return false;
    }
    return true;
}

/* What is said of a drive that is not there, or that would count for nothing, is a mistake elsewhere in the row. */
static bool check_drive(const arm_row *row)
{
    for (arm_column column = 0; column < ARM_COLUMNS; column++) {
        if (row->link.joint == ARMTOL_FIXED && arm_column_is_drive(column) && is_known(row, column)) {
            cells_message(row->cells, row->columns->place[column],
                          "a fixed link has no %s; expected - or an empty cell", arm_column_name(column));
            return false;
        }
    }
    if (row->drive.low > row->drive.high) {
        cells_message(row->cells, row->columns->place[COLUMN_LOW], "low is above high");
        return false;
    }
    const bool compliance = is_known(row, COLUMN_COMPLIANCE), moment = is_known(row, COLUMN_MOMENT);
    if (compliance != moment) {
        const arm_column column = compliance ? COLUMN_COMPLIANCE : COLUMN_MOMENT;
        cells_message(row->cells, row->columns->place[column], "%s without %s; only their product counts",
                      arm_column_name(column), compliance ? "moment" : "compliance");
        return false;
    }
    return true;
}

bool arm_row_read(const cell_row *cells, const arm_columns *columns, angle_unit angle_unit,
                  armtol_link *link, armtol_drive *drive)
{
    arm_row row = {.cells = cells, .columns = columns, .drive = armtol_drive_unknown};
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
        row.link.kind = armtol_kind_of(row.link.joint, row.link.alpha);
    }
    *link = row.link;
    *drive = row.drive;
    return check_kind(&row) && check_drive(&row);
}
