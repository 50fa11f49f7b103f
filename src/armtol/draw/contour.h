#ifndef ARMTOL_DRAW_CONTOUR_H
#define ARMTOL_DRAW_CONTOUR_H

#include <stdbool.h>
#include <stddef.h>

/*
 * Values at the points of a grid, rows from below, n_x a row; whether a point is joined to the next one, or the one
 * above.
 */
typedef struct field {
    size_t n_x, n_y;
    const double *values;
    bool (*joins)(const void *context, size_t point, bool above);
    const void *context;
} field;

/* A piece of a contour, in steps of the grid from its first point. */
typedef struct piece {
    double x[2], y[2];
} piece;

/*
 * Where the field has the value `level`, straight between the points of the grid and in squares whose four sides are
 * joined: the pieces, square by square, handed to
 * `take` (marching squares; where two lines cross a square its middle says which corners hang together).
 */
void contour_trace(const field *field, double level, void (*take)(const piece *piece, void *context), void *context);

#endif
