#ifndef ARMTOL_1987_ANALYSIS_H
#define ARMTOL_1987_ANALYSIS_H

#include "armtol/armtol.h"

#include <stdbool.h>
#include <stddef.h>

/* One run of a program of 1987, from the wish to the tolerances of every part, without any input or output. */
typedef struct analysis {
    const armtol_robot *robot;
    armtol_errata errata;

    /* from analysis_place */
    double *wish;      /* robot->n_wish; the block of memory that the others lie in */
    double *q;         /* robot->n_joints */
    double *check;     /* robot->n_wish: where q brings the tool */
    armtol_reach reach;
    armtol_link *links; /* robot->n_links, placed */

    /* from analysis_matrix */
    size_t n_columns;
    size_t n_lengths;
    armtol_column *columns; /* n_columns, as are the places of order */
    size_t *order;
    double *matrix;  /* A, 6 x n_columns */
    double *ordered; /* A, lengths first */

    /* from analysis_tolerances */
    double tolerances[6];
    double delta;
    armtol_bounds bounds;
    armtol_shares shares;
    double *machining; /* robot->n_links */
    double *motor;     /* robot->n_joints */
} analysis;

/* False where memory is short; analysis_free is then not needed. */
bool analysis_start(analysis *analysis, const armtol_robot *robot, const armtol_errata *errata);
void analysis_free(analysis *analysis);

/*
 * The steps, in this order, each once the one before has returned ARMTOL_OK; or all of them. The wish, robot->n_wish
 * numbers, may be analysis->wish. residue: words in the place of what 1987 found on the stack; NULL: what the library
 * works out. ARMTOL_NOT_FINITE where what was asked for is too large to compute with.
 */
armtol_status analysis_place(analysis *analysis, const double wish[]);
armtol_status analysis_matrix(analysis *analysis, const armtol_residue *residue);
armtol_status analysis_tolerances(analysis *analysis, const double tolerances[6], double delta);
armtol_status analysis_run(analysis *analysis, const double wish[], const armtol_residue *residue,
                           const double tolerances[6], double delta);

#endif
