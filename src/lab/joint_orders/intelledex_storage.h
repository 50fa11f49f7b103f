#ifndef ARMTOL_LAB_JOINT_ORDERS_INTELLEDEX_STORAGE_H
#define ARMTOL_LAB_JOINT_ORDERS_INTELLEDEX_STORAGE_H

#include "lab/joint_orders/intelledex_choices.h"
#include "lab/joint_orders/keep.h"

#include <math.h>

/* Values of one kind in the steps that are not printed, each as the configuration keeps them. */

static inline double sine(const configuration *how, double value)
{
    return keep(how->option[SINES] == SINES_FLOAT, value);
}

static inline double angle(const configuration *how, double value)
{
    return keep(how->option[ANGLES] == STORED, value);
}

static inline double length(const configuration *how, double value)
{
    return keep(how->option[LENGTHS] == STORED, value);
}

static inline double cosine_or_d(const configuration *how, double value)
{
    return keep(how->option[D] == D_FLOAT, value);
}

static inline double root(const configuration *how, double square)
{
    return keep(how->option[ROOT] == STORED, sqrt(square));
}

static inline double constant(const configuration *how, double value)
{
    return keep(how->option[CONSTANTS] == CONSTANTS_FLOAT, value);
}

#endif
