#ifndef ARMTOL_LAB_JOINT_ORDERS_INTELLEDEX_MATRICES_H
#define ARMTOL_LAB_JOINT_ORDERS_INTELLEDEX_MATRICES_H

#include "lab/joint_orders/intelledex_choices.h"

/* The transforms of the library, with elements and sums kept as the configuration says. */

/* The transform with its elements kept so. */
armtol_transform matrix_kept(const configuration *how, armtol_transform transform);

armtol_transform matrix_product(const configuration *how, const armtol_transform *left,
                                const armtol_transform *right);
armtol_transform matrix_inverse(const configuration *how, const armtol_transform *transform);

/* The matrix of a link in Craig's order; alpha is -1, 0 or 1 right angle. */
armtol_transform matrix_of_link(const configuration *how, double a, int alpha, double d, double theta);

/* transform inverse(link) */
armtol_transform matrix_without(const configuration *how, const armtol_transform *transform,
                                const armtol_transform *link);

#endif
