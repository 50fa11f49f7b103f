#ifndef ARMTOL_1987_REPORT_H
#define ARMTOL_1987_REPORT_H

#include "1987/analysis.h"
#include "1987/program.h"

#include <stdio.h>

/* What the files of a run say, in the formats of 1987. */
typedef struct report {
    const program *program;
    const analysis *analysis;
} report;

/* The components of the tool's error, as 1987 names them: "dx" to "dwz". */
extern const char *const tolerance_names[6];

/* The four files; data is a report. The analysis must have come as far as the file needs. */
void report_matrix(FILE *stream, const void *data);
void report_ordered(FILE *stream, const void *data);
void report_tolerances(FILE *stream, const void *data);
void report_machining(FILE *stream, const void *data);

/* What comes between prefix and run number in a file's name (inta.1, intat.1, inttol.1, intmach.1); its routine. */
typedef struct report_file {
    const char *part;
    void (*write)(FILE *stream, const void *data);
} report_file;

/* In the order in which they are written, the first two and the last two together. */
enum { REPORT_MATRIX, REPORT_ORDERED, REPORT_TOLERANCES, REPORT_MACHINING, REPORT_FILES };
extern const report_file report_files[REPORT_FILES];

/* The lines of the dialogue that follow the wish: the joint values, and where they bring the tool. */
void report_joints(FILE *stream, const analysis *analysis);

#endif
