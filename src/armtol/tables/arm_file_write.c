#include "armtol/tables/arm_file.h"

#include "armtol/tables/arm_table.h"
#include "armtol/tables/degrees.h"
#include "console/number.h"

#include <math.h>
#include <string.h>

/* What is written: the arm, its units and the columns that it needs. */
typedef struct arm_writer {
    const armtol_arm *arm;
    angle_unit angle_unit;
    size_t n_columns;
    arm_column columns[ARM_COLUMNS];
    int widths[ARM_COLUMNS];
} arm_writer;

/* ---- cells ---- */

/* A moment is known only beside a compliance. */
static bool drive_is_known(const armtol_drive *drive, arm_column column)
{
    switch (column) {
    case COLUMN_LOW:
        return drive->low > -(double)INFINITY;
    case COLUMN_HIGH:
        return drive->high < (double)INFINITY;
    case COLUMN_BACKLASH:
        return !isnan(drive->backlash);
    case COLUMN_COMPLIANCE:
        return drive->compliance != 0 || drive->moment != 0;
    case COLUMN_MOMENT:
        return drive->moment != 0;
    case COLUMN_RESOLUTION:
        return drive->resolution != 0;
    case COLUMN_FRICTION:
        return drive->friction != 0;
    default:
        return false;
    }
}

static bool mass_is_known(const armtol_mass *mass, arm_column column)
{
    return column == COLUMN_MASS || mass->center[column - COLUMN_COM_X] != 0;
}

/* Also where the number says no more than the default does; -0 is another number than 0. */
static bool is_known(const armtol_arm *arm, size_t index, arm_column column)
{
    const armtol_link *link = &arm->links[index];
    if (column == COLUMN_BETA) {
        return link->beta != 0 || signbit(link->beta);
    }
    if (arm_column_is_mass(column)) {
        return arm->masses != NULL && mass_is_known(&arm->masses[index], column);
    }
    return !arm_column_is_drive(column) ||
           (link->joint != ARMTOL_FIXED && drive_is_known(&arm->drives[index], column));
}

static const char *cell_of(const arm_writer *writer, size_t index, arm_column column, number_text *room)
{
    arm_entry entry = arm_entry_of(writer->arm, index);
    if (column == COLUMN_KIND) {
        return armtol_kind_name(entry.link.kind);
    }
    if (column == COLUMN_JOINT) {
        return arm_joint_name(entry.link.joint);
    }
    if (arm_column_is_drive(column) && !is_known(writer->arm, index, column)) {
        return "-";
    }
    const double value = *arm_column_number(column, &entry);
    const bool degrees = writer->angle_unit == UNIT_DEGREE && arm_column_is_angle(column, entry.link.joint);
    return degrees ? degrees_shortest(value, room) : number_shortest(value, &armtol_errata_none, room);
}

/* ---- columns ---- */

static bool any_known(const armtol_arm *arm, arm_column column)
{
    bool any = false;
    for (size_t i = 0; i < arm->n_links; i++) {
        any = any || is_known(arm, i, column);
    }
    return any;
}

static int width_of(const arm_writer *writer, arm_column column)
{
    size_t width = strlen(arm_column_name(column));
    for (size_t i = 0; i < writer->arm->n_links; i++) {
        const size_t length = strlen(cell_of(writer, i, column, &(number_text){""}));
        width = length > width ? length : width;
    }
    return (int)width;
}

static void choose_columns(arm_writer *writer)
{
    for (arm_column column = 0; column < ARM_COLUMNS; column++) {
        if (any_known(writer->arm, column)) {
            writer->widths[writer->n_columns] = width_of(writer, column);
            writer->columns[writer->n_columns++] = column;
        }
    }
}

/* ---- lines ---- */

/* Whether a text comes back as it is when it stands behind its key without quotes. */
static bool is_plain(const char *text)
{
    const size_t length = strlen(text);
    return strchr(text, '#') == NULL && strchr("\" \t,;", text[0]) == NULL &&
           strchr(" \t,;", text[length - 1]) == NULL;
}

/* A text stands on one line, whatever there is in it; an empty one is not given. */
static void write_text(const char *key, const char *text, FILE *stream)
{
    if (*text == '\0') {
        return;
    }
    const bool plain = is_plain(text);
    fprintf(stream, "%s: %s", key, plain ? "" : "\"");
    for (; *text != '\0'; text++) {
        if (*text == '"' && !plain) {
            fputc('"', stream);
        }
        const bool control = ((unsigned char)*text < ' ' && *text != '\t') || *text == 127;
        fputc(control ? ' ' : *text, stream);
    }
    fputs(plain ? "\n" : "\"\n", stream);
}

/* Words begin below each other, numbers end below each other. */
static void write_cell(const arm_writer *writer, size_t place, const char *text, FILE *stream)
{
    const bool word = writer->columns[place] <= COLUMN_JOINT, last = place + 1 == writer->n_columns;
    const int width = writer->widths[place], behind = word ? width - (int)strlen(text) : 0;
    fprintf(stream, "%*s%s%*s", word ? 0 : width, text, last ? "\n" : ", ", behind, "");
}

static void write_table(const arm_writer *writer, FILE *stream)
{
    for (size_t j = 0; j < writer->n_columns; j++) {
        write_cell(writer, j, arm_column_name(writer->columns[j]), stream);
    }
    for (size_t i = 0; i < writer->arm->n_links; i++) {
        for (size_t j = 0; j < writer->n_columns; j++) {
            write_cell(writer, j, cell_of(writer, i, writer->columns[j], &(number_text){""}), stream);
        }
    }
}

void arm_file_write(const armtol_arm *arm, angle_unit angle_unit, FILE *stream)
{
    arm_writer writer = {.arm = arm, .angle_unit = angle_unit};
    choose_columns(&writer);
    write_text("name", arm->name, stream);
    write_text("title", arm->title, stream);
    write_text("source", arm->source, stream);
    fprintf(stream, "units: %s %s\n\n", armtol_length_unit_name(arm->unit), angle_unit == UNIT_DEGREE ? "deg" : "rad");
    write_table(&writer, stream);
}
