/* What becomes of arms drawn: counts, quantiles, the worst. */

#include "lib/engine/tally.h"
#include "support/check.h"

#include "unity.h"

#include <math.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static const tally_limits limits_of_one = {
    .n_measures = 6, .range = {1, 1, 1, 1, 1, 1}, .accuracy = {1, 1, 1, 1, 1, 1}, .beyond = {2, 2, 2, 2, 2, 2}};
static tally counted, other;

/* Arms whose first component has these magnitudes and whose others are 0. */
static void add(tally *tally, const tally_limits *limits, uint64_t first, size_t count,
                const double first_component[])
{
    double magnitudes[6 * TALLY_MOST] = {0};
    memcpy(magnitudes, first_component, count * sizeof *magnitudes);
    tally_add(tally, limits, first, count, magnitudes);
}

static void test_quantiles_are_counted(void)
{
    double tenths[10];
    tally_start(&counted, 6);
    check_same(0, tally_quantile(&counted, &limits_of_one, 0, 500), "of none");
    for (int i = 0; i < 10; i++) {
        tenths[i] = 0.1 * (i + 1) - 1e-9;
    }
    add(&counted, &limits_of_one, 0, 10, tenths);
    check_within(0.5 / 1024, 0.5 + 0.25 / 1024, tally_quantile(&counted, &limits_of_one, 0, 500), "median");
    check_within(0.6 / 1024, 0.6 + 0.3 / 1024, tally_quantile(&counted, &limits_of_one, 0, 501), "50.1 %%");
    check_same(tenths[9], tally_quantile(&counted, &limits_of_one, 0, 1000), "all");
    check_same(0, tally_quantile(&counted, &limits_of_one, 1, 500), "a component of zeros");
    TEST_ASSERT_TRUE(tally_quantile(&counted, &limits_of_one, 0, 500) >= tenths[4]);
}

static void test_what_is_within_and_what_beyond(void)
{
    const double magnitudes[7] = {0, 1, 1.5, 2, 2.5, NAN, INFINITY};
    tally_start(&counted, 6);
    add(&counted, &limits_of_one, 0, 7, magnitudes);
    TEST_ASSERT_TRUE(counted.drawn == 7 && counted.within == 2 && counted.beyond == 3);
    tally_limits free_row = limits_of_one;
    free_row.accuracy[0] = free_row.beyond[0] = INFINITY;
    tally_start(&counted, 6);
    add(&counted, &free_row, 0, 5, magnitudes);
    TEST_ASSERT_TRUE(counted.drawn == 5 && counted.within == 5 && counted.beyond == 0);
}

/* Rounding may take a magnitude beyond the range, and the range may be nothing. */
static void test_magnitudes_out_of_range(void)
{
    const double magnitudes[3] = {0, 0.5, 1 + 1e-15};
    tally_limits nothing = limits_of_one;
    nothing.range[0] = 0;
    tally_start(&counted, 6);
    add(&counted, &limits_of_one, 0, 3, magnitudes);
    check_same(1 + 1e-15, tally_quantile(&counted, &limits_of_one, 0, 999), "beyond the range");
    tally_start(&counted, 6);
    add(&counted, &nothing, 0, 3, magnitudes);
    check_same(1 + 1e-15, tally_quantile(&counted, &nothing, 0, 500), "no range");
}

static void test_the_first_of_the_worst_wins(void)
{
    const double late[3] = {0.5, 0.9, 0.9}, early[2] = {0.1, 0.9};
    for (int order = 0; order < 2; order++) {
        tally_start(&counted, 6);
        tally_start(&other, 6);
        add(&counted, &limits_of_one, 100, 3, late);
        add(&other, &limits_of_one, 7, 2, early);
        tally *into = order == 0 ? &counted : &other;
        tally_merge(into, order == 0 ? &other : &counted);
        TEST_ASSERT_TRUE(into->worst_arm[0] == 8 && into->worst_arm[1] == 7 && into->drawn == 5);
        check_same(0.9, into->worst[0], "worst");
        check_within(0.5 / 1024, 0.5, tally_quantile(into, &limits_of_one, 0, 400), "both are counted");
    }
}

/* However far below the range: no bin is wider than 2^-10 of what is in it. What is below all bins is 0 to a double. */
static void test_quantiles_are_as_fine_far_below_the_range(void)
{
    for (int n = 0; n < 21; n++) {
        const double size = 0.3 * pow(7, -n);
        const double magnitudes[3] = {size, 1.5 * size, 3 * size};
        tally_start(&counted, 6);
        add(&counted, &limits_of_one, 0, 3, magnitudes);
        const double median = tally_quantile(&counted, &limits_of_one, 0, 600);
        TEST_ASSERT_TRUE(median >= 1.5 * size && median <= 1.5 * size * (1 + 1.0 / 1024));
    }
    const double tiny[2] = {1e-30, 1};
    tally_start(&counted, 6);
    add(&counted, &limits_of_one, 0, 2, tiny);
    const double least = tally_quantile(&counted, &limits_of_one, 0, 500);
    TEST_ASSERT_TRUE(least >= 1e-30 && least < 2e-19);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_quantiles_are_counted);
    RUN_TEST(test_quantiles_are_as_fine_far_below_the_range);
    RUN_TEST(test_what_is_within_and_what_beyond);
    RUN_TEST(test_magnitudes_out_of_range);
    RUN_TEST(test_the_first_of_the_worst_wins);
    return UNITY_END();
}
