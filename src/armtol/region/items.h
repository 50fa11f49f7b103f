#ifndef ARMTOL_REGION_ITEMS_H
#define ARMTOL_REGION_ITEMS_H

#include "armtol/region/region_words.h"

/* Takes one item, NAME=VALUE, apart; the text is cut up. False after a message. */
bool region_item_take(char *item, const armtol_arm *arm, const units *units, region_words *words);

/* The half of a joint's range that "3+" or "3-" means: on that side of where the arm is stretched. False after a
   message. */
bool region_elbow_take(const char *text, const armtol_arm *arm, region_words *words);

#endif
