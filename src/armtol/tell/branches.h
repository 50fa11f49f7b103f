#ifndef ARMTOL_TELL_BRANCHES_H
#define ARMTOL_TELL_BRANCHES_H

#include "armtol/ask/at.h"

/* All branches found of each position, on standard output; false where one has none, after a message of each. */
bool branches_print(const at_wishes *at, output_format format);

#endif
