#include "armtol/share_interval.h"

#include <math.h>

/*
 * Method
 *    Wilson's score interval, in closed form.
 *
 * Special cases
 *    Without hits it begins at 0, with all at 1. No samples: 0 to 1.
 *
 * Accuracy
 *    Beside published values of four digits (test_the_interval_of_a_share).
 */
armtol_share_interval armtol_share_interval_95(uint64_t hits, uint64_t samples)
{
    const double z = 1.959963984540054; /* the normal distribution's 97.5 % point */
    const double n = (double)samples, share = (double)hits / n;
    const double middle = share + z * z / (2 * n);
    const double half = z * sqrt(share * (1 - share) / n + z * z / (4 * n * n));
    const double scale = 1 + z * z / n;
    return (armtol_share_interval){
        .low = hits == 0 ? 0 : (middle - half) / scale,
        .high = hits == samples ? 1 : (middle + half) / scale,
    };
}
