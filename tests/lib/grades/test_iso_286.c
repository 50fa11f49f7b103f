#include "armtol/grades.h"

#include "other_programs.h"
#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>
#include <stddef.h>

#define MICROMETRE 1e-3

static const double ends[] = {1, 3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500};

enum { STEPS = sizeof ends / sizeof ends[0] - 1 };

void setUp(void)
{
}

void tearDown(void)
{
}

static armtol_range limits_of(const char *name, double size)
{
    armtol_grade grade = {0, ARMTOL_ZONE_COUNT};
    TEST_ASSERT_EQUAL_MESSAGE(ARMTOL_OK, armtol_grade_read(name, &grade), name);
    return armtol_grade_limits(&grade, size);
}

static void compare(const other_program programs[], size_t n, const double sizes[], size_t n_sizes)
{
    for (size_t i = 0; i < n; i++) {
        const other_program *of = &programs[i];
        for (size_t step = 0; step < n_sizes; step++) {
            const armtol_range limits = limits_of(of->name, sizes[step]);
            check_within(1e-12, of->limits[step] * MICROMETRE, of->is_lower ? limits.low : limits.high, "%s of %g mm",
                         of->name, sizes[step]);
        }
    }
}

static void test_limits_are_those_of_other_programs(void)
{
    compare(pressfit, sizeof pressfit / sizeof pressfit[0], pressfit_sizes, 13);
    compare(isofits, sizeof isofits / sizeof isofits[0], isofits_sizes, 11);
}

/* A hole's lower limit and a shaft's upper one are the nominal size; IT, JS and js have half to either side. */
static void test_zones(void)
{
    check_same(0, limits_of("H7", 40).low, "a hole");
    check_same(0, limits_of("h7", 40).high, "a shaft");
    static const char *const even[] = {"IT12", "JS12", "js12"};
    for (int i = 0; i < 3; i++) {
        check_within(1e-15, -0.125, limits_of(even[i], 40).low, "%s", even[i]);
        check_within(1e-15, 0.125, limits_of(even[i], 40).high, "%s", even[i]);
    }
}

/* As the standard derives them: D is the geometric mean of a step, the first one being 1 to 3 mm. */
static double derived(int grade, size_t step)
{
    static const double factors[] = {7, 10, 16, 25, 40, 64, 100, 160};
    const double d = sqrt(ends[step] * ends[step + 1]);
    return factors[grade - 5] * (0.45 * cbrt(d) + 0.001 * d);
}

/* To 1 micrometre up to 100, to 5 up to 200, to 10 above. */
static double rounded(double width)
{
    const double unit = width <= 100 ? 1 : width <= 200 ? 5 : 10;
    return unit * floor(width / unit + 0.5);
}

/*
 * Most of IT5 to IT10 are so, and the others are wider: by up to 16 % in the first steps, and 4 % at most elsewhere.
 * IT11 and IT12 are made of IT6 and IT7; see below.
 */
static void test_widths_are_those_of_the_tolerance_factor(void)
{
    int same = 0;
    for (int grade = 5; grade <= 10; grade++) {
        for (size_t step = 0; step < STEPS; step++) {
            const double width = armtol_grade_width(grade, ends[step + 1]) / MICROMETRE;
            const double of_factor = derived(grade, step);
            if (fabs(width - rounded(of_factor)) < 1e-9) {
                same++;
            } else {
                TEST_ASSERT_TRUE(width > of_factor);
                check_within(ends[step + 1] <= 6 ? 0.16 : 0.045, 1, width / of_factor, "IT%d to %g mm", grade,
                             ends[step + 1]);
            }
        }
    }
    TEST_ASSERT_EQUAL(64, same); /* of 78: 4 each of IT6, IT7 and IT10 and 2 of IT9 are wider */
}

/* From IT6 on every fifth grade is ten times as wide, but IT11 of 3 to 6 mm, which ISO 286-1 says is 75 micrometres. */
static void test_every_fifth_grade_is_ten_times_as_wide(void)
{
    for (size_t step = 0; step < STEPS; step++) {
        const double size = ends[step + 1];
        check_within(1e-12, size == 6 ? 0.075 : 10 * armtol_grade_width(6, size), armtol_grade_width(11, size),
                     "IT11 to %g mm", size);
        check_within(1e-12, 10 * armtol_grade_width(7, size), armtol_grade_width(12, size), "IT12 to %g mm", size);
    }
}

/* A step ends with its upper end; what is equal on paper, 120 mm from inches, is. */
static void test_steps_end_with_their_upper_end(void)
{
    check_same(0.035, armtol_grade_width(7, 120), "at the end");
    check_same(0.035, armtol_grade_width(7, 120 / 25.4 * 25.4), "through inches");
    check_same(0.035, armtol_grade_width(7, 120 * (1 + 4e-16)), "an ulp above it");
    check_same(0.040, armtol_grade_width(7, 120 + 1e-9), "above it");
    check_same(0.035, armtol_grade_width(7, -120), "a length below 0");
    check_same(0.010, armtol_grade_width(7, 1e-9), "the first step begins at 0");
}

static void test_what_has_no_grade(void)
{
    static const double sizes[] = {0, 500.001, 1e300};
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_TRUE(isnan(armtol_grade_width(7, sizes[i])));
        TEST_ASSERT_EQUAL(ARMTOL_GRADE_NONE, armtol_grade_within(sizes[i], 1));
        TEST_ASSERT_TRUE(isnan(limits_of("H7", sizes[i]).low) && isnan(limits_of("H7", sizes[i]).high));
    }
    TEST_ASSERT_TRUE(isnan(armtol_grade_width(7, (double)NAN)));
    TEST_ASSERT_TRUE(isnan(armtol_grade_width(4, 10)) && isnan(armtol_grade_width(13, 10)));
    TEST_ASSERT_TRUE(isnan(limits_of("h6", -10).low));
    TEST_ASSERT_EQUAL(ARMTOL_GRADE_NONE, armtol_grade_within(10, (double)NAN));
    const armtol_grade no_zone = {7, ARMTOL_ZONE_COUNT};
    TEST_ASSERT_TRUE(isnan(armtol_grade_limits(&no_zone, 10).low) && isnan(armtol_grade_limits(&no_zone, 10).high));
}

/* Rounded down: its half is within, and that of the next one is not. */
static void test_the_widest_grade_that_a_tolerance_holds(void)
{
    random_source random = {286};
    int seen[ARMTOL_GRADE_WIDER + 1] = {0};
    for (int i = 0; i < 20000; i++) {
        const double size = random_between(&random, -500, 500);
        const double tolerance = pow(10, random_between(&random, -3, 0.5));
        const int grade = armtol_grade_within(size, tolerance);
        seen[grade]++;
        if (grade >= 5 && grade <= 12) {
            TEST_ASSERT_TRUE(armtol_grade_width(grade, size) / 2 <= tolerance);
        }
        if (grade < 12) {
            TEST_ASSERT_TRUE(armtol_grade_width(grade + 1, size) / 2 > tolerance);
        }
        if (grade == 12) { /* IT13 is 250 i */
            TEST_ASSERT_TRUE(10 * armtol_grade_width(8, size) / 2 > tolerance);
        }
    }
    for (int grade = ARMTOL_GRADE_FINER; grade <= ARMTOL_GRADE_WIDER; grade++) {
        TEST_ASSERT_TRUE(seen[grade] > 100);
    }
}

/* 100 mm: IT5 15, IT7 35, IT12 350, IT13 540 micrometres (ISO 286-1, table 1). */
static void test_grades_within_tolerances_of_100_mm(void)
{
    TEST_ASSERT_EQUAL(ARMTOL_GRADE_FINER, armtol_grade_within(100, 0.00749));
    TEST_ASSERT_EQUAL(5, armtol_grade_within(100, 0.0075));
    TEST_ASSERT_EQUAL(6, armtol_grade_within(100, 0.0174));
    TEST_ASSERT_EQUAL(7, armtol_grade_within(100, 0.0175));
    TEST_ASSERT_EQUAL(7, armtol_grade_within(100, 0.0175 / 25.4 * 25.4 * (1 - 3e-16)));
    TEST_ASSERT_EQUAL(12, armtol_grade_within(100, 0.175));
    TEST_ASSERT_EQUAL(12, armtol_grade_within(100, 0.2699));
    TEST_ASSERT_EQUAL(ARMTOL_GRADE_WIDER, armtol_grade_within(100, 0.27));
    TEST_ASSERT_EQUAL(ARMTOL_GRADE_WIDER, armtol_grade_within(100, (double)INFINITY));
    TEST_ASSERT_EQUAL(ARMTOL_GRADE_FINER, armtol_grade_within(100, 0));
}

static void test_other_names_are_refused(void)
{
    static const char *const names[] = {"",   "7",    "IT",  "IT4",  "IT13", "IT 7", "it7", "IT07", "IT7 ",
                                        "g6", "G7",   "Js7", "H",    "h4",   "H13",  "K7",  "H7.",  "IT-7",
                                        "J7", "H+7",  "jS7", "H7h6", "p6"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        armtol_grade grade = {42, ARMTOL_ZONE_BELOW};
        TEST_ASSERT_EQUAL_MESSAGE(ARMTOL_BAD_GRADE, armtol_grade_read(names[i], &grade), names[i]);
        TEST_ASSERT_EQUAL(42, grade.grade);
    }
    TEST_ASSERT_EQUAL_STRING("no such grade; known are IT, H, h, JS and js with a number from 5 to 12",
                             armtol_status_text(ARMTOL_BAD_GRADE));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_limits_are_those_of_other_programs);
    RUN_TEST(test_zones);
    RUN_TEST(test_widths_are_those_of_the_tolerance_factor);
    RUN_TEST(test_every_fifth_grade_is_ten_times_as_wide);
    RUN_TEST(test_steps_end_with_their_upper_end);
    RUN_TEST(test_what_has_no_grade);
    RUN_TEST(test_the_widest_grade_that_a_tolerance_holds);
    RUN_TEST(test_grades_within_tolerances_of_100_mm);
    RUN_TEST(test_other_names_are_refused);
    return UNITY_END();
}
