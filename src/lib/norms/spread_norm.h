#ifndef ARMTOL_LIB_NORMS_SPREAD_NORM_H
#define ARMTOL_LIB_NORMS_SPREAD_NORM_H

#include "armtol/answer.h"
#include "lib/private_names.h"

/* armtol_rss_norm in a pose of an answer, by the variances of its spreads. */
double spread_norm(const armtol_answer *answer, size_t pose, unsigned components, const double shifts[],
                   const double tolerances[], double factor, double direction[6]);

#endif
