#include "armtol/link.h"

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

static void check_kind(armtol_kind kind, const char *name, const char *parameters)
{
    char listed[64] = "";
    size_t count;
    const armtol_parameter *list = armtol_kind_parameters(kind, &count);
    for (size_t i = 0; i < count; i++) {
        strcat(listed, i > 0 ? " " : "");
        strcat(listed, armtol_parameter_name(list[i]));
    }
    TEST_ASSERT_EQUAL_STRING(name, armtol_kind_name(kind));
    TEST_ASSERT_EQUAL_STRING(parameters, listed);
}

static void test_kinds_have_their_parameters_in_the_report_s_order(void)
{
    check_kind(ARMTOL_NPR, "npr", "theta d a alpha");
    check_kind(ARMTOL_NPP, "npp", "theta d alpha");
    check_kind(ARMTOL_PPR, "ppr", "theta a alpha beta");
    check_kind(ARMTOL_PPP, "ppp", "d theta a alpha beta");
}

static void test_what_is_no_kind_or_parameter_has_none(void)
{
    size_t count = 7;
    TEST_ASSERT_NULL(armtol_kind_parameters(ARMTOL_KIND_COUNT, &count));
    TEST_ASSERT_EQUAL_INT(0, count);
    TEST_ASSERT_EQUAL_STRING("?", armtol_kind_name(ARMTOL_KIND_COUNT));
    TEST_ASSERT_EQUAL_STRING("?", armtol_parameter_name(ARMTOL_PARAMETER_COUNT));
}

static void test_a_and_d_are_lengths(void)
{
    TEST_ASSERT_TRUE(armtol_parameter_is_length(ARMTOL_A));
    TEST_ASSERT_TRUE(armtol_parameter_is_length(ARMTOL_D));
    TEST_ASSERT_FALSE(armtol_parameter_is_length(ARMTOL_THETA));
    TEST_ASSERT_FALSE(armtol_parameter_is_length(ARMTOL_ALPHA));
    TEST_ASSERT_FALSE(armtol_parameter_is_length(ARMTOL_BETA));
}

/* Two good links, the second to be spoilt. */
static armtol_link arm[2];

static void good_arm(void)
{
    arm[0] = (armtol_link){ARMTOL_NPR, ARMTOL_REVOLUTE, 1, 2, 3, 4, 0};
    arm[1] = (armtol_link){ARMTOL_PPP, ARMTOL_PRISMATIC, 5, 6, 7, 8, 9};
}

static void test_a_good_table_passes(void)
{
    good_arm();
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_check(arm, 2));
    TEST_ASSERT_EQUAL_INT(2, armtol_joint_count(arm, 2));
}

static void test_a_bad_table_is_told_apart(void)
{
    double *const values[] = {&arm[1].a, &arm[1].alpha, &arm[1].d, &arm[1].theta, &arm[1].beta};
    TEST_ASSERT_EQUAL_INT(ARMTOL_NO_LINKS, armtol_links_check(arm, 0));
    good_arm();
    arm[1].kind = ARMTOL_KIND_COUNT;
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_KIND, armtol_links_check(arm, 2));
    good_arm();
    arm[1].joint = ARMTOL_JOINT_COUNT;
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_JOINT, armtol_links_check(arm, 2));
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        good_arm();
        *values[i] = i % 2 == 0 ? NAN : INFINITY;
        TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_links_check(arm, 2));
    }
}

static void test_joint_values_are_added_where_the_joint_moves(void)
{
    const double q[] = {0.5, 100};
    armtol_link placed[2];
    good_arm();
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(arm, 2, q, 2, &armtol_errata_none, placed));
    check_same(4.5, placed[0].theta, "theta of the revolute link");
    check_same(3, placed[0].d, "d of the revolute link");
    check_same(8, placed[1].theta, "theta of the prismatic link");
    check_same(107, placed[1].d, "d of the prismatic link");
}

static void test_placing_in_place_and_past_fixed_links(void)
{
    const double q[] = {100};
    good_arm();
    arm[0].joint = ARMTOL_FIXED;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(arm, 2, q, 1, &armtol_errata_none, arm));
    check_same(4, arm[0].theta, "theta of the fixed link");
    check_same(107, arm[1].d, "d of the prismatic link");
}

static void test_placing_refuses_what_does_not_fit(void)
{
    const double q[] = {0.5, NAN, 1};
    armtol_link placed[2] = {{.a = -1}, {.a = -1}};
    good_arm();
    TEST_ASSERT_EQUAL_INT(ARMTOL_NO_LINKS, armtol_links_place(arm, 0, q, 0, &armtol_errata_none, placed));
    TEST_ASSERT_EQUAL_INT(ARMTOL_WRONG_SIZE, armtol_links_place(arm, 2, q, 1, &armtol_errata_none, placed));
    TEST_ASSERT_EQUAL_INT(ARMTOL_WRONG_SIZE, armtol_links_place(arm, 2, q, 3, &armtol_errata_none, placed));
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_links_place(arm, 2, q, 2, &armtol_errata_none, placed));
    check_same(-1, placed[0].a, "the output after an error");
}

static void test_placing_refuses_a_sum_that_overflows(void)
{
    const double q[] = {0.5, 3e38};
    armtol_link placed[2] = {{.a = -1}, {.a = -1}};
    good_arm();
    arm[1].d = 3e38;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_links_place(arm, 2, q, 2, &armtol_errata_1987, placed));
    check_same(-1, placed[0].a, "the output after an error");
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(arm, 2, q, 2, &armtol_errata_none, placed));
}

/* With the erratum `float` the constants of every link are floats, the fixed ones' too; else they stay as they are. */
static void test_placing_stores_every_parameter(void)
{
    const double q[] = {0.1, 0.7}, value = 0.1, stored = (double)0.1f;
    armtol_link placed[3], table[3];
    for (int i = 0; i < 3; i++) {
        table[i] = (armtol_link){ARMTOL_NPR, (armtol_joint)i, value, value, value, value, value};
    }
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(table, 3, q, 2, &armtol_errata_1987, placed));
    for (int i = 0; i < 3; i++) {
        check_same(stored, placed[i].a, "a of link %d", i);
        check_same(stored, placed[i].alpha, "alpha of link %d", i);
        check_same(stored, placed[i].beta, "beta of link %d", i);
        check_same(i == 1 ? (double)(float)(0.1 + 0.1) : stored, placed[i].theta, "theta of link %d", i);
        check_same(i == 2 ? (double)(float)(0.1 + 0.7) : stored, placed[i].d, "d of link %d", i);
    }
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(table, 3, q, 2, &armtol_errata_none, placed));
    check_same(value, placed[0].a, "a, not stored");
    check_same(value, placed[0].beta, "beta, not stored");
}

static void test_placing_refuses_a_constant_that_no_float_holds(void)
{
    const double q[] = {0.5, 1};
    armtol_link placed[2];
    good_arm();
    arm[0].a = 1e39;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_links_place(arm, 2, q, 2, &armtol_errata_1987, placed));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(arm, 2, q, 2, &armtol_errata_none, placed));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_kinds_have_their_parameters_in_the_report_s_order);
    RUN_TEST(test_what_is_no_kind_or_parameter_has_none);
    RUN_TEST(test_a_and_d_are_lengths);
    RUN_TEST(test_a_good_table_passes);
    RUN_TEST(test_a_bad_table_is_told_apart);
    RUN_TEST(test_joint_values_are_added_where_the_joint_moves);
    RUN_TEST(test_placing_in_place_and_past_fixed_links);
    RUN_TEST(test_placing_refuses_what_does_not_fit);
    RUN_TEST(test_placing_refuses_a_sum_that_overflows);
    RUN_TEST(test_placing_stores_every_parameter);
    RUN_TEST(test_placing_refuses_a_constant_that_no_float_holds);
    return UNITY_END();
}
