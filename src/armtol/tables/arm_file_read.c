#include "armtol/tables/arm_file.h"

#include "armtol/axes.h"
#include "armtol/tables/arm_head.h"
#include "armtol/tables/arm_rows.h"
#include "armtol/tables/arm_row.h"
#include "armtol/tables/arm_table.h"
#include "armtol/tables/cells.h"
#include "console/exit_code.h"
#include "console/file_message.h"
#include "console/list_room.h"
#include "console/message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char expected_head[] =
    "expected a row of names: joint, a, alpha, d, theta and, as needed, name, kind, beta, "
    "sign, couple, multiplier, offset, low, high, backlash, compliance, moment, resolution, "
    "friction, noise, mass, com_x, com_y, com_z";

/* All that is at work while a file is read. */
typedef struct arm_reader {
    text_lines lines;
    cell_row row;
    arm_head head;
    arm_columns columns;
    size_t n_rows;
    size_t row_room, couple_room, name_room;
    arm_entry *rows;
    char **names; /* of the rows; NULL for one that has none */
    file_place *couples; /* where a row says what it follows */
    file_place last_kind; /* where the last row's kind stands */
} arm_reader;

static void start(arm_reader *reader, FILE *stream, const char *path)
{
    *reader = (arm_reader){.n_rows = 0};
    text_lines_start(&reader->lines, stream, path);
    cells_start(&reader->row);
    arm_head_start(&reader->head);
}

static void end(arm_reader *reader)
{
    text_lines_free(&reader->lines);
    cells_free(&reader->row);
    arm_head_free(&reader->head);
    for (size_t i = 0; i < reader->n_rows; i++) {
        free(reader->names[i]);
    }
    free(reader->names);
    free(reader->rows);
    free(reader->couples);
}

static bool fail_at_line(const arm_reader *reader, const char *fault, const char *expected)
{
    const size_t line = reader->lines.number > 0 ? reader->lines.number : 1;
    const file_place place = {reader->lines.path, line, 1};
    file_message(&place, "%s; %s", fault, expected);
    return false;
}

/* Up to the head row, which is then in the reader's row. */
static bool read_head(arm_reader *reader)
{
    for (;;) {
        switch (text_lines_next(&reader->lines)) {
        case LINE_NONE:
            return fail_at_line(reader, "the file ends before a table of links", expected_head);
        case LINE_WRONG:
            return false;
        case LINE_THERE:
            break;
        }
        switch (arm_head_take(&reader->head, &reader->lines, &reader->row)) {
        case HEAD_WRONG:
            return false;
        case HEAD_ENDS:
            if (reader->row.n > 0) {
                return true;
            }
            break;
        case HEAD_TAKEN:
            break;
        }
    }
}

/* Room for one row more. */
static bool grow(arm_reader *reader)
{
    arm_entry *rows = list_room(reader->rows, reader->n_rows, &reader->row_room, sizeof *rows);
    if (rows == NULL) {
        return false;
    }
    reader->rows = rows;
    file_place *couples = list_room(reader->couples, reader->n_rows, &reader->couple_room, sizeof *couples);
    reader->couples = couples != NULL ? couples : reader->couples;
    char **names = couples != NULL ? list_room(reader->names, reader->n_rows, &reader->name_room, sizeof *names) : NULL;
    reader->names = names != NULL ? names : reader->names;
    return names != NULL;
}

static file_place place_of_kind(const arm_reader *reader)
{
    const size_t place = reader->columns.place[COLUMN_KIND];
    const size_t column = place < reader->row.n ? reader->row.cells[place].column : 1;
    return (file_place){reader->lines.path, reader->lines.number, column};
}

/* No two rows have the same name: lists on the command line mean one of them. */
static bool check_name(const arm_reader *reader, const char *name)
{
    for (size_t i = 0; i < reader->n_rows; i++) {
        if (reader->names[i] != NULL && strcmp(reader->names[i], name) == 0) {
            cells_message(&reader->row, reader->columns.place[COLUMN_NAME],
                          "name: a second %s; the first is in line %zu", message_quote(name, &(quoted){""}),
                          reader->couples[i].line);
            return false;
        }
    }
    return true;
}

/* The row's name is in the line, which goes. */
static bool keep_name(arm_reader *reader, arm_entry *row)
{
    const bool has_name = row->name != NULL;
    if (has_name && !check_name(reader, row->name)) {
        return false;
    }
    char *kept = has_name ? strdup(row->name) : NULL;
    reader->names[reader->n_rows] = kept;
    row->name = kept;
    if (has_name && kept == NULL) {
        out_of_memory();
    }
    return !has_name || kept != NULL;
}

static bool take_row(arm_reader *reader)
{
    const size_t n = reader->n_rows;
    if (n == ARM_MOST_LINKS) {
        cells_message(&reader->row, 0, "more than %d links", ARM_MOST_LINKS);
        return false;
    }
    if (!grow(reader) || !arm_row_read(&reader->row, &reader->columns, reader->head.angle_unit, n, &reader->rows[n],
                                       &reader->couples[n]) ||
        !keep_name(reader, &reader->rows[n])) {
        return false;
    }
    reader->n_rows++;
    reader->last_kind = place_of_kind(reader);
    return true;
}

static bool read_table(arm_reader *reader)
{
    if (!arm_columns_read(&reader->columns, &reader->row, reader->head.order == ORDER_CRAIG)) {
        return false;
    }
    if (!reader->head.has_units) {
        return fail_at_line(reader, "no units above the table",
                            "expected a line \"units: mm deg\" (mm or m, deg or rad)");
    }
    const char separator = reader->row.separator;
    for (;;) {
        const line_result result = cells_next(&reader->row, &reader->lines, separator);
        if (result == LINE_NONE && reader->n_rows == 0) {
            return fail_at_line(reader, "the table has no links", "expected a row for each");
        }
        if (result != LINE_THERE) {
            return result == LINE_NONE;
        }
        if (!take_row(reader)) {
            return false;
        }
    }
}

/* The file's name without folders and extension, for an arm that has no other; false where memory is short. */
static bool name_after_file(arm_reader *reader)
{
    if (reader->head.texts[TEXT_NAME] != NULL) {
        return true;
    }
    const char *slash = strrchr(reader->lines.path, '/');
    char *name = strdup(slash != NULL ? slash + 1 : reader->lines.path);
    if (name == NULL) {
        out_of_memory();
        return false;
    }
    char *dot = strrchr(name, '.');
    if (dot != NULL && dot != name) {
        *dot = '\0';
    }
    text_make_printable(name);
    reader->head.texts[TEXT_NAME] = name;
    return true;
}

static bool follows_another(const arm_reader *reader, size_t row)
{
    return reader->rows[row].motion.follows != row;
}

/* What a row follows has to be another's joint with a motor of its own. */
static bool check_couple(const arm_reader *reader, size_t row)
{
    const arm_entry *rows = reader->rows;
    const size_t leader = rows[row].motion.follows;
    const char *fault = NULL;
    if (leader >= reader->n_rows) {
        fault = "and there is no such row; rows are counted from 0";
    } else if (rows[leader].link.joint == ARMTOL_FIXED) {
        fault = "which has no joint";
    } else if (follows_another(reader, leader)) {
        fault = "which follows another itself; expected the row of the joint that the motor moves";
    }
    if (fault != NULL) {
        file_message(&reader->couples[row], "couple: the joint follows that of row %zu, %s", leader, fault);
    }
    return fault == NULL;
}

static bool check_couples(const arm_reader *reader)
{
    bool fine = true;
    for (size_t i = 0; i < reader->n_rows && fine; i++) {
        fine = !follows_another(reader, i) || check_couple(reader, i);
    }
    return fine;
}

static bool make_model(arm_reader *reader, arm_model *model)
{
    char *const *texts = reader->head.texts;
    if (!check_couples(reader) || !name_after_file(reader)) {
        return false;
    }
    const armtol_arm heading = {
        .name = texts[TEXT_NAME],
        .title = texts[TEXT_TITLE] != NULL ? texts[TEXT_TITLE] : texts[TEXT_NAME],
        .source = texts[TEXT_SOURCE] != NULL ? texts[TEXT_SOURCE] : "not given",
        .unit = reader->head.length_unit,
    };
    const arm_rows rows = {reader->rows, reader->n_rows, reader->columns.place[COLUMN_MASS] != NO_PLACE};
    const bool craig = reader->head.order == ORDER_CRAIG;
    return (craig ? craig_rows_make : arm_rows_make)(&rows, &heading, reader->head.angle_unit, model);
}

/* No fault: somebody may know that the tool's length is exact. */
static void warn_of_last_kind(const arm_reader *reader, const armtol_arm *arm)
{
    const armtol_link *last = &arm->links[arm->n_links - 1];
    const bool parallel = fabs(sin(last->alpha)) <= ARMTOL_USUAL_SNAP && last->beta == 0;
    if (last->joint == ARMTOL_REVOLUTE && last->kind == ARMTOL_PPR && parallel && last->d != 0) {
        file_message(&reader->last_kind,
                     "note: the last link is ppr, which counts its d, the length of the tool, as exact; "
                     "npr, as auto makes it, does not");
    }
}

bool arm_file_read(FILE *stream, const char *path, arm_model *model)
{
    arm_reader reader;
    *model = (arm_model){.arm = {.name = NULL}};
    start(&reader, stream, path);
    const bool fine = read_head(&reader) && read_table(&reader) && make_model(&reader, model);
    if (fine) {
        warn_of_last_kind(&reader, &model->arm);
    }
    end(&reader);
    return fine;
}
