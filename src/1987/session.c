#include "1987/session.h"

#include "1987/analysis.h"
#include "1987/dialogue.h"
#include "1987/report.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "console/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* What the judges of the answers need, and what they find out. */
typedef struct session {
    const program *program;
    analysis *analysis;
    double tolerances[6];
} session;

static void explain_reach(const program *program, const armtol_reach *reach)
{
    const bool far = reach->distance > (reach->nearest + reach->farthest) / 2;
    const double excess = far ? reach->distance - reach->farthest : reach->nearest - reach->distance;
    char how[64] = "at the very edge, where rounding decides";
    if (excess > 1e-3) {
        snprintf(how, sizeof how, "%.6g mm too %s", excess, far ? "far" : "near");
    }
    message("desired position: out of reach: %s would be %.9g mm from %s, %s; expected between %.9g and %.9g mm",
            program->reach_subject, reach->distance, program->reach_origin, how, reach->nearest,
            reach->farthest);
}

/* A wish is fine when the arm gets there and A can be computed there. */
static bool judge_wish(const double wish[], void *context)
{
    const session *session = context;
    const program *program = session->program;
    armtol_status status = analysis_place(session->analysis, wish);
    if (status == ARMTOL_OK) {
        status = analysis_matrix(session->analysis, NULL);
    }
    switch (status) {
    case ARMTOL_OK:
        return true;
    case ARMTOL_OUT_OF_REACH:
        explain_reach(program, &session->analysis->reach);
        return false;
    case ARMTOL_SINGULAR:
        message("desired position: singular: %s", program->singular_text);
        return false;
    case ARMTOL_NOT_FINITE:
        message("desired position: too large to compute with; expected numbers of an arm's size");
        return false;
    default:
        message("desired position: %s", armtol_status_text(status));
        return false;
    }
}

static bool judge_tolerances(const double tolerances[], void *context)
{
    const armtol_errata *errata = &((const session *)context)->analysis->errata;
    for (int i = 0; i < 6; i++) {
        if (!(tolerances[i] > 0)) {
            message("%s: %s is no tolerance; expected a number greater than 0", tolerance_names[i],
                    number_shortest(tolerances[i], errata, &(number_text){""}));
            return false;
        }
    }
    return true;
}

/* A delta is fine when tolerances of the parts come out of it. */
static bool judge_delta(const double delta[], void *context)
{
    const session *session = context;
    const double *t = session->tolerances;
    const armtol_status status = analysis_tolerances(session->analysis, t, delta[0]);
    if (status == ARMTOL_BAD_DELTA) {
        const armtol_errata *errata = &session->analysis->errata;
        message("delta: %s does not fit; expected a number greater than 0 and less than %s, the smallest of "
                "dx, dy and dz",
                number_shortest(delta[0], errata, &(number_text){""}),
                number_shortest(fmin(t[0], fmin(t[1], t[2])), errata, &(number_text){""}));
    } else if (status != ARMTOL_OK) {
        message("delta and tolerances: too large to compute with; expected numbers of an arm's size");
    }
    return status == ARMTOL_OK;
}

/* Write the file `first` of report_files and the one after it, together. */
static int write_pair(const session *session, const folder *folder, int run, int first)
{
    outfile files[2];
    const report report = {session->program, session->analysis};
    for (int i = 0; i < 2; i++) {
        const report_file *file = &report_files[first + i];
        snprintf(files[i].name, sizeof files[i].name, "%s%s.%d", session->program->file_prefix, file->part, run);
        files[i].write = file->write;
    }
    return outfiles_write(folder, files, 2, &report) ? EXIT_OK : EXIT_FAILED;
}

/* From the wish to the files of A. */
static int first_part(session *session, dialogue *dialogue, const folder *folder, int run)
{
    const program *program = session->program;
    const question position = {"enter desired position: ", program->wish_names, program->robot->n_wish};
    const int code = dialogue_ask(dialogue, &position, judge_wish, session, session->analysis->wish);
    if (code != EXIT_OK) {
        return code;
    }
    report_joints(stderr, session->analysis);
    message_answered(true);
    return write_pair(session, folder, run, REPORT_MATRIX);
}

/* From the tolerances to the files of tolerances. */
static int second_part(session *session, dialogue *dialogue, const folder *folder, int run)
{
    static const char *const delta_name[1] = {"delta"};
    const question accuracy = {"enter desired position and orientation tolerances: ", tolerance_names, 6};
    const question share = {"enter desired delta: ", delta_name, 1};
    int code = dialogue_ask(dialogue, &accuracy, judge_tolerances, session, session->tolerances);
    if (code == EXIT_OK) {
        double delta[1];
        code = dialogue_ask(dialogue, &share, judge_delta, session, delta);
    }
    return code == EXIT_OK ? write_pair(session, folder, run, REPORT_TOLERANCES) : code;
}

/* Only where some are kept: who corrects all means all that there are. */
static void tell_of_errata_without_effect(const program *program, const armtol_errata *errata)
{
    char without[512] = "";
    for (size_t i = 0; i < armtol_errata_count(); i++) {
        if (!armtol_erratum_is_kept(errata, i) && !program_shows_erratum(program, i)) {
            strncat(without, without[0] != '\0' ? ", " : "", sizeof without - strlen(without) - 1);
            strncat(without, armtol_erratum(i)->id, sizeof without - strlen(without) - 1);
        }
    }
    if (errata_kept(errata) > 0 && without[0] != '\0') {
        message_note("--fix: in %s this changes nothing: %s", program->name, without);
    }
}

/* Nobody should build an arm to the numbers of 1987 unawares. */
static void warn_of_errata(const program *program, const armtol_errata *errata)
{
    const size_t kept = errata_kept(errata);
    if (kept > 0) {
        message_note("%s; for an arm to be built: %s --fix all",
                     kept == armtol_errata_count() ? "These are the numbers of 1987, errata included"
                                                   : "Some errata of 1987 are still included",
                     program->name);
    }
}

int session_run(const program *program, const options *options, const folder *folder)
{
    analysis analysis;
    dialogue dialogue;
    session session = {program, &analysis, {0}};
    if (!analysis_start(&analysis, program->robot, &options->errata)) {
        out_of_memory();
        return EXIT_FAILED;
    }
    tell_of_errata_without_effect(program, &options->errata);
    dialogue_start(&dialogue, stdin, isatty(STDIN_FILENO), &options->errata);
    int code = first_part(&session, &dialogue, folder, options->run);
    if (code == EXIT_OK) {
        code = second_part(&session, &dialogue, folder, options->run);
    }
    if (code == EXIT_OK) {
        dialogue_end(&dialogue);
    }
    if (code == EXIT_OK && isatty(STDERR_FILENO)) {
        warn_of_errata(program, &options->errata);
        message_end_line(); /* a shell's prompt comes next; into a file the last prompt goes as in 1987 */
    }
    analysis_free(&analysis);
    return code;
}
