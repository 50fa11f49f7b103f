#include "armtol/bounds.h"

#include "lib/report/arithmetic.h"

#include <math.h>

armtol_status armtol_tolerances_check(const double tolerances[6], double delta)
{
    for (int i = 0; i < 6; i++) {
        if (!isfinite(tolerances[i])) {
            return ARMTOL_NOT_FINITE;
        }
        if (tolerances[i] <= 0) {
            return ARMTOL_BAD_TOLERANCE;
        }
    }
    if (!isfinite(delta)) {
        return ARMTOL_NOT_FINITE;
    }
    const double smallest = fmin(tolerances[0], fmin(tolerances[1], tolerances[2]));
    return delta > 0 && delta < smallest ? ARMTOL_OK : ARMTOL_BAD_DELTA;
}

/*
 * Method
 *    The norms of the rows, lengths and angles apart; each bound is the least of what the rows allow.
 *
 * Special cases
 *    A row without an entry allows anything. What the angles leave is delta at the least: rounding apart it is.
 *
 * Accuracy
 *    With all errata the paper's bounds to their last digit (test_1987_gives_the_paper_s_bounds); nothing is summed
 *    with more care than its order gives.
 */
static double row_norm(const double row[], size_t first, size_t end, const armtol_errata *errata)
{
    double sum = 0;
    for (size_t k = first; k < end; k++) {
        sum = store(errata, sum + row[k] * row[k]);
    }
    return store(errata, sqrt(sum));
}

/* Lower the bound to the radius that one row allows; a row without an entry allows any. */
static void tighten(double *bound, double allowed, double norm, const armtol_errata *errata)
{
    if (norm > 0) {
        *bound = fmin(*bound, store(errata, allowed / norm));
    }
}

/* What errors of lengths may move a row by, while those of angles stay within their bound. */
static double left_to_lengths(double tolerance, double delta, double angles, double bound, const armtol_errata *errata)
{
    /* Erratum `distance-share`: delta, whatever the angles leave. */
    if (errata->distance_share) {
        return delta;
    }
    /* delta at the least: rounding apart it is */
    return angles > 0 ? store(errata, fmax(tolerance - angles * bound, delta)) : tolerance;
}

armtol_status armtol_norm_bounds(const double ordered[], size_t n_columns, size_t n_lengths,
                                 const double tolerances[6], double delta, const armtol_errata *errata,
                                 armtol_bounds *bounds)
{
    const armtol_status status = armtol_tolerances_check(tolerances, delta);
    if (status != ARMTOL_OK) {
        return status;
    }
    if (n_lengths > n_columns) {
        return ARMTOL_WRONG_SIZE;
    }
    double distance = (double)INFINITY, angle = (double)INFINITY;
    double lengths[6], angles[6];
    for (size_t i = 0; i < 6; i++) {
        const double *row = ordered + i * n_columns;
        lengths[i] = row_norm(row, 0, n_lengths, errata);
        angles[i] = row_norm(row, n_lengths, n_columns, errata);
        if (!isfinite(lengths[i]) || !isfinite(angles[i])) {
            return ARMTOL_NOT_FINITE;
        }
        tighten(&angle, i < 3 ? store(errata, tolerances[i] - delta) : tolerances[i], angles[i], errata);
    }
    for (size_t i = 0; i < 3; i++) {
        tighten(&distance, left_to_lengths(tolerances[i], delta, angles[i], angle, errata), lengths[i], errata);
    }
    *bounds = (armtol_bounds){distance, angle};
    return ARMTOL_OK;
}
