#ifndef ARMTOL_LIB_SPREAD_NORMAL_H
#define ARMTOL_LIB_SPREAD_NORMAL_H

#include "lib/private_names.h"

/* The standard normal distribution, with the same bits on every machine. 0.01 <= x <= 30. */

/* Phi(x) - 1/2. */
double normal_half(double x);

/* Phi(-x). */
double normal_tail(double x);

/* The variance of what is within x of 0, in x^2. */
double normal_cut_variance(double x);

/* The x with Phi(x) = 1/2 + half; of either sign, up to 0.425. */
double normal_of_half(double half);

/* The x with Phi(-x) = tail; 1e-300 <= tail <= 0.075. */
double normal_of_tail(double tail);

/* The x with Phi(x) = p; 1e-300 <= p < 1. */
double normal_quantile(double p);

#endif
