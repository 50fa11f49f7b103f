#ifndef ARMTOL_TOOL_MATRIX_H
#define ARMTOL_TOOL_MATRIX_H

#include "armtol/error_matrix.h"
#include "armtol/interface.h"
#include "armtol/tool_point.h"

ARMTOL_INTERFACE_BEGIN

/*
 * A for the tool point, the fast way: armtol_error_matrix with no erratum, from the axes of the links instead of
 * adjoints.
 *
 * Given:
 *    links, n_links      the arm, placed
 *    tool                the tool point, and along which axes is counted
 *
 * Returned:
 *    matrix, n_columns   6 x n_columns, columns as of armtol_columns: the motion of the tool point and the rotation for
 *                        a unit error of each parameter
 *
 * Errors:
 *    as of armtol_error_matrix
 */
armtol_status armtol_tool_matrix(const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                                 double matrix[], size_t n_columns);

/*
 * Set to 0 what rounding left of a 0 in such an A.
 *
 * Given:
 *    links, n_links, tool   fine (armtol_links_check)
 *
 * Given and returned:
 *    matrix, n_columns      n_columns is armtol_column_count
 *
 * Notes:
 * 1) Elements count as 0 up to 1e-12 of what they can be in this arm: its length when it is stretched, tool and all,
 *    for the motion of the tool point by an angle, and 1 for all others. The unit of length does not matter.
 */
void armtol_tool_matrix_clear(const armtol_link links[], size_t n_links, const armtol_tool_point *tool, double matrix[],
                              size_t n_columns);

ARMTOL_INTERFACE_END

#endif
