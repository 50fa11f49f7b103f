#include "lab/recompute.h"

#include "1987/program.h"
#include "1987/report.h"
#include "console/exit_code.h"
#include "console/message.h"

#include <stdio.h>
#include <stdlib.h>

/* The numbers of one role, as the programs store them; at most `most`. Returns how many there are. */
static size_t given(const published_list *list, size_t first, published_role role, const armtol_errata *errata,
                    double values[], size_t most)
{
    size_t n = 0;
    for (size_t i = first; i < list->count && n < most; i++) {
        const published_number *number = &list->numbers[i];
        if (published_same_case(number, &list->numbers[first]) && number->role == role) {
            values[n++] = armtol_stored(errata, strtod(number->value, NULL));
        }
    }
    return n;
}

static armtol_status run_steps(const published_list *list, size_t first, const armtol_residue *residue,
                               analysis *analysis)
{
    double wish[6], tolerances[6], delta;
    const armtol_errata *errata = &analysis->errata;
    if (given(list, first, ROLE_POSITION, errata, wish, 6) != analysis->robot->n_wish ||
        given(list, first, ROLE_TOLERANCE, errata, tolerances, 6) != 6 ||
        given(list, first, ROLE_DELTA, errata, &delta, 1) != 1) {
        return ARMTOL_WRONG_SIZE;
    }
    return analysis_run(analysis, wish, residue, tolerances, delta);
}

bool recompute(const published_list *list, size_t first, const armtol_errata *errata, const armtol_residue *residue,
               analysis *analysis)
{
    const published_number *number = &list->numbers[first];
    const program *program = program_named(number->program);
    if (program == NULL) {
        message("%s: unknown program", number->program);
        return false;
    }
    if (!analysis_start(analysis, program->robot, errata)) {
        out_of_memory();
        return false;
    }
    const armtol_status status = run_steps(list, first, residue, analysis);
    if (status != ARMTOL_OK) {
        message("%s, case %d: %s", number->program, number->case_number,
                armtol_status_text(status));
        analysis_free(analysis);
    }
    return status == ARMTOL_OK;
}

char *recompute_text(const analysis *analysis, const program *program)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    if (stream != NULL) {
        const report report = {program, analysis};
        report_tolerances(stream, &report);
        report_machining(stream, &report);
        if (fclose(stream) != 0) {
            free(text);
            text = NULL;
        }
    }
    if (text == NULL) {
        out_of_memory();
    }
    return text;
}

char *recompute_files(const published_list *list, size_t first, const armtol_errata *errata)
{
    analysis analysis;
    if (!recompute(list, first, errata, NULL, &analysis)) {
        return NULL;
    }
    char *text = recompute_text(&analysis, program_named(list->numbers[first].program));
    analysis_free(&analysis);
    return text;
}
