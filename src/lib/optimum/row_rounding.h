#ifndef ARMTOL_LIB_OPTIMUM_ROW_ROUNDING_H
#define ARMTOL_LIB_OPTIMUM_ROW_ROUNDING_H

#include <math.h>
#include <stddef.h>

/* Of a row of A an element up to this is what rounding left of a 0; only larger ones count (optimum.h). */
static inline double row_rounding(const double row[], size_t n)
{
    double largest = 0;
    for (size_t k = 0; k < n; k++) {
        largest = fmax(largest, fabs(row[k]));
    }
    return 1e-12 * largest;
}

#endif
