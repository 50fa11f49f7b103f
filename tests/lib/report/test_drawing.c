#include "armtol/drawing.h"

#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* a and d of either sign, and a tolerance from a tiny part of their distance to twice it. */
static void draw_part(random_source *random, double *a, double *d, double *tolerance)
{
    *a = random_between(random, -1, 1);
    *d = random_between(random, -1, 1);
    *tolerance = hypot(*a, *d) * 2 * pow(10, -random_between(random, 0, 12));
}

/*
 * Where the parameter leaves the tolerance, the distance is as long as it may be, or as short. It is the root of a
 * difference of squares: a short one has the roundings of the long ones.
 */
static void check_end(double r, double tolerance, double distance, const char *what)
{
    const double off = fabs(distance - r), rounding = 1e-15 * (r + tolerance) * (r + tolerance) / distance;
    check_within(rounding, tolerance, off, "%s: the distance %g of %g +- %g", what, distance, r, tolerance);
}

/* The ends of a range, where d has `share` of the error of a. */
static void check_ends(uint64_t seed, armtol_range (*range_of)(double a, double d, double tolerance), double share)
{
    random_source random = {seed};
    for (int i = 0; i < 10000; i++) {
        double a, d, tolerance;
        draw_part(&random, &a, &d, &tolerance);
        const double r = hypot(a, d);
        const armtol_range range = range_of(a, d, tolerance);
        TEST_ASSERT_TRUE(range.low < 0 && range.high > 0);
        check_end(r, tolerance, hypot(a + range.low, d + share * range.low), "low");
        check_end(r, tolerance, hypot(a + range.high, d + share * range.high), "high");
    }
}

static void test_the_ends_are_at_the_distances_that_the_tolerance_allows(void)
{
    check_ends(1413, armtol_drawing_length, 0);
}

/* All between the ends is allowed. */
static void test_between_the_ends_the_distance_is_within(void)
{
    random_source random = {1414};
    for (int i = 0; i < 10000; i++) {
        double a, d, tolerance;
        draw_part(&random, &a, &d, &tolerance);
        const armtol_range range = armtol_drawing_length(a, d, tolerance);
        const double x = random_between(&random, range.low, range.high);
        TEST_ASSERT_TRUE(fabs(hypot(a + x, d) - hypot(a, d)) <= tolerance + 1e-15 * (hypot(a, d) + tolerance));
    }
}

static void test_both_ends_of_equal_errors(void)
{
    check_ends(1416, armtol_drawing_length_both, 1);
}

/* The equations as the report has them, of a = 3, d = 4, r = 5 and 1 more: 36 - 16, 36 - 9, and (7, 11). */
static void test_the_report_s_upper_end(void)
{
    check_within(1e-15, sqrt(20) - 3, armtol_drawing_length(3, 4, 1).high, "a alone");
    check_within(1e-15, sqrt(27) - 4, armtol_drawing_length(4, 3, 1).high, "d alone");
    check_within(1e-15, (sqrt(49 + 22) - 7) / 2, armtol_drawing_length_both(3, 4, 1).high, "both");
    check_within(1e-15, sqrt(20) - 3, -armtol_drawing_length(-3, 4, 1).low, "a to the other side");
}

/* To first order the error of a is r / a times the tolerance: what is tiny has not lost its digits. */
static void test_a_tiny_tolerance_does_not_cancel(void)
{
    const armtol_range range = armtol_drawing_length(3, 4, 3e-14), both = armtol_drawing_length_both(3, 4, 7e-14);
    check_within(1e-26, 5e-14, range.high, "high");
    check_within(1e-26, -5e-14, range.low, "low");
    check_within(1e-26, 5e-14, both.high, "high of both");
}

/* A part whose axes meet: the distance is |a|, on both sides. */
static void test_axes_that_meet(void)
{
    const armtol_range range = armtol_drawing_length(0, 0, 0.5);
    check_within(1e-16, -0.5, range.low, "low");
    check_within(1e-16, 0.5, range.high, "high");
    const armtol_range through = armtol_drawing_length(0.1, 0, 0.5);
    check_within(1e-16, -0.7, through.low, "through the other axis");
    check_within(1e-16, 0.5, through.high, "away from it");
}

static void test_no_tolerance_allows_nothing(void)
{
    const armtol_range along = armtol_drawing_length(3, 4, 0), none = armtol_drawing_length(0, 0, 0);
    check_same(0, along.low, "low");
    check_same(0, along.high, "high");
    check_same(0, none.low, "low of no length");
    check_same(0, none.high, "high of no length");
}

static void test_what_is_no_tolerance_has_no_range(void)
{
    TEST_ASSERT_TRUE(isnan(armtol_drawing_length(1, 1, -1).low));
    TEST_ASSERT_TRUE(isnan(armtol_drawing_length_both(1, 1, (double)NAN).high));
    TEST_ASSERT_TRUE(isnan(armtol_drawing_length((double)NAN, 1, 1).low));
}

static void test_an_even_share_is_that_of_45_degrees(void)
{
    const double eighth = atan(1);
    for (int i = 0; i <= 30; i++) { /* up to 1.07 */
        const double tolerance = ldexp(1e-9, i);
        double alpha, beta;
        armtol_drawing_angle_at(tolerance, eighth, &alpha, &beta);
        check_within(1e-15, alpha, armtol_drawing_angle_even(tolerance), "alpha of %g", tolerance);
        check_within(1e-15, beta, armtol_drawing_angle_even(tolerance), "beta of %g", tolerance);
    }
    check_within(1e-16, atan(tan(0.1) / sqrt(2)), armtol_drawing_angle_even(0.1), "as printed");
}

/*
 * The axis z, turned about x by alpha and then about the new y by beta, stands at an angle g to itself with
 * tan^2 g = tan^2 tolerance + tan^2 alpha tan^2 beta: on the rim but for the square of a square.
 */
static void test_the_axis_is_on_the_rim_of_the_cone(void)
{
    random_source random = {1418};
    for (int i = 0; i < 10000; i++) {
        const double tolerance = random_between(&random, 0, 1), phi = random_between(&random, -4, 4);
        double alpha, beta;
        armtol_drawing_angle_at(tolerance, phi, &alpha, &beta);
        const double axis[3] = {sin(beta), -sin(alpha) * cos(beta), cos(alpha) * cos(beta)};
        const double tangent = hypot(axis[0], axis[1]) / axis[2], more = tan(alpha) * tan(beta);
        check_within(1e-14, hypot(tan(tolerance), more), tangent, "tolerance %g, phi %g", tolerance, phi);
        check_within(1e-14, cos(phi) * tan(tolerance), tan(alpha), "alpha towards phi");
    }
}

/* "A link parameter angle can achieve its maximum error only when the other is zero." */
static void test_the_whole_angle_goes_to_one_alone(void)
{
    double alpha, beta;
    armtol_drawing_angle_at(0.01, 0, &alpha, &beta);
    check_within(1e-17, 0.01, alpha, "alpha");
    check_same(0, beta, "beta");
    armtol_drawing_angle_at(0.01, atan(1) * 2, &alpha, &beta);
    check_within(1e-17, 0, alpha, "alpha across");
    check_within(1e-17, 0.01, beta, "beta across");
}

/* ---- discs, and the way back ---- */

/* It holds the rim, all the way round, and touches it where the errors are alike. */
static void test_the_disc_holds_the_cone(void)
{
    random_source random = {4173};
    for (int i = 0; i < 10000; i++) {
        const double tolerance = random_between(&random, 0, 1.5), phi = random_between(&random, -4, 4);
        const double radius = armtol_drawing_radius(tolerance);
        double alpha, beta;
        armtol_drawing_angle_at(tolerance, phi, &alpha, &beta);
        TEST_ASSERT_TRUE(hypot(alpha, beta) <= radius * (1 + 1e-15));
        TEST_ASSERT_TRUE(radius >= tolerance * (1 - 1e-15));
    }
    check_within(1e-9, 0.02 * (1 + 0.02 * 0.02 / 6), armtol_drawing_radius(0.02), "more by its square / 6");
}

static double farther(armtol_range range)
{
    return fmax(-range.low, range.high);
}

/* Taken forward again it keeps to the error, and a little more does not. */
static void test_the_way_back_is_the_largest_that_keeps_to_the_error(void)
{
    random_source random = {4174};
    for (int i = 0; i < 10000; i++) {
        double a, d, error;
        draw_part(&random, &a, &d, &error);
        const double alone = armtol_drawing_distance(a, d, error), both = armtol_drawing_distance_both(a, d, error);
        TEST_ASSERT_TRUE(alone > 0 && both > 0);
        TEST_ASSERT_TRUE(farther(armtol_drawing_length(a, d, alone)) <= error);
        TEST_ASSERT_TRUE(farther(armtol_drawing_length_both(a, d, both)) <= error);
        TEST_ASSERT_TRUE(farther(armtol_drawing_length(a, d, alone * (1 + 1e-9))) > error);
        TEST_ASSERT_TRUE(farther(armtol_drawing_length_both(a, d, both * (1 + 1e-9))) > error);
    }
}

static void test_the_way_back_in_closed_form(void)
{
    /* (3, 4) is 5 long, (2, 4) is nearer to that than (4, 4), and (2, 3) than (4, 5) */
    check_within(1e-15, 5 - sqrt(20), armtol_drawing_distance(3, 4, 1), "a alone");
    check_within(1e-15, 5 - sqrt(13), armtol_drawing_distance_both(3, 4, 1), "both");
    check_within(1e-15, atan(sqrt(2) * tan(0.02 / sqrt(2))), armtol_drawing_angle(0.02), "an angle");
    check_same(1.57, armtol_drawing_angle(3), "at most");
    check_same(0, armtol_drawing_distance(3, 4, 0), "exact");
    check_same(0, armtol_drawing_angle(0), "exact");
    TEST_ASSERT_TRUE(isinf(armtol_drawing_distance(3, 4, (double)INFINITY)));
    TEST_ASSERT_TRUE(isnan(armtol_drawing_distance(3, 4, -1)) && isnan(armtol_drawing_angle((double)NAN)));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_ends_are_at_the_distances_that_the_tolerance_allows);
    RUN_TEST(test_between_the_ends_the_distance_is_within);
    RUN_TEST(test_both_ends_of_equal_errors);
    RUN_TEST(test_the_report_s_upper_end);
    RUN_TEST(test_a_tiny_tolerance_does_not_cancel);
    RUN_TEST(test_axes_that_meet);
    RUN_TEST(test_no_tolerance_allows_nothing);
    RUN_TEST(test_what_is_no_tolerance_has_no_range);
    RUN_TEST(test_an_even_share_is_that_of_45_degrees);
    RUN_TEST(test_the_axis_is_on_the_rim_of_the_cone);
    RUN_TEST(test_the_whole_angle_goes_to_one_alone);
    RUN_TEST(test_the_disc_holds_the_cone);
    RUN_TEST(test_the_way_back_is_the_largest_that_keeps_to_the_error);
    RUN_TEST(test_the_way_back_in_closed_form);
    return UNITY_END();
}
