#ifndef ARMTOL_LIB_INVERSE_DAMPED_H
#define ARMTOL_LIB_INVERSE_DAMPED_H

#include "lib/private_names.h"

#include <stdbool.h>
#include <stddef.h>

/*
 * The damped least squares' step for J step = r: (J'J + damping)^-1 J'r. J is n_rows x n, n_rows at most 6. Joints that
 * are held have no step. The damping is > 0, and not so small beside J'J that rounding makes up for it.
 */
void damped_step(const double *jacobian, size_t n_rows, size_t n, const bool held[], double damping, const double r[],
                 double step[]);

#endif
