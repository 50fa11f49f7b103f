#include "armtol/draw/contour.h"

#include <math.h>
#include <stdbool.h>

/* The corners of a square, around it from the lower left one, and its sides from each corner to the next. */
typedef struct square {
    size_t i, j;
    double values[4];
} square;

static const double corner_x[4] = {0, 1, 1, 0}, corner_y[4] = {0, 0, 1, 1};

static bool take_corners(const field *field, size_t i, size_t j, square *square)
{
    const size_t at[4] = {j * field->n_x + i, j * field->n_x + i + 1, (j + 1) * field->n_x + i + 1,
                          (j + 1) * field->n_x + i};
    bool whole = field->joins(field->context, at[0], false) && field->joins(field->context, at[3], false) &&
                 field->joins(field->context, at[0], true) && field->joins(field->context, at[1], true);
    square->i = i;
    square->j = j;
    for (size_t k = 0; k < 4; k++) {
        square->values[k] = field->values[at[k]];
        whole = whole && isfinite(square->values[k]);
    }
    return whole;
}

static void cross(const square *square, size_t side, double level, double *x, double *y)
{
    const size_t next = (side + 1) % 4;
    const double share = (level - square->values[side]) / (square->values[next] - square->values[side]);
    *x = (double)square->i + corner_x[side] + share * (corner_x[next] - corner_x[side]);
    *y = (double)square->j + corner_y[side] + share * (corner_y[next] - corner_y[side]);
}

static void trace_square(const square *square, double level, void (*take)(const piece *piece, void *context),
                         void *context)
{
    size_t sides[4], n = 0;
    for (size_t k = 0; k < 4; k++) {
        if ((square->values[k] < level) != (square->values[(k + 1) % 4] < level)) {
            sides[n++] = k;
        }
    }
    const double *v = square->values;
    const bool middle_below = (v[0] + v[1] + v[2] + v[3]) / 4 < level;
    /* four sides: each line cuts off a corner that is not as the middle is; the first side ends at corner 1 */
    const size_t first = n == 4 && (v[1] < level) == middle_below ? 1 : 0;
    for (size_t k = 0; k + 1 < n; k += 2) {
        piece piece;
        cross(square, sides[(first + k) % n], level, &piece.x[0], &piece.y[0]);
        cross(square, sides[(first + k + 1) % n], level, &piece.x[1], &piece.y[1]);
        take(&piece, context);
    }
}

void contour_trace(const field *field, double level, void (*take)(const piece *piece, void *context), void *context)
{
    for (size_t j = 0; j + 1 < field->n_y; j++) {
        for (size_t i = 0; i + 1 < field->n_x; i++) {
            square square;
            if (take_corners(field, i, j, &square)) {
                trace_square(&square, level, take, context);
            }
        }
    }
}
