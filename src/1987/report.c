#include "1987/report.h"

#define NUMBER "%11.6f"

static void write_columns(FILE *stream, const double matrix[], size_t n_columns)
{
    for (size_t k = 0; k < n_columns; k++) {
        for (size_t i = 0; i < 6; i++) {
            fprintf(stream, i < 5 ? NUMBER " " : NUMBER "\n", matrix[i * n_columns + k]);
        }
    }
}

void report_matrix(FILE *stream, const void *data)
{
    const analysis *analysis = ((const report *)data)->analysis;
    write_columns(stream, analysis->matrix, analysis->n_columns);
}

void report_ordered(FILE *stream, const void *data)
{
    const analysis *analysis = ((const report *)data)->analysis;
    write_columns(stream, analysis->ordered, analysis->n_columns);
}

/*
 * What the files of text begin with. Where errata are corrected a line of its own says which, so that such a file is
 * not taken for one of 1987.
 */
static void write_head(FILE *stream, const report *report)
{
    const armtol_errata *errata = &report->analysis->errata;
    const size_t count = armtol_errata_count(), kept = errata_kept(errata);
    size_t corrected = 0;
    fprintf(stream, "For %s\n", report->program->title);
    if (kept == 0) {
        fputs("errata of 1987 corrected: all\n", stream);
    }
    for (size_t i = 0; i < count && kept > 0 && kept < count; i++) {
        if (!armtol_erratum_is_kept(errata, i)) {
            fprintf(stream, "%s%s", corrected++ == 0 ? "errata of 1987 corrected: " : ", ", armtol_erratum(i)->id);
        }
    }
    fputs(corrected > 0 ? "\n\n" : "\n", stream);
}

/* theta[1] and so on, or d[4] of a prismatic joint. */
static void write_wish(FILE *stream, const report *report)
{
    const analysis *analysis = report->analysis;
    size_t joint = 0;
    for (size_t i = 0; i < analysis->robot->n_links && joint < analysis->robot->n_wish; i++) {
        const armtol_joint moved = analysis->links[i].joint;
        if (moved != ARMTOL_FIXED) {
            fprintf(stream, " %s = " NUMBER " %s[%zu] = " NUMBER "\n", report->program->wish_letters[joint],
                    analysis->wish[joint], moved == ARMTOL_PRISMATIC ? "d" : "theta", joint + 1,
                    analysis->q[joint]);
            joint++;
        }
    }
}

const char *const tolerance_names[6] = {"dx", "dy", "dz", "dwx", "dwy", "dwz"};

static void write_tolerances(FILE *stream, const analysis *analysis)
{
    for (size_t i = 0; i < 6; i++) {
        /* Erratum `labels`: all three rotations are called dwx. */
        const size_t label = i > 3 && analysis->errata.labels ? 3 : i;
        fprintf(stream, " %s = " NUMBER "\n", tolerance_names[label], analysis->tolerances[i]);
    }
}

void report_tolerances(FILE *stream, const void *data)
{
    const report *report = data;
    const analysis *analysis = report->analysis;
    write_head(stream, report);
    fputs("with input:\n", stream);
    write_wish(stream, report);
    fprintf(stream, "\nA bound on the error in distance parameters = " NUMBER "\n",
            analysis->bounds.distance);
    fprintf(stream, "\nA bound on the error in angle parameters = " NUMBER "\n", analysis->bounds.angle);
    fputs("\nfor tolerances of:\n", stream);
    write_tolerances(stream, analysis);
    fprintf(stream, "\nand\n delta = " NUMBER "\n", analysis->delta);
}

void report_machining(FILE *stream, const void *data)
{
    const report *report = data;
    const analysis *analysis = report->analysis;
    const size_t n_links = analysis->robot->n_links;
    write_head(stream, report);
    fputs("machining distance tolerances:\n", stream);
    for (size_t i = 0; i < n_links; i++) {
        fprintf(stream, " rd[%zu] = " NUMBER "\n", i, analysis->machining[i]);
    }
    fputs("\nmachining angle tolerances:\n", stream);
    for (size_t i = 0; i < n_links; i++) {
        fprintf(stream, " ggd[%zu] = " NUMBER "\n", i, analysis->shares.angle);
    }
    fputs("\nmotor angle tolerances:\n", stream);
    for (size_t i = 0; i < analysis->robot->n_joints; i++) {
        fprintf(stream, " td[%zu] = " NUMBER "\n", i, analysis->motor[i]);
    }
}

void report_joints(FILE *stream, const analysis *analysis)
{
    for (size_t i = 0; i < analysis->robot->n_joints; i++) {
        fprintf(stream, "itheta[%zu] = %f\n", i, analysis->q[i]);
    }
    for (size_t i = 0; i < analysis->robot->n_wish; i++) {
        fprintf(stream, "check[%zu] = %f\n", i, analysis->check[i]);
    }
}

const report_file report_files[REPORT_FILES] = {
    [REPORT_MATRIX] = {"a", report_matrix},
    [REPORT_ORDERED] = {"at", report_ordered},
    [REPORT_TOLERANCES] = {"tol", report_tolerances},
    [REPORT_MACHINING] = {"mach", report_machining},
};
