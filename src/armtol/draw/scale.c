#include "armtol/draw/scale.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTHS = 8 };

/* By the decimal digits and not by a logarithm, of which machines have different last bits. */
static int exponent_of(double value)
{
    char text[40];
    snprintf(text, sizeof text, "%.15e", value);
    return (int)strtol(strchr(text, 'e') + 1, NULL, 10);
}

static double decimal(const char *digits, int exponent)
{
    char text[40];
    snprintf(text, sizeof text, "%se%d", digits, exponent);
    return strtod(text, NULL);
}

double scale_step(double span, size_t count)
{
    static const char *const digits[] = {"1", "2", "2.5", "5", "10"};
    const double least = span / (double)count * (1 - 1e-9);
    const int exponent = exponent_of(least);
    size_t i = 0;
    while (i < 4 && decimal(digits[i], exponent) < least) {
        i++;
    }
    return decimal(digits[i], exponent);
}

double scale_first(double from, double step)
{
    return ceil(from / step - 1e-9) * step;
}

void scale_make(scale *scale, double least, double most)
{
    if (!(most - least > 1e-9 * most)) {
        *scale = (struct scale){1, {least, most}};
        return;
    }
    const double step = scale_step(most - least, WIDTHS);
    const double first = floor(least / step + 1e-9);
    scale->n_bands = 0;
    scale->edges[0] = first * step;
    do {
        scale->n_bands++;
        scale->edges[scale->n_bands] = (first + (double)scale->n_bands) * step;
    } while (scale->edges[scale->n_bands] < most * (1 - 1e-12));
}

size_t scale_band(const scale *scale, double value)
{
    size_t band = 0;
    while (band + 1 < scale->n_bands && value >= scale->edges[band + 1]) {
        band++;
    }
    return band;
}
