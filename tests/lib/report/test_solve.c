#include "armtol/solve.h"

#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>

static const armtol_errata *const corrected = &armtol_errata_none;

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_the_answer_solves_the_equation(void)
{
    random_source source = {1};
    for (int n = 0; n < 1000; n++) {
        const double px = random_between(&source, -400, 400), py = random_between(&source, -400, 400);
        const double d = n % 10 == 0 ? 0 : random_between(&source, -1, 1) * hypot(px, py);
        double theta;
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_solve(px, py, d, 0, corrected, &theta));
        check_within(1e-10, d, px * cos(theta) + py * sin(theta), "draw %d", n);
    }
}

/* cos theta = 1/2 has +-pi/3; in the form of the routine they are pi/2 - atan2(1/2, +-sqrt(3)/2). */
static void test_of_two_answers_the_closer_one_comes(void)
{
    const double third = 3.141592653589793 / 3;
    double theta;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_solve(1, 0, 0.5, 2, corrected, &theta));
    check_within(1e-15, third, theta, "close to 2");
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_solve(1, 0, 0.5, -2, corrected, &theta));
    check_within(1e-15, -third, theta, "close to -2");
}

static void test_on_a_tie_the_first_answer_comes(void)
{
    /* sin theta = 1/2: pi/6 first, 5 pi/6 second, both pi/3 away from pi/2 (in numbers that tie exactly) */
    double theta, first, second;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_solve(1, 0, 0.5, 100, corrected, &first));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_solve(1, 0, 0.5, -100, corrected, &second));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_solve(1, 0, 0.5, (first + second) / 2, corrected, &theta));
    check_same(first, theta, "halfway");
}

/* 1e-9 beside the middle the squared distances differ by less than a float holds: a tie in 1987, none corrected. */
static void test_1987_compares_squared_distances_as_floats(void)
{
    const armtol_errata *const kept = &armtol_errata_1987;
    double theta, first, second;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_solve(1, 0, 0.5, 100, kept, &first));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_solve(1, 0, 0.5, -100, kept, &second));
    TEST_ASSERT_TRUE(first != second && first == (double)(float)first && second == (double)(float)second);
    const double beside = (first + second) / 2 + (second > first ? 1e-9 : -1e-9);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_solve(1, 0, 0.5, beside, kept, &theta));
    check_same(first, theta, "kept: a tie");
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_solve(1, 0, 0.5, beside, corrected, &theta));
    check_within(1e-6, second, theta, "corrected: the closer one");
}

static void test_at_the_edge_there_is_one_answer(void)
{
    double theta;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_solve(3, 4, 5, 0, corrected, &theta));
    check_within(1e-15, atan2(4, 3), theta, "theta");
}

static void test_what_has_no_answer_is_told(void)
{
    double theta = 42;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OUT_OF_REACH, armtol_solve(3, 4, 5.001, 0, corrected, &theta));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OUT_OF_REACH, armtol_solve(3, 4, -5.001, 0, corrected, &theta));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OUT_OF_REACH, armtol_solve(0, 0, 1, 0, corrected, &theta));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OUT_OF_REACH, armtol_solve(1e200, 1e200, 1e200, 0, corrected, &theta));
    TEST_ASSERT_EQUAL_INT(ARMTOL_SINGULAR, armtol_solve(0, -0.0, 0, 0, corrected, &theta));
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_solve(NAN, 1, 0, 0, corrected, &theta));
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_solve(1, INFINITY, 0, 0, corrected, &theta));
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_solve(1, 1, -INFINITY, 0, corrected, &theta));
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_solve(1, 1, 0, NAN, corrected, &theta));
    check_same(42, theta, "the output after an error");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_answer_solves_the_equation);
    RUN_TEST(test_of_two_answers_the_closer_one_comes);
    RUN_TEST(test_on_a_tie_the_first_answer_comes);
    RUN_TEST(test_1987_compares_squared_distances_as_floats);
    RUN_TEST(test_at_the_edge_there_is_one_answer);
    RUN_TEST(test_what_has_no_answer_is_told);
    return UNITY_END();
}
