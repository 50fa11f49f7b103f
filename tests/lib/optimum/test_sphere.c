#include "armtol/sphere.h"

#include "armtol/column_order.h"
#include "armtol/machining.h"
#include "armtol/robots.h"

#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

enum { MOST_COLUMNS = 40 };

/*
 * Lengths and angles mixed; norms of the rows: lengths 5, 13, 1; angles 3, 7, 9, 2, 6, 11 (as in
 * test_bounds).
 */
static const armtol_column columns[5] = {
    {0, ARMTOL_THETA}, {0, ARMTOL_D}, {0, ARMTOL_A}, {0, ARMTOL_ALPHA}, {1, ARMTOL_BETA},
};
static const double matrix[30] = {
    1, 3, 4,  2, 2, /**/
    2, 5, 12, 3, 6, /**/
    1, 1, 0,  4, 8, /**/
    2, 0, 0,  0, 0, /**/
    2, 0, 0,  4, 4, /**/
    2, 0, 0,  6, 9, /**/
};

static armtol_bounds bounds_for(const double limits[6], double delta)
{
    armtol_bounds bounds = {0, 0};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(matrix, 1, 5, columns, limits, delta, &bounds));
    return bounds;
}

static double delta_for(const double limits[6], double lever)
{
    double delta = -1;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_delta(matrix, 1, 5, columns, limits, lever, &delta));
    return delta;
}

/* ---- the bounds ---- */

static void test_each_row_can_set_the_angle_bound(void)
{
    static const double norms[6] = {3, 7, 9, 2, 6, 11};
    for (int row = 0; row < 6; row++) {
        double limits[6] = {100, 100, 100, 100, 100, 100};
        limits[row] = 2;
        check_within(1e-15, (row < 3 ? 1.5 : 2) / norms[row], bounds_for(limits, 0.5).angle, "row %d", row);
    }
}

static void test_only_rows_that_are_not_free_set_bounds(void)
{
    static const double lengths[3] = {5, 13, 1}, angles[6] = {3, 7, 9, 2, 6, 11};
    for (int row = 0; row < 6; row++) {
        double limits[6] = {INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY};
        limits[row] = 2;
        const armtol_bounds bounds = bounds_for(limits, 0.5);
        check_within(1e-15, (row < 3 ? 1.5 : 2) / angles[row], bounds.angle, "angle, row %d", row);
        if (row < 3) {
            check_within(1e-15, 0.5 / lengths[row], bounds.distance, "distance, row %d", row);
        } else {
            TEST_ASSERT_TRUE(isinf(bounds.distance) && bounds.distance > 0);
        }
    }
}

static void test_nothing_is_bounded_where_every_row_is_free(void)
{
    const double limits[6] = {INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY};
    const armtol_bounds bounds = bounds_for(limits, NAN);
    TEST_ASSERT_TRUE(isinf(bounds.distance) && isinf(bounds.angle));
    check_same(0, delta_for(limits, 1), "delta");
}

/* What a free row holds does not matter. */
static void test_a_free_row_may_be_anything(void)
{
    double spoilt[30];
    const double limits[6] = {1, INFINITY, 1, 1, INFINITY, 1};
    const armtol_bounds expected = bounds_for(limits, 0.5);
    armtol_bounds bounds;
    memcpy(spoilt, matrix, sizeof matrix);
    spoilt[5] = NAN;
    spoilt[21] = INFINITY;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(spoilt, 1, 5, columns, limits, 0.5, &bounds));
    check_same(expected.distance, bounds.distance, "distance");
    check_same(expected.angle, bounds.angle, "angle");
}

/* ---- the arms of 1987 ---- */

typedef struct arm_case {
    const armtol_robot *robot;
    double wish[6];
    const char *distance, *angle; /* central differences of Eq. (4.1), worked out apart: test_errata_effects */
} arm_case;

static const arm_case cases[4] = {
    {&armtol_intelledex_605t, {200, 200, 0, 0, 1.57, 0}, "0.049833", "0.000599"},
    {&armtol_intelledex_605t, {-200, 200, 100, 0, 1.57, 0}, "0.051587", "0.000671"},
    {&armtol_adept_one, {200, 200, 0, 0}, "0.043655", "0.000730"},
    {&armtol_adept_one, {-200, 200, 100, 0}, "0.074368", "0.000855"},
};

typedef struct arm {
    double matrix[6 * MOST_COLUMNS];
    armtol_column columns[MOST_COLUMNS];
    size_t n_columns;
} arm;

static void place(const arm_case *arm_case, const armtol_errata *errata, double unit, arm *arm)
{
    const armtol_robot *robot = arm_case->robot;
    armtol_link links[8];
    armtol_reach reach;
    double q[6];
    robot->links(errata, links);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, robot->inverse(arm_case->wish, errata, q, &reach));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(links, robot->n_links, q, robot->n_joints, errata,
                                                        links));
    for (size_t i = 0; i < robot->n_links; i++) {
        links[i].a *= unit;
        links[i].d *= unit;
    }
    arm->n_columns = armtol_column_count(links, robot->n_links);
    TEST_ASSERT_TRUE(arm->n_columns <= MOST_COLUMNS);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_columns(links, robot->n_links, arm->columns, arm->n_columns));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_error_matrix(links, robot->n_links, errata, arm->matrix,
                                                         arm->n_columns));
}

static const double accuracy[6] = {0.5, 0.5, 0.5, 0.1, 0.1, 0.1};

static void check_like_norm_bounds(const arm *arm, const armtol_bounds *bounds)
{
    size_t order[MOST_COLUMNS];
    double ordered[6 * MOST_COLUMNS];
    armtol_bounds expected;
    const size_t n_lengths = armtol_column_order(arm->columns, arm->n_columns, order);
    armtol_reorder(arm->matrix, arm->n_columns, order, ordered);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_norm_bounds(ordered, arm->n_columns, n_lengths, accuracy, 0.1,
                                                        &armtol_errata_none, &expected));
    check_within(1e-14 * expected.distance, expected.distance, bounds->distance, "distance of bounds.h");
    check_within(1e-14 * expected.angle, expected.angle, bounds->angle, "angle of bounds.h");
}

static void test_the_arms_of_1987_have_their_corrected_bounds(void)
{
    for (int i = 0; i < 4; i++) {
        arm arm;
        armtol_bounds bounds;
        place(&cases[i], &armtol_errata_none, 1, &arm);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(arm.matrix, 1, arm.n_columns, arm.columns,
                                                              accuracy, 0.1, &bounds));
        check_printed(cases[i].distance, bounds.distance, "distance, case %d", i);
        check_printed(cases[i].angle, bounds.angle, "angle, case %d", i);
        check_like_norm_bounds(&arm, &bounds);
    }
}

/* docs/errata.md: Intelledex, case 1, all corrected but the point whose motion is meant. */
static void test_the_motion_of_the_body_point_at_the_base(void)
{
    arm arm;
    armtol_bounds bounds;
    armtol_errata errata = armtol_errata_none;
    errata.base_twist = true;
    place(&cases[0], &errata, 1, &arm);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(arm.matrix, 1, arm.n_columns, arm.columns, accuracy,
                                                          0.1, &bounds));
    check_printed("0.043934", bounds.distance, "distance");
    check_printed("0.000625", bounds.angle, "angle");
}

/* ---- tolerances ---- */

static void test_every_parameter_has_an_equal_share_of_its_sphere(void)
{
    double tolerances[5];
    const armtol_bounds bounds = {3, INFINITY}, angles = {INFINITY, 6};
    armtol_sphere_tolerances(columns, 5, &bounds, tolerances);
    check_within(1e-15, 3 / sqrt(2), tolerances[1], "d");
    check_within(1e-15, 3 / sqrt(2), tolerances[2], "a");
    TEST_ASSERT_TRUE(isinf(tolerances[0]) && isinf(tolerances[3]) && isinf(tolerances[4]));
    armtol_sphere_tolerances(columns, 5, &angles, tolerances);
    check_within(1e-15, 6 / sqrt(3), tolerances[0], "theta");
    TEST_ASSERT_TRUE(isinf(tolerances[1]) && isinf(tolerances[2]));
}

/* ---- delta ---- */

/*
 * Row 0 alone: delta / (5 sqrt 2) of a length meets lever (1 - delta) / (3 sqrt 3) of an angle; with a lever
 * of 3 sqrt 3 / (5 sqrt 2) they are the same at 1/2.
 */
static void test_delta_where_a_linear_row_limits_the_angles(void)
{
    const double limits[6] = {1, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY};
    const double lever = 3 * sqrt(3) / (5 * sqrt(2));
    check_within(1e-15, 0.5, delta_for(limits, lever), "even");
    check_within(1e-15, 0.75, delta_for(limits, 3 * lever), "a longer lever leaves more to the lengths");
    check_within(1e-15, 0.25, delta_for(limits, lever / 3), "a shorter one less");
}

/*
 * Row 3 as well: 0.01 / 2 is all that angles get, and row 0 has room for that up to delta = 1 - 3 0.005. A
 * larger delta is no use, a smaller one makes the lengths' tolerances smaller than need be.
 */
static void test_delta_leaves_to_the_lengths_what_angles_cannot_use(void)
{
    const double limits[6] = {1, INFINITY, INFINITY, 0.01, INFINITY, INFINITY};
    check_within(1e-15, 1 - 3 * 0.005, delta_for(limits, 1), "delta");
    check_within(1e-17, 0.005, bounds_for(limits, delta_for(limits, 1)).angle, "angle");
}

static double least_tolerance(const arm *arm, const double limits[6], double lever, double delta)
{
    armtol_bounds bounds;
    double tolerances[MOST_COLUMNS], least = INFINITY;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(arm->matrix, 1, arm->n_columns, arm->columns, limits,
                                                          delta, &bounds));
    armtol_sphere_tolerances(arm->columns, arm->n_columns, &bounds, tolerances);
    for (size_t k = 0; k < arm->n_columns; k++) {
        const bool length = armtol_parameter_is_length(arm->columns[k].parameter);
        least = fmin(least, tolerances[k] * (length ? 1 : lever));
    }
    return least;
}

/* No other delta does better, and a larger one does worse. */
static void check_best(const arm *arm, const double limits[6], double lever, const char *what)
{
    const double smallest = fmin(limits[0], fmin(limits[1], limits[2]));
    double delta;
    const armtol_status status = armtol_sphere_delta(arm->matrix, 1, arm->n_columns, arm->columns, limits, lever,
                                                     &delta);
    TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_OK, status, what);
    TEST_ASSERT_TRUE_MESSAGE(delta > 0 && delta < smallest, what);
    const double best = least_tolerance(arm, limits, lever, delta);
    for (int i = 1; i < 1000; i++) {
        const double other = smallest * i / 1000;
        const double least = least_tolerance(arm, limits, lever, other);
        TEST_ASSERT_TRUE_MESSAGE(least <= best * (1 + 1e-12), what);
        TEST_ASSERT_TRUE_MESSAGE(other <= delta * (1 + 1e-9) || least < best * (1 - 1e-12), what);
    }
}

static void draw(random_source *source, arm *arm, double limits[6])
{
    arm->n_columns = (size_t)random_between(source, 2, MOST_COLUMNS + 1);
    for (size_t k = 0; k < arm->n_columns; k++) {
        const double parameter = random_between(source, 0, ARMTOL_PARAMETER_COUNT);
        arm->columns[k] = (armtol_column){k, k == 0   ? ARMTOL_D
                                             : k == 1 ? ARMTOL_THETA
                                                      : (armtol_parameter)parameter};
        const bool length = armtol_parameter_is_length(arm->columns[k].parameter);
        for (size_t i = 0; i < 6; i++) {
            const double scale = i < 3 ? length ? 1 : 500 : length ? 0 : 1;
            arm->matrix[i * arm->n_columns + k] = scale * random_between(source, -1, 1);
        }
    }
    for (size_t i = 0; i < 6; i++) {
        limits[i] = i < 3 ? random_between(source, 0.1, 1) : random_between(source, 1e-4, 3e-3);
        if (i > 0 && random_between(source, 0, 1) < 0.3) {
            limits[i] = INFINITY;
        }
    }
}

static void test_no_other_delta_is_better(void)
{
    random_source source = {1};
    for (int round = 0; round < 60; round++) {
        arm arm;
        double limits[6];
        draw(&source, &arm, limits);
        check_best(&arm, limits, random_between(&source, 10, 2000), "random");
    }
    for (int i = 0; i < 4; i++) {
        arm arm;
        place(&cases[i], &armtol_errata_none, 1, &arm);
        check_best(&arm, accuracy, 800, "arm of 1987");
    }
}

static void test_units_do_not_matter(void)
{
    arm millimetres, metres;
    double one, other;
    const double limits[6] = {0.5, 0.4, 0.3, 1e-3, 1e-3, 1e-3};
    const double in_metres[6] = {5e-4, 4e-4, 3e-4, 1e-3, 1e-3, 1e-3};
    place(&cases[0], &armtol_errata_none, 1, &millimetres);
    place(&cases[0], &armtol_errata_none, 1e-3, &metres);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_delta(millimetres.matrix, 1, millimetres.n_columns,
                                                         millimetres.columns, limits, 800, &one));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_delta(metres.matrix, 1, metres.n_columns, metres.columns,
                                                         in_metres, 0.8, &other));
    check_within(1e-13 * one, one, 1000 * other, "delta");
}

/* ---- classes that are missing ---- */

static void test_without_lengths_all_is_left_to_the_angles(void)
{
    static const armtol_column angles[2] = {{0, ARMTOL_THETA}, {0, ARMTOL_ALPHA}};
    static const double two[12] = {3, 4, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1};
    const double limits[6] = {1, 1, 1, 1, 1, 1};
    double delta = -1, tolerances[2];
    armtol_bounds bounds;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_delta(two, 1, 2, angles, limits, 1, &delta));
    check_same(0, delta, "delta");
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(two, 1, 2, angles, limits, delta, &bounds));
    check_within(1e-16, 0.2, bounds.angle, "angle");
    TEST_ASSERT_TRUE(isinf(bounds.distance));
    armtol_sphere_tolerances(angles, 2, &bounds, tolerances);
    check_within(1e-16, 0.2 / sqrt(2), tolerances[0], "theta");
}

static void test_without_angles_all_is_left_to_the_lengths(void)
{
    static const armtol_column lengths[2] = {{0, ARMTOL_D}, {0, ARMTOL_A}};
    static const double two[12] = {3, 4, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0};
    const double limits[6] = {1, 0.5, INFINITY, 1, 1, 1};
    double delta = -1;
    armtol_bounds bounds;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_delta(two, 1, 2, lengths, limits, 1, &delta));
    TEST_ASSERT_TRUE(delta < 0.5);
    check_within(1e-15, 0.5, delta, "delta");
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(two, 1, 2, lengths, limits, delta, &bounds));
    check_within(1e-15, 0.2, bounds.distance, "distance: 1 / 5, or 0.5 / 1");
    TEST_ASSERT_TRUE(isinf(bounds.angle));
}

/* Angles move row 0, whose limit is far; row 1, which is near, they do not. */
static void test_a_near_row_that_angles_do_not_move(void)
{
    static const armtol_column both[2] = {{0, ARMTOL_D}, {0, ARMTOL_THETA}};
    static const double two[12] = {1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    const double limits[6] = {100, 1, INFINITY, INFINITY, INFINITY, INFINITY};
    double delta = -1;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_delta(two, 1, 2, both, limits, 1, &delta));
    TEST_ASSERT_TRUE(delta < 1);
    check_within(1e-15, 1, delta, "delta");
}

/* A row that no length moves asks for all of its limit for the angles: next to nothing is kept. */
static void test_a_row_without_lengths_leaves_no_delta(void)
{
    static const armtol_column both[2] = {{0, ARMTOL_D}, {0, ARMTOL_THETA}};
    static const double two[12] = {1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1};
    const double limits[6] = {100, 1, INFINITY, INFINITY, INFINITY, INFINITY};
    double delta = -1;
    armtol_bounds bounds;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_delta(two, 1, 2, both, limits, 1, &delta));
    TEST_ASSERT_TRUE(delta > 0 && delta < 1e-15);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(two, 1, 2, both, limits, delta, &bounds));
    check_within(1e-15, 1, bounds.angle, "angle");
    check_within(1e-13, 100, bounds.distance, "distance");
}

/* ---- errors ---- */

static void check_refused(armtol_status expected, const double elements[], const double limits[6],
                          double delta, const char *what)
{
    armtol_bounds bounds = {42, 42};
    const armtol_status status = armtol_sphere_bounds(elements, 1, 5, columns, limits, delta, &bounds);
    TEST_ASSERT_EQUAL_INT_MESSAGE(expected, status, what);
    check_same(42, bounds.distance, "%s: distance", what);
    check_same(42, bounds.angle, "%s: angle", what);
}

static void check_delta_refused(armtol_status expected, const double elements[], const double limits[6],
                                double lever, const char *what)
{
    double delta = 42;
    const armtol_status status = armtol_sphere_delta(elements, 1, 5, columns, limits, lever, &delta);
    TEST_ASSERT_EQUAL_INT_MESSAGE(expected, status, what);
    check_same(42, delta, "%s: delta", what);
}

static void test_wrong_limits_are_refused(void)
{
    static const struct {
        double limit;
        armtol_status status;
    } wrong[4] = {{NAN, ARMTOL_NOT_FINITE}, {0, ARMTOL_BAD_TOLERANCE}, {-1, ARMTOL_BAD_TOLERANCE},
                  {-INFINITY, ARMTOL_BAD_TOLERANCE}};
    for (int row = 0; row < 6; row++) {
        for (int i = 0; i < 4; i++) {
            double limits[6] = {1, 1, 1, 1, 1, 1};
            limits[row] = wrong[i].limit;
            check_refused(wrong[i].status, matrix, limits, 0.5, "limit");
            check_delta_refused(wrong[i].status, matrix, limits, 1, "limit");
        }
    }
}

static void test_delta_lies_between_zero_and_the_smallest_linear_limit(void)
{
    for (int row = 0; row < 3; row++) {
        double limits[6] = {INFINITY, 2, 2, 0.1, 0.1, 0.1};
        limits[row] = 1;
        check_refused(ARMTOL_BAD_DELTA, matrix, limits, 0, "0");
        check_refused(ARMTOL_BAD_DELTA, matrix, limits, -0.1, "negative");
        check_refused(ARMTOL_BAD_DELTA, matrix, limits, 1, "the limit");
        check_refused(ARMTOL_BAD_DELTA, matrix, limits, INFINITY, "infinite");
        check_refused(ARMTOL_NOT_FINITE, matrix, limits, NAN, "nan");
        bounds_for(limits, 0.999);
    }
}

static void test_elements_and_norms_that_are_not_finite_are_told(void)
{
    static const double wrong[3] = {NAN, INFINITY, 1e200};
    const double limits[6] = {1, 1, 1, 1, 1, 1};
    for (size_t at = 0; at < 30; at++) {
        for (int i = 0; i < 3; i++) {
            double spoilt[30];
            memcpy(spoilt, matrix, sizeof matrix);
            spoilt[at] = wrong[i];
            check_refused(ARMTOL_NOT_FINITE, spoilt, limits, 0.5, "element");
            check_delta_refused(ARMTOL_NOT_FINITE, spoilt, limits, 1, "element");
        }
    }
}

static void test_wrong_levers_are_refused(void)
{
    const double limits[6] = {1, 1, 1, 1, 1, 1};
    check_delta_refused(ARMTOL_NOT_FINITE, matrix, limits, NAN, "nan");
    check_delta_refused(ARMTOL_NOT_FINITE, matrix, limits, INFINITY, "infinite");
    check_delta_refused(ARMTOL_BAD_WEIGHT, matrix, limits, 0, "0");
    check_delta_refused(ARMTOL_BAD_WEIGHT, matrix, limits, -1, "negative");
}

static void test_a_delta_that_underflows_is_told(void)
{
    const double limits[6] = {1e-320, 1, 1, 1, 1, 1};
    check_delta_refused(ARMTOL_NOT_FINITE, matrix, limits, 1e-100, "short lever");
}

/* ---- several poses ---- */

/* The radius that the rows of one pose of two columns leave the length, beside that of the angle. */
static double left_in(const double pose[12], const double limits[6], double angle)
{
    double radius = INFINITY;
    for (int i = 0; i < 3; i++) {
        radius = fmin(radius, (limits[i] - pose[2 * i + 1] * angle) / pose[2 * i]);
    }
    return radius;
}

/*
 * The angle bound of two poses is the least of each, and each leaves the lengths what it does at that bound; delta is
 * the best one for both, found again by trying.
 */
static void test_several_poses_have_the_least_bounds_and_one_delta(void)
{
    const double two[2 * 6 * 2] = {1, 100, 2, 300, 1, 50, 0, 1, 0, 1, 0, 1, 4, 20, 1, 700, 2, 40, 0, 2, 0, 1, 0, 3};
    const armtol_column both[2] = {{0, ARMTOL_D}, {0, ARMTOL_THETA}};
    const double limits[6] = {.5, .6, .7, .02, .02, .02}, lever = 400;
    armtol_bounds first, second, together, tried;
    double delta, best = 0;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(two, 1, 2, both, limits, .2, &first));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(two + 12, 1, 2, both, limits, .2, &second));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(two, 2, 2, both, limits, .2, &together));
    check_same(fmin(first.angle, second.angle), together.angle, "angle");
    TEST_ASSERT_TRUE(first.angle > second.angle);
    const double in_first = left_in(two, limits, together.angle), in_second = left_in(two + 12, limits, together.angle);
    check_within(1e-15, fmin(in_first, in_second), together.distance, "distance");
    TEST_ASSERT_TRUE(in_first > in_second && together.distance > second.distance * (1 - 1e-15));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_delta(two, 2, 2, both, limits, lever, &delta));
    for (int i = 1; i < 500; i++) {
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(two, 2, 2, both, limits, i * .001, &tried));
        best = fmax(best, fmin(tried.distance, lever * tried.angle));
    }
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sphere_bounds(two, 2, 2, both, limits, delta, &tried));
    const double reached = fmin(tried.distance, lever * tried.angle);
    TEST_ASSERT_TRUE(reached >= best && reached < best * 1.02);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_each_row_can_set_the_angle_bound);
    RUN_TEST(test_only_rows_that_are_not_free_set_bounds);
    RUN_TEST(test_nothing_is_bounded_where_every_row_is_free);
    RUN_TEST(test_a_free_row_may_be_anything);
    RUN_TEST(test_the_arms_of_1987_have_their_corrected_bounds);
    RUN_TEST(test_the_motion_of_the_body_point_at_the_base);
    RUN_TEST(test_every_parameter_has_an_equal_share_of_its_sphere);
    RUN_TEST(test_delta_where_a_linear_row_limits_the_angles);
    RUN_TEST(test_delta_leaves_to_the_lengths_what_angles_cannot_use);
    RUN_TEST(test_no_other_delta_is_better);
    RUN_TEST(test_units_do_not_matter);
    RUN_TEST(test_without_lengths_all_is_left_to_the_angles);
    RUN_TEST(test_without_angles_all_is_left_to_the_lengths);
    RUN_TEST(test_a_near_row_that_angles_do_not_move);
    RUN_TEST(test_a_row_without_lengths_leaves_no_delta);
    RUN_TEST(test_wrong_limits_are_refused);
    RUN_TEST(test_delta_lies_between_zero_and_the_smallest_linear_limit);
    RUN_TEST(test_elements_and_norms_that_are_not_finite_are_told);
    RUN_TEST(test_wrong_levers_are_refused);
    RUN_TEST(test_a_delta_that_underflows_is_told);
    RUN_TEST(test_several_poses_have_the_least_bounds_and_one_delta);
    return UNITY_END();
}
