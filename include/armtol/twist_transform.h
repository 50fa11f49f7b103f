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
 * The residue of a chain of placed links, modelled and not read: (H(alpha), sin alpha, H(a)) of the last link, where
 * H(x) is the upper 32 bits of the double x, read as a float. Zeros with the erratum corrected, for a chain of no
 * links, and for a chain whose last link is not npr: the frames of the other routines were never seen.
 * Source: the listings of gnpr and getj and the published numbers of the Adept. Erratum: skew-residue.
 */
armtol_residue armtol_skew_residue(const armtol_link links[], size_t n_links, const armtol_errata *errata);

/*
 * The map that takes a twist in the frame behind the transform to the frame before it:
 *     J = [ R  S R ]
 *         [ 0   R  ],  S = skew(p) + diag(residue),  (v; w) -> (R v + p x R w; R w).
 * Source: Hahn 1987, routine getj. Erratum: float.
 */
armtol_adjoint armtol_twist_transform(const armtol_transform *transform, const armtol_residue *residue,
                                      const armtol_errata *errata);

ARMTOL_INTERFACE_END

#endif
