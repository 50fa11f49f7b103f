#include "armtol/ask/arm_source.h"

#include "armtol/tables/arm_file.h"
#include "armtol/tables/arm_laying.h"
#include "armtol/tables/arm_table.h"
#include "armtol/tables/degrees.h"
#include "armtol/urdf/urdf.h"
#include "console/exit_code.h"
#include "console/message.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* White space, and what a byte order mark or a text in UTF-16 has about its letters. */
static bool comes_before(int c)
{
    return c == '\0' || strchr(" \t\r\n\xef\xbb\xbf\xfe\xff", c) != NULL;
}

/* The first character of the text, if it is near the beginning; the stream is then at its start again. */
static int first_character(FILE *stream)
{
    enum { NEAR = 4096 };
    int c = getc(stream);
    for (int i = 0; i < NEAR && c != EOF && comes_before(c); i++) {
        c = getc(stream);
    }
    rewind(stream);
    return c;
}

static int cannot_copy(const char *path)
{
    message("%s: cannot be copied: %s", path, strerror(errno));
    return EXIT_FAILED;
}

/* Up to the end of the pipe, which may have none: no arm is that large. An exit code, after a message. */
static int copy_all(FILE *pipe, const char *path, FILE *copy)
{
    enum { MOST = 1 << 24 };
    char block[4096];
    size_t n, length = 0;
    while ((n = fread(block, 1, sizeof block, pipe)) > 0) {
        length += n;
        if (length > MOST) {
            message("%s: is too long; expected an arm of at most %d bytes through a pipe", path, MOST);
            return EXIT_WRONG;
        }
        if (fwrite(block, 1, n, copy) < n) {
            return cannot_copy(path);
        }
    }
    return ferror(pipe) || fflush(copy) != 0 ? cannot_copy(path) : EXIT_OK;
}

static bool read_file(FILE *stream, const cli_options *options, arm_model *model, bool *is_table)
{
    *is_table = first_character(stream) != '<';
    if (!*is_table) {
        return urdf_read(stream, options->arm, options->base, options->tip, model);
    }
    if (options->base != NULL || options->tip != NULL) {
        message("--base and --tip are for URDF files, and %s is none", options->arm);
        return false;
    }
    return arm_file_read(stream, options->arm, model);
}

/* A double has to hold it in degrees too, in which it may be shown. A joint without an end is none of these. */
static bool check_angle(const char *path, const arm_model *model, size_t i, arm_column column)
{
    arm_entry entry = arm_entry_of(&model->arm, i);
    const double radians = *arm_column_number(column, &entry);
    const bool fine = !isfinite(radians) || fabs(radians) <= LARGEST_ANGLE;
    if (!fine) {
        message("%s: link %zu: %s: %g rad is too large; expected at most %g", path, i, arm_column_name(column), radians,
                LARGEST_ANGLE);
    }
    return fine;
}

static bool check_angles(const char *path, const arm_model *model)
{
    bool fine = true;
    for (size_t i = 0; i < model->arm.n_links && fine; i++) {
        for (arm_column column = COLUMN_A; column < ARM_COLUMNS && fine; column++) {
            fine = !arm_column_is_angle(column, model->arm.links[i].joint) ||
                   check_angle(path, model, i, column);
        }
    }
    return fine;
}

/* A URDF has digits that decide nothing, a table frames that its author chose, but for those that lie far off. */
static bool lay(const cli_options *options, bool is_table, arm_model *model)
{
    if (is_table) {
        return options->as_is || arm_laying_gather(model);
    }
    return arm_laying_snap(model, options->snap);
}

/* The same for a URDF as for the table that it may be shown as. */
static bool check_count(const char *path, const arm_model *model)
{
    const bool fine = model->arm.n_links <= ARM_MOST_LINKS;
    if (!fine) {
        message("%s: the chain has %zu links; expected at most %d", path, model->arm.n_links, ARM_MOST_LINKS);
    }
    return fine;
}

static int read_and_close(FILE *stream, const cli_options *options, arm_model *model)
{
    bool is_table;
    bool fine = read_file(stream, options, model, &is_table);
    fclose(stream);
    if (fine && !(check_count(options->arm, model) && check_angles(options->arm, model) &&
                  lay(options, is_table, model))) {
        arm_model_free(model);
        fine = false;
    }
    return fine ? EXIT_OK : EXIT_WRONG;
}

/* By way of a copy, since a pipe cannot be wound back. */
static int read_pipe(FILE *pipe, const cli_options *options, arm_model *model)
{
    FILE *copy = tmpfile();
    if (copy == NULL) {
        return cannot_copy(options->arm);
    }
    const int code = copy_all(pipe, options->arm, copy);
    if (code != EXIT_OK) {
        fclose(copy);
        return code;
    }
    rewind(copy);
    return read_and_close(copy, options, model);
}

static int open_and_read(const cli_options *options, arm_model *model)
{
    FILE *stream = fopen(options->arm, "rb");
    if (stream == NULL) {
        exit_code_note_error(errno);
        const bool a_word = errno == ENOENT && strpbrk(options->arm, "./") == NULL;
        message(a_word ? "%s is neither a built-in arm (see --list) nor a file" : "%s: %s", options->arm,
                strerror(errno));
        return EXIT_WRONG;
    }
    if (fseek(stream, 0, SEEK_SET) == 0) {
        return read_and_close(stream, options, model);
    }
    const int code = read_pipe(stream, options, model);
    fclose(stream);
    return code;
}

int arm_source_read(const cli_options *options, arm_model *model)
{
    const armtol_arm *built_in = armtol_arm_named(options->arm);
    if (built_in == NULL) {
        return open_and_read(options, model);
    }
    if (options->base != NULL || options->tip != NULL) {
        message("--base and --tip are for URDF files, and %s is a built-in arm", options->arm);
        return EXIT_WRONG;
    }
    return arm_model_make(model, built_in, UNIT_RADIAN) ? EXIT_OK : EXIT_FAILED;
}
