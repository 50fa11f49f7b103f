#ifndef ARMTOL_STATUS_H
#define ARMTOL_STATUS_H

#include "armtol/interface.h"

ARMTOL_INTERFACE_BEGIN

typedef enum armtol_status {
    ARMTOL_OK = 0,
    ARMTOL_NO_LINKS,        /* a chain of no links */
    ARMTOL_BAD_KIND,        /* a link kind that is none of armtol_kind */
    ARMTOL_BAD_JOINT,       /* a joint variable that is none of armtol_joint */
    ARMTOL_NOT_FINITE,      /* nan or inf among the input, or a result that overflows */
    ARMTOL_WRONG_SIZE,      /* an array length that does not fit the chain */
    ARMTOL_OUT_OF_REACH,    /* no joint values lead there */
    ARMTOL_SINGULAR,        /* infinitely many joint values lead there */
    ARMTOL_BAD_TOLERANCE,   /* a tolerance that is not positive */
    ARMTOL_BAD_DELTA,       /* delta not between 0 and the smallest linear tolerance */
    ARMTOL_UNKNOWN_ERRATUM, /* a name that stands in no row of the errata table */
    ARMTOL_BAD_WEIGHT,      /* a weight that is not positive */
    ARMTOL_BAD_AXIS,        /* an axis without a direction, or of a joint that does not move */
    ARMTOL_NOT_SOLVED,      /* an iteration that did not converge */
    ARMTOL_NO_MEMORY,       /* the machine has none left */
    ARMTOL_BAD_QUESTION,    /* a question without what it needs, or of no known method */
    ARMTOL_UNBOUNDED,       /* a component that has to keep to an accuracy, and has no bound */
    ARMTOL_BAD_LOAD,        /* a mass, drive or share that is none, or compliance without a moment */
    ARMTOL_BAD_RANGE,       /* a tolerance's least value is above its largest, or not one that the method can keep to */
    ARMTOL_NOTHING_LEFT,    /* what is given exceeds the accuracy by itself */
    ARMTOL_BAD_NORM,        /* a norm that is not of two or three lengths or angles, or a method without norms */
    ARMTOL_BAD_GRADE,       /* a name that is no tolerance grade */
    ARMTOL_BAD_SPREAD,      /* a distribution that is none, a group of unlike ones, or what cannot be asked of them */
    ARMTOL_STATUS_COUNT     /* the number of the above, itself no status */
} armtol_status;

/* A short English text without a full stop, never NULL, for any value. */
const char *armtol_status_text(armtol_status status);

ARMTOL_INTERFACE_END

#endif
