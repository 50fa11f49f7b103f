#include "armtol/robots.h"
#include "armtol/tool_matrix.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"
#include "unity.h"

#include <math.h>
#include <string.h>

enum { MOST_LINKS = 50, MOST_COLUMNS = MOST_LINKS * ARMTOL_PARAMETER_COUNT };

static double matrix[6 * MOST_COLUMNS], other[6 * MOST_COLUMNS];
static armtol_column columns[MOST_COLUMNS];

void setUp(void)
{
}

void tearDown(void)
{
}

/* beta, and the a of npp, are not 0 either: every nominal value counts. */
static void random_links(uint64_t seed, size_t n, armtol_link links[])
{
    random_source source = {seed};
    for (size_t i = 0; i < n; i++) {
        links[i] = (armtol_link){
            .kind = (armtol_kind)((i + seed) % ARMTOL_KIND_COUNT),
            .joint = (armtol_joint)((i + seed / 4) % ARMTOL_JOINT_COUNT),
            .a = random_between(&source, -300, 300),
            .alpha = random_between(&source, -3, 3),
            .d = random_between(&source, -300, 300),
            .theta = random_between(&source, -3, 3),
            .beta = random_between(&source, -1, 1),
        };
    }
}

static armtol_tool_point random_tool(uint64_t seed, armtol_frame frame)
{
    random_source source = {seed ^ 77};
    armtol_tool_point tool = {.frame = frame};
    for (int i = 0; i < 3; i++) {
        tool.offset[i] = random_between(&source, -200, 200);
    }
    return tool;
}

/*
 * The chain with a link more, that puts its frame's origin on the tool point, where an offset is not written
 * so.
 */
static size_t with_offset(armtol_link links[], size_t n, const double offset[3])
{
    /* theta and a lead to x and y, d to z; a second link turns back */
    const double direction = atan2(offset[1], offset[0]);
    links[n] = (armtol_link){.a = hypot(offset[0], offset[1]), .d = offset[2], .theta = direction};
    links[n + 1] = (armtol_link){.theta = -direction};
    return n + 2;
}

/* What the six numbers are along the axes of the last frame. */
static void turn_to_tool(double chain[4][4], const double twist[6], double turned[6])
{
    for (int i = 0; i < 6; i++) {
        turned[i] = 0;
        for (int j = 0; j < 3; j++) {
            turned[i] += chain[j][i % 3] * twist[i / 3 * 3 + j];
        }
    }
}

static void check_column(const double expected[6], size_t n, size_t k, double tolerance, double reach)
{
    for (size_t i = 0; i < 6; i++) {
        check_within(tolerance * (i < 3 ? reach : 1), expected[i], matrix[i * n + k], "link %zu, %s, row %zu",
                     columns[k].link, armtol_parameter_name(columns[k].parameter), i);
    }
}

static double reach_of(const armtol_link links[], size_t n)
{
    double reach = 1;
    for (size_t i = 0; i < n; i++) {
        reach += fabs(links[i].a) + fabs(links[i].d);
    }
    return reach;
}

static void make(const armtol_link links[], size_t n_links, const armtol_tool_point *tool, size_t *n)
{
    *n = armtol_column_count(links, n_links);
    TEST_ASSERT_TRUE(*n <= MOST_COLUMNS);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_columns(links, n_links, columns, *n));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tool_matrix(links, n_links, tool, matrix, *n));
}

/* Against central differences of Eq. (4.1), the offset being links of their own there. */
static void check_differences(armtol_link links[], size_t n_links, const armtol_tool_point *tool)
{
    size_t n;
    double chain[4][4];
    make(links, n_links, tool, &n);
    const size_t n_longer = with_offset(links, n_links, tool->offset);
    const double reach = reach_of(links, n_longer);
    reference_chain(links, n_longer, chain);
    for (size_t k = 0; k < n; k++) {
        double in_base[6], in_tool[6];
        reference_column(links, n_longer, columns[k], true, in_base);
        turn_to_tool(chain, in_base, in_tool);
        check_column(tool->frame == ARMTOL_TOOL_FRAME ? in_tool : in_base, n, k, 1e-9, reach);
    }
}

static void test_chains_of_all_kinds_agree_with_central_differences(void)
{
    for (uint64_t seed = 0; seed < 48; seed++) {
        armtol_link links[MOST_LINKS];
        const size_t n_links = 1 + seed % 9;
        for (armtol_frame frame = ARMTOL_BASE_FRAME; frame < ARMTOL_FRAME_COUNT; frame++) {
            const armtol_tool_point tool = random_tool(seed, frame);
            random_links(seed, n_links, links);
            check_differences(links, n_links, &tool);
        }
    }
}

/* What is 0 is passed over, and nothing else is: parameters that are 1, of fixed links too. */
static void test_links_of_ones(void)
{
    for (uint64_t seed = 0; seed < 12; seed++) {
        armtol_link links[MOST_LINKS];
        random_links(seed, 7, links);
        for (size_t i = 0; i < 7; i++) {
            links[i].a = links[i].d = links[i].alpha = links[i].theta = links[i].beta = 1;
        }
        check_differences(links, 7, &armtol_tool_origin);
    }
}

/* Against the other way to A, by adjoints. */
static void check_error_matrix(const armtol_link links[], size_t n_links)
{
    size_t n;
    make(links, n_links, &armtol_tool_origin, &n);
    const double reach = reach_of(links, n_links);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_error_matrix(links, n_links, &armtol_errata_none, other, n));
    for (size_t k = 0; k < n; k++) {
        double expected[6];
        for (size_t i = 0; i < 6; i++) {
            expected[i] = other[i * n + k];
        }
        check_column(expected, n, k, 1e-12, reach);
    }
}

static void test_it_is_the_error_matrix_without_errata(void)
{
    armtol_link links[MOST_LINKS];
    for (uint64_t seed = 0; seed < 48; seed++) {
        random_links(seed, 1 + seed % 9, links);
        check_error_matrix(links, 1 + seed % 9);
    }
    random_links(3, MOST_LINKS, links);
    check_error_matrix(links, MOST_LINKS);
    armtol_intelledex_605t.links(&armtol_errata_none, links);
    check_error_matrix(links, armtol_intelledex_605t.n_links);
    armtol_adept_one.links(&armtol_errata_none, links);
    check_error_matrix(links, armtol_adept_one.n_links);
}

static void test_angles_of_any_size(void)
{
    armtol_link links[4];
    random_links(5, 4, links);
    links[0].theta = 1e9;
    links[1].alpha = -3.5e6;
    links[2].theta = 999999.5;
    links[3].beta = 1e300;
    check_error_matrix(links, 4);
}

static void check_refused(armtol_status expected, const armtol_link links[], size_t n_links, size_t n_columns)
{
    double untouched[6 * 4] = {42};
    TEST_ASSERT_EQUAL_INT(expected,
                          armtol_tool_matrix(links, n_links, &armtol_tool_origin, untouched, n_columns));
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
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_tool_matrix(links, 2, &armtol_tool_origin, matrix, 8));
    const armtol_tool_point nowhere = {{0, NAN, 0}, ARMTOL_BASE_FRAME};
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_tool_matrix(links, 1, &nowhere, matrix, 4));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_chains_of_all_kinds_agree_with_central_differences);
    RUN_TEST(test_links_of_ones);
    RUN_TEST(test_it_is_the_error_matrix_without_errata);
    RUN_TEST(test_angles_of_any_size);
    RUN_TEST(test_wrong_chains_and_sizes_are_refused);
    RUN_TEST(test_an_overflow_is_told);
    return UNITY_END();
}
