/* Degrees as text, radians as doubles. */

#include "armtol/tables/degrees.h"

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

/* What is expected was worked out with eighty digits and rounded once. */
static void test_the_nearest_double_is_taken(void)
{
    static const struct {
        const char *degrees;
        double radians;
    } rows[] = {
        {"90", 0x1.921fb54442d18p+0},
        {"-90", -0x1.921fb54442d18p+0},
        {"45", 0x1.921fb54442d18p-1},
        {"266", 0x1.291ff64a9d75dp+2},
        {"100.7", 0x1.c1ee923679695p+0},
        {"1e-5", 0x1.76ce7d8722ea9p-23},
        {"114.01234567890123", 0x1.fd697c1a97579p+0},
        {"0.1e-99", 0x1.f45d208ddd28fp-339},
        {"1e300", 0x1.aafe6d51317bbp+990},
        {"-360", -0x1.921fb54442d18p+2},
        {"57.295779513082320876798154814105", 0x1.0000000000000p+0},
        {"1234567890123456789012345678901234567890", 0x1.035daa7c090ccp+124},
        {"0.000000000000000000000000000012", 0x1.0fde371158071p-102},
        {"+12.5E+1", 0x1.1740afa84ad8ap+1},
        {"1e-320", 0x0.0000000000023p-1022},
        {"1.7976931348623158e308", 0x1.1df46a2529d39p+1018}, /* next to what a double cannot hold */
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        check_same(rows[i].radians, degrees_parse(rows[i].degrees), "%s degrees", rows[i].degrees);
    }
    TEST_ASSERT_TRUE(signbit(degrees_parse("-0")) && !signbit(degrees_parse("0")));
}

static void check_shortest(const char *expected, double radians)
{
    TEST_ASSERT_EQUAL_STRING(expected, degrees_shortest(radians, &(number_text){""}));
}

static void test_what_was_typed_is_shown(void)
{
    static const char *const typed[] = {"0", "-0", "90", "-160", "0.1", "33.3", "1e-05", "123.456789", "7.25e+20"};
    for (size_t i = 0; i < sizeof typed / sizeof typed[0]; i++) {
        check_shortest(typed[i], degrees_parse(typed[i]));
    }
    check_shortest("57.29577951308232", 1);
}

/* Where the two kinds of doubles are spaced differently, and on both sides of a power of ten or two. */
static void check_neighbours(double radians)
{
    enum { NEIGHBOURS = 8 };
    for (int i = 0; i < NEIGHBOURS; i++) {
        radians = nextafter(radians, -(double)INFINITY);
    }
    for (int i = 0; i < 2 * NEIGHBOURS; i++) {
        number_text shortest;
        double checked;
        TEST_ASSERT_EQUAL_INT(NUMBER_FINE, number_parse(degrees_shortest(radians, &shortest), &checked));
        check_same(radians, degrees_parse(shortest.text), "%s degrees", shortest.text);
        radians = nextafter(radians, (double)INFINITY);
    }
}

static void test_every_double_has_a_text(void)
{
    for (int i = -720; i <= 720; i++) {
        char text[16];
        snprintf(text, sizeof text, "%g", i / 2.0);
        check_neighbours(degrees_parse(text));
    }
    for (int exponent = -270; exponent <= 290; exponent += 5) {
        check_neighbours(pow(10, exponent) * 0.017453292519943295);
        check_neighbours(ldexp(1, 3 * exponent));
    }
    random_source random = {180};
    for (int i = 0; i < 5000; i++) {
        check_neighbours(random_between(&random, -4, 4));
    }
}

/* Near the least double degrees, too, have fewer digits; a neighbour at the most is what is read. */
static void test_the_least_numbers(void)
{
    random_source random = {77};
    for (int i = 0; i < 5000; i++) {
        const double radians = ldexp(random_between(&random, 1, 2), -1020 + i % 90);
        number_text shortest;
        double checked;
        TEST_ASSERT_EQUAL_INT(NUMBER_FINE, number_parse(degrees_shortest(radians, &shortest), &checked));
        check_within(radians * 3e-16, radians, degrees_parse(shortest.text), "%s degrees", shortest.text);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_nearest_double_is_taken);
    RUN_TEST(test_what_was_typed_is_shown);
    RUN_TEST(test_every_double_has_a_text);
    RUN_TEST(test_the_least_numbers);
    return UNITY_END();
}
