#include "lab/yield/farthest.h"

#include "lab/yield/error_size.h"

static double distance_at(const drawn_arm *arm, const double errors[])
{
    double error[6];
    drawn_arm_error(arm, errors, error);
    return error_norm(error);
}

/* Give one error the sign that takes the tool point farther, if any does. Returns the distance then. */
static double climb_one(const drawn_arm *arm, double tolerance, double distance, double errors[], size_t k)
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

double farthest_from_corner(const drawn_arm *arm, const double tolerances[], double errors[])
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
