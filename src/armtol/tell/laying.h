#ifndef ARMTOL_TELL_LAYING_H
#define ARMTOL_TELL_LAYING_H

#include "armtol/ask/units.h"
#include "armtol/forms/json.h"

/* What was done to the frames of an arm; nothing where nothing was. Each line of text begins with `before`. */
void laying_print(const arm_laying *laying, const units *units, const char *before);
void laying_write(json *json, const arm_laying *laying, const units *units);

#endif
