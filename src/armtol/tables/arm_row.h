#ifndef ARMTOL_TABLES_ARM_ROW_H
#define ARMTOL_TABLES_ARM_ROW_H

#include "armtol/tables/arm_model.h"
#include "armtol/tables/arm_table.h"

#include <stdbool.h>

/*
 * A row of an arm's table below its head row; where its kind is not given, that is for the whole table to say. False
 * after a message.
 */
bool arm_row_read(const cell_row *cells, const arm_columns *columns, angle_unit angle_unit, arm_entry *entry);

#endif
