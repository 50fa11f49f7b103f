#include "armtol/corners.h"

#include "armtol/error_matrix.h"
#include "armtol/tool_error.h"

#include <math.h>

/* What is climbed on. */
typedef struct slope {
    const armtol_link *links;
    size_t n_links;
    const armtol_tool_point *tool;
    const double *shifts, *tolerances;
    size_t n_columns;
    armtol_error_size size;
    const void *context;
} slope;

static double size_at(const slope *slope, const double errors[])
{
    double error[6];
    const armtol_status status =
        armtol_tool_error(slope->links, slope->n_links, errors, slope->n_columns, slope->tool, error);
    return status == ARMTOL_OK ? slope->size(error, slope->context) : (double)NAN;
}

/* Give one error the sign that makes more of it, if any does. Returns what it is then. */
static double climb_one(const slope *slope, double most, size_t k, double errors[])
{
    static const double least_gain = 1e-9; /* less may be rounding, and not end */
    const double shift = slope->shifts != NULL ? slope->shifts[k] : 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        const double before = errors[k], end = shift + sign * slope->tolerances[k];
        if (before == end) {
            continue;
        }
        errors[k] = end;
        const double changed = size_at(slope, errors);
        if (changed > most * (1 + least_gain)) {
            most = changed;
        } else {
            errors[k] = before;
        }
    }
    return most;
}

double armtol_climb(const armtol_link links[], size_t n_links, const armtol_tool_point *tool, const double shifts[],
                    const double tolerances[], size_t n_columns, armtol_error_size size, const void *context,
                    double errors[])
{
    enum { MOST_ROUNDS = 100 }; /* two or three do, where errors are small */
    const slope slope = {links, n_links, tool, shifts, tolerances, n_columns, size, context};
    double most = size_at(&slope, errors), before = -1;
    for (int round = 0; round < MOST_ROUNDS && most > before; round++) {
        before = most;
        for (size_t k = 0; k < n_columns; k++) {
            most = climb_one(&slope, most, k, errors);
        }
    }
    return most;
}
