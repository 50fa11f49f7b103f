#ifndef ARMTOL_TWIST_TRANSFORM_H
#define ARMTOL_TWIST_TRANSFORM_H

#include "armtol/conventions.h"
#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/link.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * What stood on the diagonal of the skew matrix in getj, which never set it: the words that the last call of
 * gnpr had left on the stack. The type keeps it apart from a point.
 */
typedef struct armtol_residue {
    double diagonal[3];
} armtol_residue;

/*
 * The residue of a chain, modelled and not read: (H(alpha), sin alpha, H(a)) of the last link, where H(x) is the upper
 * 32 bits of the double x, read as a float.
 *
 * Given:
 *    links, n_links   placed
 *    errata           skew-residue, float
 *
 * Notes:
 * 1) Zeros with the erratum corrected, for a chain of no links, and for a chain whose last link is not npr: the frames
 *    of the other routines were never seen.
 *
 * Reference:
 *    The listings of gnpr and getj in Hahn 1987 and the published numbers of the Adept.
 */
armtol_residue armtol_skew_residue(const armtol_link links[], size_t n_links, const armtol_errata *errata);

/*
 * The map that takes a twist in the frame behind a transform to the frame before it.
 *
 * Given:
 *    transform   a rigid motion
 *    residue     what stands on the diagonal of its skew matrix
 *    errata      float
 *
 * Returned (function value):
 *    J = [ R  S R ]
 *        [ 0   R  ],  S = skew(p) + diag(residue),  (v; w) -> (R v + p x R w; R w)
 *
 * Reference:
 *    Hahn 1987, Eq. (4.8), routine getj.
 */
armtol_adjoint armtol_twist_transform(const armtol_transform *transform, const armtol_residue *residue,
                                      const armtol_errata *errata);

ARMTOL_INTERFACE_END

#endif
