#include "lab/yield/farthest.h"

#include "lab/yield/error_size.h"

static double distance_of(const double error[6], const void *context)
{
    (void)context;
    return error_norm(error);
}

double farthest_from_corner(const drawn_arm *arm, const double tolerances[], double errors[])
{
    return armtol_climb(arm->links, arm->n_links, &armtol_tool_origin, NULL, tolerances, arm->n_columns, distance_of,
                        NULL, errors);
}
