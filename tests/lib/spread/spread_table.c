/* What the library says of cut normal errors, for spread_scipy: K, the variance, and draws with what they make. */

#include "armtol/spread.h"

#include <stdio.h>

int main(void)
{
    static const double sigmas[] = {0.01, 0.1, 0.5, 1, 1.5, 2, 2.5, 3, 4, 6, 10, 30};
    for (size_t i = 0; i < sizeof sigmas / sizeof sigmas[0]; i++) {
        const armtol_error_spread spread = {ARMTOL_NORMAL, sigmas[i], 0, 0};
        const armtol_shape shape = armtol_shape_of(&spread);
        for (int n = -100; n <= 100; n++) {
            const double draw = n / 100.0;
            printf("%.17g %.17g %.17g %.17g\n", sigmas[i], armtol_spread_variance(&spread), draw,
                   armtol_shape_value(&shape, draw));
        }
    }
    return 0;
}
