#ifndef ARMTOL_LAB_JOINT_ORDERS_INTELLEDEX_MATRICES_H
#define ARMTOL_LAB_JOINT_ORDERS_INTELLEDEX_MATRICES_H

#include "lab/joint_orders/intelledex_choices.h"

/* The routines for matrices as the listing prints them: each element and each term of a sum is stored. */

/* mpynn, invtrf */
armtol_transform matrix_product(const armtol_transform *left, const armtol_transform *right);
armtol_transform matrix_inverse(const armtol_transform *transform);

/* transf, Craig's order; alpha is -1, 0 or 1 right angle, given to transf as the configuration says. */
armtol_transform matrix_of_link(const configuration *how, double a, int alpha, double d, double theta);

/* transform inverse(link) */
armtol_transform matrix_without(const armtol_transform *transform, const armtol_transform *link);

#endif
