#ifndef ARMTOL_DRAW_SCALE_H
#define ARMTOL_DRAW_SCALE_H

#include <stddef.h>

/* Round numbers for axes and bands: 1, 2, 2.5 or 5 times a power of ten. The same on every machine. */

/* A round number, so that about `count` of it are the span, which is > 0. */
double scale_step(double span, size_t count);

/* The first multiple of step that is not below `from`, a little rounding apart. */
double scale_first(double from, double step);

/* Bands of values, an edge between each two: edges[0] to edges[n_bands]. */
enum { SCALE_MOST = 12 };
typedef struct scale {
    size_t n_bands;
    double edges[SCALE_MOST + 1];
} scale;

/*
 * Bands of one width that hold all of least to most, 0 <= least <= most; one where the two are the same but for
 * rounding.
 */
void scale_make(scale *scale, double least, double most);

/* The band of a value that is within. */
size_t scale_band(const scale *scale, double value);

#endif
