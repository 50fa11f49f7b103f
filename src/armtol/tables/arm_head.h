#ifndef ARMTOL_TABLES_ARM_HEAD_H
#define ARMTOL_TABLES_ARM_HEAD_H

#include "armtol/tables/arm_model.h"
#include "armtol/tables/cells.h"

#include <stdbool.h>

/* What stands above an arm's table. */
typedef enum arm_text { TEXT_NAME, TEXT_TITLE, TEXT_SOURCE, ARM_TEXTS } arm_text;

/* Whose a and alpha a row of the table has: those of its own link (Paul), or of the link before (Craig). */
typedef enum row_order { ORDER_PAUL, ORDER_CRAIG } row_order;

typedef struct arm_head {
    char *texts[ARM_TEXTS]; /* NULL where not given */
    bool has_order;
    row_order order;
    bool has_units;
    armtol_length_unit length_unit;
    angle_unit angle_unit;
} arm_head;

typedef enum head_result {
    HEAD_TAKEN, /* the line has a key, and its value is taken */
    HEAD_ENDS,  /* it has none; the row then has the cells of the line, without any comment */
    HEAD_WRONG  /* a message has been given */
} head_result;

void arm_head_start(arm_head *head);
void arm_head_free(arm_head *head);

/*
 * Take the line at hand: "KEY: VALUE", "KEY VALUE" or, as a row of a spreadsheet, a cell "KEY" or "KEY:" and one or
 * more with the value. A key is name, title, source, order or units; a text without a value counts as not given.
 */
head_result arm_head_take(arm_head *head, text_lines *lines, cell_row *row);

#endif
