#ifndef ARMTOL_LISTS_LISTS_H
#define ARMTOL_LISTS_LISTS_H

#include "armtol/arm.h"
#include "armtol/error_matrix.h"
#include "armtol/link.h"
#include "armtol/spread.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/*
 * Files of numbers in the user's units, read like the table of an arm: comments, CRLF, a byte order mark, columns set
 * apart by commas, semicolons, tabs or blanks. False after a message with FILE:LINE:COLUMN.
 */

/*
 * Joint values, one pose a line, n_joints values each; a file has one pose or more. *poses is the caller's to free,
 * n_joints values a pose; NULL where the file was wrong.
 */
bool poses_read(FILE *stream, const char *path, size_t n_joints, double **poses, size_t *n_poses);

/* Where the tool should be, as typed: x, y, z and, unless n is 3, gamma, beta, alpha. */
typedef struct typed_wish {
    double value[6];
    size_t n;
} typed_wish;

/* Positions, one a line, each with angles or without; a file has one or more. *wishes as *poses above. */
bool wishes_read(FILE *stream, const char *path, typed_wish **wishes, size_t *n_wishes);

/* What a file says of parameters: one value a column of A; the file has a head that names its columns. */
typedef struct parameter_table {
    const armtol_arm *arm;
    const armtol_column *columns; /* of A */
    size_t n_columns;
    const char *value; /* the name of the column that is wanted: tolerance, weight */
    bool zero_allowed; /* a value may be 0; what has no row stays as it was */
    bool signed_allowed; /* a value may be anything finite */
    const char *length_unit; /* what a column `unit`, where there is one, has to say of lengths, and of angles; */
    const char *angle_unit;  /* NULL where values have no units */
    double *means; /* a column of A: a file may have columns upper and lower in place of the value, which is then half
                      of what is between them, and the mean their middle; NULL: it may not */
} parameter_table;

/*
 * Rows of link (its number from 0, or its name), parameter (theta, d, a, alpha, beta) and the wanted value; other
 * columns are passed over. So `armtol --csv` can be read again. Values are greater than 0, or 0 where zero_allowed;
 * "inf" or "-" is infinite where infinite_allowed. After a message values[] is of no use.
 */
bool parameters_read(FILE *stream, const char *path, const parameter_table *table, bool infinite_allowed,
                     double values[]);

/* A distribution in words: "uniform", "normal:3". */
typedef struct distribution_text {
    char text[48];
} distribution_text;

/* False, and nothing changed, where it is none; what was expected is then distribution_expected. */
bool distribution_parse(const char *text, armtol_error_spread *spread);
extern const char distribution_expected[];

/* Returns words->text: distribution_words(spread, &(distribution_text){""}). */
const char *distribution_words(const armtol_error_spread *spread, distribution_text *words);

/* A group's name; empty where there is none. */
typedef struct group_name {
    char text[32];
} group_name;

/*
 * Rows of link, parameter, distribution, shift and group; of the last three a file needs one, and a cell may be empty
 * or a dash. What has no row, or cell, stays as it was. groups has a place a column of A, all empty: group n gets its
 * name at n - 1. Of the table arm, columns and units are read, and `value` for messages.
 */
bool spreads_read(FILE *stream, const char *path, const parameter_table *table, armtol_error_spread spreads[],
                  group_name groups[]);

#endif
