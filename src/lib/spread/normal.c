#include "lib/spread/normal.h"

#include <math.h>

/*
 * Method
 *    Phi(x) - 1/2 = phi(x) S(x), S(x) = x + x^3/3 + x^5/(3 5) + ...: all terms are positive. The tail from 2 on is
 *    Laplace's continued fraction phi(x) / (x + 1/(x + 2/(x + 3/(x + ...)))). Inverses are Wichura's PPND16.
 *
 * Special cases
 *    None within the ranges of normal.h.
 *
 * Accuracy
 *    2e-15 of the result, and of tails x^2/2 roundings more, which the exponent's own rounding makes
 *    (test_the_normal_distribution_is_that_of_erfc, test_quantiles_are_inverses). The series of the logarithm leaves
 *    out less than 1e-19, that of the exponential less than 1e-25, the fraction from 2 on less than 1e-24.
 */

/* ln 2 in two parts; what up to 2^20 times the first is exact (FDLIBM, e_log.c). */
#define LN2_HIGH 6.93147180369123816490e-01
#define LN2_LOW 1.90821492927058770002e-10
#define ROOT_2_PI 2.50662827463100050242

/* exp(-x), 0 <= x <= 700. */
static double exponential_of_minus(double x)
{
    enum { TERMS = 20 };
    const double n = floor(x / (LN2_HIGH + LN2_LOW) + 0.5);
    const double rest = (x - n * LN2_HIGH) - n * LN2_LOW;
    double sum = 1;
    for (int i = TERMS; i > 0; i--) {
        sum = 1 - rest * sum / i;
    }
    return ldexp(sum, -(int)n);
}

/* The logarithm, x > 0. */
static double logarithm(double x)
{
    enum { TERMS = 12 };
    int exponent;
    double part = frexp(x, &exponent), sum = 0;
    if (part < 0.70710678118654752440) {
        part *= 2;
        exponent--;
    }
    const double s = (part - 1) / (part + 1), z = s * s;
    for (int i = TERMS; i >= 0; i--) {
        sum = sum * z + 1.0 / (2 * i + 1);
    }
    return exponent * LN2_HIGH + (exponent * LN2_LOW + 2 * s * sum);
}

static double density(double x)
{
    return exponential_of_minus(x * x / 2) / ROOT_2_PI;
}

/* S(x), and what of it is not x. */
static double series(double x, double *beyond)
{
    double term = x, sum = 0;
    for (int n = 3; term > 0x1p-70 * (sum + x); n += 2) {
        term *= x * x / n;
        sum += term;
    }
    *beyond = sum;
    return x + sum;
}

double normal_half(double x)
{
    double beyond;
    return density(x) * series(x, &beyond);
}

double normal_tail(double x)
{
    enum { TERMS = 120 };
    double fraction = x;
    if (x < 2) {
        return 0.5 - normal_half(x);
    }
    for (int n = TERMS; n > 0; n--) {
        fraction = x + n / fraction;
    }
    return density(x) / fraction;
}

/* 1/x^2 (1 - 2 x phi / (2 Phi - 1)) = 1/x^2 (1 - x / S). */
double normal_cut_variance(double x)
{
    double beyond;
    const double whole = series(x, &beyond);
    return beyond / whole / (x * x);
}

/* ---- AS 241, PPND16 ---- */

enum { DEGREE = 8 };

typedef struct quotient {
    double above[DEGREE], below[DEGREE]; /* the highest power first */
} quotient;

static double quotient_at(const quotient *quotient, double x)
{
    double above = 0, below = 0;
    for (int i = 0; i < DEGREE; i++) {
        above = above * x + quotient->above[i];
        below = below * x + quotient->below[i];
    }
    return above / below;
}

double normal_of_half(double half)
{
    static const quotient middle = {
        {2.5090809287301226727e+3, 3.3430575583588128105e+4, 6.7265770927008700853e+4, 4.5921953931549871457e+4,
         1.3731693765509461125e+4, 1.9715909503065514427e+3, 1.3314166789178437745e+2, 3.3871328727963666080e+0},
        {5.2264952788528545610e+3, 2.8729085735721942674e+4, 3.9307895800092710610e+4, 2.1213794301586595867e+4,
         5.3941960214247511077e+3, 6.8718700749205790830e+2, 4.2313330701600911252e+1, 1.0}};
    return half * quotient_at(&middle, 0.180625 - half * half);
}

double normal_of_tail(double tail)
{
    static const quotient near = {
        {7.74545014278341407640e-4, 2.27238449892691845833e-2, 2.41780725177450611770e-1, 1.27045825245236838258e+0,
         3.64784832476320460504e+0, 5.76949722146069140550e+0, 4.63033784615654529590e+0, 1.42343711074968357734e+0},
        {1.05075007164441684324e-9, 5.47593808499534494600e-4, 1.51986665636164571966e-2, 1.48103976427480074590e-1,
         6.89767334985100004550e-1, 1.67638483018380384940e+0, 2.05319162663775882187e+0, 1.0}};
    static const quotient far = {
        {2.01033439929228813265e-7, 2.71155556874348757815e-5, 1.24266094738807843860e-3, 2.65321895265761230930e-2,
         2.96560571828504891230e-1, 1.78482653991729133580e+0, 5.46378491116411436990e+0, 6.65790464350110377720e+0},
        {2.04426310338993978564e-15, 1.42151175831644588870e-7, 1.84631831751005468180e-5,
         7.86869131145613259100e-4, 1.48753612908506148525e-2, 1.36929880922735805310e-1, 5.99832206555887937690e-1,
         1.0}};
    const double r = sqrt(-logarithm(tail));
    return r <= 5 ? quotient_at(&near, r - 1.6) : quotient_at(&far, r - 5);
}

double normal_quantile(double p)
{
    const double half = p - 0.5;
    return fabs(half) <= 0.425 ? normal_of_half(half) : half < 0 ? -normal_of_tail(p) : normal_of_tail(1 - p);
}
