#ifndef ARMTOL_TABLES_ARM_ROW_H
#define ARMTOL_TABLES_ARM_ROW_H

#include "armtol/tables/arm_model.h"
#include "armtol/tables/arm_table.h"
#include "console/file_message.h"

#include <stdbool.h>

/*
 * Row number `index` of an arm's table, from 0. The kind is ARMTOL_KIND_COUNT where the table leaves it to us, and what
 * the row follows is not looked at: *couple is where it says so. The name is in the cells, and gone with them. False
 * after a message.
 */
bool arm_row_read(const cell_row *cells, const arm_columns *columns, angle_unit angle_unit, size_t index,
                  arm_entry *entry, file_place *couple);

#endif
