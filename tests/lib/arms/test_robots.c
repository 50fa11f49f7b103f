#include "armtol/euler.h"
#include "armtol/link_transform.h"
#include "armtol/robots.h"

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

static const double unset = 42;

/* Wishes that can be met, since joint values lead there. */
static void draw_wish(const armtol_robot *robot, random_source *source, double wish[])
{
    double q[6];
    for (size_t i = 0; i < robot->n_joints; i++) {
        q[i] = random_between(source, -3, 3);
    }
    robot->forward(q, &armtol_errata_none, wish);
}

/* The distance between two poses: of their points, and the largest difference in their rotations. */
static void check_pose(const double expected[6], const double actual[6], double length, double angle, int draw)
{
    const armtol_transform one = armtol_pose_to_transform(expected, &armtol_errata_none);
    const armtol_transform other = armtol_pose_to_transform(actual, &armtol_errata_none);
    for (int i = 0; i < 3; i++) {
        check_within(length, expected[i], actual[i], "draw %d, position %d", draw, i);
        for (int j = 0; j < 3; j++) {
            check_within(angle, one.m[i][j], other.m[i][j], "draw %d, rotation %d %d", draw, i, j);
        }
    }
}

static void check_intelledex(const armtol_errata *errata, double length, double angle)
{
    random_source source = {605};
    for (int n = 0; n < 2000; n++) {
        double wish[6], q[6], back[6];
        armtol_reach reach;
        draw_wish(&armtol_intelledex_605t, &source, wish);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_intelledex_605t.inverse(wish, errata, q, &reach));
        armtol_intelledex_605t.forward(q, errata, back);
        check_pose(wish, back, length, angle, n);
    }
}

static void test_the_intelledex_gets_where_it_should(void)
{
    check_intelledex(&armtol_errata_none, 1e-7, 1e-10);
}

static void check_adept(const armtol_errata *errata, double length, double angle)
{
    random_source source = {1987};
    for (int n = 0; n < 2000; n++) {
        double wish[4], q[4], back[4];
        armtol_reach reach;
        draw_wish(&armtol_adept_one, &source, wish);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_adept_one.inverse(wish, errata, q, &reach));
        armtol_adept_one.forward(q, errata, back);
        for (int i = 0; i < 3; i++) {
            check_within(length, wish[i], back[i], "draw %d, position %d", n, i);
        }
        check_within(angle, 0, sin(wish[3] - back[3]), "draw %d, theta", n);
    }
}

static void test_the_adept_gets_where_it_should(void)
{
    check_adept(&armtol_errata_none, 1e-7, 1e-10);
}

/* With floats and 3.14159 the Adept is off by at most the error of pi times its length, and by rounding. */
static void test_the_adept_of_1987_nearly_gets_there(void)
{
    check_adept(&armtol_errata_1987, 5e-3, 1e-5);
}

/* An elbow of 2.7e-6 rad: the error of 3.14159, seen at the tool of a stretched arm. */
static void test_the_1987_check_shows_the_short_pi(void)
{
    const double wish[4] = {200, 200, 0, 0};
    double q[4], back[4];
    armtol_reach reach;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_adept_one.inverse(wish, &armtol_errata_1987, q, &reach));
    armtol_adept_one.forward(q, &armtol_errata_1987, back);
    TEST_ASSERT_TRUE(fabs(back[0] - 200) > 1e-4);
    TEST_ASSERT_TRUE(fabs(back[0] - 200) < 2.7e-6 * 400);
}

/* Both descriptions of an arm put the tool in the same place, but for the Adept's half turns. */
static void check_descriptions(const armtol_robot *robot, double sign)
{
    random_source source = {2};
    armtol_errata errata = armtol_errata_none;
    errata.half_turns = sign < 0;
    for (int n = 0; n < 100; n++) {
        armtol_link links[8];
        double q[6], wish[6];
        for (size_t i = 0; i < robot->n_joints; i++) {
            q[i] = random_between(&source, -3, 3);
        }
        robot->links(&errata, links);
        TEST_ASSERT_EQUAL_INT(
            ARMTOL_OK, armtol_links_place(links, robot->n_links, q, robot->n_joints, &errata, links));
        robot->forward(q, &errata, wish);
        const armtol_transform tool = armtol_chain_transform(links, robot->n_links, &errata);
        check_within(1e-10, sign * wish[0], tool.m[0][3], "x");
        check_within(1e-10, sign * wish[1], tool.m[1][3], "y");
        check_within(1e-10, wish[2], tool.m[2][3], "z");
    }
}

static void test_both_descriptions_agree(void)
{
    check_descriptions(&armtol_intelledex_605t, 1);
    check_descriptions(&armtol_adept_one, 1);
}

static void test_half_turns_mirror_the_adept(void)
{
    check_descriptions(&armtol_adept_one, -1);
}

static void check_refused(const armtol_robot *robot, armtol_status expected, const double wish[],
                          double distance)
{
    const armtol_errata *const modes[] = {&armtol_errata_1987, &armtol_errata_none};
    for (int i = 0; i < 2; i++) {
        double q[6] = {unset};
        armtol_reach reach;
        TEST_ASSERT_EQUAL_INT(expected, robot->inverse(wish, modes[i], q, &reach));
        check_same(unset, q[0], "the output after an error");
        check_within(1e-9 * distance + 1e-9, distance, reach.distance, "the distance");
    }
}

static void test_the_adept_s_reach_is_from_50_to_800(void)
{
    static const double far[] = {480.1, 640, 0, 0}, near[] = {30, 39.9, 0, 0}, at_axis[] = {0, 0, 0, 0};
    static const double huge[] = {3e38, 0, 0, 0};
    double q[4];
    armtol_reach reach;
    check_refused(&armtol_adept_one, ARMTOL_OUT_OF_REACH, far, hypot(480.1, 640));
    check_refused(&armtol_adept_one, ARMTOL_OUT_OF_REACH, near, hypot(30, 39.9));
    check_refused(&armtol_adept_one, ARMTOL_OUT_OF_REACH, at_axis, 0);
    check_refused(&armtol_adept_one, ARMTOL_OUT_OF_REACH, huge, 3e38);
    const double stretched[] = {480, 640, 0, 0}, folded[] = {30, 40, 0, 0};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_adept_one.inverse(stretched, &armtol_errata_none, q, &reach));
    check_same(50, reach.nearest, "nearest");
    check_same(800, reach.farthest, "farthest");
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_adept_one.inverse(folded, &armtol_errata_none, q, &reach));
}

static void test_the_intelledex_s_reach_is_that_of_its_wrist(void)
{
    const double quarter = 1.5707963267948966;
    /* the tool along x: the wrist is 100 behind it, the shoulder 359.7 up */
    const double far[] = {753, 40, 359.7, 0, quarter, 0}, near[] = {193, 10, 359.7, 0, quarter, 0};
    const double huge[] = {0, 3e38, 0, 0, quarter, 0};
    const double far_off[] = {752, 10, 359.7, 0, quarter, 0}, near_off[] = {195, 10, 359.7, 0, quarter, 0};
    double q[6];
    armtol_reach reach;
    check_refused(&armtol_intelledex_605t, ARMTOL_OUT_OF_REACH, far, hypot(653, 40));
    check_refused(&armtol_intelledex_605t, ARMTOL_OUT_OF_REACH, near, hypot(93, 10));
    check_refused(&armtol_intelledex_605t, ARMTOL_OUT_OF_REACH, huge, 3e38);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                          armtol_intelledex_605t.inverse(far_off, &armtol_errata_none, q, &reach));
    check_within(1e-12, 373.4 - 279.4, reach.nearest, "nearest");
    check_within(1e-12, 373.4 + 279.4, reach.farthest, "farthest");
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                          armtol_intelledex_605t.inverse(near_off, &armtol_errata_none, q, &reach));
}

static void test_the_shoulder_on_the_tool_axis_is_singular(void)
{
    const double quarter = 1.5707963267948966;
    const double above[] = {0, 0, 700, 0, 0, 0}, ahead[] = {500, 0, 359.7, 0, quarter, 0};
    const double at_shoulder[] = {0, 0, 359.7, 0.1, 0.2, 0.3};
    const double beside[] = {500, 0.002, 359.7, 0, quarter, 0}, above_it[] = {500, 0, 359.702, 0, quarter, 0};
    double q[6];
    armtol_reach reach;
    check_refused(&armtol_intelledex_605t, ARMTOL_SINGULAR, above, 700 - 100 - 359.7);
    check_refused(&armtol_intelledex_605t, ARMTOL_SINGULAR, ahead, 400);
    check_refused(&armtol_intelledex_605t, ARMTOL_SINGULAR, at_shoulder, 100);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_intelledex_605t.inverse(beside, &armtol_errata_1987, q, &reach));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_intelledex_605t.inverse(above_it, &armtol_errata_1987, q, &reach));
}

static void test_out_of_reach_comes_before_singular(void)
{
    const double far_above[] = {0, 0, 5000, 0, 0, 0}, too_near[] = {0, 0, 500, 0, 0, 0};
    check_refused(&armtol_intelledex_605t, ARMTOL_OUT_OF_REACH, far_above, 5000 - 100 - 359.7);
    check_refused(&armtol_intelledex_605t, ARMTOL_OUT_OF_REACH, too_near, 500 - 100 - 359.7);
}

static void test_a_joint_value_that_overflows_is_told(void)
{
    const double wish[] = {200, 200, 1e300, 0};
    double q[4] = {unset};
    armtol_reach reach;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_adept_one.inverse(wish, &armtol_errata_1987, q, &reach));
    check_same(unset, q[0], "the output after an error");
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_adept_one.inverse(wish, &armtol_errata_none, q, &reach));
}

/* The axes of joints 3 to 5 upright, as joint 1's is: any q1 will do, and the arm gets there. */
static void test_an_upright_elbow_is_no_error(void)
{
    static const double wishes[][6] = {{300, 200, 359.7, 0, 1.5707963267948966, 0}, /* upright but for rounding */
                                       {300, 0, 359.7, 1.5707963267948966, 0, 0}};
    for (size_t i = 0; i < sizeof wishes / sizeof wishes[0]; i++) {
        double q[6], back[6];
        armtol_reach reach;
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_intelledex_605t.inverse(wishes[i], &armtol_errata_none, q, &reach));
        armtol_intelledex_605t.forward(q, &armtol_errata_none, back);
        check_pose(wishes[i], back, 1e-7, 1e-10, 0);
    }
}

static void check_not_finite(const armtol_robot *robot)
{
    for (size_t i = 0; i < robot->n_wish; i++) {
        double wish[6] = {200, 200, 0, 0, 1.57, 0}, q[6] = {unset};
        armtol_reach reach;
        wish[i] = i % 2 == 0 ? NAN : -INFINITY;
        TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, robot->inverse(wish, &armtol_errata_1987, q, &reach));
        check_same(unset, q[0], "the output after an error");
    }
}

static void test_a_wish_has_to_be_finite(void)
{
    check_not_finite(&armtol_intelledex_605t);
    check_not_finite(&armtol_adept_one);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_intelledex_gets_where_it_should);
    RUN_TEST(test_the_adept_gets_where_it_should);
    RUN_TEST(test_the_adept_of_1987_nearly_gets_there);
    RUN_TEST(test_the_1987_check_shows_the_short_pi);
    RUN_TEST(test_both_descriptions_agree);
    RUN_TEST(test_half_turns_mirror_the_adept);
    RUN_TEST(test_the_adept_s_reach_is_from_50_to_800);
    RUN_TEST(test_the_intelledex_s_reach_is_that_of_its_wrist);
    RUN_TEST(test_the_shoulder_on_the_tool_axis_is_singular);
    RUN_TEST(test_out_of_reach_comes_before_singular);
    RUN_TEST(test_a_joint_value_that_overflows_is_told);
    RUN_TEST(test_an_upright_elbow_is_no_error);
    RUN_TEST(test_a_wish_has_to_be_finite);
    return UNITY_END();
}
