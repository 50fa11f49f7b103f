/* Distributions: quantiles and variances against erfc of libm, and against sums over the density. */

#include "armtol/spread.h"
#include "support/check.h"

#include "unity.h"

#include <math.h>

static const double pi = 3.14159265358979323846;
static const double sigmas[] = {0.01, 0.1, 0.5, 1, 1.43, 1.45, 1.99, 2, 2.5, 3, 4, 6, 9, 14, 20, 30};
enum { SIGMAS = sizeof sigmas / sizeof sigmas[0] };

void setUp(void)
{
}

void tearDown(void)
{
}

static armtol_error_spread normal(double k)
{
    return (armtol_error_spread){ARMTOL_NORMAL, k, 0, 0};
}

static void test_the_normal_distribution_is_that_of_erfc(void)
{
    for (size_t i = 0; i < SIGMAS; i++) {
        const double k = sigmas[i], tail = erfc(k / sqrt(2)) / 2;
        const armtol_error_spread spread = normal(k);
        const armtol_shape shape = armtol_shape_of(&spread);
        check_within(2e-15 * shape.half, erf(k / sqrt(2)) / 2, shape.half, "half of %g", k);
        /* erfc of a number that is rounded, as x^2/2 is */
        check_within((3e-15 + 5e-16 * k * k) * tail, tail, shape.tail, "tail of %g", k);
    }
}

/* Newton's way on with erfc: how far the quantile is from where the distribution is what was drawn. */
static double newton(double x, double half, double tail)
{
    const double density = exp(-x * x / 2) / sqrt(2 * pi);
    return x < 1 ? (erf(x / sqrt(2)) / 2 - half) / density : (tail - erfc(x / sqrt(2)) / 2) / density;
}

static void test_quantiles_are_inverses(void)
{
    for (size_t i = 0; i < SIGMAS; i++) {
        const double k = sigmas[i], half = erf(k / sqrt(2)) / 2, tail = erfc(k / sqrt(2)) / 2;
        const armtol_error_spread spread = normal(k);
        const armtol_shape shape = armtol_shape_of(&spread);
        for (int n = 1; n < 4096; n++) {
            const double draw = n / 4096.0, x = k * armtol_shape_value(&shape, draw);
            check_within(1e-14 * x, 0, newton(x, draw * half, tail + (1 - draw) * half), "draw %g of %g sigmas", draw,
                         k);
        }
        for (int n = 12; n < 52; n++) { /* to the last draw that there is */
            const double left = ldexp(1, -n), x = k * armtol_shape_value(&shape, 1 - left);
            check_within(1e-14 * x, 0, newton(x, (1 - left) * half, tail + left * half), "draw 1 - 2^-%d of %g sigmas",
                         n, k);
        }
    }
}

/* The end of the range, and that no draw goes beyond it; odd, and rising. */
static void check_shape(const armtol_error_spread *spread, double least_end)
{
    const armtol_shape shape = armtol_shape_of(spread);
    double before = -1;
    check_within(1 - least_end, 1, armtol_shape_value(&shape, 1), "the end");
    for (int n = -1000; n <= 1000; n++) {
        const double draw = n / 1000.0, value = armtol_shape_value(&shape, draw);
        TEST_ASSERT_TRUE(value >= before && fabs(value) <= 1);
        if (n != 0 || spread->distribution != ARMTOL_ENDS) {
            check_same(-value, armtol_shape_value(&shape, -draw), "the other side of %g", draw);
        }
        before = value;
    }
}

static void test_draws_make_what_rises_and_is_odd(void)
{
    for (int i = 0; i < ARMTOL_DISTRIBUTION_COUNT; i++) {
        const armtol_error_spread spread = {(armtol_distribution)i, 3, 0, 0};
        check_shape(&spread, 1 - 4e-15);
    }
    for (size_t i = 0; i < SIGMAS; i++) {
        const armtol_error_spread spread = normal(sigmas[i]);
        check_shape(&spread, 1 - 1e-13);
    }
}

/* The sum of the squares of quantiles at the middles of many equal parts, with the error of a midpoint rule. */
static double variance_of_quantiles(const armtol_error_spread *spread, int parts)
{
    const armtol_shape shape = armtol_shape_of(spread);
    double sum = 0;
    for (int n = 0; n < parts; n++) {
        const double value = armtol_shape_value(&shape, (2 * n + 1.0) / parts - 1);
        sum += value * value;
    }
    return sum / parts;
}

static void test_variances_are_those_of_the_draws(void)
{
    for (int i = 0; i < ARMTOL_DISTRIBUTION_COUNT; i++) {
        const armtol_error_spread spread = {(armtol_distribution)i, 2.5, 0, 0};
        check_within(1e-6, variance_of_quantiles(&spread, 20000), armtol_spread_variance(&spread), "%s",
                     armtol_distribution_name((armtol_distribution)i));
    }
}

/* 1/K^2 (1 - 2 K phi / (2 Phi - 1)), which loses digits of a small K (1/3 - 2/45 K^2 + 2/945 K^4). */
static void test_variances_of_cut_normal_errors(void)
{
    for (size_t i = 0; i < SIGMAS; i++) {
        const double k = sigmas[i], phi = exp(-k * k / 2) / sqrt(2 * pi);
        const armtol_error_spread spread = normal(k);
        const double expected = (1 - 2 * k * phi / erf(k / sqrt(2))) / (k * k);
        check_within(4e-16 / (k * k) + 4e-16, expected, armtol_spread_variance(&spread), "%g sigmas", k);
    }
    const armtol_error_spread narrow = normal(0.01);
    check_within(2e-15, 1.0 / 3 - 2 * 1e-4 / 45 + 2 * 1e-8 / 945, armtol_spread_variance(&narrow), "almost even");
}

static void test_what_is_known(void)
{
    const armtol_error_spread wrong[] = {{ARMTOL_DISTRIBUTION_COUNT, 0, 0, 0}, {(armtol_distribution)-1, 0, 0, 0},
                                         {ARMTOL_NORMAL, 0, 0, 0},             {ARMTOL_NORMAL, 0.0099, 0, 0},
                                         {ARMTOL_NORMAL, 30.1, 0, 0},          {ARMTOL_NORMAL, NAN, 0, 0},
                                         {ARMTOL_UNIFORM, 0, INFINITY, 0},     {ARMTOL_ENDS, 0, NAN, 0}};
    const armtol_error_spread right[] = {{ARMTOL_UNIFORM, 0, 0, 0}, {ARMTOL_NORMAL, 0.01, -3, 7},
                                         {ARMTOL_NORMAL, 30, 0, 0}, {ARMTOL_ENDS, NAN, 1, 0}};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        TEST_ASSERT_FALSE(armtol_spread_is_known(&wrong[i]));
    }
    for (size_t i = 0; i < sizeof right / sizeof right[0]; i++) {
        TEST_ASSERT_TRUE(armtol_spread_is_known(&right[i]));
    }
    TEST_ASSERT_EQUAL_STRING("triangular", armtol_distribution_name(ARMTOL_TRIANGULAR));
    TEST_ASSERT_EQUAL_STRING("?", armtol_distribution_name(ARMTOL_DISTRIBUTION_COUNT));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_normal_distribution_is_that_of_erfc);
    RUN_TEST(test_quantiles_are_inverses);
    RUN_TEST(test_draws_make_what_rises_and_is_odd);
    RUN_TEST(test_variances_are_those_of_the_draws);
    RUN_TEST(test_variances_of_cut_normal_errors);
    RUN_TEST(test_what_is_known);
    return UNITY_END();
}
