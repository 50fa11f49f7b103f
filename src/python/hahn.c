/* The programs of 1987, a run at a time. */

#include "1987/report.h"
#include "python/binding.h"

#include <stdlib.h>
#include <string.h>

static armtol_status run_steps(analysis *run, const double wish[], const double accuracy[6], double delta,
                               const double residue[3])
{
    double stored_wish[6], stored[6];
    armtol_residue words = {{0}};
    const armtol_errata *errata = &run->errata;
    for (size_t i = 0; i < run->robot->n_wish; i++) {
        stored_wish[i] = armtol_stored(errata, wish[i]);
    }
    for (int i = 0; i < 6; i++) {
        stored[i] = armtol_stored(errata, accuracy[i]);
    }
    if (residue != NULL) {
        memcpy(words.diagonal, residue, sizeof words.diagonal);
    }
    return analysis_run(run, stored_wish, residue != NULL ? &words : NULL, stored, armtol_stored(errata, delta));
}

analysis *binding_run(const program *program, const double wish[], const double accuracy[6], double delta,
                      const armtol_errata *errata, const double residue[3], armtol_status *status)
{
    analysis *run = malloc(sizeof *run);
    *status = ARMTOL_NO_MEMORY;
    if (run == NULL || !analysis_start(run, program->robot, errata)) {
        free(run);
        return NULL;
    }
    *status = run_steps(run, wish, accuracy, delta, residue);
    return run;
}

void binding_run_free(analysis *run)
{
    if (run != NULL) {
        analysis_free(run);
        free(run);
    }
}

char *binding_run_file(const program *program, const analysis *run, int file)
{
    char *text = NULL;
    size_t length = 0;
    const report report = {program, run};
    FILE *stream = open_memstream(&text, &length);
    if (stream != NULL) {
        report_files[file].write(stream, &report);
        if (fclose(stream) != 0) {
            free(text);
            text = NULL;
        }
    }
    return text;
}
