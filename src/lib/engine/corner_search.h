#ifndef ARMTOL_LIB_ENGINE_CORNER_SEARCH_H
#define ARMTOL_LIB_ENGINE_CORNER_SEARCH_H

#include "armtol/verification.h"
#include "lib/private_names.h"

#include <stdbool.h>

/*
 * The worst corner of the six components, the largest of all poses, what has no bound counting as exact. False where it
 * was ended early: what was found until then is there. errors has a place a column.
 */
bool search_corners(const armtol_answer *answer, const armtol_draw *draw, double errors[],
                    armtol_verified components[6]);

#endif
