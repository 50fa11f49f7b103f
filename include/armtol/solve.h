#ifndef ARMTOL_SOLVE_H
#define ARMTOL_SOLVE_H

#include "armtol/errata.h"
#include "armtol/interface.h"
#include "armtol/status.h"

ARMTOL_INTERFACE_BEGIN

/*
 * The theta with px cos theta + py sin theta = d. Of the two answers for d != 0 the one closer to `close`,
 * the first on a tie of their squared distances; for d = 0 always atan2(px, -py). Angles are not wrapped.
 * Source: Paul 1981, chapter 3; Hahn 1987, routine solve. Erratum: float.
 * Errors: ARMTOL_NOT_FINITE; ARMTOL_SINGULAR for px = py = d = 0; ARMTOL_OUT_OF_REACH for
 * d^2 > px^2 + py^2, as computed. The squares have to stay within the range of a double.
 */
armtol_status armtol_solve(double px, double py, double d, double close, const armtol_errata *errata,
                           double *theta);

ARMTOL_INTERFACE_END

#endif
