#include "lab/yield/drawn_arm.h"

void drawn_arm_error(const drawn_arm *arm, const double errors[], double error[6])
{
    /* nothing can be wrong with links that A was made of */
    armtol_tool_error(arm->links, arm->n_links, errors, arm->n_columns, &armtol_tool_origin, error);
}
