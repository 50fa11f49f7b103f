#ifndef ARMTOL_TRANSFORM_H
#define ARMTOL_TRANSFORM_H

#include "armtol/conventions.h"
#include "armtol/errata.h"
#include "armtol/interface.h"

ARMTOL_INTERFACE_BEGIN

/* Of two frames that coincide. */
armtol_transform armtol_transform_identity(void);

/*
 * left right: the frame of right in that of left. Each element is summed from 0 over its four products in order.
 * Erratum: float.
 */
armtol_transform armtol_transform_product(const armtol_transform *left, const armtol_transform *right,
                                          const armtol_errata *errata);

/*
 * The inverse of a rigid motion, [R' , -R' p]. Erratum: float.
 *
 * Reference:
 *    Craig 1986, chapter 2.
 */
armtol_transform armtol_transform_inverse(const armtol_transform *transform, const armtol_errata *errata);

ARMTOL_INTERFACE_END

#endif
