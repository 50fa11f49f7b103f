#ifndef ARMTOL_LIB_ARRIVALS_NORMAL_QUANTILE_H
#define ARMTOL_LIB_ARRIVALS_NORMAL_QUANTILE_H

#include "lib/private_names.h"

/* The number that a standard normal variable does not exceed with this probability, 0 < p < 1. */
double normal_quantile(double p);

#endif
