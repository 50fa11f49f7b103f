#include "lib/norms/discs.h"

#include "armtol/corners.h"

#include <math.h>

bool discs_have(const bool discs[], size_t column)
{
    return discs != NULL && (discs[column] || (column > 0 && discs[column - 1]));
}

size_t discs_count(const bool discs[], size_t n_columns)
{
    size_t n = 0;
    for (size_t k = 0; k < n_columns && discs != NULL; k++) {
        n += discs[k];
    }
    return n;
}

/* Without overflow on the way. */
static double length(double one, double other)
{
    const double more = fmax(fabs(one), fabs(other)), less = fmin(fabs(one), fabs(other));
    return more > 0 ? more * sqrt(1 + less / more * (less / more)) : 0;
}

static double part_of(double element, double tolerance)
{
    return element != 0 ? fabs(element) * tolerance : 0;
}

double discs_worst_part(const double row[], size_t column, const double tolerances[], const bool discs[])
{
    if (!discs_have(discs, column)) {
        return part_of(row[column], tolerances[column]);
    }
    return discs[column] ? length(row[column], row[column + 1]) * tolerances[column] : 0;
}

double discs_worst(const double row[], size_t n_columns, const double tolerances[], const bool discs[])
{
    double sum = 0;
    for (size_t k = 0; k < n_columns; k++) {
        sum += discs_worst_part(row, k, tolerances, discs);
    }
    return sum;
}

void discs_corner(const double row[], size_t n_columns, int sign, const double tolerances[], const bool discs[],
                  double errors[])
{
    armtol_corner(row, n_columns, 0, sign, tolerances, errors);
    for (size_t k = 0; k < n_columns; k++) {
        if (discs != NULL && discs[k]) {
            const double steepest = length(row[k], row[k + 1]);
            errors[k] = steepest > 0 ? sign * tolerances[k] * (row[k] / steepest) : 0;
            errors[k + 1] = steepest > 0 ? sign * tolerances[k] * (row[k + 1] / steepest) : 0;
        }
    }
}
