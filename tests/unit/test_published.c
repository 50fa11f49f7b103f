/* Every number that the paper prints, from the library and the reports, in this process. */

#include "analysis.h"
#include "compare.h"
#include "program.h"
#include "published.h"
#include "report.h"

#include "unity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static published_list published;

void setUp(void)
{
    TEST_ASSERT_TRUE(published_read(PUBLISHED, &published));
}

void tearDown(void)
{
    published_free(&published);
}

/* The numbers of one role, as floats. */
static void given(size_t first, published_role role, double values[])
{
    for (size_t i = first; i < published.count; i++) {
        const published_number *number = &published.numbers[i];
        if (published_same_case(number, &published.numbers[first]) && number->role == role) {
            *values++ = armtol_stored(&armtol_errata_1987, strtod(number->value, NULL));
        }
    }
}

static char *files_of(size_t first)
{
    static const char *const letters[] = {"x", "y", "z", "a", "b", "c"};
    const bool intella = strcmp(published.numbers[first].program, "intella") == 0;
    const armtol_robot *robot = intella ? &armtol_intelledex_605t : &armtol_adept_one;
    const program program = {.title = "", .wish_letters = letters, .robot = robot};
    double wish[6], tolerances[6], delta;
    analysis analysis;
    char *text = NULL;
    size_t size = 0;

    given(first, ROLE_WISH, wish);
    given(first, ROLE_TOLERANCE, tolerances);
    given(first, ROLE_DELTA, &delta);
    TEST_ASSERT_TRUE(analysis_start(&analysis, robot, &armtol_errata_1987));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, analysis_place(&analysis, wish));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, analysis_matrix(&analysis));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, analysis_tolerances(&analysis, tolerances, delta));

    FILE *stream = open_memstream(&text, &size);
    TEST_ASSERT_NOT_NULL(stream);
    const report report = {&program, &analysis};
    report_tolerances(stream, &report);
    report_machining(stream, &report);
    fclose(stream);
    analysis_free(&analysis);
    return text;
}

static void test_every_published_number(void)
{
    size_t results = 0;
    char *files = NULL;
    for (size_t i = 0; i < published.count; i++) {
        const published_number *number = &published.numbers[i];
        if (published_begins_case(&published, i)) {
            free(files);
            files = files_of(i);
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
    RUN_TEST(test_the_comparison_can_fail);
    return UNITY_END();
}
