/* armtol: how precisely the parts of an arm have to be made. */

#include "armtol/against/against.h"
#include "armtol/armtol.h"
#include "armtol/ask/arm_source.h"
#include "armtol/ask/options.h"
#include "armtol/ask/request.h"
#include "armtol/ask/watched.h"
#include "armtol/cluster/arms.h"
#include "armtol/cluster/merge.h"
#include "armtol/draw/budget.h"
#include "armtol/draw/drawing.h"
#include "armtol/map/run.h"
#include "armtol/region/region_run.h"
#include "armtol/tables/arm_file.h"
#include "armtol/tell/arm_list.h"
#include "armtol/tell/branches.h"
#include "armtol/tell/json_arms.h"
#include "armtol/tell/laying.h"
#include "armtol/tell/output.h"
#include "console/exit_code.h"
#include "console/flags.h"
#include "console/message.h"
#include "console/rounding.h"
#include "files/outfile.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char program_name[] = "armtol";

static size_t threads_of(const cli_options *options)
{
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    return options->threads != 0 ? (size_t)options->threads : processors > 0 ? (size_t)processors : 1;
}

static armtol_draw draw_of(const cli_options *options)
{
    return (armtol_draw){.samples = options->verify, .seed = options->seed, .n_threads = threads_of(options)};
}

/* The arms drawn here, or those that others drew. An exit code, after a message. */
static int verify(const request *request, const armtol_answer *answer, const merged *merged, armtol_verification *found)
{
    const armtol_draw draw = draw_of(request->options);
    armtol_fault fault;
    if (merged != NULL && !arms_are_of(merged, answer)) {
        return EXIT_WRONG;
    }
    const armtol_status status = merged == NULL
                                     ? watched_verify(answer, &draw, found, &fault)
                                     : watched_tally_verify(answer, &draw, merged->content.arms, found, &fault);
    return status == ARMTOL_OK ? EXIT_OK : request_failed(request, &fault);
}

/*
 * Arms that come back, after all were drawn once; NULL where that was not asked for, or interrupted. An exit code,
 * after a message.
 */
static int repeat(const request *request, const armtol_answer *answer, const armtol_verification *found,
                  armtol_arrivals **arrivals)
{
    const armtol_draw draw = draw_of(request->options);
    armtol_fault fault = {.status = ARMTOL_OK};
    *arrivals = NULL;
    if (request->options->cycles != 0 && found->drawn < draw.samples) {
        message("interrupted: no arm comes to its poses again");
    } else if (request->options->cycles != 0) {
        watched_arrivals(answer, &draw, (size_t)request->options->cycles, arrivals, &fault);
    }
    return fault.status == ARMTOL_OK ? EXIT_OK : request_failed(request, &fault);
}

/* An exit code, after a message. */
static int allot_noises(const request *request, const armtol_answer *answer, noises *noises)
{
    armtol_fault fault;
    return noises_find(request, answer, noises, &fault)  ? EXIT_OK
           : fault.status == ARMTOL_NOTHING_LEFT         ? EXIT_WRONG
                                                         : request_failed(request, &fault);
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

/* What is to be drawn, and all that is asked told. */
static int draw_and_tell(findings findings, const merged *merged)
{
    const request *request = findings.request;
    const armtol_answer *answer = findings.answer;
    armtol_budget *budget = NULL;
    armtol_arrivals *arrivals;
    armtol_verification found = {.drawn = 0};
    if (request->options->verify != 0) {
        const int code = verify(request, answer, merged, &found);
        if (code != EXIT_OK) {
            return code;
        }
        findings.verification = &found;
    }
    const int code = repeat(request, answer, &found, &arrivals);
    if (code != EXIT_OK) {
        return code;
    }
    findings.arrivals = arrivals;
    if (request->options->budget && armtol_budget_create(answer, &budget) != ARMTOL_OK) {
        armtol_arrivals_destroy(arrivals);
        out_of_memory();
        return EXIT_FAILED;
    }
    findings.budget = budget;
    const char *svg = request->options->svg, *drawing = request->options->write_drawing;
    const bool told = outfile_is_standard(svg) || outfile_is_standard(drawing); /* in the place of the answer */
    const bool fine = (svg == NULL || outfile_write(svg, budget_write_svg, &findings)) &&
                      (drawing == NULL || outfile_write(drawing, drawing_write, &findings)) &&
                      (told || print(&findings));
    armtol_budget_destroy(budget);
    armtol_arrivals_destroy(arrivals);
    return fine ? EXIT_OK : EXIT_FAILED;
}

/* merged, region: NULL where there are none. */
static int tell(const request *request, const armtol_answer *answer, const merged *merged,
                const armtol_region_answer *region)
{
    findings findings = {.request = request, .answer = answer, .region = region};
    noises noises;
    if (request->repeatability > 0) {
        const int code = allot_noises(request, answer, &noises);
        if (code != EXIT_OK) {
            return code;
        }
        findings.noises = &noises;
    }
    const int code = draw_and_tell(findings, merged);
    if (findings.noises != NULL) {
        noises_free(&noises);
    }
    return code;
}

static int answer_request(const request *request, const merged *merged)
{
    armtol_answer *answer;
    int code = request_answer(request, &answer);
    if (code == EXIT_OK) {
        const bool shard = request->options->shard != 0 && merged == NULL;
        code = shard ? arms_shard(request, answer, threads_of(request->options)) : tell(request, answer, merged, NULL);
        armtol_answer_destroy(answer);
    }
    return code;
}

static int answer_region(request *request)
{
    armtol_region_answer *region;
    int code = region_run(request, &region);
    if (code == EXIT_OK) {
        code = tell(request, region->answer, NULL, region);
        code = code == EXIT_OK ? region_exit_code(request, region) : code;
        armtol_region_answer_destroy(region);
    }
    return code;
}

static int run(const cli_options *options, const arm_model *model, const merged *merged)
{
    request request;
    const int code = request_make(&request, options, model);
    if (code != EXIT_OK) {
        return code;
    }
    const int ended = options->action == CLI_MAP  ? map_run(&request, merged)
                      : against_is_asked(options) ? against_run(&request, model)
                      : options->region != NULL   ? answer_region(&request)
                                                  : answer_request(&request, merged);
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

/* merged NULL: whatever has to be drawn is drawn here. */
static int with_arm(const cli_options *options, const merged *merged)
{
    arm_model model;
    int code = arm_source_read(options, &model);
    if (code != EXIT_OK) {
        return code;
    }
    code = options->action == CLI_SHOW       ? show(&model, options)
           : options->action == CLI_BRANCHES ? list_branches(options, &model)
                                             : run(options, &model, merged);
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
        return with_arm(options, NULL);
    }
}

/* The command that the tallies have in them, with what is in them in place of what is to be drawn. */
static int tell_merged(const merged *merged)
{
    cli_options options;
    char **words = calloc(merged->head.n_words + 2, sizeof *words);
    if (words == NULL) {
        out_of_memory();
        return EXIT_FAILED;
    }
    words[0] = program_name;
    memcpy(words + 1, merged->head.words, merged->head.n_words * sizeof *words);
    int code = cli_options_parse((int)merged->head.n_words + 1, words, &options);
    if (code == EXIT_OK && !merged_is_asked(merged, &options)) {
        code = EXIT_WRONG;
    }
    if (code == EXIT_OK) {
        code = with_arm(&options, merged);
    }
    free(words);
    return code;
}

/* What begins with a hyphen is an option, of which there are none: ./-NAME is a file. */
static bool check_paths(int n_paths, char *const paths[])
{
    if (n_paths == 0) {
        message("merge: the tallies are missing; expected armtol merge FILE...");
        return false;
    }
    for (int i = 0; i < n_paths; i++) {
        if (paths[i][0] == '-') {
            return flags_wrong("unknown option of merge", paths[i]);
        }
    }
    return true;
}

static int merge(int n_paths, char *paths[])
{
    merged merged;
    if (n_paths == 1 && strcmp(paths[0], "--help") == 0) {
        cli_help();
        return EXIT_OK;
    }
    if (!check_paths(n_paths, paths)) {
        return EXIT_WRONG;
    }
    int code = merge_files(paths, (size_t)n_paths, &merged);
    if (code == EXIT_OK) {
        code = tell_merged(&merged);
        merged_free(&merged);
    }
    return code;
}

static int obey(int argc, char *argv[])
{
    cli_options options;
    if (argc > 1 && strcmp(argv[1], "merge") == 0) {
        return merge(argc - 2, argv + 2);
    }
    const int code = cli_options_parse(argc, argv, &options);
    return code == EXIT_OK ? act(&options) : code;
}

int main(int argc, char *argv[])
{
    rounding_to_double();
    message_start("armtol");
    signal(SIGXFSZ, SIG_IGN); /* a file size limit is then a failed write, with a message */
    return exit_code_of_output(obey(argc, argv));
}
