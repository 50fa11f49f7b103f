#ifndef ARMTOL_TOOL_MATRIX_H
#define ARMTOL_TOOL_MATRIX_H

#include "armtol/error_matrix.h"
#include "armtol/interface.h"
#include "armtol/tool_point.h"

ARMTOL_INTERFACE_BEGIN

/*
 * A, 6 x n_columns, for the tool point: the motion of that point and the rotation, along the axes of
 * tool->frame, for a unit error of each parameter of the placed links; columns as of armtol_columns. The same
 * as armtol_error_matrix with no erratum, from the axes of the links instead of adjoints, and many times as
 * fast. Errors: as of armtol_error_matrix.
 */
armtol_status armtol_tool_matrix(const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                                 double matrix[], size_t n_columns);

/*
 * Set to 0 what rounding left of a 0 in such an A: elements up to 1e-12 of what they can be in this arm, which is its
 * length when it is stretched, tool and all, for the motion of the tool point by an angle, and 1 for all others. The
 * unit of length does not matter. The links are fine (armtol_links_check), n_columns is armtol_column_count.
 */
void armtol_tool_matrix_clear(const armtol_link links[], size_t n_links, const armtol_tool_point *tool, double matrix[],
                              size_t n_columns);

ARMTOL_INTERFACE_END

#endif
