#ifndef ARMTOL_LIB_REGION_BOXES_H
#define ARMTOL_LIB_REGION_BOXES_H

#include "lib/private_names.h"

#include <stdbool.h>
#include <stddef.h>

/* Boxes that are still open, the one with the largest bound first: a binary heap. */
typedef struct open_box {
    double bound;
    size_t halve;  /* the variable along which */
    double *range; /* n_variables lows, and as many highs: in the heap's memory */
} open_box;

typedef struct boxes {
    size_t n_variables, count, room;
    open_box *heap;
} boxes;

void boxes_start(boxes *boxes, size_t n_variables);
void boxes_free(boxes *boxes);

/* A copy of the box; false where memory is short. */
bool boxes_add(boxes *boxes, double bound, size_t halve, const double range[]);

/* Takes the first out, into range; there is one. Its bound and variable. */
open_box boxes_take(boxes *boxes, double range[]);

#endif
