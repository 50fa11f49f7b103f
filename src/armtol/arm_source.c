#include "arm_source.h"

#include "arm_file.h"
#include "arm_table.h"
#include "degrees.h"
#include "exit_code.h"
#include "message.h"
#include "urdf.h"

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

/* Up to the end of the pipe, which may have none: no arm is that large. False, with errno, where that fails. */
static bool copy_all(FILE *pipe, FILE *copy)
{
    enum { MOST = 1 << 24 };
    char block[4096];
    size_t n, length = 0;
    while ((n = fread(block, 1, sizeof block, pipe)) > 0) {
        length += n;
        if (length > MOST) {
            errno = EFBIG;
            return false;
        }
        if (fwrite(block, 1, n, copy) < n) {
            return false;
        }
    }
    return !ferror(pipe) && fflush(copy) == 0;
}

/* What is kept of a pipe, which cannot be wound back, so that it can; NULL, with errno, where that fails. */
static FILE *copy_of(FILE *pipe)
{
    FILE *copy = tmpfile();
    if (copy != NULL && !copy_all(pipe, copy)) {
        const int why = errno;
        fclose(copy);
        errno = why;
        return NULL;
    }
    if (copy != NULL) {
        rewind(copy);
    }
    return copy;
}

static bool read_file(FILE *stream, const cli_options *options, arm_model *model)
{
    if (first_character(stream) == '<') {
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
    armtol_link link = model->arm.links[i];
    armtol_drive drive = model->arm.drives[i];
    const double radians = *arm_column_number(column, &link, &drive);
    const bool fine = !isfinite(radians) || fabs(radians) <= LARGEST_ANGLE;
    if (!fine) {
        message("%s: link %zu: %s: %g rad is too large an angle", path, i, arm_column_name(column), radians);
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

static int read_and_close(FILE *stream, const cli_options *options, arm_model *model)
{
    bool fine = read_file(stream, options, model);
    fclose(stream);
    if (fine && !check_angles(options->arm, model)) {
        arm_model_free(model);
        fine = false;
    }
    return fine ? EXIT_OK : EXIT_WRONG;
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
    FILE *copy = copy_of(stream);
    fclose(stream);
    if (copy == NULL) {
        message("%s: cannot be copied: %s", options->arm, strerror(errno));
        return EXIT_FAILED;
    }
    return read_and_close(copy, options, model);
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
