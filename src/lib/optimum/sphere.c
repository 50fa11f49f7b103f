#include "armtol/sphere.h"

#include "armtol/machining.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

/*
 * Method
 *    The angle bound is that of the largest norms of all poses, as limits are the same in each; the distance bound is
 *    looked for row by row, since both its norms are of one row of one pose. Delta is what is left of the least limit
 *    where the tolerance of a length, which falls with the angles' radius, meets that of an angle, which grows.
 *
 * Special cases
 *    Free rows have norms of 0. Bounds that no row sets are infinite. Delta is 0 where no linear row has a length; else
 *    it is between 2^-52 of the smallest limit and the number below that.
 *
 * Accuracy
 *    Bounds to 1e-14 of those of bounds.c (test_the_arms_of_1987_have_their_corrected_bounds); of 1,000 deltas no other
 *    gives a least tolerance that is larger by 1e-12 (test_no_other_delta_is_better).
 */

/* What the bounds are of. */
typedef struct task {
    const double *matrix;
    size_t n_poses;
    size_t n_columns;
    const armtol_column *columns;
    const double *limits;
} task;

/* The largest norms of the rows of all poses. The limits being the same in every pose, these set the angle bound. */
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

/* Norms of one row of one pose. */
typedef struct row_norms {
    double lengths;
    double angles;
} row_norms;

/* 0 where the row is free. */
static row_norms norms_of(const task *task, size_t pose, size_t i)
{
    const double *row = task->matrix + (pose * 6 + i) * task->n_columns;
    double lengths = 0, angles = 0;
    for (size_t k = 0; k < task->n_columns && !isinf(task->limits[i]); k++) {
        const bool length = armtol_parameter_is_length(task->columns[k].parameter);
        lengths += length ? row[k] * row[k] : 0;
        angles += length ? 0 : row[k] * row[k];
    }
    return (row_norms){sqrt(lengths), sqrt(angles)};
}

/* Raise the norms to those of one pose. */
static armtol_status raise_norms(const task *task, size_t pose, sphere_rows *rows)
{
    for (size_t i = 0; i < 6; i++) {
        const row_norms norms = norms_of(task, pose, i);
        if (!isfinite(norms.lengths) || !isfinite(norms.angles)) {
            return ARMTOL_NOT_FINITE;
        }
        rows->lengths[i] = fmax(rows->lengths[i], norms.lengths);
        rows->angles[i] = fmax(rows->angles[i], norms.angles);
    }
    return ARMTOL_OK;
}

static armtol_status find_rows(const task *task, sphere_rows *rows)
{
    armtol_status status = check_limits(task->limits);
    *rows = (sphere_rows){{0}, {0}, 0, 0};
    count_classes(task->columns, task->n_columns, rows);
    for (size_t pose = 0; pose < task->n_poses && status == ARMTOL_OK; pose++) {
        status = raise_norms(task, pose, rows);
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

/*
 * The least radius that the rows of any pose leave the lengths while the errors of angles stay within theirs. Both
 * norms are of one row of one pose: the largest of each, of two poses, would leave less than need be.
 */
static double length_radius(const task *task, double angle, double delta)
{
    double radius = (double)INFINITY;
    for (size_t pose = 0; pose < task->n_poses; pose++) {
        for (size_t i = 0; i < 3; i++) {
            const row_norms norms = norms_of(task, pose, i);
            const double taken = norms.angles > 0 ? norms.angles * angle : 0;
            if (norms.lengths > 0) {
                /* delta at the least: rounding apart it is */
                radius = fmin(radius, fmax(task->limits[i] - taken, delta) / norms.lengths);
            }
        }
    }
    return radius;
}

armtol_status armtol_sphere_bounds(const double matrix[], size_t n_poses, size_t n_columns,
                                   const armtol_column columns[], const double limits[6], double delta,
                                   armtol_bounds *bounds)
{
    const task task = {matrix, n_poses, n_columns, columns, limits};
    sphere_rows rows;
    armtol_status status = find_rows(&task, &rows);
    if (status == ARMTOL_OK) {
        status = check_delta(&rows, limits, delta);
    }
    if (status != ARMTOL_OK) {
        return status;
    }
    bounds->angle = fmin(least_radius(rows.angles, limits, delta, 0, 3),
                         least_radius(rows.angles, limits, 0, 3, 6));
    bounds->distance = length_radius(&task, bounds->angle, delta);
    return ARMTOL_OK;
}

/*
 * The angles' radius where the tolerance of an angle, which grows with it, meets that of a length, which falls: the
 * length radius times ratio. Each row of each pose has one; the least counts.
 */
static double even_radius(const task *task, double ratio)
{
    double radius = (double)INFINITY;
    for (size_t pose = 0; pose < task->n_poses; pose++) {
        for (size_t i = 0; i < 3; i++) {
            const row_norms norms = norms_of(task, pose, i);
            if (norms.lengths > 0) {
                radius = fmin(radius, ratio * task->limits[i] / (norms.lengths + ratio * norms.angles));
            }
        }
    }
    return radius;
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

/* A row that no length moves may ask for all that is left; then what rounding does not lose stays for delta. */
static double best_delta(const task *task, const sphere_rows *rows, double lever)
{
    const double smallest = smallest_linear(task->limits);
    const double ratio = sqrt((double)rows->n_angles) / sqrt((double)rows->n_lengths) / lever;
    const double radius = fmin(even_radius(task, ratio), least_radius(rows->angles, task->limits, 0, 3, 6));
    const double delta = most_delta(rows, task->limits, radius);
    return fmin(fmax(delta, smallest * DBL_EPSILON), nextafter(smallest, 0));
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
    const task task = {matrix, n_poses, n_columns, columns, limits};
    sphere_rows rows;
    const armtol_status status = find_rows(&task, &rows);
    if (status != ARMTOL_OK) {
        return status;
    }
    if (largest_linear(rows.lengths) <= 0) {
        *delta = 0;
        return ARMTOL_OK;
    }
    const double best = best_delta(&task, &rows, lever);
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
