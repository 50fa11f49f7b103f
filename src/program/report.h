#ifndef PROGRAM_REPORT_H
#define PROGRAM_REPORT_H

#include "analysis.h"
#include "program.h"

#include <stdio.h>

/* What the files of a run say, in the formats of 1987. */
typedef struct report {
    const program *program;
    const analysis *analysis;
} report;

/* The four files; data is a report. The analysis must have come as far as the file needs. */
void report_matrix(FILE *stream, const void *data);     /* inta, adpta */
void report_ordered(FILE *stream, const void *data);    /* intat, adptat */
void report_tolerances(FILE *stream, const void *data); /* inttol, adpttol */
void report_machining(FILE *stream, const void *data);  /* intmach, adptmach */

/* The lines of the dialogue that follow the wish: the joint values, and where they bring the tool. */
void report_joints(FILE *stream, const analysis *analysis);

#endif
