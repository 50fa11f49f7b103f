/* armtol --verify, its arms drawn by several workers. */

#include "armtol/answer.h"
#include "armtol/ask/arm_source.h"
#include "armtol/ask/options.h"
#include "armtol/ask/request.h"
#include "armtol/tell/findings.h"
#include "armtol/tell/output.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "lib/engine/corner_search.h"
#include "lib/engine/draw.h"
#include "lib/engine/verification_parts.h"
#include "page/wasm/page.h"

#include <stdlib.h>

/* A worker asks once in its life: what is here is never given back. */
static struct {
    cli_options options;
    arm_model model;
    request request;
    armtol_answer *answer;
    tally_limits limits;
    tally *counted, *part; /* of some MB: on the heap, which grows only where arms are drawn */
} asked;

int page_verify_begin(int argc, char *argv[])
{
    message_start("armtol");
    int code = cli_options_parse(argc, argv, &asked.options);
    if (code == EXIT_OK) {
        code = arm_source_read(&asked.options, &asked.model);
    }
    if (code == EXIT_OK) {
        code = request_make(&asked.request, &asked.options, &asked.model);
    }
    if (code == EXIT_OK) {
        code = request_answer(&asked.request, &asked.answer);
    }
    if (code != EXIT_OK) {
        return code;
    }
    const armtol_fault fault = verification_check(asked.answer);
    if (fault.status != ARMTOL_OK) {
        return request_failed(&asked.request, &fault);
    }
    asked.counted = malloc(sizeof *asked.counted);
    asked.part = malloc(sizeof *asked.part);
    if (asked.counted == NULL || asked.part == NULL) {
        out_of_memory();
        return EXIT_FAILED;
    }
    verification_limits(asked.answer, &asked.limits);
    tally_start(asked.counted, asked.limits.n_measures);
    return EXIT_OK;
}

int page_verify_draw(double first, double count)
{
    const armtol_draw draw = {.samples = (uint64_t)count, .seed = asked.options.seed, .n_threads = 1};
    if (draw_arms(asked.answer, &draw, (uint64_t)first, &asked.limits, asked.part) != ARMTOL_OK) {
        out_of_memory();
        return EXIT_FAILED;
    }
    tally_merge(asked.counted, asked.part);
    return EXIT_OK;
}

void *page_verify_counted(void)
{
    return asked.counted;
}

int page_verify_size(void)
{
    return (int)tally_size(asked.counted);
}

void page_verify_add(const void *counted)
{
    tally_merge(asked.counted, counted);
}

int page_verify_end(void)
{
    armtol_verification found = {0};
    const armtol_draw draw = {.seed = asked.options.seed, .n_threads = 1};
    findings findings = {&asked.request, asked.answer, NULL, &found};
    double *errors = calloc(asked.answer->n_columns, 2 * sizeof *errors);
    if (errors == NULL) {
        out_of_memory();
        return EXIT_FAILED;
    }
    search_corners(asked.answer, &draw, errors, &found);
    free(errors);
    verification_report(asked.answer, asked.counted, &asked.limits, &found);
    const bool fine = asked.options.format == OUTPUT_JSON  ? output_json(&findings)
                      : asked.options.format == OUTPUT_CSV ? output_csv(&findings)
                                                           : output_text(&findings);
    return exit_code_of_output(fine ? EXIT_OK : EXIT_FAILED);
}
