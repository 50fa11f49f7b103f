#include "corners.h"

#include "error_size.h"

#include <math.h>

double corner_prediction(const double matrix[], size_t n_columns, size_t row, const double tolerances[])
{
    double sum = 0;
    for (size_t k = 0; k < n_columns; k++) {
        sum += fabs(matrix[row * n_columns + k]) * tolerances[k];
    }
    return sum;
}

void corner_of_row(const double matrix[], size_t n_columns, size_t row, int sign, const double tolerances[],
                   double errors[])
{
    const double *elements = matrix + row * n_columns;
    double largest = 0;
    for (size_t k = 0; k < n_columns; k++) {
        largest = fmax(largest, fabs(elements[k]));
    }
    const double rounding = 1e-12 * largest;
    for (size_t k = 0; k < n_columns; k++) {
        errors[k] = fabs(elements[k]) > rounding ? sign * copysign(tolerances[k], elements[k]) : 0;
    }
}

static double distance_at(const built_arm *arm, const double errors[])
{
    double error[6];
    built_arm_error(arm, errors, error);
    return error_norm(error);
}

/* Give one error the sign that takes the tool point farther, if any does. Returns the distance then. */
static double climb_one(const built_arm *arm, double tolerance, double distance, double errors[], size_t k)
{
    static const double least_gain = 1e-9; /* of the distance: less may be rounding, and not end */
    for (int sign = -1; sign <= 1; sign += 2) {
        const double before = errors[k];
        errors[k] = sign * tolerance;
        const double changed = distance_at(arm, errors);
        if (changed > distance * (1 + least_gain)) {
            distance = changed;
        } else {
            errors[k] = before;
        }
    }
    return distance;
}

double corner_climb(const built_arm *arm, const double tolerances[], double errors[])
{
    double distance = distance_at(arm, errors), before;
    do {
        before = distance;
        for (size_t k = 0; k < arm->n_columns; k++) {
            distance = climb_one(arm, tolerances[k], distance, errors, k);
        }
    } while (distance > before);
    return distance;
}

/* The sum of the tolerances of all lengths, or of all angles. */
static double sum_of(const built_arm *arm, const double tolerances[], bool lengths)
{
    double sum = 0;
    for (size_t k = 0; k < arm->n_columns; k++) {
        sum += armtol_parameter_is_length(arm->columns[k].parameter) == lengths ? tolerances[k] : 0;
    }
    return sum;
}

double corner_remainder(const built_arm *arm, const double tolerances[])
{
    const double angles = sum_of(arm, tolerances, false), lengths = sum_of(arm, tolerances, true);
    double reach = lengths;
    for (size_t i = 0; i < arm->n_links; i++) {
        reach += hypot(arm->links[i].a, arm->links[i].d);
    }
    return angles * angles * reach / 2 + angles * lengths;
}

bool corner_all_within(const built_arm *arm, const double matrix[], const double tolerances[],
                       const double accuracy[6])
{
    const double remainder = corner_remainder(arm, tolerances), angles = sum_of(arm, tolerances, false);
    bool within = true;
    for (size_t i = 0; i < 3; i++) {
        const double prediction = corner_prediction(matrix, arm->n_columns, i, tolerances);
        within = within && prediction + remainder <= accuracy[i] && angles <= accuracy[i + 3];
    }
    return within;
}
