#ifndef ARMTOL_ASK_NAMED_H
#define ARMTOL_ASK_NAMED_H

#include "armtol/arm.h"
#include "armtol/error_matrix.h"

#include <stdbool.h>

/* Options that take NAME=NUMBER,... : what stands in them, and which columns of A a name means. */

/* One item. The texts are the reader's: they are gone with it. */
typedef struct named_item {
    const char *option;
    const char *whole; /* as typed, up to the sign */
    long link;         /* of "3.alpha" and "elbow.alpha"; NAMED_ANY_LINK where there is none */
    const char *name;  /* behind it */
    char sign[3];      /* "=", ">=", "<="; empty where there is none */
    const char *value;
} named_item;

enum { NAMED_ANY_LINK = -1 };

/*
 * Hands every item to `take`, until that is false. False, after a message, for one that is too long, too, and for one
 * of a link that the arm does not have. A number is that of a link, also where a link is called so; where that is
 * another link, the item is refused.
 */
bool named_each(const char *option, const char *text, const armtol_arm *arm,
                bool (*take)(const named_item *item, void *context), void *context);

/* Whether the item has a sign of those in `signs`; else false after a message with what was expected. */
bool named_is(const named_item *item, const char *signs, const char *expected);

/* The columns of A of an arm. */
typedef struct named_columns {
    const armtol_arm *arm;
    const armtol_column *columns;
    size_t n_columns;
} named_columns;

/*
 * Whether an item means a column: its name is a parameter (theta) or a class (lengths, angles, motors, machining), of
 * that link or of all.
 */
bool named_column(const named_columns *of, const named_item *item, size_t column);

/* Whether it means any; else false after a message. */
bool named_any_column(const named_columns *of, const named_item *item);

#endif
