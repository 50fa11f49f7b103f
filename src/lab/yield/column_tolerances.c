#include "lab/yield/column_tolerances.h"

#include <math.h>

static bool has_one_length(const armtol_link *link)
{
    size_t count, lengths = 0;
    const armtol_parameter *parameters = armtol_kind_parameters(link->kind, &count);
    for (size_t i = 0; i < count; i++) {
        lengths += armtol_parameter_is_length(parameters[i]);
    }
    return lengths == 1;
}

static double tolerance_of(const analysis *analysis, length_reading reading, const armtol_column *column)
{
    const armtol_link *link = &analysis->links[column->link];
    if (armtol_joint_moves(link->joint, column->parameter)) {
        return analysis->motor[armtol_joint_count(analysis->links, column->link)];
    }
    if (!armtol_parameter_is_length(column->parameter)) {
        return analysis->shares.angle;
    }
    return reading == LENGTHS_RD && has_one_length(link) ? analysis->machining[column->link]
                                                         : analysis->shares.distance;
}

void column_tolerances(const analysis *analysis, length_reading reading, double tolerances[])
{
    for (size_t k = 0; k < analysis->n_columns; k++) {
        tolerances[k] = fabs(tolerance_of(analysis, reading, &analysis->columns[k]));
    }
}
