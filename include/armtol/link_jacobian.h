#ifndef ARMTOL_LINK_JACOBIAN_H
#define ARMTOL_LINK_JACOBIAN_H

#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/link.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * G of one placed link: column k of its *count columns is the twist of the frame behind the link, in the
 * coordinates of that frame, for a unit error of the k-th parameter of the link's kind. Columns beyond
 * *count are left as they were.
 * Source: Hahn 1987, routines gnpr, gnpp, gppr and gppp, behind one table of kinds.
 * The routines of 1987 had no beta for npr and npp and no a for npp; here every nominal value counts.
 * Errata: parallel-arm, prismatic-alpha, beta-sign, float; and gppp-clearing, with which a ppp link leaves g[0..2][3],
 * g[4][3], g[0..3][4] and g[5][4] as they were, as gppp left what the main program's g4 held.
 * Error: ARMTOL_BAD_KIND.
 */
armtol_status armtol_link_jacobian(const armtol_link *link, const armtol_errata *errata,
                                   double g[6][ARMTOL_PARAMETER_COUNT], size_t *count);

ARMTOL_INTERFACE_END

#endif
