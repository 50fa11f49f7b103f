/* Questions and their answers: defaults, what is refused and why, closed forms. */

#include "armtol/answer.h"
#include "armtol/sphere.h"
#include "lib/engine/answers.h"
#include "lib/engine/one_link.h"
#include "support/check.h"

#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double accuracy[6] = {2, 2, 2, 0.01, 0.01, 0.01};

void setUp(void)
{
}

void tearDown(void)
{
}

/* The link, and what its tool is to keep to. */
static void ask_for_tolerances(one_link *one)
{
    one_link_make(one, 0);
    one->question.tolerances = NULL;
    one->question.accuracy = accuracy;
}

/* ---- closed forms ---- */

enum { THETA, A, ALPHA, BETA };

/*
 * Along x the tool is moved by a alone, across by theta alone and by 400 mm a radian; alpha, beta and theta turn it
 * about x, y and z. Theta is held down by dy, 2 = 400 t, and not by wz.
 */
static void test_the_tolerances_of_one_link(void)
{
    one_link one;
    ask_for_tolerances(&one);
    armtol_answer *answer = answer_of(&one.question);
    TEST_ASSERT_TRUE(answer->n_links == 1 && answer->n_joints == 1 && answer->n_columns == 4 && answer->n_poses == 1);
    check_within(1e-12, 0.005, answer->tolerances[THETA], "theta");
    check_within(1e-9, 2, answer->tolerances[A], "a");
    check_within(1e-12, 0.01, answer->tolerances[ALPHA], "alpha");
    check_within(1e-12, 0.01, answer->tolerances[BETA], "beta");
    for (int i = 0; i < 6; i++) {
        const double worst = (const double[]){2, 2, 0, 0.01, 0.01, 0.005}[i];
        check_within(1e-9, worst, answer->components[i].worst, "worst case %d", i);
        check_within(1e-9, worst / sqrt(3), answer->components[i].deviation, "deviation %d", i);
        check_within(1e-9, i == 2 || i == 5 ? 0 : 0.25, answer->components[i].binds, "binds %d", i);
        check_same(accuracy[i], answer->accuracy[i], "accuracy %d", i);
    }
    check_within(1e-12, 0.005, answer->parts[0].motor, "motor");
    check_within(1e-12, 0.01, answer->parts[0].angle, "angle");
    check_within(1e-9, 2, answer->parts[0].distance, "distance");
    TEST_ASSERT_TRUE(isnan(answer->parts[0].drive) && isnan(answer->delta));
    armtol_answer_destroy(answer);
}

/* Nothing of the question is needed once there is an answer. */
static void test_an_answer_stands_alone(void)
{
    one_link one;
    ask_for_tolerances(&one);
    one.q[0] = 0.5;
    one.question.tool.offset[0] = 100;
    armtol_answer *answer = answer_of(&one.question);
    double point[3];
    memset(&one, 0xff, sizeof one);
    armtol_answer_tool(answer, 0, point);
    check_within(1e-12, 500 * cos(0.5), point[0], "x");
    check_within(1e-12, 500 * sin(0.5), point[1], "y");
    check_same(0, point[2], "z");
    check_same(0.5, armtol_answer_links(answer, 0)->theta, "theta");
    check_within(1e-12, 500 * cos(0.5), armtol_answer_matrix(answer, 0)[4 + THETA], "dy of theta");
    armtol_answer_destroy(answer);
}

static void test_given_tolerances_are_taken(void)
{
    one_link one;
    one_link_make(&one, 0);
    one.tolerances[A] = INFINITY;
    one.question.accuracy = accuracy;
    armtol_answer *answer = answer_of(&one.question);
    check_same(0.004, answer->tolerances[THETA], "theta");
    check_same(INFINITY, answer->tolerances[A], "a");
    check_same(0, answer->bounded[A], "a that counts as exact");
    check_same(INFINITY, answer->components[0].worst, "dx");
    check_within(1e-12, 1.6, answer->components[1].worst, "dy");
    armtol_answer_destroy(answer);
}

/* Sigma deviations of a uniform error: theta alone moves dy. */
static void test_method_rss(void)
{
    one_link one;
    ask_for_tolerances(&one);
    one.question.method = ARMTOL_METHOD_RSS;
    one.question.sigma = 2;
    armtol_answer *answer = answer_of(&one.question);
    check_within(1e-12, 0.005 * sqrt(3) / 2, answer->tolerances[THETA], "theta");
    check_within(1e-9, 1, answer->components[1].deviation, "half of the accuracy of dy");
    armtol_answer_destroy(answer);
}

/* A delta of 0 is the one that armtol_sphere_delta chooses, the lever being the arm's and the tool's length. */
static void test_method_sphere(void)
{
    one_link one;
    double delta;
    armtol_bounds bounds;
    ask_for_tolerances(&one);
    one.question.method = ARMTOL_METHOD_SPHERE;
    one.question.tool.offset[2] = 30;
    armtol_answer *answer = answer_of(&one.question);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                          armtol_sphere_delta(answer->matrices, 1, 4, answer->columns, accuracy, 430, &delta));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                          armtol_sphere_bounds(answer->matrices, 1, 4, answer->columns, accuracy, delta, &bounds));
    check_same(delta, answer->delta, "delta");
    check_same(bounds.distance, answer->bounds.distance, "distance");
    check_same(bounds.angle, answer->bounds.angle, "angle");
    armtol_answer_destroy(answer);
    one.question.delta = 0.5;
    answer = answer_of(&one.question);
    check_same(0.5, answer->delta, "a delta that is given");
    armtol_answer_destroy(answer);
}

static void test_weights(void)
{
    static const double ones[4] = {1, 1, 1, 1}, some[4] = {3, 1, 1, 1};
    one_link one;
    ask_for_tolerances(&one);
    one.question.tool.offset[1] = 50; /* dx is shared between theta and a */
    armtol_answer *without = answer_of(&one.question);
    one.question.weights = ones;
    armtol_answer *with = answer_of(&one.question);
    one.question.weights = some;
    armtol_answer *weighted = answer_of(&one.question);
    TEST_ASSERT_EQUAL_MEMORY(without->tolerances, with->tolerances, 4 * sizeof(double));
    TEST_ASSERT_TRUE(weighted->tolerances[THETA] > without->tolerances[THETA]);
    armtol_answer_destroy(without);
    armtol_answer_destroy(with);
    armtol_answer_destroy(weighted);
}

static void test_an_arm_without_joints_needs_no_joint_values(void)
{
    one_link one;
    ask_for_tolerances(&one);
    one.link.joint = ARMTOL_FIXED;
    one.question.q = NULL;
    armtol_answer *answer = answer_of(&one.question);
    TEST_ASSERT_TRUE(answer->n_joints == 0 && isnan(answer->parts[0].motor));
    armtol_answer_destroy(answer);
}

/* ---- what is refused ---- */

static void test_a_question_that_lacks_something(void)
{
    one_link one;
    ask_for_tolerances(&one);
    armtol_question question = one.question;
    question.arm = NULL;
    check_refused(&question, ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0);
    question = one.question;
    question.q = NULL;
    check_refused(&question, ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0);
    question = one.question;
    question.n_poses = 0;
    check_refused(&question, ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0);
    question = one.question;
    question.accuracy = NULL;
    check_refused(&question, ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0);
}

static void test_an_arm_that_is_none(void)
{
    one_link one;
    ask_for_tolerances(&one);
    one.link.kind = ARMTOL_KIND_COUNT;
    check_refused(&one.question, ARMTOL_BAD_KIND, ARMTOL_ABOUT_ARM, 0);
    one.link.kind = ARMTOL_PPR;
    one.link.joint = ARMTOL_JOINT_COUNT;
    check_refused(&one.question, ARMTOL_BAD_JOINT, ARMTOL_ABOUT_ARM, 0);
    one.link.joint = ARMTOL_REVOLUTE;
    one.link.alpha = NAN;
    check_refused(&one.question, ARMTOL_NOT_FINITE, ARMTOL_ABOUT_ARM, 0);
    one.arm.n_links = 0;
    one.question.q = NULL;
    check_refused(&one.question, ARMTOL_NO_LINKS, ARMTOL_ABOUT_ARM, 0);
}

static void test_a_pose_that_cannot_be_computed_with(void)
{
    one_link one;
    ask_for_tolerances(&one);
    one.question.n_poses = 2;
    one.q[1] = INFINITY;
    check_refused(&one.question, ARMTOL_NOT_FINITE, ARMTOL_ABOUT_POSE, 1);
    one.q[1] = 0;
    one.question.tool.offset[2] = NAN;
    check_refused(&one.question, ARMTOL_NOT_FINITE, ARMTOL_ABOUT_POSE, 0);
}

static void test_an_accuracy_that_is_none(void)
{
    static const double wrong[] = {0, -1, NAN, -(double)INFINITY};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        one_link one;
        double asked[6] = {1, 1, 1, 1, 1, 1};
        ask_for_tolerances(&one);
        asked[4] = wrong[i];
        one.question.accuracy = asked;
        check_refused(&one.question, ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_ACCURACY, 4);
    }
}

static void test_a_method_that_is_none(void)
{
    static const double wrong[] = {0, -1, NAN, INFINITY};
    one_link one;
    ask_for_tolerances(&one);
    one.question.method = ARMTOL_METHOD_COUNT;
    check_refused(&one.question, ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_METHOD, 0);
    one.question.method = ARMTOL_METHOD_RSS;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        one.question.sigma = wrong[i];
        check_refused(&one.question, ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_METHOD, 0);
    }
    one.question.method = ARMTOL_METHOD_SPHERE;
    one.question.delta = 2; /* of a smallest linear accuracy of 2 */
    check_refused(&one.question, ARMTOL_BAD_DELTA, ARMTOL_ABOUT_METHOD, 0);
    one.question.delta = -1;
    check_refused(&one.question, ARMTOL_BAD_DELTA, ARMTOL_ABOUT_METHOD, 0);
    one.question.delta = NAN;
    check_refused(&one.question, ARMTOL_NOT_FINITE, ARMTOL_ABOUT_METHOD, 0);
}

/* Beyond what the optimum computes with. */
static void test_tolerances_that_cannot_be_found(void)
{
    static const double tiny[6] = {1e-300, 1, 1, 1, 1, 1};
    one_link one;
    ask_for_tolerances(&one);
    one.question.accuracy = tiny;
    check_refused(&one.question, ARMTOL_NOT_FINITE, ARMTOL_ABOUT_METHOD, 0);
}

static void test_weights_and_tolerances_that_are_none(void)
{
    static const double wrong[] = {0, -1, NAN, INFINITY};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        one_link one;
        double weights[4] = {1, 1, 1, 1};
        ask_for_tolerances(&one);
        weights[2] = wrong[i];
        one.question.weights = weights;
        check_refused(&one.question, ARMTOL_BAD_WEIGHT, ARMTOL_ABOUT_WEIGHTS, 2);
        if (wrong[i] < 0 || isnan(wrong[i])) {
            one_link_make(&one, 0);
            one.tolerances[3] = wrong[i];
            check_refused(&one.question, ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_TOLERANCES, 3);
        }
    }
}

/* ---- names ---- */

static void test_names(void)
{
    TEST_ASSERT_EQUAL_STRING("worst", armtol_method_name(ARMTOL_METHOD_WORST));
    TEST_ASSERT_EQUAL_STRING("rss", armtol_method_name(ARMTOL_METHOD_RSS));
    TEST_ASSERT_EQUAL_STRING("sphere", armtol_method_name(ARMTOL_METHOD_SPHERE));
    TEST_ASSERT_EQUAL_STRING("?", armtol_method_name(ARMTOL_METHOD_COUNT));
    TEST_ASSERT_EQUAL_STRING("dx", armtol_component_name(0));
    TEST_ASSERT_EQUAL_STRING("wz", armtol_component_name(5));
    TEST_ASSERT_EQUAL_STRING("?", armtol_component_name(6));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_tolerances_of_one_link);
    RUN_TEST(test_an_answer_stands_alone);
    RUN_TEST(test_given_tolerances_are_taken);
    RUN_TEST(test_method_rss);
    RUN_TEST(test_method_sphere);
    RUN_TEST(test_weights);
    RUN_TEST(test_an_arm_without_joints_needs_no_joint_values);
    RUN_TEST(test_a_question_that_lacks_something);
    RUN_TEST(test_an_arm_that_is_none);
    RUN_TEST(test_a_pose_that_cannot_be_computed_with);
    RUN_TEST(test_an_accuracy_that_is_none);
    RUN_TEST(test_a_method_that_is_none);
    RUN_TEST(test_tolerances_that_cannot_be_found);
    RUN_TEST(test_weights_and_tolerances_that_are_none);
    RUN_TEST(test_names);
    armtol_answer_destroy(NULL);
    return UNITY_END();
}
