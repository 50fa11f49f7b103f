#include "armtol/machining.h"

#include "support/check.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* Corrected, the corner of the cube of shares lies on the sphere. */
static void test_shares_fill_the_sphere(void)
{
    const armtol_bounds bounds = {0.09, 0.004};
    const armtol_shares shares = armtol_parameter_shares(&bounds, 9, 16, &armtol_errata_none);
    check_within(1e-16, 0.03, shares.distance, "distance");
    check_within(1e-17, 0.001, shares.angle, "angle");
}

static void test_root_of_ratio_takes_the_root_of_all(void)
{
    const armtol_bounds bounds = {0.09, 0.0064};
    armtol_errata errata = armtol_errata_none;
    errata.root_of_ratio = true;
    const armtol_shares shares = armtol_parameter_shares(&bounds, 9, 16, &errata);
    check_within(1e-15, 0.1, shares.distance, "distance");
    check_within(1e-15, 0.02, shares.angle, "angle");
}

static void test_copied_counts_are_14_and_18(void)
{
    const armtol_bounds bounds = {sqrt(14), sqrt(18)};
    armtol_errata errata = armtol_errata_none;
    errata.copied_counts = true;
    const armtol_shares shares = armtol_parameter_shares(&bounds, 9, 16, &errata);
    check_within(1e-15, 1, shares.distance, "distance");
    check_within(1e-15, 1, shares.angle, "angle");
}

static void test_no_parameters_have_no_share(void)
{
    const armtol_bounds bounds = {INFINITY, INFINITY};
    const armtol_shares shares = armtol_parameter_shares(&bounds, 0, 0, &armtol_errata_none);
    check_same(0, shares.distance, "distance");
    check_same(0, shares.angle, "angle");
}

/* With a alone, h + rd = sqrt((a + s)^2 + s^2); with a = 3, s = 1: 3 + rd = sqrt(17). */
static void test_the_machining_distance_in_closed_form(void)
{
    const armtol_link along_a = {.a = 3}, along_d = {.d = 3}, both = {.a = 3, .d = 4}, none = {.a = 0};
    check_within(1e-15, sqrt(17) - 3, armtol_machining_distance(&along_a, 1, &armtol_errata_none), "a");
    check_within(1e-15, sqrt(17) - 3, armtol_machining_distance(&along_d, 1, &armtol_errata_none), "d");
    check_within(1e-15, sqrt(16 + 25) - 5, armtol_machining_distance(&both, 1, &armtol_errata_none), "both");
    check_within(1e-15, sqrt(2), armtol_machining_distance(&none, 1, &armtol_errata_none), "neither");
}

static void test_signed_mach_lets_a_negative_length_make_a_negative_tolerance(void)
{
    const armtol_link down = {.d = -3}, up = {.d = 3}, left = {.a = -3};
    armtol_errata kept = armtol_errata_none;
    kept.signed_mach = true;
    /* 9 - 6 + 2 = 5 */
    check_within(1e-15, sqrt(5) - 3, armtol_machining_distance(&down, 1, &kept), "kept, d < 0");
    check_within(1e-15, sqrt(5) - 3, armtol_machining_distance(&left, 1, &kept), "kept, a < 0");
    check_within(1e-15, sqrt(17) - 3, armtol_machining_distance(&up, 1, &kept), "kept, d > 0");
    check_within(1e-15, sqrt(17) - 3, armtol_machining_distance(&down, 1, &armtol_errata_none), "d < 0");
    check_within(1e-15, sqrt(17) - 3, armtol_machining_distance(&left, 1, &armtol_errata_none), "a < 0");
}

/* a = d = -share: the corner comes back onto the other axis, h + rd = 0, and rounding must not make it nan. */
static void test_a_signed_length_of_its_own_share_is_no_nan(void)
{
    armtol_errata kept = armtol_errata_none;
    kept.signed_mach = true;
    for (int n = 1; n < 100; n++) {
        const double share = 0.1 * n;
        const armtol_link link = {.a = -share, .d = -share};
        check_within(1e-6, -share * sqrt(2), armtol_machining_distance(&link, share, &kept), "share %g", share);
    }
}

static void test_motors_follow_their_joints(void)
{
    const armtol_shares shares = {1, 2};
    const armtol_link revolute = {.joint = ARMTOL_REVOLUTE}, prismatic = {.joint = ARMTOL_PRISMATIC};
    const armtol_link fixed = {.joint = ARMTOL_FIXED};
    check_same(2, armtol_motor_tolerance(&revolute, 3, &shares), "revolute");
    check_same(3, armtol_motor_tolerance(&prismatic, 3, &shares), "prismatic");
    check_same(0, armtol_motor_tolerance(&fixed, 3, &shares), "fixed");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_shares_fill_the_sphere);
    RUN_TEST(test_root_of_ratio_takes_the_root_of_all);
    RUN_TEST(test_copied_counts_are_14_and_18);
    RUN_TEST(test_no_parameters_have_no_share);
    RUN_TEST(test_the_machining_distance_in_closed_form);
    RUN_TEST(test_signed_mach_lets_a_negative_length_make_a_negative_tolerance);
    RUN_TEST(test_a_signed_length_of_its_own_share_is_no_nan);
    RUN_TEST(test_motors_follow_their_joints);
    return UNITY_END();
}
