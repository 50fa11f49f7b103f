/* Numbers on the command line: all of a number counts, or none of it. */

#include "armtol/ask/number_list.h"
#include "armtol/ask/weights.h"

#include "console/message.h"
#include "support/check.h"
#include "support/said.h"

#include "unity.h"

#include <stdio.h>
#include <string.h>

static const char digits[] = "0000000000" "0000000000" "0000000000" "0000000000" "0000000000";

void setUp(void)
{
}

void tearDown(void)
{
}

/* 63 characters are a number; one more, and it is not cut but refused. */
static void test_a_list_cuts_no_number(void)
{
    char text[200];
    double values[2];
    said said;
    snprintf(text, sizeof text, "1%s%.12s,2", digits, digits);
    TEST_ASSERT_TRUE(number_list_parse("--joints", text, "numbers", false, 2, values));
    check_same(1e62, values[0], "63 digits");
    check_same(2, values[1], "behind them");

    snprintf(text, sizeof text, "2,1%s%.13s", digits, digits);
    said_begin();
    const bool fine = number_list_parse("--joints", text, "numbers", false, 2, values);
    said_end(&said);
    TEST_ASSERT_FALSE(fine);
    TEST_ASSERT_EQUAL_STRING("armtol: --joints: \"1000000000000000000000000000000000000000...\" is too long\n",
                             said.text);
}

static void test_blanks_may_stand_anywhere_between_numbers(void)
{
    static const char *const texts[] = {"1,2,3", " 1 , 2 , 3 ", "1\t,\t2,\n3\n", "1 ,2 ,3", "1, 2, 3", "  1,2,3  "};
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        double values[3] = {0, 0, 0};
        TEST_ASSERT_TRUE_MESSAGE(number_list_parse("--joints", texts[i], "numbers", false, 3, values), texts[i]);
        for (int k = 0; k < 3; k++) {
            check_same(k + 1, values[k], "number %d of %s", k, texts[i]);
        }
    }
}

static void test_a_weight_is_not_cut(void)
{
    const armtol_arm *arm = armtol_arm_named("puma560");
    const size_t n = armtol_column_count(arm->links, arm->n_links);
    char text[200];
    double weights[64];
    armtol_column columns[64];
    said said;
    TEST_ASSERT_TRUE(n <= 64 && armtol_columns(arm->links, arm->n_links, columns, n) == ARMTOL_OK);
    snprintf(text, sizeof text, "alpha=1%s%.6s", digits, digits);
    TEST_ASSERT_TRUE(weights_parse(text, arm, columns, n, weights));
    check_same(1e56, weights[3], "63 characters");

    snprintf(text, sizeof text, "alpha=1%s%.7s", digits, digits);
    said_begin();
    const bool fine = weights_parse(text, arm, columns, n, weights);
    said_end(&said);
    TEST_ASSERT_FALSE(fine);
    TEST_ASSERT_EQUAL_STRING("armtol: --weights: \"alpha=1000000000000000000000000000000000...\" is too long\n",
                             said.text);
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_a_list_cuts_no_number);
    RUN_TEST(test_blanks_may_stand_anywhere_between_numbers);
    RUN_TEST(test_a_weight_is_not_cut);
    return UNITY_END();
}
