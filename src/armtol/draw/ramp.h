#ifndef ARMTOL_DRAW_RAMP_H
#define ARMTOL_DRAW_RAMP_H

#include <stddef.h>

/*
 * Colour number i of n, from dark to light: "#440154". Every step is as large for the eye, the luminance grows from one
 * to the next, and colour-blind readers tell them apart: the map viridis by S. van der Walt and N. Smith (2015,
 * matplotlib; CC0), of whose 256 rows every 17th is here. n is 1 to RAMP_COLOURS.
 */
enum { RAMP_COLOURS = 16 };
const char *ramp_colour(size_t i, size_t n);

#endif
