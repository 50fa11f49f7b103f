#include "armtol/sphere.h"

#include "armtol/machining.h"

#include <math.h>
#include <stdbool.h>

/* What the bounds are made of. The limits being the same in every pose, only the largest norm of a row counts. */
typedef struct sphere_rows {
    double lengths[6]; /* norms of the rows' length columns, 0 for rows that are free */
    double angles[6];
    size_t n_lengths;
    size_t n_angles;
} sphere_rows;

static void count_classes(const armtol_column columns[], size_t n_columns, sphere_rows *rows)
{
    rows->n_lengths = 0;
    for (size_t k = 0; k < n_columns; k++) {
        rows->n_lengths += armtol_parameter_is_length(columns[k].parameter);
    }
    rows->n_angles = n_columns - rows->n_lengths;
}

static double class_norm(const double row[], size_t n_columns, const armtol_column columns[], bool of_lengths)
{
    double sum = 0;
    for (size_t k = 0; k < n_columns; k++) {
        if (armtol_parameter_is_length(columns[k].parameter) == of_lengths) {
            sum += row[k] * row[k];
        }
    }
    return sqrt(sum);
}

static armtol_status check_limits(const double limits[6])
{
    for (int i = 0; i < 6; i++) {
        if (isnan(limits[i])) {
            return ARMTOL_NOT_FINITE;
        }
        if (limits[i] <= 0) {
            return ARMTOL_BAD_TOLERANCE;
        }
    }
    return ARMTOL_OK;
}

/* Raise the norms to those of one pose. */
static armtol_status raise_norms(const double matrix[], size_t n_columns, const armtol_column columns[],
                                 const double limits[6], sphere_rows *rows)
{
    for (size_t i = 0; i < 6; i++) {
        const double *row = matrix + i * n_columns;
        const double lengths = isinf(limits[i]) ? 0 : class_norm(row, n_columns, columns, true);
        const double angles = isinf(limits[i]) ? 0 : class_norm(row, n_columns, columns, false);
        if (!isfinite(lengths) || !isfinite(angles)) {
            return ARMTOL_NOT_FINITE;
        }
        rows->lengths[i] = fmax(rows->lengths[i], lengths);
        rows->angles[i] = fmax(rows->angles[i], angles);
    }
    return ARMTOL_OK;
}

static armtol_status find_rows(const double matrix[], size_t n_poses, size_t n_columns,
                               const armtol_column columns[], const double limits[6], sphere_rows *rows)
{
    armtol_status status = check_limits(limits);
    *rows = (sphere_rows){{0}, {0}, 0, 0};
    count_classes(columns, n_columns, rows);
    for (size_t pose = 0; pose < n_poses && status == ARMTOL_OK; pose++) {
        status = raise_norms(matrix + pose * 6 * n_columns, n_columns, columns, limits, rows);
    }
    return status;
}

static double largest_linear(const double norms[6])
{
    return fmax(norms[0], fmax(norms[1], norms[2]));
}

static double smallest_linear(const double limits[6])
{
    return fmin(limits[0], fmin(limits[1], limits[2]));
}

/* The least of allowed / norm over rows first to end - 1 that have a norm; infinite where none has. */
static double least_radius(const double norms[6], const double limits[6], double delta, int first, int end)
{
    double radius = (double)INFINITY;
    for (int i = first; i < end; i++) {
        if (norms[i] > 0) {
            radius = fmin(radius, (limits[i] - delta) / norms[i]);
        }
    }
    return radius;
}

static armtol_status check_delta(const sphere_rows *rows, const double limits[6], double delta)
{
    const double smallest = smallest_linear(limits);
    if (isinf(smallest)) {
        return ARMTOL_OK;
    }
    if (isnan(delta)) {
        return ARMTOL_NOT_FINITE;
    }
    const bool may_be_zero = largest_linear(rows->lengths) <= 0;
    return (delta > 0 || (may_be_zero && delta >= 0)) && delta < smallest ? ARMTOL_OK : ARMTOL_BAD_DELTA;
}

armtol_status armtol_sphere_bounds(const double matrix[], size_t n_poses, size_t n_columns,
                                   const armtol_column columns[], const double limits[6], double delta, armtol_bounds *bounds)
{
    sphere_rows rows;
    armtol_status status = find_rows(matrix, n_poses, n_columns, columns, limits, &rows);
    if (status == ARMTOL_OK) {
        status = check_delta(&rows, limits, delta);
    }
    if (status != ARMTOL_OK) {
        return status;
    }
    const double norm = largest_linear(rows.lengths);
    bounds->distance = norm > 0 ? delta / norm : (double)INFINITY;
    bounds->angle = fmin(least_radius(rows.angles, limits, delta, 0, 3),
                         least_radius(rows.angles, limits, 0, 3, 6));
    return ARMTOL_OK;
}

/*
 * Where the length tolerance, which grows with delta, meets the linear rows' angle tolerances at the lever's
 * end, which fall to 0 at the rows' limits. An angle's radius over a length's is ratio times their tolerances
 * there.
 */
static double linear_crossing(const sphere_rows *rows, const double limits[6], double ratio)
{
    double crossing = (double)INFINITY;
    for (int i = 0; i < 3; i++) {
        if (!isinf(limits[i])) {
            const double slope = rows->angles[i] * ratio / largest_linear(rows->lengths);
            crossing = fmin(crossing, limits[i] / (1 + slope));
        }
    }
    return crossing;
}

/* The largest delta that leaves the angles this radius. */
static double most_delta(const sphere_rows *rows, const double limits[6], double radius)
{
    double delta = (double)INFINITY;
    for (int i = 0; i < 3; i++) {
        if (!isinf(limits[i])) {
            delta = fmin(delta, limits[i] - radius * rows->angles[i]);
        }
    }
    return delta;
}

static double best_delta(const sphere_rows *rows, const double limits[6], double lever)
{
    const double ratio = sqrt((double)rows->n_angles) / sqrt((double)rows->n_lengths) / lever;
    const double linear = linear_crossing(rows, limits, ratio);
    const double radius = least_radius(rows->angles, limits, 0, 3, 6);
    const double angular = radius * largest_linear(rows->lengths) / ratio;
    const double delta = linear <= angular ? linear : most_delta(rows, limits, radius);
    return fmin(delta, nextafter(smallest_linear(limits), 0));
}

armtol_status armtol_sphere_delta(const double matrix[], size_t n_poses, size_t n_columns,
                                  const armtol_column columns[], const double limits[6], double lever, double *delta)
{
    if (!isfinite(lever)) {
        return ARMTOL_NOT_FINITE;
    }
    if (lever <= 0) {
        return ARMTOL_BAD_WEIGHT;
    }
    sphere_rows rows;
    const armtol_status status = find_rows(matrix, n_poses, n_columns, columns, limits, &rows);
    if (status != ARMTOL_OK) {
        return status;
    }
    if (largest_linear(rows.lengths) <= 0) {
        *delta = 0;
        return ARMTOL_OK;
    }
    const double best = best_delta(&rows, limits, lever);
    if (!(best > 0)) {
        return ARMTOL_NOT_FINITE;
    }
    *delta = best;
    return ARMTOL_OK;
}

void armtol_sphere_tolerances(const armtol_column columns[], size_t n_columns, const armtol_bounds *bounds,
                              double tolerances[])
{
    sphere_rows rows;
    count_classes(columns, n_columns, &rows);
    const armtol_shares shares = armtol_parameter_shares(bounds, rows.n_lengths, rows.n_angles,
                                                         &armtol_errata_none);
    for (size_t k = 0; k < n_columns; k++) {
        tolerances[k] = armtol_parameter_is_length(columns[k].parameter) ? shares.distance : shares.angle;
    }
}
