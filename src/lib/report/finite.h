#ifndef ARMTOL_LIB_REPORT_FINITE_H
#define ARMTOL_LIB_REPORT_FINITE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

static inline bool all_finite(const double values[], size_t count)
{
    bool finite = true;
    for (size_t i = 0; i < count; i++) {
        finite = finite && isfinite(values[i]);
    }
    return finite;
}

#endif
