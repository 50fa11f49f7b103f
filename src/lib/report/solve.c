#include "armtol/solve.h"

#include "lib/report/arithmetic.h"
#include "lib/report/trigonometry.h"

#include <math.h>

/*
 * Method
 *    The angle of (px, -py) less that of (d, s), s one of the two roots of px^2 + py^2 - d^2, as the listing has it.
 *
 * Special cases
 *    d = 0 has the one answer atan2(px, -py), none of px = py = 0. Squares that overflow are out of reach.
 *
 * Accuracy
 *    px cos theta + py sin theta is d to 1e-10 for lengths up to 400 (test_the_answer_solves_the_equation).
 */
static double squared_distance(double close, double theta, const armtol_errata *errata)
{
    return store(errata, (close - theta) * (close - theta));
}

armtol_status armtol_solve(double px, double py, double d, double close, const armtol_errata *errata,
                           double *theta)
{
    if (!isfinite(px) || !isfinite(py) || !isfinite(d) || !isfinite(close)) {
        return ARMTOL_NOT_FINITE;
    }
    if (d == 0) {
        if (px == 0 && py == 0) {
            return ARMTOL_SINGULAR;
        }
        *theta = store(errata, angle_of(errata, px, -py));
        return ARMTOL_OK;
    }
    const double square = py * py + px * px - d * d;
    if (!(square >= 0)) { /* also where the squares overflow to inf - inf */
        return ARMTOL_OUT_OF_REACH;
    }
    const double s = store(errata, sqrt(square));
    const double first = store(errata, angle_of(errata, px, -py) - angle_of(errata, d, s));
    const double second = store(errata, angle_of(errata, px, -py) - angle_of(errata, d, -s));
    const double to_first = squared_distance(close, first, errata);
    const double to_second = squared_distance(close, second, errata);
    *theta = to_first <= to_second ? first : second;
    return ARMTOL_OK;
}
