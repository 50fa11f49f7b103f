#ifndef ARMTOL_LISTS_PARAMETER_ROWS_H
#define ARMTOL_LISTS_PARAMETER_ROWS_H

#include "armtol/lists/lists.h"
#include "armtol/tables/cells.h"

/* The rows of a file that says something of parameters: which columns it has, and which column of A a row is of. */

enum { FIELD_LINK, FIELD_PARAMETER, FIELD_VALUE, FIELDS_MOST = FIELD_VALUE + 3 };

typedef struct parameter_rows parameter_rows;
struct parameter_rows {
    const parameter_table *table;
    int n_fields;
    const char *names[FIELDS_MOST]; /* of the columns of the file, from FIELD_VALUE on; the first two are known */
    bool optional[FIELDS_MOST];
    bool (*settle)(parameter_rows *rows);                    /* once the head is there, to choose or check them */
    bool (*take)(const parameter_rows *rows, size_t column); /* a row, of a column of A. Both: false after a message */
    void *context;

    /* at work */
    size_t *lines; /* n_columns: the line that a value is from; 0 where there is none yet */
    text_lines text;
    cell_row row;
    size_t places[FIELDS_MOST];
    size_t unit_place; /* of the column `unit`; beyond every row where there is none */
};

/* Reads the file. False after a message. */
bool parameter_rows_each(parameter_rows *rows, FILE *stream, const char *path);

/* The cell of a field in the row at hand; NULL where there is none, or it is empty or a dash. */
const cell *parameter_rows_cell(const parameter_rows *rows, int field);

/* The number in it, where there is a cell; false after a message. */
bool parameter_rows_number(const parameter_rows *rows, int field, double *value);

#endif
