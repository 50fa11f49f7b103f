#ifndef ARMTOL_TABLES_ARM_ROWS_H
#define ARMTOL_TABLES_ARM_ROWS_H

#include "armtol/tables/arm_model.h"
#include "armtol/tables/arm_table.h"

#include <stdbool.h>
#include <stddef.h>

/* The rows of a table. */
typedef struct arm_rows {
    const arm_entry *entries;
    size_t n;
    bool has_masses; /* the table says what the links weigh */
} arm_rows;

/*
 * The arm of a table in our own order: a link a row, under the name, title, source and unit of the heading. A kind that
 * the table left to us is chosen. False, after a message, where memory is short.
 */
bool arm_rows_make(const arm_rows *rows, const armtol_arm *heading, angle_unit angle_unit, arm_model *model);

/*
 * Tables in Craig's order (Introduction to Robotics, 1986), called modified too:
 *
 *     T = Rot(x, alpha) Trans(a, 0, 0) Rot(y, beta) Rot(z, theta) Trans(0, 0, d)
 *
 * a row having alpha, a and beta of the link before. The chain is cut at other places, no more: alpha, a and beta move
 * up by one row. Those of the first row go into a fixed link before it, left out where all are 0; a fixed row at the
 * end whose theta and d are 0, whose kind is npr and which has no mass, is only there for alpha, a and beta of the last
 * link, and goes. So every parameter is the same length or angle in both tables, and errors belong to the links of
 * ours. A center of mass is in the frame of its row, and is turned into that of the link. The name of a row goes with
 * its joint, and is lost with a row that goes.
 */

/* arm_rows_make for such a table. What a row follows is counted in its rows. */
bool craig_rows_make(const arm_rows *rows, const armtol_arm *heading, angle_unit angle_unit, arm_model *model);

/*
 * The table of an arm in Craig's order, the other way round: the links of *table are its rows. False after a message.
 */
bool craig_rows_of(const armtol_arm *arm, angle_unit angle_unit, arm_model *table);

#endif
