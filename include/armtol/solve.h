#ifndef ARMTOL_SOLVE_H
#define ARMTOL_SOLVE_H

#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/status.h"

ARMTOL_INTERFACE_BEGIN

/*
 * The theta with px cos theta + py sin theta = d.
 *
 * Given:
 *    px, py, d
 *    close     which of the two answers for d != 0: the nearer one, the first on a tie of their squared distances
 *    errata    float
 *
 * Returned:
 *    *theta    not wrapped; for d = 0 always atan2(px, -py)
 *
 * Errors:
 *    ARMTOL_NOT_FINITE
 *    ARMTOL_SINGULAR       px = py = d = 0
 *    ARMTOL_OUT_OF_REACH   d^2 > px^2 + py^2, as computed; also where the squares overflow
 *
 * Reference:
 *    Paul 1981, chapter 3; Hahn 1987, routine solve.
 */
armtol_status armtol_solve(double px, double py, double d, double close, const armtol_errata *errata,
                           double *theta);

ARMTOL_INTERFACE_END

#endif
