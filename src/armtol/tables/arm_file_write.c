#include "armtol/tables/arm_file.h"

#include "armtol/tables/arm_rows.h"
#include "armtol/tables/arm_table.h"
#include "armtol/tables/degrees.h"
#include "armtol/tables/text_lines.h"
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
    case COLUMN_NOISE:
        return drive->noise != 0;
    default:
        return false;
    }
}

static bool mass_is_known(const armtol_mass *mass, arm_column column)
{
    return column == COLUMN_MASS || mass->center[column - COLUMN_COM_X] != 0;
}

static bool motion_is_known(const arm_entry *row, size_t index, arm_column column)
{
    const bool coupled = row->motion.follows != index;
    switch (column) {
    case COLUMN_SIGN:
        return row->motion.sign != 1;
    case COLUMN_MULTIPLIER:
        return coupled && row->motion.multiplier != 1;
    case COLUMN_OFFSET:
        return coupled && (row->motion.offset != 0 || signbit(row->motion.offset));
    default:
        return coupled;
    }
}

/* Also where the number says no more than the default does; -0 is another number than 0. */
static bool is_known(const arm_entry *row, size_t index, bool has_masses, arm_column column)
{
    if (column == COLUMN_NAME) {
        return row->name != NULL;
    }
    if (column == COLUMN_BETA) {
        return row->link.beta != 0 || signbit(row->link.beta);
    }
    if (arm_column_is_mass(column)) {
        return has_masses && mass_is_known(&row->mass, column);
    }
    if (arm_column_is_motion(column)) {
        return row->link.joint != ARMTOL_FIXED && motion_is_known(row, index, column);
    }
    return !arm_column_is_drive(column) || (row->link.joint != ARMTOL_FIXED && drive_is_known(&row->drive, column));
}

static const char *cell_of(const arm_writer *writer, size_t index, arm_column column, number_text *room)
{
    arm_entry row = arm_entry_of(writer->arm, index);
    if (column == COLUMN_NAME) {
        return row.name != NULL ? row.name : "-";
    }
    if (column == COLUMN_KIND) {
        return armtol_kind_name(row.link.kind);
    }
    if (column == COLUMN_JOINT) {
        return arm_joint_name(row.link.joint);
    }
    /* a dash for the sign of a joint would be taken for a minus */
    const bool sign = column == COLUMN_SIGN && row.link.joint != ARMTOL_FIXED;
    if (!sign && (arm_column_is_motion(column) || arm_column_is_drive(column)) &&
        !is_known(&row, index, false, column)) {
        return "-";
    }
    if (column == COLUMN_COUPLE) {
        snprintf(room->text, sizeof room->text, "%zu", row.motion.follows);
        return room->text;
    }
    const double value = *arm_column_number(column, &row);
    const bool degrees = writer->angle_unit == UNIT_DEGREE && arm_column_is_angle(column, row.link.joint);
    return degrees ? degrees_shortest(value, room) : number_shortest(value, &armtol_errata_none, room);
}

/* Names are the user's: one with a separator, a comment or a quote in it, or blanks around it, stands in quotes. */
static bool needs_quotes(arm_column column, const char *text)
{
    const size_t length = strlen(text);
    return column == COLUMN_NAME && (strpbrk(text, "\",;#") != NULL || text[0] == ' ' || text[length - 1] == ' ');
}

/* In characters, as it is written. */
static size_t length_of(arm_column column, const char *text)
{
    const bool quotes = needs_quotes(column, text);
    size_t length = text_characters(text, text + strlen(text)) + (quotes ? 2 : 0);
    for (; quotes && *text != '\0'; text++) {
        length += *text == '"';
    }
    return length;
}

/* ---- columns ---- */

static bool any_known(const armtol_arm *arm, arm_column column)
{
    bool any = false;
    for (size_t i = 0; i < arm->n_links; i++) {
        const arm_entry row = arm_entry_of(arm, i);
        any = any || is_known(&row, i, arm->masses != NULL, column);
    }
    return any;
}

static int width_of(const arm_writer *writer, arm_column column)
{
    size_t width = strlen(arm_column_name(column));
    for (size_t i = 0; i < writer->arm->n_links; i++) {
        const size_t length = length_of(column, cell_of(writer, i, column, &(number_text){""}));
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

static void write_quoted(const char *text, bool quotes, FILE *stream)
{
    fputs(quotes ? "\"" : "", stream);
    for (; *text != '\0'; text++) {
        fputs(quotes && *text == '"' ? "\"" : "", stream);
        fputc(*text, stream);
    }
    fputs(quotes ? "\"" : "", stream);
}

/* Words begin below each other, numbers end below each other. */
static void write_cell(const arm_writer *writer, size_t place, const char *text, FILE *stream)
{
    const bool word = writer->columns[place] <= COLUMN_JOINT, last = place + 1 == writer->n_columns;
    const size_t length = length_of(writer->columns[place], text);
    const int space = writer->widths[place] - (int)length;
    fprintf(stream, "%*s", word ? 0 : space, "");
    write_quoted(text, needs_quotes(writer->columns[place], text), stream);
    fprintf(stream, "%s%*s", last ? "\n" : ", ", word ? space : 0, "");
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

static void write_arm(const armtol_arm *arm, row_order order, angle_unit angle_unit, FILE *stream)
{
    arm_writer writer = {.arm = arm, .angle_unit = angle_unit};
    choose_columns(&writer);
    write_text("name", arm->name, stream);
    write_text("title", arm->title, stream);
    write_text("source", arm->source, stream);
    fputs(order == ORDER_CRAIG ? "order: craig\n" : "", stream);
    fprintf(stream, "units: %s %s\n\n", armtol_length_unit_name(arm->unit), angle_unit == UNIT_DEGREE ? "deg" : "rad");
    write_table(&writer, stream);
}

bool arm_file_write(const armtol_arm *arm, row_order order, angle_unit angle_unit, FILE *stream)
{
    if (order == ORDER_PAUL) {
        write_arm(arm, order, angle_unit, stream);
        return true;
    }
    arm_model table;
    const bool fine = craig_rows_of(arm, angle_unit, &table);
    if (fine) {
        write_arm(&table.arm, order, angle_unit, stream);
        arm_model_free(&table);
    }
    return fine;
}
