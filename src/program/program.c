#include "program.h"

#include "analysis.h"
#include "dialogue.h"
#include "exit_code.h"
#include "message.h"
#include "options.h"
#include "outfile.h"
#include "report.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

/* What the judges of the answers need. */
typedef struct session {
    const program *program;
    analysis *analysis;
    const double *tolerances;
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
    /* at the very edge rounding can refuse what lies within: which edge it was is then the nearer one */
    const bool far = reach->distance > (reach->nearest + reach->farthest) / 2;
    const double excess = far ? reach->distance - reach->farthest : reach->nearest - reach->distance;
    message("desired position: out of reach: %s would be %.9g mm from %s, %.3g mm too %s; "
            "expected between %.9g and %.9g mm",
            program->reach_subject, reach->distance, program->reach_origin, fmax(excess, 0),
            far ? "far" : "near", reach->nearest, reach->farthest);
}

static bool judge_wish(const double wish[], void *context)
{
    const session *session = context;
    const armtol_status status = analysis_place(session->analysis, wish);
    if (status == ARMTOL_OUT_OF_REACH) {
        explain_reach(session->program, &session->analysis->reach);
    } else if (status == ARMTOL_SINGULAR) {
        message("desired position: %s", session->program->singular_text);
    } else if (status != ARMTOL_OK) {
        message("desired position: %s", armtol_status_text(status));
    }
    return status == ARMTOL_OK;
}

static const char *const tolerance_names[6] = {"dx", "dy", "dz", "dwx", "dwy", "dwz"};

static bool judge_tolerances(const double tolerances[], void *context)
{
    (void)context;
    for (int i = 0; i < 6; i++) {
        if (!(tolerances[i] > 0)) {
            message("%s: %g is no tolerance; expected a number greater than 0", tolerance_names[i],
                    tolerances[i]);
            return false;
        }
    }
    return true;
}

static bool judge_delta(const double delta[], void *context)
{
    const double *t = ((const session *)context)->tolerances;
    if (armtol_tolerances_check(t, delta[0]) == ARMTOL_OK) {
        return true;
    }
    message("delta: %g does not fit; expected a number greater than 0 and less than %g, the smallest of "
            "dx, dy and dz",
            delta[0], fmin(t[0], fmin(t[1], t[2])));
    return false;
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

static int fail(const char *what, armtol_status status)
{
    message("%s: %s", what, armtol_status_text(status));
    return EXIT_FAILED;
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
    const armtol_status status = analysis_matrix(session->analysis);
    if (status != ARMTOL_OK) {
        return fail("A", status);
    }
    return write_pair(session, folder, run, "a", report_matrix, "at", report_ordered) ? EXIT_OK : EXIT_FAILED;
}

/* From the tolerances to the files of tolerances. */
static int second_part(session *session, dialogue *dialogue, const folder *folder, int run)
{
    static const char *const delta_name[1] = {"delta"};
    const question accuracy = {"enter desired position and orientation tolerances: ", tolerance_names, 6};
    const question share = {"enter desired delta: ", delta_name, 1};
    double tolerances[6], delta[1];
    int code = dialogue_ask(dialogue, &accuracy, judge_tolerances, session, tolerances);
    if (code != EXIT_OK) {
        return code;
    }
    session->tolerances = tolerances;
    code = dialogue_ask(dialogue, &share, judge_delta, session, delta);
    if (code != EXIT_OK) {
        return code;
    }
    const armtol_status status = analysis_tolerances(session->analysis, tolerances, delta[0]);
    if (status != ARMTOL_OK) {
        return fail("bounds", status);
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
        fprintf(stderr, "These are the numbers of 1987, errata included; for an arm to be built: %s --fix all\n",
                program->name);
    } else if (kept > 0) {
        fprintf(stderr, "Some errata of 1987 are still included; for an arm to be built: %s --fix all\n",
                program->name);
    }
}

static int run(const program *program, const options *options, const folder *folder)
{
    analysis analysis;
    dialogue dialogue;
    session session = {program, &analysis, NULL};
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
