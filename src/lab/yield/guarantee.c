#include "lab/yield/guarantee.h"

#include <math.h>

/* The sum of the tolerances of all lengths, or of all angles. */
static double sum_of(const drawn_arm *arm, const double tolerances[], bool lengths)
{
    double sum = 0;
    for (size_t k = 0; k < arm->n_columns; k++) {
        sum += armtol_parameter_is_length(arm->columns[k].parameter) == lengths ? tolerances[k] : 0;
    }
    return sum;
}

double guarantee_remainder(const drawn_arm *arm, const double tolerances[])
{
    const double angles = sum_of(arm, tolerances, false), lengths = sum_of(arm, tolerances, true);
    double reach = lengths;
    for (size_t i = 0; i < arm->n_links; i++) {
        reach += hypot(arm->links[i].a, arm->links[i].d);
    }
    return angles * angles * reach / 2 + angles * lengths;
}

bool guarantee_holds(const drawn_arm *arm, const double matrix[], const double tolerances[],
                     const double accuracy[6])
{
    const double remainder = guarantee_remainder(arm, tolerances), angles = sum_of(arm, tolerances, false);
    bool within = true;
    for (size_t i = 0; i < 3; i++) {
        const double prediction = armtol_worst_error(matrix, arm->n_columns, i, tolerances);
        within = within && prediction + remainder <= accuracy[i] && angles <= accuracy[i + 3];
    }
    return within;
}
