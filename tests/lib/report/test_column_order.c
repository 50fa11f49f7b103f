#include "armtol/column_order.h"
#include "armtol/robots.h"

#include "support/check.h"
#include "unity.h"

enum { MOST = 32 };

void setUp(void)
{
}

void tearDown(void)
{
}

static void check_order(const armtol_robot *robot, const size_t expected[], size_t n, size_t n_lengths)
{
    armtol_link links[8];
    armtol_column columns[MOST];
    size_t order[MOST];
    robot->links(&armtol_errata_1987, links);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_columns(links, robot->n_links, columns, n));
    TEST_ASSERT_EQUAL_INT(n_lengths, armtol_column_order(columns, n, order));
    for (size_t k = 0; k < n; k++) {
        TEST_ASSERT_EQUAL_INT(expected[k], order[k]);
    }
}

/* The tables of the two programs, from the order of parameters in each link of the report's tables. */
static void test_the_intelledex_s_table(void)
{
    static const size_t order[32] = {2,  6,  10, 22, 26, 30,                 /* a beside d */
                                     1,  5,  9,  13, 17, 21, 25, 29,         /* d, or a */
                                     0,  4,  8,  12, 16, 20, 24, 28,         /* theta */
                                     3,  7,  11, 14, 18, 23, 27, 31, 15, 19 /* alpha, beta */};
    check_order(&armtol_intelledex_605t, order, 32, 14);
}

static void test_the_adept_s_table(void)
{
    static const size_t order[25] = {2, 18, 23,                                /* a beside d */
                                     1, 5,  9,  13, 16, 22,                    /* d, or a */
                                     0, 4,  8,  12, 17, 21,                    /* theta */
                                     3, 6,  10, 14, 19, 24, 7, 11, 15, 20 /* alpha, beta */};
    check_order(&armtol_adept_one, order, 25, 9);
}

static void test_a_link_without_a_has_one_length(void)
{
    const armtol_link link = {.kind = ARMTOL_NPP};
    armtol_column columns[3];
    size_t order[3];
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_columns(&link, 1, columns, 3));
    TEST_ASSERT_EQUAL_INT(1, armtol_column_order(columns, 3, order));
    TEST_ASSERT_EQUAL_INT(1, order[0]);
    TEST_ASSERT_EQUAL_INT(0, order[1]);
    TEST_ASSERT_EQUAL_INT(2, order[2]);
}

static void test_no_columns_have_no_order(void)
{
    TEST_ASSERT_EQUAL_INT(0, armtol_column_order(NULL, 0, NULL));
}

static void test_reordering_moves_whole_columns(void)
{
    const size_t order[3] = {2, 0, 1};
    double matrix[18], ordered[18];
    for (int i = 0; i < 18; i++) {
        matrix[i] = i;
    }
    armtol_reorder(matrix, 3, order, ordered);
    for (size_t i = 0; i < 6; i++) {
        for (size_t k = 0; k < 3; k++) {
            check_same((double)(i * 3 + order[k]), ordered[i * 3 + k], "row %zu, place %zu", i, k);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_intelledex_s_table);
    RUN_TEST(test_the_adept_s_table);
    RUN_TEST(test_a_link_without_a_has_one_length);
    RUN_TEST(test_no_columns_have_no_order);
    RUN_TEST(test_reordering_moves_whole_columns);
    return UNITY_END();
}
