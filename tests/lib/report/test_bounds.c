#include "armtol/bounds.h"

#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* Two lengths, three angles; norms of the rows: lengths 5, 13, 1; angles 3, 7, 9, 2, 6, 11. */
static const double ordered[30] = {
    3, 4,  1, 2, 2, /**/
    5, 12, 2, 3, 6, /**/
    1, 0,  1, 4, 8, /**/
    0, 0,  2, 0, 0, /**/
    0, 0,  2, 4, 4, /**/
    0, 0,  2, 6, 9, /**/
};

static armtol_bounds bounds_for(const double tolerances[6], double delta)
{
    armtol_bounds bounds = {0, 0};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_norm_bounds(ordered, 5, 2, tolerances, delta,
                                                        &armtol_errata_none, &bounds));
    return bounds;
}

static void test_each_row_can_set_the_angle_bound(void)
{
    static const double norms[6] = {3, 7, 9, 2, 6, 11};
    for (int row = 0; row < 6; row++) {
        double tolerances[6] = {100, 100, 100, 100, 100, 100};
        tolerances[row] = 2;
        const double allowed = row < 3 ? 2 - 0.5 : 2;
        check_within(1e-15, allowed / norms[row], bounds_for(tolerances, 0.5).angle, "row %d", row);
    }
}

/* tol[i] - delta of 1987 goes into tol[], a float, before it is divided. */
static void test_1987_stores_what_delta_leaves(void)
{
    random_source source = {3};
    for (int n = 0; n < 100; n++) {
        const float e = (float)random_between(&source, 0.5, 1), delta = (float)random_between(&source, 0, 0.5);
        const double tolerances[6] = {100, (double)e, 100, 100, 100, 100};
        armtol_bounds bounds;
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_norm_bounds(ordered, 5, 2, tolerances, (double)delta,
                                                            &armtol_errata_1987, &bounds));
        const float left = (float)((double)e - (double)delta);
        check_same((double)(float)((double)left / 7), bounds.angle, "draw %d", n);
    }
}

/* Row 2 sets the angle bound, 0.5 / 9; it leaves row 1 1 - 7 (0.5 / 9) for its lengths, whose norm is 13. */
static void test_what_the_angles_leave_sets_the_distance_bound(void)
{
    const double tolerances[6] = {1, 1, 1, 1, 1, 1};
    check_within(1e-15, (1 - 7 * (0.5 / 9)) / 13, bounds_for(tolerances, 0.5).distance, "distance bound");
}

/* Row 5 allows the angles but 0.011 / 11: what delta is does not matter. */
static void test_the_lengths_get_what_rotations_keep_the_angles_from(void)
{
    const double tolerances[6] = {1, 1, 1, 1, 1, 0.011};
    check_within(1e-15, (1 - 7 * 0.001) / 13, bounds_for(tolerances, 0.5).distance, "distance bound");
    check_within(1e-15, (1 - 7 * 0.001) / 13, bounds_for(tolerances, 0.1).distance, "distance bound");
}

/* Each row can be the one: its tolerance is the near one. Then it sets the angle bound too, and delta is left. */
static void test_each_row_can_set_the_distance_bound(void)
{
    static const double norms[3] = {5, 13, 1};
    for (int row = 0; row < 3; row++) {
        double tolerances[6] = {1000, 1000, 1000, 1000, 1000, 1000};
        tolerances[row] = 2;
        check_within(1e-15, 0.5 / norms[row], bounds_for(tolerances, 0.5).distance, "row %d", row);
    }
}

/* What the angles leave is delta in the row that binds, though the difference may round to 0, below or above. */
static void test_a_delta_far_below_the_tolerance_is_left(void)
{
    for (int i = 1; i < 200; i++) {
        const double e = 0.1 * i;
        const double tolerances[6] = {1000 * e, 1000 * e, e, 1000 * e, 1000 * e, 1000 * e};
        const double distance = bounds_for(tolerances, 1e-300).distance;
        TEST_ASSERT_TRUE(distance >= 1e-300 && distance < 1e-15 * e);
    }
}

static void test_in_1987_the_longest_row_sets_the_distance_bound(void)
{
    const double tolerances[6] = {1, 1, 1, 1, 1, 0.011};
    armtol_errata errata = armtol_errata_none;
    armtol_bounds bounds;
    errata.distance_share = true;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_norm_bounds(ordered, 5, 2, tolerances, 0.5, &errata, &bounds));
    check_within(1e-15, 0.5 / 13, bounds.distance, "distance bound");
}

/* In other units of length and angle the numbers may be of any size. */
static void test_bounds_are_inverse_to_the_matrix(void)
{
    static const double scales[] = {1e-9, 1e-3, 0.01, 100};
    const double tolerances[6] = {1, 1, 1, 1, 1, 1};
    const armtol_bounds usual = bounds_for(tolerances, 0.5);
    for (size_t k = 0; k < sizeof scales / sizeof scales[0]; k++) {
        double matrix[30];
        armtol_bounds bounds;
        for (int i = 0; i < 30; i++) {
            matrix[i] = scales[k] * ordered[i];
        }
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_norm_bounds(matrix, 5, 2, tolerances, 0.5, &armtol_errata_none,
                                                            &bounds));
        check_within(1e-14 * usual.distance / scales[k], usual.distance / scales[k], bounds.distance, "%g", scales[k]);
        check_within(1e-14 * usual.angle / scales[k], usual.angle / scales[k], bounds.angle, "%g", scales[k]);
    }
}

static void test_an_arm_without_lengths_or_angles_is_not_bound_by_them(void)
{
    const double tolerances[6] = {1, 1, 1, 1, 1, 1};
    armtol_bounds bounds;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_norm_bounds(ordered, 5, 0, tolerances, 0.5, &armtol_errata_none,
                                                        &bounds));
    TEST_ASSERT_TRUE(isinf(bounds.distance) && bounds.distance > 0);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_norm_bounds(ordered, 5, 5, tolerances, 0.5, &armtol_errata_none,
                                                        &bounds));
    TEST_ASSERT_TRUE(isinf(bounds.angle) && bounds.angle > 0);
}

static void check_refused(armtol_status expected, const double tolerances[6], double delta)
{
    armtol_bounds bounds = {42, 42};
    TEST_ASSERT_EQUAL_INT(expected, armtol_tolerances_check(tolerances, delta));
    TEST_ASSERT_EQUAL_INT(expected, armtol_norm_bounds(ordered, 5, 2, tolerances, delta, &armtol_errata_1987,
                                                       &bounds));
    check_same(42, bounds.distance, "the output after an error");
}

static void test_each_tolerance_has_to_be_positive_and_finite(void)
{
    for (int i = 0; i < 6; i++) {
        double tolerances[6] = {1, 1, 1, 1, 1, 1};
        tolerances[i] = 0;
        check_refused(ARMTOL_BAD_TOLERANCE, tolerances, 0.5);
        tolerances[i] = -1;
        check_refused(ARMTOL_BAD_TOLERANCE, tolerances, 0.5);
        tolerances[i] = NAN;
        check_refused(ARMTOL_NOT_FINITE, tolerances, 0.5);
        tolerances[i] = INFINITY;
        check_refused(ARMTOL_NOT_FINITE, tolerances, 0.5);
    }
}

static void test_delta_lies_between_zero_and_the_smallest_linear_tolerance(void)
{
    for (int i = 0; i < 3; i++) {
        double tolerances[6] = {2, 2, 2, 0.1, 0.1, 0.1};
        tolerances[i] = 1;
        check_refused(ARMTOL_BAD_DELTA, tolerances, 0);
        check_refused(ARMTOL_BAD_DELTA, tolerances, -0.1);
        check_refused(ARMTOL_BAD_DELTA, tolerances, 1);
        check_refused(ARMTOL_BAD_DELTA, tolerances, 1.5);
        check_refused(ARMTOL_NOT_FINITE, tolerances, NAN);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tolerances_check(tolerances, 0.999));
    }
}

static void test_more_lengths_than_columns_are_refused(void)
{
    const double tolerances[6] = {1, 1, 1, 1, 1, 1};
    armtol_bounds bounds;
    TEST_ASSERT_EQUAL_INT(ARMTOL_WRONG_SIZE, armtol_norm_bounds(ordered, 5, 6, tolerances, 0.5,
                                                                &armtol_errata_none, &bounds));
}

/* In double 1e200 squared overflows, in float 1e20 does: no bound may come out of such a row. */
static void test_a_norm_that_overflows_is_told(void)
{
    const double tolerances[6] = {1, 1, 1, 1, 1, 1};
    for (int i = 0; i < 30; i++) {
        double matrix[30];
        armtol_bounds bounds = {42, 42};
        memcpy(matrix, ordered, sizeof matrix);
        matrix[i] = 1e20;
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_norm_bounds(matrix, 5, 2, tolerances, 0.5,
                                                            &armtol_errata_none, &bounds));
        bounds.angle = 42;
        TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_norm_bounds(matrix, 5, 2, tolerances, 0.5,
                                                                    &armtol_errata_1987, &bounds));
        matrix[i] = i % 2 == 0 ? 1e200 : (double)NAN;
        TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_norm_bounds(matrix, 5, 2, tolerances, 0.5,
                                                                    &armtol_errata_none, &bounds));
        check_same(42, bounds.angle, "the output after an error");
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_each_row_can_set_the_angle_bound);
    RUN_TEST(test_1987_stores_what_delta_leaves);
    RUN_TEST(test_what_the_angles_leave_sets_the_distance_bound);
    RUN_TEST(test_the_lengths_get_what_rotations_keep_the_angles_from);
    RUN_TEST(test_each_row_can_set_the_distance_bound);
    RUN_TEST(test_a_delta_far_below_the_tolerance_is_left);
    RUN_TEST(test_in_1987_the_longest_row_sets_the_distance_bound);
    RUN_TEST(test_bounds_are_inverse_to_the_matrix);
    RUN_TEST(test_an_arm_without_lengths_or_angles_is_not_bound_by_them);
    RUN_TEST(test_each_tolerance_has_to_be_positive_and_finite);
    RUN_TEST(test_delta_lies_between_zero_and_the_smallest_linear_tolerance);
    RUN_TEST(test_more_lengths_than_columns_are_refused);
    RUN_TEST(test_a_norm_that_overflows_is_told);
    return UNITY_END();
}
