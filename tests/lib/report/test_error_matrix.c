#include "armtol/error_matrix.h"
#include "armtol/robots.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"
#include "unity.h"

#include <math.h>
#include <stdbool.h>

enum { MOST_LINKS = 50, MOST_COLUMNS = MOST_LINKS * ARMTOL_PARAMETER_COUNT };

static double matrix[6 * MOST_COLUMNS];
static armtol_column columns[MOST_COLUMNS];

void setUp(void)
{
}

void tearDown(void)
{
}

static double norm3(const double v[3])
{
    return hypot(hypot(v[0], v[1]), v[2]);
}

/* Every column of A within 1e-6 of its norm, the lengths and the angles of it each by their own. */
static void check_links(const armtol_link links[], size_t n_links, bool of_tool_point)
{
    const size_t n = armtol_column_count(links, n_links);
    armtol_errata errata = armtol_errata_none;
    errata.base_twist = !of_tool_point;
    TEST_ASSERT_TRUE(n <= MOST_COLUMNS);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_columns(links, n_links, columns, n));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_error_matrix(links, n_links, &errata, matrix, n));
    for (size_t k = 0; k < n; k++) {
        double expected[6];
        reference_column(links, n_links, columns[k], of_tool_point, expected);
        for (size_t i = 0; i < 6; i++) {
            const double scale = norm3(expected + (i < 3 ? 0 : 3));
            check_within(1e-6 * scale + 1e-9, expected[i], matrix[i * n + k], "link %zu, %s, row %zu",
                         columns[k].link, armtol_parameter_name(columns[k].parameter), i);
        }
    }
}

static armtol_link random_link(random_source *source, armtol_kind kind)
{
    const bool has_beta = kind == ARMTOL_PPR || kind == ARMTOL_PPP;
    return (armtol_link){
        .kind = kind,
        .joint = kind == ARMTOL_NPP || kind == ARMTOL_PPP ? ARMTOL_PRISMATIC : ARMTOL_REVOLUTE,
        .a = kind == ARMTOL_NPP ? 0 : random_between(source, -300, 300),
        .alpha = random_between(source, -3, 3),
        .d = random_between(source, -300, 300),
        .theta = random_between(source, -3, 3),
        .beta = has_beta ? random_between(source, -1, 1) : 0,
    };
}

static void check_random_chain(size_t n_links, uint64_t seed)
{
    random_source source = {seed};
    armtol_link links[MOST_LINKS];
    for (size_t i = 0; i < n_links; i++) {
        links[i] = random_link(&source, (armtol_kind)((i + seed) % ARMTOL_KIND_COUNT));
    }
    check_links(links, n_links, false);
    check_links(links, n_links, true);
}

static void test_a_chain_of_one_link_of_each_kind(void)
{
    for (uint64_t seed = 0; seed < 40; seed++) {
        check_random_chain(1, seed);
    }
}

static void test_chains_of_several_links(void)
{
    for (uint64_t seed = 0; seed < 40; seed++) {
        check_random_chain(2 + seed % 8, seed);
    }
}

static void test_a_chain_of_fifty_links(void)
{
    check_random_chain(50, 7);
}

static void check_robot(const armtol_robot *robot)
{
    random_source source = {87};
    armtol_link links[8];
    double q[6];
    for (int n = 0; n < 50; n++) {
        robot->links(&armtol_errata_none, links);
        for (size_t i = 0; i < robot->n_joints; i++) {
            q[i] = random_between(&source, -3, 3);
        }
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(links, robot->n_links, q, robot->n_joints,
                                                            &armtol_errata_none, links));
        check_links(links, robot->n_links, false);
        check_links(links, robot->n_links, true);
    }
}

static void test_the_intelledex(void)
{
    check_robot(&armtol_intelledex_605t);
}

static void test_the_adept(void)
{
    check_robot(&armtol_adept_one);
}

static void test_the_arms_of_1987_have_32_and_25_columns(void)
{
    armtol_link links[8];
    armtol_intelledex_605t.links(&armtol_errata_1987, links);
    TEST_ASSERT_EQUAL_INT(32, armtol_column_count(links, 8));
    armtol_adept_one.links(&armtol_errata_1987, links);
    TEST_ASSERT_EQUAL_INT(25, armtol_column_count(links, 6));
}

static void test_referring_to_a_point_adds_w_cross_point(void)
{
    /* one column: v = (1, 2, 3), w = (4, 5, 6); w x (7, 8, 9) = (45 - 48, 42 - 36, 32 - 35) */
    double column[6] = {1, 2, 3, 4, 5, 6};
    const double point[3] = {7, 8, 9}, expected[6] = {-2, 8, 0, 4, 5, 6};
    armtol_refer_to_point(column, 1, point, &armtol_errata_none);
    for (int i = 0; i < 6; i++) {
        check_same(expected[i], column[i], "row %d", i);
    }
}

static void check_refused(armtol_status expected, const armtol_link links[], size_t n_links, size_t n_columns)
{
    double untouched[6 * 4] = {42};
    armtol_column described[4] = {{42, ARMTOL_A}};
    TEST_ASSERT_EQUAL_INT(expected, armtol_columns(links, n_links, described, n_columns));
    TEST_ASSERT_EQUAL_INT(42, described[0].link);
    TEST_ASSERT_EQUAL_INT(expected,
                          armtol_error_matrix(links, n_links, &armtol_errata_none, untouched, n_columns));
    check_same(42, untouched[0], "the output after an error");
}

static void test_wrong_chains_and_sizes_are_refused(void)
{
    const armtol_link good = {.kind = ARMTOL_NPR};
    const armtol_link no_kind = {.kind = ARMTOL_KIND_COUNT};
    const armtol_link no_joint = {.joint = ARMTOL_JOINT_COUNT};
    const armtol_link nan_length = {.a = NAN};
    check_refused(ARMTOL_NO_LINKS, &good, 0, 0);
    check_refused(ARMTOL_BAD_KIND, &no_kind, 1, 4);
    check_refused(ARMTOL_BAD_JOINT, &no_joint, 1, 4);
    check_refused(ARMTOL_NOT_FINITE, &nan_length, 1, 4);
    check_refused(ARMTOL_WRONG_SIZE, &good, 1, 3);
    check_refused(ARMTOL_WRONG_SIZE, &good, 1, 5);
}

static void test_an_overflow_is_told(void)
{
    const armtol_link links[2] = {{.a = 1e308, .d = 1e308, .theta = 1}, {.a = 1e308, .d = 1e308, .alpha = 1}};
    double overflowing[6 * 8];
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE,
                          armtol_error_matrix(links, 2, &armtol_errata_none, overflowing, 8));
}

/*
 * One link, so that J is used once: S with a residue has R w with r, element by element, more in v. The difference is
 * linear in the residue, and w does not change.
 */
static void test_a_residue_that_is_given(void)
{
    static const armtol_residue none = {{0, 0, 0}}, given = {{1.946349, -3, 0.25}};
    const armtol_link link = {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 3, .alpha = 0.7, .d = -2, .theta = 1.1};
    double plain[6 * 4], moved[6 * 4];
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                          armtol_error_matrix_with_residue(&link, 1, &none, &armtol_errata_1987, plain, 4));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                          armtol_error_matrix_with_residue(&link, 1, &given, &armtol_errata_1987, moved, 4));
    for (size_t i = 0; i < 3; i++) {
        for (size_t k = 0; k < 4; k++) {
            const double turned = plain[(i + 3) * 4 + k];
            check_same(turned, moved[(i + 3) * 4 + k], "row %zu, column %zu", i + 3, k);
            check_within(1e-5, plain[i * 4 + k] + given.diagonal[i] * turned, moved[i * 4 + k], "row %zu, column %zu",
                         i, k);
        }
    }
    TEST_ASSERT_EQUAL_INT(ARMTOL_WRONG_SIZE,
                          armtol_error_matrix_with_residue(&link, 1, &given, &armtol_errata_1987, moved, 3));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_residue_that_is_given);
    RUN_TEST(test_a_chain_of_one_link_of_each_kind);
    RUN_TEST(test_chains_of_several_links);
    RUN_TEST(test_a_chain_of_fifty_links);
    RUN_TEST(test_the_intelledex);
    RUN_TEST(test_the_adept);
    RUN_TEST(test_the_arms_of_1987_have_32_and_25_columns);
    RUN_TEST(test_referring_to_a_point_adds_w_cross_point);
    RUN_TEST(test_wrong_chains_and_sizes_are_refused);
    RUN_TEST(test_an_overflow_is_told);
    return UNITY_END();
}
