#include "program.h"

#include "analysis.h"
#include "dialogue.h"
#include "exit_code.h"
#include "message.h"
#include "number.h"
#include "options.h"
#include "outfile.h"
#include "report.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

/* What the judges of the answers need, and what they find out. */
typedef struct session {
    const program *program;
    analysis *analysis;
    double tolerances[6];
} session;

static void print_help(const program *program)
{
    printf("Usage: %s [OPTION]...\n"
           "Tolerances for the links, joints and motors of %s, from a wished position\n"
           "of its tool and the accuracy wished there, as the program of 1987 computed them.\n"
           "Asks on standard error, reads standard input: the position (",
           program->name, program->title);
    for (size_t i = 0; i < program->robot->n_wish; i++) {
        printf("%s%s", i > 0 ? " " : "", program->wish_names[i]);
    }
    printf("),\n"
           "the six tolerances (dx dy dz dwx dwy dwz) and delta, in mm and radians.\n"
           "Writes %sa.N, %sat.N, %stol.N and %smach.N.\n"
           "\n"
           "  -o, --output DIR            write the files into DIR (default: the current folder)\n"
           "  -r, --run N                 the run number in their names (default: 1)\n"
           "  -f, --fix NAME[,NAME]...    correct the named errata of 1987; `all' for every one\n"
           "  -l, --list-errata           list the errata and what each touches\n"
           "  -h, --help                  show this and exit\n"
           "  -V, --version               show the version and exit\n"
           "\n"
           "Exit status: 0 done, 2 wrong input or usage, 1 any other failure.\n",
           program->file_prefix, program->file_prefix, program->file_prefix, program->file_prefix);
}

static void print_errata(void)
{
    for (size_t i = 0; i < armtol_errata_count(); i++) {
        const armtol_erratum_info *erratum = armtol_erratum(i);
        printf("%-16s %s\n%-16s touches: %s\n", erratum->id, erratum->slip, "", erratum->touches);
    }
}

static int print(action action, const program *program)
{
    switch (action) {
    case ACTION_LIST_ERRATA:
        print_errata();
        break;
    case ACTION_HELP:
        print_help(program);
        break;
    default:
        printf("%s (armtol) %s\n", program->name, armtol_version());
        break;
    }
    if (fflush(stdout) != 0 || ferror(stdout)) {
        message("cannot write to standard output");
        return EXIT_FAILED;
    }
    return EXIT_OK;
}

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
        status = analysis_matrix(session->analysis);
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

static const char *const tolerance_names[6] = {"dx", "dy", "dz", "dwx", "dwy", "dwz"};

static bool judge_tolerances(const double tolerances[], void *context)
{
    const armtol_errata *errata = &((const session *)context)->analysis->errata;
    for (int i = 0; i < 6; i++) {
        if (!(tolerances[i] > 0)) {
            message("%s: %s is no tolerance; expected a number greater than 0", tolerance_names[i],
                    number_shortest(tolerances[i], errata).text);
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
                number_shortest(delta[0], errata).text,
                number_shortest(fmin(t[0], fmin(t[1], t[2])), errata).text);
    } else if (status != ARMTOL_OK) {
        message("delta and tolerances: too large to compute with; expected numbers of an arm's size");
    }
    return status == ARMTOL_OK;
}

/* Write two files of this run together. False after a message. */
static bool write_pair(const session *session, const folder *folder, int run, const char *first,
                       void (*write_first)(FILE *, const void *), const char *second,
                       void (*write_second)(FILE *, const void *))
{
    outfile files[2] = {{.write = write_first}, {.write = write_second}};
    const char *const parts[2] = {first, second};
    const report report = {session->program, session->analysis};
    for (int i = 0; i < 2; i++) {
        snprintf(files[i].name, sizeof files[i].name, "%s%s.%d", session->program->file_prefix, parts[i],
                 run);
    }
    return outfiles_write(folder, files, 2, &report);
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
    message_answered();
    return write_pair(session, folder, run, "a", report_matrix, "at", report_ordered) ? EXIT_OK : EXIT_FAILED;
}

/* From the tolerances to the files of tolerances. */
static int second_part(session *session, dialogue *dialogue, const folder *folder, int run)
{
    static const char *const delta_name[1] = {"delta"};
    const question accuracy = {"enter desired position and orientation tolerances: ", tolerance_names, 6};
    const question share = {"enter desired delta: ", delta_name, 1};
    double delta[1];
    int code = dialogue_ask(dialogue, &accuracy, judge_tolerances, session, session->tolerances);
    if (code == EXIT_OK) {
        code = dialogue_ask(dialogue, &share, judge_delta, session, delta);
    }
    if (code != EXIT_OK) {
        return code;
    }
    return write_pair(session, folder, run, "tol", report_tolerances, "mach", report_machining)
               ? EXIT_OK
               : EXIT_FAILED;
}

/* Nobody should build an arm to the numbers of 1987 unawares. */
static void warn_of_errata(const program *program, const armtol_errata *errata)
{
    size_t kept = 0;
    for (size_t i = 0; i < armtol_errata_count(); i++) {
        kept += armtol_erratum_is_kept(errata, i);
    }
    if (kept == armtol_errata_count()) {
        message_note("These are the numbers of 1987, errata included; for an arm to be built: %s --fix all",
                     program->name);
    } else if (kept > 0) {
        message_note("Some errata of 1987 are still included; for an arm to be built: %s --fix all",
                     program->name);
    }
}

static int run(const program *program, const options *options, const folder *folder)
{
    analysis analysis;
    dialogue dialogue;
    session session = {program, &analysis, {0}};
    if (!analysis_start(&analysis, program->robot, &options->errata)) {
        message("out of memory");
        return EXIT_FAILED;
    }
    dialogue_start(&dialogue, stdin, isatty(STDIN_FILENO), &options->errata);
    int code = first_part(&session, &dialogue, folder, options->run);
    if (code == EXIT_OK) {
        code = second_part(&session, &dialogue, folder, options->run);
    }
    if (code == EXIT_OK && isatty(STDERR_FILENO)) {
        warn_of_errata(program, &options->errata);
    }
    analysis_free(&analysis);
    return code;
}

int program_main(int argc, char *argv[], const program *program)
{
    options options;
    folder folder;
    message_start(program->name);
    signal(SIGXFSZ, SIG_IGN); /* a file size limit is then a failed write, with a message */
    const int code = options_parse(argc, argv, &options);
    if (code != EXIT_OK) {
        return code;
    }
    if (options.action != ACTION_RUN) {
        return print(options.action, program);
    }
    if (!folder_open(&folder, options.folder)) {
        return EXIT_FAILED;
    }
    const int ended = run(program, &options, &folder);
    folder_close(&folder);
    return ended;
}
