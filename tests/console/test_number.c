#include "console/number.h"

#include "support/check.h"
#include "unity.h"

#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_decimal_numbers_are_read(void)
{
    static const struct {
        const char *text;
        double value;
    } rows[] = {
        {"200", 200},     {"-200", -200},  {"+.5", 0.5},   {"5.", 5},         {"1.5e2", 150}, {"1E-3", 0.001},
        {"-0", 0},        {"007", 7},      {"1e+2", 100},  {"1e-400", 0},     {"1e308", 1e308},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        double value = 42;
        TEST_ASSERT_EQUAL_INT_MESSAGE(NUMBER_FINE, number_parse(rows[i].text, &value), rows[i].text);
        check_same(rows[i].value, value, "%s", rows[i].text);
    }
}

static void test_what_is_no_decimal_number_is_refused(void)
{
    static const char *const wrong[] = {"",    "abc", "1,5",  "0x10", "1.5.5", "1e",    "1e+", "e5", ".",
                                        "+",   "-",   "--1",  "1-",   "1 ",    " 1",    "1_0", "+-1", "1e5.",
                                        "nano", "in", "1inf", ".e1"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        double value = 42;
        TEST_ASSERT_EQUAL_INT_MESSAGE(NUMBER_NONE, number_parse(wrong[i], &value), wrong[i]);
        check_same(42, value, "%s", wrong[i]);
    }
}

static void check_fault(number_fault expected, const char *text)
{
    double value = 42;
    TEST_ASSERT_EQUAL_INT_MESSAGE(expected, number_parse(text, &value), text);
    check_same(42, value, "%s", text);
}

static void test_nan_and_infinity_are_told_apart(void)
{
    check_fault(NUMBER_NOT_FINITE, "nan");
    check_fault(NUMBER_NOT_FINITE, "-NaN");
    check_fault(NUMBER_NOT_FINITE, "inf");
    check_fault(NUMBER_NOT_FINITE, "+Infinity");
}

static void test_overflow_is_told_apart(void)
{
    check_fault(NUMBER_TOO_LARGE, "1e309");
    check_fault(NUMBER_TOO_LARGE, "-1e999999999999");
}

static void test_typeset_minus_signs_are_known(void)
{
    TEST_ASSERT_EQUAL_INT(3, (int)number_typeset_minus("\xe2\x88\x92" "5"));
    TEST_ASSERT_EQUAL_INT(3, (int)number_typeset_minus("\xe2\x80\x93"));
    static const char *const others[] = {"", "-5", "5", "\xe2", "\xe2\x88", "\xe2\x80\x94 5"};
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        TEST_ASSERT_EQUAL_INT(0, (int)number_typeset_minus(others[i]));
    }
}

static void check_shortest(const char *expected, double value, const armtol_errata *errata)
{
    TEST_ASSERT_EQUAL_STRING(expected, number_shortest(armtol_stored(errata, value), errata, &(number_text){""}));
}

/* The neighbours of 0.5 are 6e-8 away as floats, 1.1e-16 as doubles. */
static void test_a_stored_number_is_shown_as_it_was_typed(void)
{
    check_shortest("0.5", 0.5, &armtol_errata_1987);
    check_shortest("0.1", 0.1, &armtol_errata_1987);
    check_shortest("0.500001", 0.500001, &armtol_errata_1987);
    check_shortest("0.5000001", 0.5000001, &armtol_errata_1987);
    check_shortest("0.5", 0.50000000001, &armtol_errata_1987);
    check_shortest("0.50000000001", 0.50000000001, &armtol_errata_none);
    check_shortest("-1e-50", -1e-50, &armtol_errata_none);
    check_shortest("0.30000000000000004", 0.1 + 0.2, &armtol_errata_none);
}

static void test_each_fault_has_a_text_of_its_own(void)
{
    TEST_ASSERT_TRUE(strcmp(number_fault_text(NUMBER_NONE), number_fault_text(NUMBER_NOT_FINITE)) != 0);
    TEST_ASSERT_TRUE(strcmp(number_fault_text(NUMBER_NONE), number_fault_text(NUMBER_TOO_LARGE)) != 0);
    TEST_ASSERT_TRUE(strcmp(number_fault_text(NUMBER_TOO_LARGE), number_fault_text(NUMBER_NOT_FINITE)) != 0);
    TEST_ASSERT_TRUE(strcmp(number_fault_text(NUMBER_TOO_LARGE), number_fault_text(NUMBER_TOO_LONG)) != 0);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_decimal_numbers_are_read);
    RUN_TEST(test_what_is_no_decimal_number_is_refused);
    RUN_TEST(test_nan_and_infinity_are_told_apart);
    RUN_TEST(test_overflow_is_told_apart);
    RUN_TEST(test_typeset_minus_signs_are_known);
    RUN_TEST(test_a_stored_number_is_shown_as_it_was_typed);
    RUN_TEST(test_each_fault_has_a_text_of_its_own);
    return UNITY_END();
}
