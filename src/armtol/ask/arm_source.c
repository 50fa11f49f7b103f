#include "armtol/ask/arm_source.h"

#include "armtol/ask/units.h"
#include "armtol/names/link_name.h"
#include "armtol/tables/arm_file.h"
#include "armtol/tables/arm_laying.h"
#include "armtol/tables/arm_table.h"
#include "armtol/tables/degrees.h"
#include "armtol/urdf/urdf.h"
#include "armtol/urdf/xacro.h"
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

static bool is_urdf(FILE *stream)
{
    return first_character(stream) == '<';
}

static bool read_file(FILE *stream, const cli_options *options, arm_model *model)
{
    if (is_urdf(stream)) {
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
        message("%s: %s: %s: %g rad is too large; expected at most %g", path,
                link_words(&model->arm, i, &(link_text){""}), arm_column_name(column), radians, LARGEST_ANGLE);
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
static bool lay(const cli_options *options, bool of_urdf, arm_model *model)
{
    if (of_urdf) {
        return arm_laying_snap(model, options->snap);
    }
    return options->as_is || arm_laying_gather(model);
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

int arm_source_take(FILE *stream, const cli_options *options, arm_model *model)
{
    const bool of_urdf = is_urdf(stream);
    bool fine = read_file(stream, options, model);
    if (fine && !(check_count(options->arm, model) && check_angles(options->arm, model) &&
                  lay(options, of_urdf, model))) {
        arm_model_free(model);
        fine = false;
    }
    return fine ? EXIT_OK : EXIT_WRONG;
}

/* ---- the file ---- */

/* By way of a copy, since a pipe cannot be wound back. */
static int copy_pipe(FILE *pipe, const char *path, FILE **copy)
{
    *copy = tmpfile();
    if (*copy == NULL) {
        return cannot_copy(path);
    }
    const int code = copy_all(pipe, path, *copy);
    if (code != EXIT_OK) {
        fclose(*copy);
    } else {
        rewind(*copy);
    }
    return code;
}

static bool is_to_be_expanded(const cli_options *options)
{
    static const char ending[] = ".xacro";
    const size_t length = strlen(options->arm), n = sizeof ending - 1;
    return options->xacro || (length >= n && strcmp(options->arm + length - n, ending) == 0);
}

/* A stream that can be wound back. EXIT_OK, or an exit code after a message. */
static int open_arm(const cli_options *options, FILE **stream)
{
    *stream = fopen(options->arm, "rb");
    if (*stream == NULL) {
        exit_code_note_error(errno);
        const bool a_word = errno == ENOENT && strpbrk(options->arm, "./") == NULL;
        message(a_word ? "%s is neither a built-in arm (see --list) nor a file" : "%s: %s", options->arm,
                strerror(errno));
        return EXIT_WRONG;
    }
    if (is_to_be_expanded(options)) {
        fclose(*stream);
        return xacro_expand(options->arm, options->xacro_arguments, options->n_xacro_arguments, stream);
    }
    if (fseek(*stream, 0, SEEK_SET) == 0) {
        return EXIT_OK;
    }
    FILE *const pipe = *stream;
    const int code = copy_pipe(pipe, options->arm, stream);
    fclose(pipe);
    return code;
}

int arm_source_read(const cli_options *options, arm_model *model)
{
    const armtol_arm *built_in = armtol_arm_named(options->arm);
    if (built_in == NULL) {
        FILE *stream;
        const int opened = open_arm(options, &stream);
        if (opened != EXIT_OK) {
            return opened;
        }
        const int code = arm_source_take(stream, options, model);
        fclose(stream);
        return code;
    }
    if (options->base != NULL || options->tip != NULL || options->xacro) {
        message("--base, --tip and --xacro are for URDF files, and %s is a built-in arm", options->arm);
        return EXIT_WRONG;
    }
    return arm_model_make(model, built_in, UNIT_RADIAN) ? EXIT_OK : EXIT_FAILED;
}

static int draw(FILE *stream, const cli_options *options)
{
    const units shown = {
        .arm = ARMTOL_METRE,
        .length = options->length == UNITS_OF_ARM ? ARMTOL_METRE : units_chosen_length(options->length),
        .angle = options->angle == UNITS_SMALL ? UNIT_DEGREE : UNIT_RADIAN,
    };
    const urdf_units units = {units_shown(&shown, true, 1), units_shown(&shown, false, 1), units_name(&shown, true),
                              units_name(&shown, false)};
    if (!is_urdf(stream)) {
        message("--links is for URDF files, and %s is none", options->arm);
        return EXIT_WRONG;
    }
    return urdf_draw(stream, options->arm, &units, stdout) ? EXIT_OK : EXIT_WRONG;
}

int arm_source_draw(const cli_options *options)
{
    FILE *stream;
    if (armtol_arm_named(options->arm) != NULL) {
        message("--links is for URDF files, and %s is a built-in arm", options->arm);
        return EXIT_WRONG;
    }
    const int opened = open_arm(options, &stream);
    if (opened != EXIT_OK) {
        return opened;
    }
    const int code = draw(stream, options);
    fclose(stream);
    return code;
}
