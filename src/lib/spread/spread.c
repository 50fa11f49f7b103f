#include "armtol/spread.h"

#include "lib/spread/normal.h"

#include <math.h>

const char *armtol_distribution_name(armtol_distribution distribution)
{
    static const char *const names[ARMTOL_DISTRIBUTION_COUNT] = {"uniform", "normal", "triangular", "ends"};
    return (size_t)distribution < ARMTOL_DISTRIBUTION_COUNT ? names[distribution] : "?";
}

bool armtol_spread_is_known(const armtol_error_spread *spread)
{
    const bool fine = (size_t)spread->distribution < ARMTOL_DISTRIBUTION_COUNT && isfinite(spread->shift);
    return fine && (spread->distribution != ARMTOL_NORMAL ||
                    (spread->sigmas >= ARMTOL_LEAST_SIGMAS && spread->sigmas <= ARMTOL_MOST_SIGMAS));
}

double armtol_spread_variance(const armtol_error_spread *spread)
{
    switch (spread->distribution) {
    case ARMTOL_NORMAL:
        return normal_cut_variance(spread->sigmas);
    case ARMTOL_TRIANGULAR:
        return 1.0 / 6;
    case ARMTOL_ENDS:
        return 1;
    default:
        return 1.0 / 3;
    }
}

armtol_shape armtol_shape_of(const armtol_error_spread *spread)
{
    armtol_shape shape = {.distribution = spread->distribution};
    if (spread->distribution == ARMTOL_NORMAL) {
        shape.sigmas = spread->sigmas;
        shape.half = normal_half(spread->sigmas);
        shape.tail = normal_tail(spread->sigmas);
    }
    return shape;
}

/* By the tail where that is short: what is left of 1/2 would have lost its digits. */
static double normal_value(const armtol_shape *shape, double part)
{
    const double half = part * shape->half, x = half <= 0.425 ? normal_of_half(half)
                                                : normal_of_tail(shape->tail + (1 - part) * shape->half);
    return fmin(x / shape->sigmas, 1);
}

double armtol_shape_value(const armtol_shape *shape, double uniform)
{
    switch (shape->distribution) {
    case ARMTOL_NORMAL:
        return copysign(normal_value(shape, fabs(uniform)), uniform);
    case ARMTOL_TRIANGULAR:
        return copysign(1 - sqrt(1 - fabs(uniform)), uniform);
    case ARMTOL_ENDS:
        return uniform < 0 ? -1 : 1;
    default:
        return uniform;
    }
}
