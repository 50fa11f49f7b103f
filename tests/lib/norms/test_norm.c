#include "armtol/arm.h"
#include "armtol/norm.h"
#include "armtol/tool_matrix.h"

#include "lib/norms/cover.h"
#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { COLUMNS = 48 };

static const unsigned all_norms[ARMTOL_MOST_NORMS] = {007, 003, 005, 006, 070, 030, 050, 060};

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- a norm, its columns, and what is said of it ---- */

typedef struct sums {
    size_t n;
    unsigned components;
    double factor; /* of standard deviations; unused of the worst case */
    double matrix[6 * COLUMNS], shifts[COLUMNS], tolerances[COLUMNS];
} sums;

static double worst_of(const sums *sums, double direction[6])
{
    double workspace[6 * (COLUMNS + 1)];
    TEST_ASSERT_TRUE(armtol_norm_workspace(sums->n) <= sizeof workspace / sizeof workspace[0]);
    return armtol_worst_norm(sums->matrix, sums->n, sums->components, sums->shifts, sums->tolerances, direction,
                             workspace);
}

static double rss_of(const sums *sums, double direction[6])
{
    return armtol_rss_norm(sums->matrix, sums->n, sums->components, sums->shifts, sums->tolerances, sums->factor,
                           direction);
}

/* Along a direction, six components; nothing is summed as the library does. */
static double along(const sums *sums, const double direction[6], bool rss)
{
    double shift = 0, sum = 0;
    for (size_t k = 0; k < sums->n; k++) {
        double element = 0;
        for (size_t i = 0; i < 6; i++) {
            element += direction[i] * sums->matrix[i * sums->n + k];
        }
        shift += element * sums->shifts[k];
        const double part = fabs(element) * sums->tolerances[k];
        sum += rss ? part * part : part;
    }
    return fabs(shift) + (rss ? sums->factor * sqrt(sum) : sum);
}

/* Three components of a unit vector, those that are not the norm's left out. */
static void widen(const sums *sums, const double direction[3], double wide[6])
{
    memset(wide, 0, 6 * sizeof *wide);
    for (size_t i = 0; i < 3; i++) {
        wide[i] = sums->components >> i & 1 ? direction[i] : 0;
        wide[3 + i] = sums->components >> (3 + i) & 1 ? direction[i] : 0;
    }
}

static double worst_support(const double direction[3], const void *context)
{
    double wide[6];
    widen(context, direction, wide);
    return along(context, wide, false);
}

static double rss_support(const double direction[3], const void *context)
{
    double wide[6];
    widen(context, direction, wide);
    return along(context, wide, true);
}

/* It is reached along its direction, a unit vector of the norm's components. */
static void check_direction(const sums *sums, double norm, const double direction[6], bool rss)
{
    double squares = 0;
    for (size_t i = 0; i < 6; i++) {
        squares += direction[i] * direction[i];
        TEST_ASSERT_TRUE((sums->components >> i & 1) != 0 || direction[i] == 0);
    }
    check_within(1e-14, norm > 0, squares, "a unit vector");
    check_within(1e-13 * norm, norm, along(sums, direction, rss), "along its direction");
}

/* ---- what is drawn ---- */

/* Columns that lie in planes, along each other but for rounding, and nowhere; tolerances of all sizes. */
static double element_of(random_source *source, double kind)
{
    return kind < 0.25 ? 0 : kind < 0.4 ? floor(random_between(source, -1, 2)) : random_between(source, -1, 1);
}

static void draw_sums(random_source *source, size_t n, sums *sums)
{
    const bool shifted = random_between(source, 0, 1) < 0.5;
    *sums = (struct sums){.n = n, .factor = random_between(source, 0.1, 3)};
    sums->components = all_norms[random_bits(source) % ARMTOL_MOST_NORMS];
    for (size_t k = 0; k < n; k++) {
        const bool like = k > 0 && random_between(source, 0, 1) < 0.2;
        const double factor = random_between(source, -2, 2), doubt = random_between(source, 0, 1) < 0.5 ? 1e-12 : 0;
        for (size_t i = 0; i < 6; i++) {
            double *element = &sums->matrix[i * n + k];
            *element = like ? factor * element[-1] * (1 + doubt * random_between(source, -1, 1))
                            : element_of(source, random_between(source, 0, 1));
        }
        const double size = random_between(source, 0, 1);
        sums->tolerances[k] = size < 0.1 ? 0 : random_between(source, 0, 1) * (size < 0.25 ? 1e-5 : 1);
        sums->shifts[k] = shifted && random_between(source, 0, 1) < 0.5 ? random_between(source, -1, 1) : 0;
    }
}

/* ---- worst case ---- */

/* The norm at the corner whose signs are the bits. */
static double norm_at(const sums *sums, unsigned signs)
{
    double squares = 0;
    for (size_t i = 0; i < 6; i++) {
        double error = 0;
        for (size_t k = 0; k < sums->n; k++) {
            const double off = (signs >> k & 1) != 0 ? sums->tolerances[k] : -sums->tolerances[k];
            error += sums->matrix[i * sums->n + k] * (sums->shifts[k] + off);
        }
        squares += (sums->components >> i & 1) != 0 ? error * error : 0;
    }
    return sqrt(squares);
}

static void test_the_worst_of_all_corners(void)
{
    random_source source = {1};
    for (int i = 0; i < 700; i++) {
        sums sums;
        double most = 0, direction[6];
        draw_sums(&source, 1 + (size_t)i % (i % 100 == 0 ? 15 : 10), &sums);
        for (unsigned signs = 0; signs < 1u << sums.n; signs++) {
            most = fmax(most, norm_at(&sums, signs));
        }
        const double worst = worst_of(&sums, direction);
        check_within(1e-13 * most, most, worst, "case %d, %s of %zu columns", i, armtol_norm_name(sums.components),
                     sums.n);
        check_direction(&sums, worst, direction, false);
    }
}

/* Branch and bound over all directions, which knows nothing of vertices. */
static void check_cover(const sums *sums, const char *what)
{
    static const double accuracy = 1e-10;
    double direction[6];
    const double worst = worst_of(sums, direction), bound = cover_of_sphere(worst_support, sums, accuracy);
    check_direction(sums, worst, direction, false);
    check_within(2 * accuracy * bound, bound, worst, "worst of %s", what);
    const double spread = rss_of(sums, direction), rss_bound = cover_of_sphere(rss_support, sums, accuracy);
    check_direction(sums, spread, direction, true);
    check_within(2 * accuracy * rss_bound, rss_bound, spread, "deviations of %s", what);
}

static void test_no_direction_is_worse(void)
{
    random_source source = {2};
    for (int i = 0; i < 30; i++) {
        sums sums;
        draw_sums(&source, 1 + (size_t)i, &sums);
        check_cover(&sums, "columns drawn");
    }
}

static void test_no_direction_of_an_arm_is_worse(void)
{
    random_source source = {3};
    for (size_t i = 0; i < 3 * armtol_arm_count(); i++) {
        const armtol_arm *arm = armtol_arm_at(i % armtol_arm_count());
        const armtol_tool_point tool = {{0, 0, 0}, ARMTOL_BASE_FRAME};
        armtol_link links[16];
        double q[16];
        sums sums = {.n = armtol_column_count(arm->links, arm->n_links), .factor = 2};
        sums.components = all_norms[i % 3 * 4 % 7];
        TEST_ASSERT_TRUE(arm->n_links <= 16 && sums.n <= COLUMNS);
        for (size_t j = 0; j < armtol_arm_joint_count(arm); j++) {
            q[j] = random_between(&source, -2, 2);
        }
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(arm->links, arm->n_links, q, armtol_arm_joint_count(arm),
                                                            &armtol_errata_none, links));
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tool_matrix(links, arm->n_links, &tool, sums.matrix, sums.n));
        for (size_t k = 0; k < sums.n; k++) {
            sums.tolerances[k] = random_between(&source, 0, 1e-3);
            sums.shifts[k] = i % 2 ? random_between(&source, -1e-4, 1e-4) : 0;
        }
        check_cover(&sums, arm->name);
    }
}

/* ---- by hand ---- */

/* Along x, y and z by 3, 4 and 12. */
static sums three_axes(unsigned components)
{
    return (sums){.n = 3,
                  .components = components,
                  .factor = 0.5,
                  .matrix = {1, 0, 0, 0, 2, 0, 0, 0, -3, 5, 0, 0, 0, 5, 0, 0, 0, 5},
                  .tolerances = {3, 2, 4}};
}

static void test_closed_forms(void)
{
    double direction[6];
    sums sums = three_axes(007);
    check_same(13, worst_of(&sums, direction), "3, 4, 12");
    check_within(1e-15, 12.0 / 13, fabs(direction[2]), "along z");
    check_same(6, rss_of(&sums, direction), "the longest half axis");
    check_same(1, fabs(direction[2]), "along z");
    sums.components = 003;
    check_same(5, worst_of(&sums, direction), "3, 4");
    check_same(2, rss_of(&sums, direction), "the longest of two");
    sums.components = 050;
    check_same(25, worst_of(&sums, direction), "15, 20");
    sums.shifts[0] = 1; /* along x, where the half axis is shorter: 1 + 1.5 against the farthest point between */
    sums.components = 003;
    check_same(sqrt(32), worst_of(&sums, direction), "4, 4");
    sums.tolerances[1] = 0.5; /* half axes of 1.5 and 0.5 along x and y, and the farthest point is on x */
    check_within(1e-15, 2.5, rss_of(&sums, direction), "shift and half axis");
    check_same(1, direction[0], "along x");
}

static void test_no_bound_and_no_error(void)
{
    double direction[6];
    sums sums = three_axes(003);
    sums.tolerances[2] = (double)INFINITY;
    check_same(5, worst_of(&sums, direction), "a column that does not count");
    check_same(2, rss_of(&sums, direction), "likewise");
    sums.components = 007;
    TEST_ASSERT_TRUE(isinf(worst_of(&sums, direction)) && direction[0] == 0 && direction[1] == 0 && direction[2] == 0);
    TEST_ASSERT_TRUE(isinf(rss_of(&sums, direction)) && direction[0] == 0 && direction[1] == 0 && direction[2] == 0);
    memset(sums.tolerances, 0, sizeof sums.tolerances);
    check_same(0, worst_of(&sums, direction), "exact");
    check_same(0, rss_of(&sums, direction), "exact");
    sums.shifts[1] = -3;
    check_same(6, worst_of(&sums, direction), "a shift alone");
    check_same(6, rss_of(&sums, direction), "a shift alone");
    check_same(1, direction[1], "its direction");
    check_same(5, armtol_worst_norm(three_axes(003).matrix, 3, 003, NULL, three_axes(003).tolerances, direction,
                                    (double[24]){0}), "no shifts at all");
}

static void test_numbers_whose_squares_are_none(void)
{
    double direction[6];
    sums sums = three_axes(007);
    for (int i = 0; i < 2; i++) {
        const double scale = i == 0 ? 1e200 : 1e-200;
        for (size_t k = 0; k < 3; k++) {
            sums.tolerances[k] = three_axes(007).tolerances[k] * scale;
        }
        check_within(1e-14 * scale, 13 * scale, worst_of(&sums, direction), "worst");
        check_within(1e-14 * scale, 6 * scale, rss_of(&sums, direction), "deviations");
        const double error[6] = {3 * scale, 1, 4 * scale, 0, 0, 0};
        check_within(1e-14 * scale, 5 * scale, armtol_norm_of(error, 005), "norm");
    }
    TEST_ASSERT_TRUE(isinf(armtol_norm_of((double[]){1, (double)INFINITY, 2, 0, 0, 0}, 003)));
    check_same(0, armtol_norm_of((double[]){0, 0, 2, 0, 0, 0}, 003), "no error");
}

static void test_names(void)
{
    static const char *const names[ARMTOL_MOST_NORMS] = {"r", "xy", "xz", "yz", "w", "wxy", "wxz", "wyz"};
    for (int i = 0; i < ARMTOL_MOST_NORMS; i++) {
        TEST_ASSERT_EQUAL_STRING(names[i], armtol_norm_name(all_norms[i]));
        TEST_ASSERT_TRUE(armtol_norm_of_name(names[i]) == all_norms[i] && armtol_norm_is_known(all_norms[i]));
        TEST_ASSERT_TRUE(armtol_norm_is_length(all_norms[i]) == (i < 4));
    }
    TEST_ASSERT_EQUAL_STRING("?", armtol_norm_name(1));
    TEST_ASSERT_TRUE(armtol_norm_of_name("dx") == 0 && armtol_norm_of_name("") == 0);
    TEST_ASSERT_FALSE(armtol_norm_is_known(0) || armtol_norm_is_known(011) || armtol_norm_is_known(0107));
}

static void test_the_row_along_a_direction(void)
{
    const sums sums = three_axes(007);
    double row[3];
    armtol_norm_row(sums.matrix, 3, (double[]){0.6, 0.8, 0, 0, 0, 1}, row);
    check_same(0.6, row[0], "dx");
    check_same(1.6, row[1], "dy");
    check_same(5, row[2], "wz");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_worst_of_all_corners);
    RUN_TEST(test_no_direction_is_worse);
    RUN_TEST(test_no_direction_of_an_arm_is_worse);
    RUN_TEST(test_closed_forms);
    RUN_TEST(test_no_bound_and_no_error);
    RUN_TEST(test_numbers_whose_squares_are_none);
    RUN_TEST(test_names);
    RUN_TEST(test_the_row_along_a_direction);
    return UNITY_END();
}
