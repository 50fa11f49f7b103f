/* Who an error comes from. */

#include "armtol/budget.h"
#include "lib/engine/one_link.h"
#include "support/check.h"

#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* theta moves dx by 3 and dy by 4 a unit, a dx alone. */
static armtol_budget *budget_of(one_link *one, armtol_method method, double a)
{
    armtol_answer *answer;
    armtol_budget *budget;
    one->link.a = 4;
    one->question.tool.offset[1] = 3;
    one->question.method = method;
    one->question.sigma = 1;
    one->tolerances[0] = 0.5;
    one->tolerances[1] = a;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&one->question, &answer, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_budget_create(answer, &budget));
    armtol_answer_destroy(answer);
    return budget;
}

static void check_shares(armtol_method method, double motor_of_dx)
{
    one_link one;
    one_link_make(&one, 0);
    armtol_budget *budget = budget_of(&one, method, 0.5);
    TEST_ASSERT_TRUE(budget->n_rows == 2);
    TEST_ASSERT_TRUE(budget->rows[0].link == 0 && budget->rows[0].role == ARMTOL_MACHINING);
    TEST_ASSERT_TRUE(budget->rows[1].link == 0 && budget->rows[1].role == ARMTOL_MOTOR);
    check_within(1e-15, 1 - motor_of_dx, budget->rows[0].shares[0], "making, dx");
    check_within(1e-15, motor_of_dx, budget->rows[1].shares[0], "motor, dx");
    check_within(1e-15, motor_of_dx, budget->motors[0], "motors, dx");
    check_within(1e-15, 1, budget->motors[1], "motors, dy");
    check_same(0, budget->rows[0].shares[2] + budget->rows[1].shares[2], "dz, which nothing moves");
    armtol_budget_destroy(budget);
}

static void test_the_shares_of_magnitudes_and_of_squares(void)
{
    check_shares(ARMTOL_METHOD_WORST, 3.0 / 4);
    check_shares(ARMTOL_METHOD_RSS, 9.0 / 10);
}

static void test_what_has_no_bound_has_no_shares(void)
{
    one_link one;
    one_link_make(&one, 0);
    armtol_budget *budget = budget_of(&one, ARMTOL_METHOD_WORST, INFINITY);
    TEST_ASSERT_TRUE(isnan(budget->motors[0]) && isnan(budget->rows[0].shares[0]));
    check_within(1e-15, 1, budget->motors[1], "motors, dy");
    armtol_budget_destroy(budget);
}

/* A fixed link has no motor. */
static void test_rows_are_in_order_and_those_without_a_parameter_left_out(void)
{
    const armtol_link links[3] = {{ARMTOL_NPR, ARMTOL_FIXED, .a = 10}, {ARMTOL_PPP, ARMTOL_PRISMATIC, .a = 20},
                                  {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 30}};
    const armtol_drive drives[3] = {armtol_drive_unknown, armtol_drive_unknown, armtol_drive_unknown};
    static const size_t link[5] = {0, 1, 1, 2, 2};
    static const double accuracy[6] = {1, 1, 1, 1, 1, 1};
    one_link one;
    armtol_answer *answer;
    armtol_budget *budget;
    one_link_make(&one, 0);
    one.arm.n_links = 3;
    one.arm.links = links;
    one.arm.drives = drives;
    one.question.tolerances = NULL;
    one.question.accuracy = accuracy;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&one.question, &answer, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_budget_create(answer, &budget));
    TEST_ASSERT_TRUE(budget->n_rows == 5);
    for (size_t r = 0; r < 5; r++) {
        TEST_ASSERT_TRUE(budget->rows[r].link == link[r]);
        TEST_ASSERT_EQUAL_STRING(r == 2 || r == 4 ? "motor" : "machining", armtol_role_name(budget->rows[r].role));
    }
    armtol_budget_destroy(budget);
    armtol_answer_destroy(answer);
}

static void test_roles(void)
{
    const armtol_link turns = {ARMTOL_NPR, ARMTOL_REVOLUTE}, slides = {ARMTOL_NPP, ARMTOL_PRISMATIC};
    TEST_ASSERT_EQUAL_INT(ARMTOL_MOTOR, armtol_role_of(&turns, ARMTOL_THETA));
    TEST_ASSERT_EQUAL_INT(ARMTOL_MACHINING, armtol_role_of(&turns, ARMTOL_D));
    TEST_ASSERT_EQUAL_INT(ARMTOL_MACHINING, armtol_role_of(&slides, ARMTOL_THETA));
    TEST_ASSERT_EQUAL_INT(ARMTOL_MOTOR, armtol_role_of(&slides, ARMTOL_D));
    TEST_ASSERT_EQUAL_STRING("?", armtol_role_name(ARMTOL_ROLE_COUNT));
    armtol_budget_destroy(NULL);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_shares_of_magnitudes_and_of_squares);
    RUN_TEST(test_what_has_no_bound_has_no_shares);
    RUN_TEST(test_rows_are_in_order_and_those_without_a_parameter_left_out);
    RUN_TEST(test_roles);
    return UNITY_END();
}
