#include "armtol/tables/arm_file.h"

#include "armtol/axes.h"
#include "armtol/tables/arm_head.h"
#include "armtol/tables/arm_row.h"
#include "armtol/tables/arm_table.h"
#include "armtol/tables/cells.h"
#include "console/exit_code.h"
#include "console/file_message.h"
#include "console/list_room.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char expected_head[] = "expected a row of names: joint, a, alpha, d, theta and, as needed, kind, beta, "
                                    "low, high, backlash, compliance, moment, resolution, friction, mass, com_x, com_y, com_z";

/* All that is at work while a file is read. */
typedef struct arm_reader {
    text_lines lines;
    cell_row row;
    arm_head head;
    arm_columns columns;
    size_t n_links;
    size_t link_room, drive_room, mass_room, given_room;
    armtol_link *links;
    armtol_drive *drives;
    armtol_mass *masses;
    bool *kinds_given;
    file_place last_kind; /* where the last row's kind stands */
} arm_reader;

static void start(arm_reader *reader, FILE *stream, const char *path)
{
    *reader = (arm_reader){.n_links = 0};
    text_lines_start(&reader->lines, stream, path);
    cells_start(&reader->row);
    arm_head_start(&reader->head);
}

static void end(arm_reader *reader)
{
    text_lines_free(&reader->lines);
    cells_free(&reader->row);
    arm_head_free(&reader->head);
    free(reader->links);
    free(reader->drives);
    free(reader->masses);
    free(reader->kinds_given);
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

/* Room for one link more. */
static bool grow(arm_reader *reader)
{
    armtol_link *links = list_room(reader->links, reader->n_links, &reader->link_room, sizeof *links);
    if (links == NULL) {
        return false;
    }
    reader->links = links;
    armtol_drive *drives = list_room(reader->drives, reader->n_links, &reader->drive_room, sizeof *drives);
    reader->drives = drives != NULL ? drives : reader->drives;
    if (drives == NULL) {
        return false;
    }
    armtol_mass *masses = list_room(reader->masses, reader->n_links, &reader->mass_room, sizeof *masses);
    reader->masses = masses != NULL ? masses : reader->masses;
    if (masses == NULL) {
        return false;
    }
    bool *given = list_room(reader->kinds_given, reader->n_links, &reader->given_room, sizeof *given);
    reader->kinds_given = given != NULL ? given : reader->kinds_given;
    return given != NULL;
}

static file_place place_of_kind(const arm_reader *reader)
{
    const size_t place = reader->columns.place[COLUMN_KIND];
    const size_t column = place < reader->row.n ? reader->row.cells[place].column : 1;
    return (file_place){reader->lines.path, reader->lines.number, column};
}

static bool take_row(arm_reader *reader)
{
    if (reader->n_links == ARM_MOST_LINKS) {
        cells_message(&reader->row, 0, "more than %d links", ARM_MOST_LINKS);
        return false;
    }
    arm_entry entry;
    if (!grow(reader) || !arm_row_read(&reader->row, &reader->columns, reader->head.angle_unit, &entry)) {
        return false;
    }
    reader->links[reader->n_links] = entry.link;
    reader->drives[reader->n_links] = entry.drive;
    reader->masses[reader->n_links] = entry.mass;
    reader->kinds_given[reader->n_links] = entry.kind_given;
    reader->last_kind = place_of_kind(reader);
    reader->n_links++;
    return true;
}

static bool read_table(arm_reader *reader)
{
    if (!arm_columns_read(&reader->columns, &reader->row)) {
        return false;
    }
    if (!reader->head.has_units) {
        return fail_at_line(reader, "no units above the table",
                            "expected a line \"units: mm deg\" (mm or m, deg or rad)");
    }
    const char separator = reader->row.separator;
    for (;;) {
        const line_result result = cells_next(&reader->row, &reader->lines, separator);
        if (result == LINE_NONE && reader->n_links == 0) {
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

/* ---- kinds ---- */

static bool fill_kinds(arm_reader *reader, armtol_axis rows[], armtol_kind kinds[])
{
    if (rows == NULL || kinds == NULL) {
        out_of_memory();
        return false;
    }
    /* What overflows has no kinds, and the same is said where it is to be placed. */
    if (armtol_kinds_of_links(reader->links, reader->n_links, rows, kinds) == ARMTOL_OK) {
        for (size_t i = 0; i < reader->n_links; i++) {
            reader->links[i].kind = reader->kinds_given[i] ? reader->links[i].kind : kinds[i];
        }
    }
    return true;
}

/* The kinds that the table leaves to the axes. */
static bool choose_kinds(arm_reader *reader)
{
    armtol_axis *rows = calloc(reader->n_links, sizeof *rows);
    armtol_kind *kinds = calloc(reader->n_links, sizeof *kinds);
    const bool fine = fill_kinds(reader, rows, kinds);
    free(rows);
    free(kinds);
    return fine;
}

/* No fault: somebody may know that the tool's length is exact. */
static void warn_of_last_kind(const arm_reader *reader)
{
    const armtol_link *last = &reader->links[reader->n_links - 1];
    const bool parallel = fabs(sin(last->alpha)) <= ARMTOL_USUAL_SNAP && last->beta == 0;
    if (last->joint == ARMTOL_REVOLUTE && last->kind == ARMTOL_PPR && parallel && last->d != 0) {
        file_message(&reader->last_kind, "note: the last link is ppr, which counts its d, the length of the tool, as exact; "
                                         "npr, as auto makes it, does not");
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

static bool make_model(arm_reader *reader, arm_model *model)
{
    char *const *texts = reader->head.texts;
    if (!name_after_file(reader)) {
        return false;
    }
    const armtol_arm arm = {
        .name = texts[TEXT_NAME],
        .title = texts[TEXT_TITLE] != NULL ? texts[TEXT_TITLE] : texts[TEXT_NAME],
        .source = texts[TEXT_SOURCE] != NULL ? texts[TEXT_SOURCE] : "not given",
        .unit = reader->head.length_unit,
        .n_links = reader->n_links,
        .links = reader->links,
        .drives = reader->drives,
        .masses = reader->columns.place[COLUMN_MASS] != NO_PLACE ? reader->masses : NULL,
    };
    return arm_model_make(model, &arm, reader->head.angle_unit);
}

bool arm_file_read(FILE *stream, const char *path, arm_model *model)
{
    arm_reader reader;
    *model = (arm_model){.arm = {.name = NULL}};
    start(&reader, stream, path);
    const bool fine =
        read_head(&reader) && read_table(&reader) && choose_kinds(&reader) && make_model(&reader, model);
    if (fine) {
        warn_of_last_kind(&reader);
    }
    end(&reader);
    return fine;
}
