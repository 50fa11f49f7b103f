#ifndef ARMTOL_LIB_TOOL_BUILT_H
#define ARMTOL_LIB_TOOL_BUILT_H

#include "armtol/link.h"
#include "armtol/tool_point.h"
#include "armtol/transform.h"
#include "lib/private_names.h"

#include <stddef.h>

/* The link with errors of the parameters that its kind counts; *count is their number. */
armtol_link built_link(const armtol_link *link, const double parameter_errors[], size_t *count);

/* The last frame of a chain whose links are built so. */
armtol_transform built_chain(const armtol_link links[], size_t n_links, const double parameter_errors[]);

/* What armtol_tool_error says where the last frame is built there and meant there. */
void built_error(const armtol_transform *built, const armtol_transform *meant, const armtol_tool_point *tool,
                 double error[6]);

#endif
