#ifndef ARMTOL_TABLES_ARM_TABLE_H
#define ARMTOL_TABLES_ARM_TABLE_H

#include "armtol/arm.h"
#include "armtol/tables/cells.h"

#include <stdbool.h>
#include <stddef.h>

/* The columns of an arm's table, in the order in which it is written; docs/arm-files.md. */
typedef enum arm_column {
    COLUMN_KIND,
    COLUMN_JOINT,
    COLUMN_A,
    COLUMN_ALPHA,
    COLUMN_D,
    COLUMN_THETA,
    COLUMN_BETA,
    COLUMN_LOW,
    COLUMN_HIGH,
    COLUMN_BACKLASH,
    COLUMN_COMPLIANCE,
    COLUMN_MOMENT,
    ARM_COLUMNS
} arm_column;

const char *arm_column_name(arm_column column);

/* Whether a table may do without it, or without a value in it. */
bool arm_column_is_optional(arm_column column);

/* Whether it is about the drive of a joint. */
bool arm_column_is_drive(arm_column column);

/* Whether the numbers of a link with that joint are angles. */
bool arm_column_is_angle(arm_column column, armtol_joint joint);

/* The number that the column is about; not of kind and joint. */
double *arm_column_number(arm_column column, armtol_link *link, armtol_drive *drive);

/* "theta", "d" or "fixed", as in the column joint. */
const char *arm_joint_name(armtol_joint joint);

/* What a head row says: which column comes where. */
enum { NO_PLACE = ARM_COLUMNS };

typedef struct arm_columns {
    size_t n;
    arm_column order[ARM_COLUMNS];
    size_t place[ARM_COLUMNS]; /* NO_PLACE where there is no such column */
} arm_columns;

/* False after a message. */
bool arm_columns_read(arm_columns *columns, const cell_row *row);

#endif
