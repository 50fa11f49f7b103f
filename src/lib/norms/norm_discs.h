#ifndef ARMTOL_LIB_NORMS_NORM_DISCS_H
#define ARMTOL_LIB_NORMS_NORM_DISCS_H

#include "armtol/norm.h"
#include "lib/private_names.h"

#include <stdbool.h>

/*
 * armtol_worst_norm where some tolerances are radii of discs (discs.h; NULL: none). The worst case is no less than the
 * truth, and nearly always to 1e-12 of it (farthest_round.c). The workspace is norm_discs_workspace doubles.
 */
size_t norm_discs_workspace(size_t n_columns, size_t n_discs);
double norm_discs_worst(const double matrix[], size_t n_columns, unsigned components, const double shifts[],
                        const double tolerances[], const bool discs[], double direction[6], double workspace[]);

#endif
