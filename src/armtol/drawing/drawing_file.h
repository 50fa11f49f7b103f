#ifndef ARMTOL_DRAWING_DRAWING_FILE_H
#define ARMTOL_DRAWING_DRAWING_FILE_H

#include "armtol/arm.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* What a drawing says of the links of an arm: a table with a row a link (docs/drawing.md). */

/* How the tolerance of a distance is shared: one of a and d has it and the other is exact, or both have the same. */
typedef enum drawing_split { DRAWING_SPLIT_NONE, DRAWING_SPLIT_A, DRAWING_SPLIT_D, DRAWING_SPLIT_EVEN } drawing_split;

/* "-", "a", "d", "even". */
const char *drawing_split_name(drawing_split split);

/* Whether a and d of the link are both made, so that they can share. */
bool drawing_splits_evenly(const armtol_link *link);

/* The split that a link has where none is named: NONE where there are two to choose from, or no distance at all. */
drawing_split drawing_only_split(const armtol_link *link);

/* Whether the link is one of parallel axes, whose distance is |a| whatever d is. */
bool drawing_is_parallel(const armtol_link *link);

/* One row, in the units of the file. */
typedef struct drawing_row {
    size_t link;
    double distance;     /* with what the seat adds; nan where nothing is said */
    double angle;        /* likewise */
    double side;         /* the length of the angle's shorter side; nan where nothing is said */
    double seat;         /* how far the two seats are apart that the axis at the link's end has; likewise, and then: */
    double position, play;
    drawing_split split; /* NONE where there is no distance, and only there */
    size_t line;
    bool is_other;       /* from the row "others" */
} drawing_row;

typedef struct drawing {
    size_t n_rows, room;
    drawing_row *rows; /* no link twice */
} drawing;

/* In whose light the file is read. */
typedef struct drawing_view {
    const armtol_arm *arm;
    const char *length_unit, *angle_unit; /* what a column `unit`, where there is one, has to say: "mm deg" */
    double right_angle;                   /* in that unit; every angle is less */
    armtol_length_unit length;            /* of length_unit: names of tolerances are of mm */
} drawing_view;

/*
 * A head row names the columns, in any order: link (number or name), distance, angle, split, side, seat, position and
 * play; what else there is is passed over but for `unit`. A dash, or nothing, says nothing of a distance or an angle. A
 * row "others" is of all links that have no row before it. *drawing is to be freed also after a message, which begins
 * with FILE:LINE:COLUMN.
 */
bool drawing_read(FILE *stream, const char *path, const drawing_view *view, drawing *drawing);
void drawing_free(drawing *drawing);

#endif
