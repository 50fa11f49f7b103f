#ifndef ARMTOL_LIB_ENGINE_CORNER_SEARCH_H
#define ARMTOL_LIB_ENGINE_CORNER_SEARCH_H

#include "armtol/verification.h"
#include "lib/private_names.h"

#include <stdbool.h>

/*
 * The worst corner of every component and norm, the largest of all poses, what has no bound counting as exact. False
 * where it was ended early: what was found until then is there. workspace has SEARCH_WORKSPACE places a column.
 */
enum { SEARCH_WORKSPACE = 4 };
bool search_corners(const armtol_answer *answer, const armtol_draw *draw, double workspace[],
                    armtol_verification *found);

#endif
