#ifndef TEST_CHECK_H
#define TEST_CHECK_H

#include <stddef.h>

/*
 * Doubles, compared without Unity's own (stock builds of Unity leave them out). A failure says both values to 17
 * digits and, printf-like, what they are.
 */

/* |actual - expected| <= tolerance; never true of nan. */
void check_within(double tolerance, double expected, double actual, const char *format, ...)
#ifdef __GNUC__
    __attribute__((format(printf, 4, 5)))
#endif
    ;

/* The same double, but that any zero equals any other. */
void check_same(double expected, double actual, const char *format, ...)
#ifdef __GNUC__
    __attribute__((format(printf, 3, 4)))
#endif
    ;

/* Equal when printed with six decimals, as the paper prints: expected is the paper's text. */
void check_printed(const char *expected, double actual, const char *format, ...)
#ifdef __GNUC__
    __attribute__((format(printf, 3, 4)))
#endif
    ;

#endif
