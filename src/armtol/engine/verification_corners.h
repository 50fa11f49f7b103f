#ifndef ARMTOL_ENGINE_VERIFICATION_CORNERS_H
#define ARMTOL_ENGINE_VERIFICATION_CORNERS_H

#include "armtol/engine/verification.h"

#include <stdbool.h>

/*
 * What the corners of the box of tolerances do: prediction, rss, remainder and worst_corner of the six
 * components, the largest of all poses. Every tolerance is finite. False, after a message, where memory is
 * short.
 */
bool verification_corners(const verification_task *task, verified_component components[6]);

#endif
