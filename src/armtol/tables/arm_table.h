#ifndef ARMTOL_TABLES_ARM_TABLE_H
#define ARMTOL_TABLES_ARM_TABLE_H

#include "armtol/arm.h"
#include "armtol/tables/cells.h"

#include <stdbool.h>
#include <stddef.h>

/* The columns of an arm's table, in the order in which it is written; docs/arm-files.md. */
typedef enum arm_column {
    COLUMN_NAME,
    COLUMN_KIND,
    COLUMN_JOINT,
    COLUMN_A,
    COLUMN_ALPHA,
    COLUMN_D,
    COLUMN_THETA,
    COLUMN_BETA,
    COLUMN_SIGN,
    COLUMN_COUPLE,
    COLUMN_MULTIPLIER,
    COLUMN_OFFSET,
    COLUMN_LOW,
    COLUMN_HIGH,
    COLUMN_BACKLASH,
    COLUMN_COMPLIANCE,
    COLUMN_MOMENT,
    COLUMN_RESOLUTION,
    COLUMN_FRICTION,
    COLUMN_NOISE,
    COLUMN_STIFFNESS, /* compliance and resolution in other words; never written */
    COLUMN_BITS,
    COLUMN_MASS,
    COLUMN_COM_X,
    COLUMN_COM_Y,
    COLUMN_COM_Z,
    ARM_COLUMNS
} arm_column;

const char *arm_column_name(arm_column column);

/* Whether a table may do without it, or without a value in it. */
bool arm_column_is_optional(arm_column column);

/*
 * Whether it is about how a joint moves, about its drive, or about the mass of a link. A fixed link has only the last.
 */
bool arm_column_is_motion(arm_column column);
bool arm_column_is_drive(arm_column column);
bool arm_column_is_mass(arm_column column);

/* Whether the numbers of a link with that joint are angles. */
bool arm_column_is_angle(arm_column column, armtol_joint joint);

/* What a row says of a link; stiffness and bits are 0 where they are not given. */
typedef struct arm_entry {
    armtol_link link;
    armtol_drive drive;
    armtol_mass mass;
    armtol_motion motion; /* follows: a row, this one or another */
    double stiffness, bits;
    const char *name; /* NULL where it has none */
} arm_entry;

/* The number that the column is about; not of name, kind, joint and couple. */
double *arm_column_number(arm_column column, arm_entry *entry);

/* The entry of an arm's link. */
arm_entry arm_entry_of(const armtol_arm *arm, size_t link);

/*
 * Turns stiffness and bits, where they are not 0, into compliance and resolution: its inverse, and the step of an
 * encoder of 2^bits steps a turn. The stiffness is in N m a radian, or N a length.
 */
void arm_entry_settle(arm_entry *entry);

/* "theta", "d" or "fixed", as in the column joint. */
const char *arm_joint_name(armtol_joint joint);

/* What a head row says: which column comes where. */
enum { NO_PLACE = ARM_COLUMNS };

typedef struct arm_columns {
    size_t n;
    arm_column order[ARM_COLUMNS];
    size_t place[ARM_COLUMNS]; /* NO_PLACE where there is no such column */
} arm_columns;

/* craig: the table is in Craig's order, as far as is known. False after a message. */
bool arm_columns_read(arm_columns *columns, const cell_row *row, bool craig);

#endif
