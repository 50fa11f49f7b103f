#ifndef ARMTOL_WISH_ACCURACY_H
#define ARMTOL_WISH_ACCURACY_H

#include "armtol/norm.h"

#include <stdbool.h>

/* An accuracy by names, in the units that it was typed in. */
typedef struct named_accuracy {
    double components[6]; /* infinity for those that are not named */
    armtol_norm norms[ARMTOL_MOST_NORMS];
    size_t n_norms;
    bool r, ap;           /* whether the norm of dx, dy and dz is named by either; never by both */
    double repeatability; /* rp; infinity where it is not named */
} named_accuracy;

/* Whether an accuracy is by names, and no list of six numbers. */
bool accuracy_is_named(const char *text);

/*
 * "dz=0.1,xy=0.02,w=0.01": components, norms (armtol_norm_name), ap and rp, each once, numbers > 0. False after a
 * message.
 */
bool accuracy_parse(const char *text, named_accuracy *accuracy);

#endif
