#ifndef ARMTOL_LINK_JACOBIAN_H
#define ARMTOL_LINK_JACOBIAN_H

#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/link.h"

#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/*
 * G of one placed link: the twist of the frame behind it, in that frame's coordinates, for a unit error of each
 * parameter of its kind.
 *
 * Given:
 *    link       placed
 *    errata     parallel-arm, prismatic-alpha, beta-sign, float, gppp-clearing
 *
 * Returned:
 *    g, *count  column k for the k-th parameter of the kind; columns beyond *count are left as they were
 *
 * Notes:
 * 1) The routines of 1987 had no beta for npr and npp and no a for npp; here every nominal value counts.
 * 2) With the erratum gppp-clearing a ppp link leaves g[0..2][3], g[4][3], g[0..3][4] and g[5][4] as they were, as gppp
 *    left what the main program's g4 held.
 *
 * Errors:
 *    ARMTOL_BAD_KIND
 *
 * Reference:
 *    Hahn 1987, routines gnpr, gnpp, gppr and gppp, behind one table of kinds.
 */
armtol_status armtol_link_jacobian(const armtol_link *link, const armtol_errata *errata,
                                   double g[6][ARMTOL_PARAMETER_COUNT], size_t *count);

ARMTOL_INTERFACE_END

#endif
