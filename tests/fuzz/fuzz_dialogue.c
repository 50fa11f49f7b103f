/*
 * A whole session of intella or adpta, files apart. The first byte says which program and whether it is on a terminal,
 * the next two which errata are corrected; the rest is what the user types.
 */

#include "fuzz/harness.h"
#include "fuzz/require.h"

#include "1987/options.h"
#include "files/outfile.h"
#include "1987/report.h"
#include "1987/session.h"
#include "console/exit_code.h"
#include "console/message.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int __wrap_isatty(int descriptor);
bool __wrap_outfiles_write(const folder *folder, const outfile files[], size_t count, const void *data);
bool __real_outfiles_write(const folder *folder, const outfile files[], size_t count, const void *data);

enum { EVERY = 1000 }; /* session of which the files are really written */

static struct {
    bool terminal;
    bool corrected;
    unsigned long number;
    int pairs; /* of files, written by the session at hand */
    folder folder;
    char path[64];
    FILE *file; /* in memory */
    char text[1 << 16];
} at_work;

int __wrap_isatty(int descriptor)
{
    return descriptor == STDIN_FILENO && at_work.terminal;
}

/* ---- what is in the files ---- */

static void check_finite(const double values[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        REQUIRE(isfinite(values[i]));
    }
}

static void check_matrix(const analysis *analysis)
{
    REQUIRE(analysis->n_lengths <= analysis->n_columns);
    check_finite(analysis->wish, analysis->robot->n_wish);
    check_finite(analysis->q, analysis->robot->n_joints);
    check_finite(analysis->check, analysis->robot->n_wish);
    check_finite(analysis->matrix, 6 * analysis->n_columns);
    check_finite(analysis->ordered, 6 * analysis->n_columns);
}

/* The tool is where it was wished, angles being the same a turn further. Beyond the size of arms nothing is said. */
static void check_place(const analysis *analysis)
{
    const size_t n = analysis->robot->n_wish;
    double size = 0;
    for (size_t i = 0; i < n; i++) {
        size = fmax(size, fabs(analysis->wish[i]));
    }
    if (size > 1e4) {
        return;
    }
    const double *wish = analysis->wish, *check = analysis->check;
    for (size_t i = 0; i < 3; i++) {
        REQUIRE(fabs(wish[i] - check[i]) <= 1e-6);
    }
    if (n == 4) {
        REQUIRE(fabs(sin((wish[3] - check[3]) / 2)) <= 1e-6);
        return;
    }
    const armtol_transform wished = armtol_pose_to_transform(wish, &armtol_errata_none);
    const armtol_transform reached = armtol_pose_to_transform(check, &armtol_errata_none);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            REQUIRE(fabs(wished.m[i][k] - reached.m[i][k]) <= 1e-6);
        }
    }
}

/* What every parameter may be off by keeps every component within its tolerance. */
static void check_guarantee(const analysis *analysis)
{
    for (size_t i = 0; i < 6; i++) {
        double sum = 0;
        for (size_t k = 0; k < analysis->n_columns; k++) {
            const bool is_length = k < analysis->n_lengths;
            sum += fabs(analysis->ordered[i * analysis->n_columns + k]) *
                   (is_length ? analysis->shares.distance : analysis->shares.angle);
        }
        REQUIRE(sum <= analysis->tolerances[i] * (1 + 1e-9));
    }
}

static void check_tolerances(const analysis *analysis)
{
    REQUIRE(analysis->bounds.angle >= 0 && analysis->bounds.distance >= 0);
    REQUIRE(isfinite(analysis->bounds.angle) && isfinite(analysis->bounds.distance));
    check_finite(analysis->machining, analysis->robot->n_links);
    check_finite(analysis->motor, analysis->robot->n_joints);
    if (!at_work.corrected) {
        return; /* an erratum takes a root of a difference, and floats round to 0 */
    }
    REQUIRE(analysis->bounds.angle > 0 && analysis->bounds.distance > 0);
    REQUIRE(analysis->shares.angle > 0 && analysis->shares.distance > 0);
    for (size_t i = 0; i < analysis->robot->n_links; i++) {
        REQUIRE(analysis->machining[i] >= 0);
    }
    for (size_t i = 0; i < analysis->robot->n_joints; i++) {
        REQUIRE(analysis->motor[i] >= 0);
    }
    check_guarantee(analysis);
}

/* As printed: no word where a number belongs. */
static void check_text(const outfile *file, const void *data)
{
    rewind(at_work.file);
    file->write(at_work.file, data);
    REQUIRE(!ferror(at_work.file) && fflush(at_work.file) == 0);
    const long length = ftell(at_work.file);
    REQUIRE(length > 0 && (size_t)length < sizeof at_work.text);
    at_work.text[length] = '\0';
    REQUIRE(strstr(at_work.text, "nan") == NULL && strstr(at_work.text, "inf") == NULL);
}

static bool exists(const char *name)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", at_work.path, name);
    return access(path, F_OK) == 0;
}

static void write_really(const outfile files[], size_t count, const void *data)
{
    REQUIRE(__real_outfiles_write(&at_work.folder, files, count, data));
    for (size_t i = 0; i < count; i++) {
        char path[512];
        REQUIRE(exists(files[i].name));
        snprintf(path, sizeof path, "%s/%s", at_work.path, files[i].name);
        remove(path);
    }
}

bool __wrap_outfiles_write(const folder *folder, const outfile files[], size_t count, const void *data)
{
    const report *report = data;
    REQUIRE(folder == &at_work.folder && count == 2 && at_work.pairs < 2);
    check_matrix(report->analysis);
    if (at_work.corrected) {
        check_place(report->analysis);
    }
    if (at_work.pairs == 1) {
        check_tolerances(report->analysis);
    }
    for (size_t i = 0; i < count; i++) {
        check_text(&files[i], data);
    }
    if (at_work.number % EVERY == 0) {
        write_really(files, count, data);
    }
    at_work.pairs++;
    return true;
}

/* ---- what is said ---- */

/* A terminal's user ends the line of a prompt, so that more may be said on it. */
static const char *behind_prompts(const char *line)
{
    static const char *const prompts[] = {"enter desired position: ",
                                          "enter desired position and orientation tolerances: ",
                                          "enter desired delta: "};
    const char *at;
    do {
        at = line;
        for (size_t i = 0; i < sizeof prompts / sizeof prompts[0]; i++) {
            const size_t length = strlen(prompts[i]);
            line += strncmp(line, prompts[i], length) == 0 ? length : 0;
        }
    } while (line != at);
    return line;
}

static bool begins(const char *line, const char *words)
{
    return strncmp(line, words, strlen(words)) == 0;
}

typedef struct said {
    size_t messages; /* warnings apart */
    size_t warnings;
    bool message_last;
    bool joints;
} said;

static said listen(const program *program)
{
    said said = {0, 0, false, false};
    for (const char *line = behind_prompts(caught_text()); *line != '\0'; line = behind_prompts(line)) {
        said.message_last = begins(line, program->name) && begins(line + strlen(program->name), ": ");
        const bool warning = said.message_last && begins(line + strlen(program->name), ": warning: ");
        said.warnings += warning;
        said.messages += said.message_last && !warning;
        said.joints = said.joints || begins(line, "itheta[0] = ");
        line += strcspn(line, "\n");
        line += *line == '\n';
    }
    return said;
}

static void check_ascii(void)
{
    for (const char *c = caught_text(); *c != '\0'; c++) {
        REQUIRE(isprint((unsigned char)*c) || *c == '\n');
    }
}

static void check_said(const program *program, int code)
{
    const said said = listen(program);
    REQUIRE(code == EXIT_OK || code == EXIT_WRONG);
    REQUIRE(code == EXIT_OK ? at_work.pairs == 2 : at_work.pairs < 2);
    REQUIRE(at_work.terminal || said.messages == (code == EXIT_OK ? 0 : 1));
    REQUIRE(said.warnings <= (code == EXIT_OK ? 1 : 0));
    REQUIRE(code == EXIT_OK || said.message_last);
    REQUIRE(said.joints == (at_work.pairs > 0));
    check_ascii();
}

/* ---- sessions ---- */

static armtol_errata errata_of(unsigned mask)
{
    armtol_errata errata = armtol_errata_1987;
    for (size_t i = 0; i < armtol_errata_count(); i++) {
        if ((mask >> i & 1) != 0) {
            armtol_erratum_keep(&errata, armtol_erratum(i)->id, false);
        }
    }
    return errata;
}

/* '0' in the second byte keeps all, '1' corrects all; else both bytes are a mask. */
static armtol_errata take_errata(const uint8_t *data)
{
    const armtol_errata errata = data[1] == '0'   ? armtol_errata_1987
                                 : data[1] == '1' ? armtol_errata_none
                                                  : errata_of(data[1] | (unsigned)data[2] << 8);
    at_work.corrected = true;
    for (size_t i = 0; i < armtol_errata_count(); i++) {
        at_work.corrected = at_work.corrected && !armtol_erratum_is_kept(&errata, i);
    }
    return errata;
}

static void remove_folder(void)
{
    rmdir(at_work.path);
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    const char *scratch = getenv("TMPDIR");
    (void)argc;
    (void)argv;
    caught_start("intella");
    snprintf(at_work.path, sizeof at_work.path, "%.40s/fuzz-XXXXXX", scratch != NULL ? scratch : P_tmpdir);
    REQUIRE(mkdtemp(at_work.path) != NULL && folder_open(&at_work.folder, at_work.path));
    atexit(remove_folder);
    at_work.file = fmemopen(at_work.text, sizeof at_work.text, "w");
    REQUIRE(at_work.file != NULL);
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    enum { HEAD = 3 };
    if (size < HEAD) {
        return 0;
    }
    const program *program = (data[0] & 1) != 0 ? &program_adpta : &program_intella;
    const options options = {ACTION_RUN, at_work.path, 1, take_errata(data)};
    at_work.terminal = (data[0] & 2) != 0;
    at_work.pairs = 0;
    at_work.number++;
    caught_forget();
    message_start(program->name);
    stdin = caught_file(data + HEAD, size - HEAD);
    const int code = session_run(program, &options, &at_work.folder);
    fclose(stdin);
    check_said(program, code);
    return 0;
}
