/* armtol: how precisely the parts of an arm have to be made. */

#include "armtol/against/against.h"
#include "armtol/armtol.h"
#include "armtol/ask/arm_source.h"
#include "armtol/ask/options.h"
#include "armtol/ask/request.h"
#include "armtol/ask/watched.h"
#include "armtol/tables/arm_file.h"
#include "armtol/tell/arm_list.h"
#include "armtol/tell/branches.h"
#include "armtol/tell/json_arms.h"
#include "armtol/tell/laying.h"
#include "armtol/tell/output.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "console/rounding.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static size_t threads_of(const cli_options *options)
{
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    return options->threads != 0 ? options->threads : processors > 0 ? (size_t)processors : 1;
}

/* A component, or a norm, that has to keep to an accuracy. */
static void say_unbounded(const armtol_answer *answer, const armtol_fault *fault)
{
    const bool is_norm = fault->about == ARMTOL_ABOUT_NORM;
    const char *name = is_norm ? armtol_norm_name(answer->norms[fault->number].components)
                               : armtol_component_name(fault->number);
    message("--verify: the tolerances leave %s without a bound; expected finite ones for all that %s depends on, or %s "
            "in --accuracy",
            name, name, is_norm ? "none for it" : "- in its place");
}

/* An exit code, after a message. */
static int verify(const request *request, const armtol_answer *answer, armtol_verification *found)
{
    const armtol_draw draw = {
        .samples = request->options->verify,
        .seed = request->options->seed,
        .n_threads = threads_of(request->options),
    };
    armtol_fault fault;
    const armtol_status status = watched_verify(answer, &draw, found, &fault);
    if (status == ARMTOL_UNBOUNDED) {
        say_unbounded(answer, &fault);
        return EXIT_WRONG;
    }
    return status == ARMTOL_OK ? EXIT_OK : request_failed(request, &fault);
}

static bool print(const findings *findings)
{
    switch (findings->request->options->format) {
    case OUTPUT_JSON:
        return output_json(findings);
    case OUTPUT_CSV:
        return output_csv(findings);
    default:
        return output_text(findings);
    }
}

static int tell(const request *request, const armtol_answer *answer)
{
    armtol_budget *budget = NULL;
    armtol_verification found;
    findings findings = {request, answer, NULL, NULL};
    if (request->options->verify != 0) {
        const int code = verify(request, answer, &found);
        if (code != EXIT_OK) {
            return code;
        }
        findings.verification = &found;
    }
    if (request->options->budget && armtol_budget_create(answer, &budget) != ARMTOL_OK) {
        out_of_memory();
        return EXIT_FAILED;
    }
    findings.budget = budget;
    const bool fine = print(&findings);
    armtol_budget_destroy(budget);
    return fine ? EXIT_OK : EXIT_FAILED;
}

static int answer_request(const request *request)
{
    armtol_answer *answer;
    int code = request_answer(request, &answer);
    if (code == EXIT_OK) {
        code = tell(request, answer);
        armtol_answer_destroy(answer);
    }
    return code;
}

static int run(const cli_options *options, const arm_model *model)
{
    request request;
    const int code = request_make(&request, options, model);
    if (code != EXIT_OK) {
        return code;
    }
    const int ended = against_is_asked(options) ? against_run(&request, model) : answer_request(&request);
    request_free(&request);
    return ended;
}

/* All ways to bring the tool where it is asked to be. */
static int list_branches(const cli_options *options, const arm_model *model)
{
    const units units = units_chosen(options, model);
    at_wishes at;
    if (!at_make(&at, options, &units, &model->arm)) {
        return EXIT_WRONG;
    }
    const bool fine = branches_print(&at, options->format);
    at_free(&at);
    return fine ? EXIT_OK : EXIT_WRONG;
}

static int show(arm_model *model, const cli_options *options)
{
    bool fine = true;
    units units = units_chosen(options, model);
    const struct units laid = units; /* what was laid anew is told in the arm's own lengths, as they are to be shown */
    if (!arm_model_convert(model, units.length)) {
        return EXIT_WRONG;
    }
    units.arm = units.length;
    if (options->format == OUTPUT_JSON) {
        json_show(model, &units, &laid);
    } else {
        laying_print(&model->laying, &laid, "# ");
        const row_order order = options->craig ? ORDER_CRAIG : ORDER_PAUL;
        fine = arm_file_write(&model->arm, order, units.angle, stdout);
    }
    return fine ? EXIT_OK : EXIT_FAILED;
}

static int with_arm(const cli_options *options)
{
    arm_model model;
    int code = arm_source_read(options, &model);
    if (code != EXIT_OK) {
        return code;
    }
    code = options->action == CLI_SHOW       ? show(&model, options)
           : options->action == CLI_BRANCHES ? list_branches(options, &model)
                                             : run(options, &model);
    arm_model_free(&model);
    return code;
}

static int act(const cli_options *options)
{
    switch (options->action) {
    case CLI_HELP:
        cli_help();
        return EXIT_OK;
    case CLI_VERSION:
        printf("armtol %s\n", armtol_version());
        return EXIT_OK;
    case CLI_LIST:
        if (options->format == OUTPUT_JSON) {
            json_list();
        } else {
            arm_list_print();
        }
        return EXIT_OK;
    case CLI_LINKS:
        return arm_source_draw(options);
    default:
        return with_arm(options);
    }
}

int main(int argc, char *argv[])
{
    cli_options options;
    rounding_to_double();
    message_start("armtol");
    signal(SIGXFSZ, SIG_IGN); /* a file size limit is then a failed write, with a message */
    const int code = cli_options_parse(argc, argv, &options);
    return exit_code_of_output(code == EXIT_OK ? act(&options) : code);
}
