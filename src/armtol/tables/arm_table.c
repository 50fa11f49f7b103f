#include "armtol/tables/arm_table.h"

#include "console/message.h"

#include <math.h>

static const char *const names[ARM_COLUMNS] = {
    [COLUMN_KIND] = "kind",   [COLUMN_JOINT] = "joint",           [COLUMN_A] = "a",
    [COLUMN_ALPHA] = "alpha", [COLUMN_D] = "d",                   [COLUMN_THETA] = "theta",
    [COLUMN_BETA] = "beta",   [COLUMN_LOW] = "low",               [COLUMN_HIGH] = "high",
    [COLUMN_BACKLASH] = "backlash", [COLUMN_COMPLIANCE] = "compliance", [COLUMN_MOMENT] = "moment",
    [COLUMN_RESOLUTION] = "resolution", [COLUMN_FRICTION] = "friction", [COLUMN_STIFFNESS] = "stiffness",
    [COLUMN_BITS] = "bits",   [COLUMN_MASS] = "mass",             [COLUMN_COM_X] = "com_x",
    [COLUMN_COM_Y] = "com_y", [COLUMN_COM_Z] = "com_z",
};

const char *arm_column_name(arm_column column)
{
    return names[column];
}

bool arm_column_is_optional(arm_column column)
{
    return column == COLUMN_KIND || column >= COLUMN_BETA;
}

bool arm_column_is_drive(arm_column column)
{
    return column >= COLUMN_LOW && column <= COLUMN_BITS;
}

bool arm_column_is_mass(arm_column column)
{
    return column >= COLUMN_MASS;
}

bool arm_column_is_angle(arm_column column, armtol_joint joint)
{
    switch (column) {
    case COLUMN_ALPHA:
    case COLUMN_THETA:
    case COLUMN_BETA:
        return true;
    case COLUMN_LOW:
    case COLUMN_HIGH:
    case COLUMN_BACKLASH:
    case COLUMN_COMPLIANCE:
    case COLUMN_RESOLUTION:
        return joint == ARMTOL_REVOLUTE;
    default:
        return false;
    }
}

double *arm_column_number(arm_column column, arm_entry *entry)
{
    double *const numbers[ARM_COLUMNS] = {
        [COLUMN_A] = &entry->link.a,
        [COLUMN_ALPHA] = &entry->link.alpha,
        [COLUMN_D] = &entry->link.d,
        [COLUMN_THETA] = &entry->link.theta,
        [COLUMN_BETA] = &entry->link.beta,
        [COLUMN_LOW] = &entry->drive.low,
        [COLUMN_HIGH] = &entry->drive.high,
        [COLUMN_BACKLASH] = &entry->drive.backlash,
        [COLUMN_COMPLIANCE] = &entry->drive.compliance,
        [COLUMN_MOMENT] = &entry->drive.moment,
        [COLUMN_RESOLUTION] = &entry->drive.resolution,
        [COLUMN_FRICTION] = &entry->drive.friction,
        [COLUMN_STIFFNESS] = &entry->stiffness,
        [COLUMN_BITS] = &entry->bits,
        [COLUMN_MASS] = &entry->mass.mass,
        [COLUMN_COM_X] = &entry->mass.center[0],
        [COLUMN_COM_Y] = &entry->mass.center[1],
        [COLUMN_COM_Z] = &entry->mass.center[2],
    };
    return numbers[column];
}

arm_entry arm_entry_of(const armtol_arm *arm, size_t link)
{
    arm_entry entry = {.link = arm->links[link], .drive = arm->drives[link]};
    if (arm->masses != NULL) {
        entry.mass = arm->masses[link];
    }
    return entry;
}

void arm_entry_settle(arm_entry *entry)
{
    static const double turn = 6.28318530717958647693;
    if (entry->stiffness > 0) {
        entry->drive.compliance = 1 / entry->stiffness;
    }
    if (entry->bits > 0) {
        entry->drive.resolution = ldexp(turn, -(int)entry->bits);
    }
}

const char *arm_joint_name(armtol_joint joint)
{
    static const char *const joints[ARMTOL_JOINT_COUNT] = {
        [ARMTOL_FIXED] = "fixed", [ARMTOL_REVOLUTE] = "theta", [ARMTOL_PRISMATIC] = "d"};
    return joints[joint];
}

static arm_column column_of(const cell *cell)
{
    arm_column column = 0;
    while (column < ARM_COLUMNS && !cell_is(cell, names[column])) {
        column++;
    }
    return column;
}

/* Of a row whose first cell is no column nobody knows that it was to be the head row. */
static void unknown_column(const cell_row *row, size_t index)
{
    quoted quote;
    const char *text = message_quote(row->cells[index].text, &quote);
    if (row->cells[index].text[0] == '\0') {
        cells_message(row, index, "a column without a name");
    } else if (index == 0) {
        cells_message(row, 0, "%s is neither a key (name, title, source, units) nor a column (kind, joint, a, alpha, "
                              "d, theta, ...)", text);
    } else {
        cells_message(row, index, "unknown column %s; expected kind, joint, a, alpha, d, theta, beta, low, high, "
                                  "backlash, compliance or stiffness, moment, resolution or bits, friction, mass, com_x, "
                                  "com_y or com_z", text);
    }
}

static bool add_column(arm_columns *columns, const cell_row *row, size_t index)
{
    const arm_column column = column_of(&row->cells[index]);
    if (column == ARM_COLUMNS) {
        unknown_column(row, index);
        return false;
    }
    if (columns->place[column] != NO_PLACE) {
        cells_message(row, index, "a second column \"%s\"", names[column]);
        return false;
    }
    columns->place[column] = index;
    columns->order[columns->n++] = column;
    return true;
}

bool arm_columns_read(arm_columns *columns, const cell_row *row)
{
    columns->n = 0;
    for (arm_column column = 0; column < ARM_COLUMNS; column++) {
        columns->place[column] = NO_PLACE;
    }
    for (size_t i = 0; i < row->n; i++) {
        if (!add_column(columns, row, i)) {
            return false;
        }
    }
    for (arm_column column = 0; column < ARM_COLUMNS; column++) {
        if (columns->place[column] == NO_PLACE && !arm_column_is_optional(column)) {
            cells_message(row, row->n, "the head row has no column \"%s\"", names[column]);
            return false;
        }
    }
    return true;
}
