/* Every number that the paper prints, from the library and the reports, in this process. */

#include "lab/published.h"
#include "lab/recompute.h"
#include "lab/reproduce/compare.h"

#include "unity.h"

#include <stdio.h>
#include <stdlib.h>

static published_list published;

void setUp(void)
{
    TEST_ASSERT_TRUE(published_read(PUBLISHED, &published));
}

void tearDown(void)
{
    published_free(&published);
}

static void test_every_published_number(void)
{
    size_t results = 0;
    char *files = NULL;
    for (size_t i = 0; i < published.count; i++) {
        const published_number *number = &published.numbers[i];
        if (published_begins_case(&published, i)) {
            free(files);
            files = recompute_files(&published, i, &armtol_errata_1987);
            TEST_ASSERT_NOT_NULL(files);
        }
        if (number->role == ROLE_RESULT) {
            char what[256];
            const comparison comparison = compare_number(number, files);
            snprintf(what, sizeof what, "%s, case %d, %s: published %s, computed %s", number->program,
                     number->case_number, number->quantity, number->value, comparison.computed);
            TEST_ASSERT_EQUAL_INT_MESSAGE(
                number->without_sign ? VERDICT_AGREES_WITHOUT_SIGN : VERDICT_AGREES, comparison.verdict, what);
            results++;
        }
    }
    free(files);
    TEST_ASSERT_EQUAL_INT(66, results);
}

/* The report prints what is common to all cases once; each case has it. */
static void test_each_case_has_its_tolerances(void)
{
    size_t cases = 0, tolerances = 0, deltas = 0;
    for (size_t i = 0; i < published.count; i++) {
        cases += published_begins_case(&published, i);
        tolerances += published.numbers[i].role == ROLE_TOLERANCE;
        deltas += published.numbers[i].role == ROLE_DELTA;
        if (published.numbers[i].role == ROLE_DELTA) {
            TEST_ASSERT_EQUAL_INT(cases, deltas);
            TEST_ASSERT_EQUAL_INT(6 * cases, tolerances);
        }
    }
    TEST_ASSERT_EQUAL_INT(4, cases);
    TEST_ASSERT_EQUAL_INT(4, deltas);
}

static comparison compare(const char *quantity, const char *value, bool without_sign, const char *files)
{
    published_number number = {.without_sign = without_sign};
    snprintf(number.quantity, sizeof number.quantity, "%s", quantity);
    snprintf(number.value, sizeof number.value, "%s", value);
    return compare_number(&number, files);
}

static void test_the_comparison_can_fail(void)
{
    const char *files = " rd[0] =    0.100000\n rd[1] =   -0.200000\n xrd[2] = 1\n";
    TEST_ASSERT_EQUAL_INT(VERDICT_AGREES, compare("rd[0]", "0.100000", false, files).verdict);
    TEST_ASSERT_EQUAL_INT(VERDICT_DIFFERS, compare("rd[0]", "0.100001", false, files).verdict);
    TEST_ASSERT_EQUAL_INT(VERDICT_DIFFERS, compare("rd[1]", "0.200000", false, files).verdict);
    TEST_ASSERT_EQUAL_INT(VERDICT_AGREES_WITHOUT_SIGN, compare("rd[1]", "0.200000", true, files).verdict);
    TEST_ASSERT_EQUAL_INT(VERDICT_MISSING, compare("rd[2]", "1", false, files).verdict);
    TEST_ASSERT_EQUAL_INT(VERDICT_DIFFERS, compare("rd[0..1]", "0.100000", false, files).verdict);
    TEST_ASSERT_EQUAL_INT(VERDICT_MISSING, compare("td[0..1]", "0.100000", false, files).verdict);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_published_number);
    RUN_TEST(test_each_case_has_its_tolerances);
    RUN_TEST(test_the_comparison_can_fail);
    return UNITY_END();
}
