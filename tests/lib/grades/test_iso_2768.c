#include "armtol/grades.h"

#include "support/check.h"
#include "unity.h"

#include <math.h>
#include <stddef.h>

#define PI 3.14159265358979323846
#define MINUTE (PI / 180 / 60)

void setUp(void)
{
}

void tearDown(void)
{
}

/*
 * Of f and m a size inside each step and the step's upper end, from a sheet "According to DIN ISO 2768-1"; what else
 * the numbers were compared with is in docs/grades.md.
 */
static const struct {
    double inside, end, fine, medium;
} lengths[] = {
    {0.5, 3, 0.05, 0.1},  {3.01, 6, 0.05, 0.1},    {6.5, 30, 0.1, 0.2},     {100, 120, 0.15, 0.3},
    {121, 400, 0.2, 0.5}, {650.5, 1000, 0.3, 0.8}, {1000.1, 2000, 0.5, 1.2}};

static void test_lengths(void)
{
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        const double sizes[] = {lengths[i].inside, lengths[i].end, -lengths[i].end};
        for (int j = 0; j < 3; j++) {
            check_same(lengths[i].fine, armtol_general_length(ARMTOL_GENERAL_FINE, sizes[j]), "f of %g", sizes[j]);
            check_same(lengths[i].medium, armtol_general_length(ARMTOL_GENERAL_MEDIUM, sizes[j]), "m of %g", sizes[j]);
        }
    }
    check_same(2, armtol_general_length(ARMTOL_GENERAL_MEDIUM, 2000.1), "m above 2 m");
    check_same(2, armtol_general_length(ARMTOL_GENERAL_MEDIUM, 4000), "m of 4 m");
}

static void test_lengths_that_have_none(void)
{
    static const double sizes[] = {0, 0.49, 4001, 1e300};
    for (int i = 0; i < 4; i++) {
        TEST_ASSERT_TRUE(isnan(armtol_general_length(ARMTOL_GENERAL_MEDIUM, sizes[i])));
        TEST_ASSERT_EQUAL(ARMTOL_GENERAL_COUNT, armtol_general_within(sizes[i], 10));
    }
    TEST_ASSERT_TRUE(isnan(armtol_general_length(ARMTOL_GENERAL_FINE, 2000.1)));
    TEST_ASSERT_TRUE(isnan(armtol_general_length(ARMTOL_GENERAL_MEDIUM, (double)NAN)));
    TEST_ASSERT_TRUE(isnan(armtol_general_length(ARMTOL_GENERAL_COUNT, 10)));
    TEST_ASSERT_EQUAL(ARMTOL_GENERAL_COUNT, armtol_general_within(10, (double)NAN));
}

static void test_the_coarser_class_that_a_tolerance_holds(void)
{
    TEST_ASSERT_EQUAL(ARMTOL_GENERAL_COUNT, armtol_general_within(300, 0.199));
    TEST_ASSERT_EQUAL(ARMTOL_GENERAL_FINE, armtol_general_within(300, 0.2));
    TEST_ASSERT_EQUAL(ARMTOL_GENERAL_FINE, armtol_general_within(300, 0.499));
    TEST_ASSERT_EQUAL(ARMTOL_GENERAL_MEDIUM, armtol_general_within(300, 0.5 * (1 - 1e-15)));
    TEST_ASSERT_EQUAL(ARMTOL_GENERAL_MEDIUM, armtol_general_within(-300, (double)INFINITY));
    TEST_ASSERT_EQUAL(ARMTOL_GENERAL_COUNT, armtol_general_within(3000, 1.9)); /* f has no such sizes */
    TEST_ASSERT_EQUAL(ARMTOL_GENERAL_MEDIUM, armtol_general_within(3000, 2));
}

/* 1 degree, 30', 20', 10', 5', of the same sources. */
static void test_angles(void)
{
    check_within(1e-17, 60 * MINUTE, armtol_general_angle(0.1), "a short side");
    check_within(1e-17, 60 * MINUTE, armtol_general_angle(10), "to 10 mm");
    check_within(1e-17, 30 * MINUTE, armtol_general_angle(10.1), "above 10 mm");
    check_within(1e-17, 30 * MINUTE, armtol_general_angle(50), "to 50 mm");
    check_within(1e-17, 20 * MINUTE, armtol_general_angle(120), "to 120 mm");
    check_within(1e-17, 10 * MINUTE, armtol_general_angle(400), "to 400 mm");
    check_within(1e-17, 5 * MINUTE, armtol_general_angle(400.1), "above 400 mm");
    check_within(1e-17, 5 * MINUTE, armtol_general_angle(1e6), "far above");
    TEST_ASSERT_TRUE(isnan(armtol_general_angle(0)) && isnan(armtol_general_angle(-1)));
    TEST_ASSERT_TRUE(isnan(armtol_general_angle((double)NAN)));
}

static void test_how_long_the_shorter_side_has_to_be(void)
{
    check_same(0, armtol_general_side((double)INFINITY), "no bound");
    check_same(0, armtol_general_side(PI / 180), "1 degree");
    check_same(10, armtol_general_side(0.99 * PI / 180), "less");
    check_same(10, armtol_general_side(0.5 * PI / 180), "30'");
    check_same(50, armtol_general_side(20 * MINUTE), "20'");
    check_same(120, armtol_general_side(10 * MINUTE), "10'");
    check_same(400, armtol_general_side(9.9 * MINUTE), "less than 10'");
    check_same(400, armtol_general_side(5 * MINUTE), "5'");
    TEST_ASSERT_TRUE(isinf(armtol_general_side(4.9 * MINUTE)) && isinf(armtol_general_side((double)NAN)));
}

static void test_names(void)
{
    TEST_ASSERT_EQUAL_STRING("f", armtol_general_name(ARMTOL_GENERAL_FINE));
    TEST_ASSERT_EQUAL_STRING("m", armtol_general_name(ARMTOL_GENERAL_MEDIUM));
    TEST_ASSERT_EQUAL_STRING("", armtol_general_name(ARMTOL_GENERAL_COUNT));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_lengths);
    RUN_TEST(test_lengths_that_have_none);
    RUN_TEST(test_the_coarser_class_that_a_tolerance_holds);
    RUN_TEST(test_angles);
    RUN_TEST(test_how_long_the_shorter_side_has_to_be);
    RUN_TEST(test_names);
    return UNITY_END();
}
