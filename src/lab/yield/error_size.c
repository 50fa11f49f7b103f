#include "lab/yield/error_size.h"

#include <math.h>

bool error_is_within(const double error[6], const double accuracy[6])
{
    for (int i = 0; i < 6; i++) {
        if (!(fabs(error[i]) <= accuracy[i])) {
            return false;
        }
    }
    return true;
}

double error_largest(const double components[3])
{
    return fmax(fabs(components[0]), fmax(fabs(components[1]), fabs(components[2])));
}

double error_norm(const double components[3])
{
    const double x = components[0], y = components[1], z = components[2];
    return sqrt(x * x + y * y + z * z);
}
