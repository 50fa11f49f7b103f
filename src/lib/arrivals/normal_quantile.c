#include "lib/arrivals/normal_quantile.h"

#include <math.h>

/*
 * Method
 *    Wichura's AS 241 (PPND16): a quotient of polynomials in the middle, and two in the square root of the logarithm of
 *    what is left of the probability at either end. The logarithm is our own, from the exact halves of frexp and the
 *    series of the area tangent, so that machines agree to the bit.
 *
 * Accuracy
 *    4e-15 of the result, 4e-16 about 0, for p from 1e-300 (test_quantiles_come_back).
 *
 * Reference
 *    M. J. Wichura, Algorithm AS 241: The percentage points of the normal distribution, Applied Statistics 37 (1988),
 *    477-484.
 */

static const double middle_above[8] = {
    3.3871328727963666080e+0, 1.3314166789178437745e+2, 1.9715909503065514427e+3,
    1.3731693765509461125e+4, 4.5921953931549871457e+4, 6.7265770927008700853e+4,
    3.3430575583588128105e+4, 2.5090809287301226727e+3,
};
static const double middle_below[8] = {
    1, 4.2313330701600911252e+1, 6.8718700749205790830e+2,
    5.3941960214247511077e+3, 2.1213794301586595867e+4, 3.9307895800092710610e+4,
    2.8729085735721942674e+4, 5.2264952788528545610e+3,
};
static const double side_above[8] = {
    1.42343711074968357734e+0, 4.63033784615654529590e+0, 5.76949722146069140550e+0,
    3.64784832476320460504e+0, 1.27045825245236838258e+0, 2.41780725177450611770e-1,
    2.27238449892691845833e-2, 7.74545014278341407640e-4,
};
static const double side_below[8] = {
    1, 2.05319162663775882187e+0, 1.67638483018380384940e+0,
    6.89767334985100004550e-1, 1.48103976427480074590e-1, 1.51986665636164571966e-2,
    5.47593808499534494600e-4, 1.05075007164441684324e-9,
};
static const double end_above[8] = {
    6.65790464350110377720e+0, 5.46378491116411436990e+0, 1.78482653991729133580e+0,
    2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3,
    2.71155556874348757815e-5, 2.01033439929228813265e-7,
};
static const double end_below[8] = {
    1, 5.99832206555887937690e-1, 1.36929880922735805310e-1,
    1.48753612908506148525e-2, 7.86869131145613259100e-4, 1.84631831751005468180e-5,
    1.42151175831644588870e-7, 2.04426310338993978564e-15,
};

static double polynomial(const double coefficients[8], double r)
{
    double value = coefficients[7];
    for (int i = 6; i >= 0; i--) {
        value = value * r + coefficients[i];
    }
    return value;
}

static double quotient(const double above[8], const double below[8], double r)
{
    return polynomial(above, r) / polynomial(below, r);
}

/* Of p < 0.1: 2 artanh((m - 1) / (m + 1)) and so many times log 2, p = m 2^halvings and m from 0.7 to 1.4. */
static double logarithm(double p)
{
    enum { TERMS = 11 };
    int halvings;
    double m = frexp(p, &halvings);
    if (m < 0.70710678118654752) {
        m *= 2;
        halvings--;
    }
    const double f = (m - 1) / (m + 1), square = f * f;
    double sum = 0;
    for (int k = TERMS; k >= 0; k--) {
        sum = sum * square + 1.0 / (2 * k + 1);
    }
    return halvings * 0.69314718055994530942 + 2 * f * sum;
}

double normal_quantile(double p)
{
    const double q = p - 0.5;
    if (fabs(q) <= 0.425) {
        return q * quotient(middle_above, middle_below, 0.180625 - q * q);
    }
    const double r = sqrt(-logarithm(q < 0 ? p : 1 - p));
    const double size = r <= 5 ? quotient(side_above, side_below, r - 1.6) : quotient(end_above, end_below, r - 5);
    return q < 0 ? -size : size;
}
