#ifndef ARMTOL_TOOL_POINT_H
#define ARMTOL_TOOL_POINT_H

#include "armtol/conventions.h"
#include "armtol/interface.h"
#include "armtol/link.h"

ARMTOL_INTERFACE_BEGIN

/* The axes along which errors of the tool are counted: those of the base, or of the tool where it should be. */
typedef enum armtol_frame { ARMTOL_BASE_FRAME, ARMTOL_TOOL_FRAME, ARMTOL_FRAME_COUNT } armtol_frame;

/* The point whose error is meant, and how it is counted. */
typedef struct armtol_tool_point {
    double offset[3]; /* from the origin of the last frame, in its coordinates */
    armtol_frame frame;
} armtol_tool_point;

/* The origin of the last frame, counted along the base's axes. */
extern const armtol_tool_point armtol_tool_origin;

/*
 * Where the tool is.
 *
 * Given:
 *    links, n_links   the arm, placed
 *    tool             the tool point; its frame is not looked at
 *
 * Returned:
 *    frame            the last frame's orientation, at the tool point, in the base's coordinates
 */
void armtol_tool_frame(const armtol_link links[], size_t n_links, const armtol_tool_point *tool,
                       armtol_transform *frame);

ARMTOL_INTERFACE_END

#endif
