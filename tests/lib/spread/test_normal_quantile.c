/* The quantiles of the normal distribution: against libm's erfc, and numbers of printed tables. */

#include "lib/spread/normal.h"
#include "support/check.h"

#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* What a normal variable does not exceed x with, for x < 0; and how fast that grows. */
static double probability(double x)
{
    return erfc(-x / sqrt(2)) / 2;
}

static double density(double x)
{
    return exp(-x * x / 2) / sqrt(2 * 3.14159265358979323846);
}

/* By one step of Newton: what the probability of the quantile is off by, as a part of the quantile. */
static void check_back(double p)
{
    const double x = normal_quantile(p);
    check_within(4e-15 * fmax(fabs(x), 0.1), 0, (probability(x) - p) / density(x), "p = %.17g: %.17g", p, x);
}

static void test_quantiles_come_back(void)
{
    for (int i = 1; i < 5000; i++) {
        check_back(i / 10000.0);
    }
    for (int power = 4; power <= 300; power++) {
        check_back(pow(10, -power));
        check_back(3 * pow(10, -power));
    }
    check_back(0x1p-53);
}

static void test_both_sides_are_alike(void)
{
    check_same(0, normal_quantile(0.5), "the middle");
    for (int i = 1; i < 1024; i++) {
        check_same(-normal_quantile(i / 2048.0), normal_quantile(1 - i / 2048.0), "%d / 2048", i);
    }
    check_same(-normal_quantile(0x1p-53), normal_quantile(1 - 0x1p-53), "the ends that are drawn");
}

/* Abramowitz and Stegun, table 26.5 (five decimals); of 0.975 more of it is printed everywhere. */
static void test_printed_quantiles(void)
{
    check_within(5e-6, 1.28155, normal_quantile(0.9), "0.9");
    check_within(5e-6, 2.32635, normal_quantile(0.99), "0.99");
    check_within(5e-6, 3.09023, normal_quantile(0.999), "0.999");
    check_within(1e-14, 1.959963984540054, normal_quantile(0.975), "0.975");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_quantiles_come_back);
    RUN_TEST(test_both_sides_are_alike);
    RUN_TEST(test_printed_quantiles);
    return UNITY_END();
}
