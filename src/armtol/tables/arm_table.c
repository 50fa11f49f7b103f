#include "armtol/tables/arm_table.h"

#include "console/message.h"

#include <math.h>
#include <string.h>
#include <strings.h>

static const char *const names[ARM_COLUMNS] = {
    [COLUMN_NAME] = "name",   [COLUMN_KIND] = "kind",   [COLUMN_JOINT] = "joint",           [COLUMN_A] = "a",
    [COLUMN_ALPHA] = "alpha", [COLUMN_D] = "d",                   [COLUMN_THETA] = "theta",
    [COLUMN_BETA] = "beta",   [COLUMN_SIGN] = "sign",             [COLUMN_COUPLE] = "couple",
    [COLUMN_MULTIPLIER] = "multiplier", [COLUMN_OFFSET] = "offset", [COLUMN_LOW] = "low", [COLUMN_HIGH] = "high",
    [COLUMN_BACKLASH] = "backlash", [COLUMN_COMPLIANCE] = "compliance", [COLUMN_MOMENT] = "moment",
    [COLUMN_RESOLUTION] = "resolution", [COLUMN_FRICTION] = "friction", [COLUMN_NOISE] = "noise",
    [COLUMN_STIFFNESS] = "stiffness",
    [COLUMN_BITS] = "bits",   [COLUMN_MASS] = "mass",             [COLUMN_COM_X] = "com_x",
    [COLUMN_COM_Y] = "com_y", [COLUMN_COM_Z] = "com_z",
};

const char *arm_column_name(arm_column column)
{
    return names[column];
}

bool arm_column_is_optional(arm_column column)
{
    return column <= COLUMN_KIND || column >= COLUMN_BETA;
}

bool arm_column_is_motion(arm_column column)
{
    return column >= COLUMN_SIGN && column <= COLUMN_OFFSET;
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
    case COLUMN_OFFSET:
    case COLUMN_LOW:
    case COLUMN_HIGH:
    case COLUMN_BACKLASH:
    case COLUMN_COMPLIANCE:
    case COLUMN_RESOLUTION:
    case COLUMN_NOISE:
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
        [COLUMN_SIGN] = &entry->motion.sign,
        [COLUMN_MULTIPLIER] = &entry->motion.multiplier,
        [COLUMN_OFFSET] = &entry->motion.offset,
        [COLUMN_LOW] = &entry->drive.low,
        [COLUMN_HIGH] = &entry->drive.high,
        [COLUMN_BACKLASH] = &entry->drive.backlash,
        [COLUMN_COMPLIANCE] = &entry->drive.compliance,
        [COLUMN_MOMENT] = &entry->drive.moment,
        [COLUMN_RESOLUTION] = &entry->drive.resolution,
        [COLUMN_FRICTION] = &entry->drive.friction,
        [COLUMN_NOISE] = &entry->drive.noise,
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
    entry.motion = (armtol_motion){.follows = link, .multiplier = 1, .sign = 1};
    if (arm->masses != NULL) {
        entry.mass = arm->masses[link];
    }
    if (arm->motions != NULL) {
        entry.motion = arm->motions[link];
    }
    if (arm->names != NULL) {
        entry.name = arm->names[link];
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

static arm_column column_named(const char *name)
{
    arm_column column = 0;
    while (column < ARM_COLUMNS && strcasecmp(names[column], name) != 0) {
        column++;
    }
    return column;
}

/* The column that a name with i-1 is: alpha_{i-1}, a(i-1); ARM_COLUMNS where it is none. */
static arm_column column_of_link_before(const cell *cell)
{
    char name[16];
    size_t n = 0;
    for (const char *from = cell->text; *from != '\0' && n + 1 < sizeof name; from++) {
        if (strchr("_{}()[] ", *from) == NULL) {
            name[n++] = *from;
        }
    }
    const size_t end = n > 3 ? n - 3 : n;
    name[n] = '\0';
    if (strcasecmp(name + end, "i-1") != 0) {
        return ARM_COLUMNS;
    }
    name[end] = '\0';
    const arm_column column = column_named(name);
    return column == COLUMN_A || column == COLUMN_ALPHA ? column : ARM_COLUMNS;
}

/* Of a row whose first cell is no column nobody knows that it was to be the head row. */
static void unknown_column(const cell_row *row, size_t index)
{
    quoted quote;
    const char *text = message_quote(row->cells[index].text, &quote);
    if (row->cells[index].text[0] == '\0') {
        cells_message(row, index, "a column without a name");
    } else if (column_of_link_before(&row->cells[index]) != ARM_COLUMNS) {
        cells_message(row, index, "%s is of the link before, as in Craig's order; expected a line \"order: craig\" "
                                  "above the table", text);
    } else if (index == 0) {
        cells_message(row, 0, "%s is neither a key (name, title, source, units, order) nor a column (name, kind, "
                              "joint, a, alpha, d, theta, ...)", text);
    } else {
        cells_message(row, index, "unknown column %s; expected name, kind, joint, a, alpha, d, theta, beta, sign, "
                                  "couple, multiplier, offset, low, high, backlash, compliance or stiffness, moment, "
                                  "resolution or bits, friction, noise, mass, com_x, com_y or com_z", text);
    }
}

static bool add_column(arm_columns *columns, const cell_row *row, size_t index, bool craig)
{
    arm_column column = column_named(row->cells[index].text);
    if (column == ARM_COLUMNS && craig) {
        column = column_of_link_before(&row->cells[index]);
    }
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

bool arm_columns_read(arm_columns *columns, const cell_row *row, bool craig)
{
    columns->n = 0;
    for (arm_column column = 0; column < ARM_COLUMNS; column++) {
        columns->place[column] = NO_PLACE;
    }
    for (size_t i = 0; i < row->n; i++) {
        if (!add_column(columns, row, i, craig)) {
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
