#include "support/check.h"

#include "unity.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#ifdef __GNUC__
__attribute__((format(printf, 3, 0)))
#endif
static void fail(const char *expected, const char *actual, const char *format, va_list arguments)
{
    char what[200], text[400];
    vsnprintf(what, sizeof what, format, arguments);
    snprintf(text, sizeof text, "%s: expected %s, got %s", what, expected, actual);
    TEST_FAIL_MESSAGE(text);
}

#ifdef __GNUC__
__attribute__((format(printf, 3, 0)))
#endif
static void fail_numbers(double expected, double actual, const char *format, va_list arguments)
{
    char one[40], other[40];
    snprintf(one, sizeof one, "%.17g", expected);
    snprintf(other, sizeof other, "%.17g", actual);
    fail(one, other, format, arguments);
}

void check_within(double tolerance, double expected, double actual, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (!(fabs(actual - expected) <= tolerance)) {
        fail_numbers(expected, actual, format, arguments);
    }
    va_end(arguments);
}

void check_same(double expected, double actual, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (!(actual == expected)) {
        fail_numbers(expected, actual, format, arguments);
    }
    va_end(arguments);
}

void check_printed(const char *expected, double actual, const char *format, ...)
{
    char text[40];
    va_list arguments;
    va_start(arguments, format);
    snprintf(text, sizeof text, "%.6f", actual);
    if (strcmp(text, expected) != 0) {
        fail(expected, text, format, arguments);
    }
    va_end(arguments);
}
