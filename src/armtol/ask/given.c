#include "armtol/ask/given.h"

#include "armtol/ask/number_list.h"
#include "armtol/tables/arm_table.h"
#include "console/message.h"

#include <math.h>
#include <string.h>

static bool take_size(const named_item *item, const char *text, double *value)
{
    if (!number_option_parse(item->option, text, value)) {
        return false;
    }
    if (*value < 0) {
        message("%s: %s is negative", item->option, message_quote(text, &(quoted){""}));
    }
    return *value >= 0;
}

/* ---- ranges ---- */

typedef struct ranges {
    named_columns of;
    const units *units;
    double *least, *largest;
} ranges;

/* "0.02..0.2", or one number; the other end stays where the sign is not =. */
static bool take_ends(const named_item *item, double *least, double *largest)
{
    char text[64];
    const char *dots = strstr(item->value, "..");
    const size_t length = dots != NULL ? (size_t)(dots - item->value) : strlen(item->value);
    *least = 0;
    *largest = (double)INFINITY;
    memcpy(text, item->value, length);
    text[length] = '\0';
    if (item->sign[0] == '<') {
        return take_size(item, item->value, largest);
    }
    if (item->sign[0] == '>') {
        return take_size(item, item->value, least);
    }
    if (!take_size(item, text, least) || !take_size(item, dots != NULL ? dots + 2 : text, largest)) {
        return false;
    }
    if (*least > *largest) {
        message("--given: %s: the least is above the largest", message_quote(item->value, &(quoted){""}));
    }
    return *least <= *largest;
}

static bool take_range(const named_item *item, void *context)
{
    const ranges *ranges = context;
    double least, largest;
    if (!named_is(item, "= >= <=", "NAME=NUMBER, NAME=LEAST..LARGEST, NAME>=LEAST or NAME<=LARGEST") ||
        !take_ends(item, &least, &largest)) {
        return false;
    }
    for (size_t k = 0; k < ranges->of.n_columns; k++) {
        if (named_column(&ranges->of, item, k)) {
            const bool is_length = armtol_parameter_is_length(ranges->of.columns[k].parameter);
            ranges->least[k] = units_taken(ranges->units, is_length, least);
            ranges->largest[k] = units_taken(ranges->units, is_length, largest);
        }
    }
    return named_any_column(&ranges->of, item);
}

bool given_parse(const char *text, const named_columns *of, const units *units, double least[], double largest[])
{
    ranges ranges = {*of, units, least, largest};
    for (size_t k = 0; k < of->n_columns; k++) {
        least[k] = 0;
        largest[k] = (double)INFINITY;
    }
    return text == NULL || named_each("--given", text, of->arm, take_range, &ranges);
}

/* ---- tolerances ---- */

static bool take_tolerance(const named_item *item, void *context)
{
    const ranges *ranges = context;
    double tolerance;
    if (!named_is(item, "=", "NAME=NUMBER") || !take_size(item, item->value, &tolerance)) {
        return false;
    }
    for (size_t k = 0; k < ranges->of.n_columns; k++) {
        if (named_column(&ranges->of, item, k)) {
            ranges->least[k] =
                units_taken(ranges->units, armtol_parameter_is_length(ranges->of.columns[k].parameter), tolerance);
        }
    }
    return named_any_column(&ranges->of, item);
}

bool given_tolerances_parse(const char *text, const named_columns *of, const units *units, double tolerances[])
{
    ranges ranges = {*of, units, tolerances, NULL};
    return named_each("--tolerances", text, of->arm, take_tolerance, &ranges);
}

/* ---- drives ---- */

typedef struct driven {
    const armtol_arm *arm;
    const units *units;
    armtol_drive *drives;
} driven;

static arm_column column_of(const named_item *item)
{
    arm_column column = COLUMN_BACKLASH;
    while (column <= COLUMN_BITS && strcmp(item->name, arm_column_name(column)) != 0) {
        column++;
    }
    return column;
}

/* In the units of the table: radians, lengths; a stiffness is told by its inverse. */
static double value_of(const driven *driven, arm_column column, armtol_joint joint, double value)
{
    const bool slides = joint == ARMTOL_PRISMATIC;
    if (column == COLUMN_STIFFNESS) {
        return 1 / units_taken(driven->units, slides, 1 / value);
    }
    return arm_column_is_angle(column, ARMTOL_REVOLUTE) ? units_taken(driven->units, slides, value) : value;
}

static bool check_value(const named_item *item, arm_column column, double value)
{
    enum { MOST_BITS = 64 };
    const bool bits = column == COLUMN_BITS;
    if (bits ? value >= 1 && value <= MOST_BITS && value == floor(value)
             : column != COLUMN_STIFFNESS || isfinite(1 / value)) {
        return true;
    }
    message("--drives: %s: %s is %s", item->name, message_quote(item->value, &(quoted){""}),
            bits ? "no whole number from 1 to 64" : "not greater than zero");
    return false;
}

static bool takes_part(const named_item *item, const armtol_link *link, size_t i, arm_column column)
{
    return (item->link == NAMED_ANY_LINK || (size_t)item->link == i) && link->joint != ARMTOL_FIXED &&
           (column != COLUMN_BITS || link->joint == ARMTOL_REVOLUTE);
}

static bool take_drive(const named_item *item, void *context)
{
    const driven *driven = context;
    const arm_column column = column_of(item);
    double value;
    bool any = false;
    if (column > COLUMN_BITS) {
        message("--drives: unknown name %s; expected backlash, compliance, moment, resolution, friction, noise, "
                "stiffness or bits, or one of these of a link, as in 3.backlash",
                message_quote(item->whole, &(quoted){""}));
        return false;
    }
    if (!named_is(item, "=", "NAME=NUMBER") || !take_size(item, item->value, &value) ||
        !check_value(item, column, value)) {
        return false;
    }
    for (size_t i = 0; i < driven->arm->n_links; i++) {
        const armtol_link *link = &driven->arm->links[i];
        if (takes_part(item, link, i, column)) {
            arm_entry entry = {.link = *link, .drive = driven->drives[i]};
            *arm_column_number(column, &entry) = value_of(driven, column, link->joint, value);
            arm_entry_settle(&entry);
            driven->drives[i] = entry.drive;
            any = true;
        }
    }
    if (!any) {
        message("--drives: %s has no joint with %s", driven->arm->name, message_quote(item->whole, &(quoted){""}));
    }
    return any;
}

bool given_drives_parse(const char *text, const armtol_arm *arm, const units *units, armtol_drive drives[])
{
    driven driven = {arm, units, drives};
    return text == NULL || named_each("--drives", text, arm, take_drive, &driven);
}
