#ifndef ARMTOL_TOOL_ERROR_H
#define ARMTOL_TOOL_ERROR_H

#include "armtol/interface.h"
#include "armtol/link.h"
#include "armtol/tool_point.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * Where the tool of an arm is whose parameters are off, less where it should be, by Eq. (4.1) and nothing linear.
 *
 * Given:
 *    links, n_links                the arm as meant, placed
 *    parameter_errors, n_columns   one value a column (error_matrix.h); nan and inf go through
 *    tool                          the tool point, and along which axes is counted
 *
 * Returned:
 *    error                         the displacement of the tool point, then the rotation vector (axis times angle, for
 *                                  angles up to pi) that turns the orientation as meant into that as built
 *
 * Errors:
 *    those of armtol_links_check
 *    ARMTOL_WRONG_SIZE             n_columns is not armtol_column_count
 */
armtol_status armtol_tool_error(const armtol_link links[], size_t n_links, const double parameter_errors[],
                                size_t n_columns, const armtol_tool_point *tool, double error[6]);

ARMTOL_INTERFACE_END

#endif
