#ifndef ARMTOL_CORNERS_H
#define ARMTOL_CORNERS_H

#include "armtol/interface.h"
#include "armtol/link.h"
#include "armtol/tool_point.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * The corners of the box that tolerances span, every parameter off by all that it may be, and how far the
 * exact error of the tool (tool_error.h) can be from what A says. matrix is A of the arm as meant, 6 x
 * n_columns, its columns those of armtol_columns and its linear rows those of the tool point (tool_matrix.h);
 * tolerances has one value >= 0 a column.
 */

/*
 * The largest that a row's component of the error gets to first order: |row| tolerances. An infinite tolerance makes it
 * infinite where its element is not 0, and adds nothing where it is.
 */
double armtol_worst_error(const double matrix[], size_t n_columns, size_t row, const double tolerances[]);

/* The root of the sum of the squares of row x tolerances, infinite ones as above. */
double armtol_rss_error(const double matrix[], size_t n_columns, size_t row, const double tolerances[]);

/*
 * The corner where a row's component of the error is largest, or least.
 *
 * Given:
 *    matrix, n_columns, tolerances   as above
 *    row                             0 to 5
 *    sign                            1 for the largest value, -1 for the least
 *
 * Returned:
 *    parameter_errors                n_columns: each tolerance with the sign of its element, times sign; 0 for a
 *                                    parameter that does not move the component to first order
 */
void armtol_corner(const double matrix[], size_t n_columns, size_t row, int sign, const double tolerances[],
                   double parameter_errors[]);

/*
 * What the exact error can differ from A's prediction by, anywhere in the box.
 *
 * Given:
 *    matrix, n_columns, tolerances   as above
 *
 * Returned:
 *    remainder                       of the six components, along the axes that A is counted along
 *
 * Notes:
 * 1) It is never less than the truth, but for rounding, and near it for small tolerances, where it goes with their
 *    square; corners.c says why it holds.
 * 2) The angular components are bounded as long as the tolerances of all angles sum to less than pi, and have infinity
 *    from there on. An infinite tolerance, or one that is nan, makes all six infinite.
 */
void armtol_remainder(const double matrix[], size_t n_columns, const double tolerances[],
                      double remainder[6]);

/*
 * What rounding can make of the six components of the error, anywhere in the box.
 *
 * Given:
 *    links, n_links   the arm, placed and fine (armtol_links_check); joint values and angles below 1e6 rad
 *    tool             the tool point
 *    tolerances       finite, one a column
 *
 * Returned:
 *    rounding         six bounds
 *
 * Notes:
 * 1) A bound of how far A's prediction, of a matrix that armtol_tool_matrix_clear may have seen, and the exact error as
 *    armtol_tool_error and armtol_sampler_draw compute it, can together be from what they would be without rounding. It
 *    is proved in rounding.c; the truth is some hundred times less.
 */
void armtol_rounding(const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                     const double tolerances[], double rounding[6]);

/* How large an error of the tool is: one number >= 0 of the six of armtol_tool_error. */
typedef double (*armtol_error_size)(const double error[6], const void *context);

/*
 * Climb from errors within the box to a corner from where no change of one of them alone makes the exact error of the
 * tool larger.
 *
 * Given:
 *    links, n_links, tool      the arm, placed, and its tool point
 *    shifts                    the middle of the box, one a column; NULL: the arm as meant
 *    tolerances, n_columns     the box: finite, one a column
 *    size, context             what is to be made large; context is handed to it
 *    errors                    where to begin: n_columns values, the middle or plus or minus the tolerance from there
 *
 * Returned:
 *    errors                    where it ends
 *
 * Returns what the size is there; nan, and errors as they were, where the links are not fine (armtol_links_check) or
 * n_columns is not armtol_column_count.
 *
 * Notes:
 * 1) Errors are tried one after the other, - before +, round after round, until a round gains nothing. A gain below
 *    1e-9 of the size does not count: it may be rounding, and not end. After 100 rounds it is left at that.
 * 2) A round takes a time that is in proportion to the number of links.
 * 3) It is a local search: it finds no less than it began with, and need not find the largest of all corners.
 */
double armtol_climb(const armtol_link links[], size_t n_links, const armtol_tool_point *tool, const double shifts[],
                    const double tolerances[], size_t n_columns, armtol_error_size size, const void *context,
                    double errors[]);

ARMTOL_INTERFACE_END

#endif
