#include "lab/yield/drawn_arm.h"

#include <math.h>

void drawn_arm_error(const drawn_arm *arm, const double errors[], double error[6])
{
    /* nothing can be wrong with links that A was made of */
    armtol_tool_error(arm->links, arm->n_links, errors, arm->n_columns, &armtol_tool_origin, error);
}

static double distance_of(const double error[6], const void *context)
{
    (void)context;
    return error_norm(error);
}

double drawn_arm_farthest(const drawn_arm *arm, const double tolerances[], double errors[])
{
    return armtol_climb(arm->links, arm->n_links, &armtol_tool_origin, NULL, tolerances, arm->n_columns, distance_of,
                        NULL, errors);
}

bool error_is_within(const double error[6], const double accuracy[6])
{
    bool within = true;
    for (int i = 0; i < 6; i++) {
        within = within && fabs(error[i]) <= accuracy[i];
    }
    return within;
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
