#ifndef ARMTOL_CRAIG_H
#define ARMTOL_CRAIG_H

#include "armtol/conventions.h"
#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/link.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * A link in Craig's order, T = Rot(x, alpha) Trans(a, 0, 0) Rot(z, theta) Trans(0, 0, d): the second
 * description of an arm, that of its inverse kinematics and of the `check` lines.
 */
typedef struct armtol_craig_link {
    armtol_joint joint;
    double a;     /* of the link before */
    double alpha; /* of the link before */
    double d;
    double theta;
} armtol_craig_link;

/*
 * The transform of one link.
 *
 * Given:
 *    link     its row
 *    q        the joint's value, which is added to theta or d; of a fixed link not looked at
 *    errata   float
 *
 * Reference:
 *    Craig 1986, Eq. (3.6); Hahn 1987, routine transf.
 */
armtol_transform armtol_craig_transform(const armtol_craig_link *link, double q, const armtol_errata *errata);

/* The transform of a chain; q has one value for each link that has a joint, in order. Erratum: float. */
armtol_transform armtol_craig_chain(const armtol_craig_link links[], size_t n_links, const double q[],
                                    const armtol_errata *errata);

ARMTOL_INTERFACE_END

#endif
