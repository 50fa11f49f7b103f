#ifndef ARMTOL_ASK_NOTHING_LEFT_H
#define ARMTOL_ASK_NOTHING_LEFT_H

#include "armtol/ask/request.h"

/*
 * The message of a wish for which drives and given tolerances leave nothing: by how much, where, and which sources make
 * it up. The fault is the engine's. An exit code.
 */
int nothing_left(const request *request, const armtol_fault *fault);

#endif
