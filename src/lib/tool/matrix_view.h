#ifndef ARMTOL_LIB_TOOL_MATRIX_VIEW_H
#define ARMTOL_LIB_TOOL_MATRIX_VIEW_H

#include <stddef.h>

/*
 * A matrix A, or lanes of a block of them: element (i, k) of the first lane at first[i * row + k * column].
 */
typedef struct matrix_view {
    double *first;
    size_t row, column;
} matrix_view;

#endif
