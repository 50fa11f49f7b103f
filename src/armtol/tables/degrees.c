#include "armtol/tables/degrees.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/*
 * Method
 *    Degrees times pi/180, and radians over it, in numbers of about 32 digits: sums of two doubles (Dekker 1971). So a
 *    text is rounded once. To be shown, the fewest digits are tried that are read as the same radians.
 *
 * Special cases
 *    Powers of ten beyond 300 are left to strtod. Where no double of degrees is read as these radians, a decimal number
 *    beside the best of them is looked for.
 *
 * Accuracy
 *    The nearest double of radians, worked out with eighty digits (test_the_nearest_double_is_taken); every double that
 *    was tried is had again from its text (test_every_double_has_a_text).
 */

/* Decimal digits that tell any two doubles apart. */
enum { DIGITS = 17 };

/* A number of about 32 digits: the sum of two doubles, the second at most half a last digit of the first. */
typedef struct pair {
    double high, low;
} pair;

/* pi/180. */
static const pair degree = {0.017453292519943295, 2.9486522708701687e-19};

/* a + b, where a is 0 or not the smaller one. */
static pair sum(double a, double b)
{
    const double high = a + b;
    return (pair){high, b - (high - a)};
}

/* The upper 26 bits; what is left has as many. */
static double upper_half(double value)
{
    const double shifted = 134217729 * value; /* 2^27 + 1 */
    return shifted - (shifted - value);
}

/*
 * x y without what x * y keeps of it: Dekker's way, by halves whose products are exact. Not fma, which on some
 * machines changes how they round (rounding.h).
 */
static double rest_of_product(double x, double y)
{
    int x_exponent, y_exponent;
    x = frexp(x, &x_exponent); /* so that nothing over- or underflows on the way */
    y = frexp(y, &y_exponent);
    const double x_high = upper_half(x), x_low = x - x_high, y_high = upper_half(y), y_low = y - y_high;
    const double rest = ((x_high * y_high - x * y) + x_high * y_low + x_low * y_high) + x_low * y_low;
    return ldexp(rest, x_exponent + y_exponent);
}

static pair product(pair x, pair y)
{
    const double high = x.high * y.high;
    return sum(high, rest_of_product(x.high, y.high) + (x.high * y.low + x.low * y.high));
}

static pair quotient(pair x, pair y)
{
    const double high = x.high / y.high;
    const double rest = (x.high - high * y.high) - rest_of_product(high, y.high);
    return sum(high, (rest + (x.low - high * y.low)) / y.high);
}

static pair power_of_ten(unsigned exponent)
{
    pair power = {1, 0}, factor = {10, 0};
    for (; exponent > 0; exponent /= 2) {
        if (exponent % 2 != 0) {
            power = product(power, factor);
        }
        if (exponent > 1) {
            factor = product(factor, factor);
        }
    }
    return power;
}

/* A decimal number without its sign: digits 10^exponent. */
typedef struct decimal {
    uint64_t digits; /* the first 19 that count, which is enough: a double has 17 */
    long exponent;
} decimal;

static decimal decimal_of(const char *text)
{
    enum { KEPT = 19 };
    decimal number = {0, 0};
    bool fraction = false;
    int n = 0;
    for (; *text != '\0' && *text != 'e' && *text != 'E'; text++) {
        if (*text == '.') {
            fraction = true;
        } else if (n < KEPT) {
            number.digits = 10 * number.digits + (uint64_t)(*text - '0');
            number.exponent -= fraction;
            n += number.digits > 0;
        } else {
            number.exponent += !fraction;
        }
    }
    if (*text != '\0') {
        const long exponent = strtol(text + 1, NULL, 10);
        number.exponent += exponent > 10000 ? 10000 : exponent < -10000 ? -10000 : exponent;
    }
    return number;
}

/* Radians of a text without sign. Powers that a double cannot hold are left to strtod. */
static pair radians_of(const char *text)
{
    enum { MOST = 300 };
    const decimal number = decimal_of(text);
    if (number.exponent > MOST || number.exponent < -MOST) {
        return product((pair){strtod(text, NULL), 0}, degree);
    }
    const pair digits = sum((double)(number.digits >> 32) * 4294967296.0, (double)(number.digits & 0xffffffffu));
    const pair power = power_of_ten((unsigned)labs(number.exponent));
    /* The largest number of degrees may round up to infinity; as radians it is far from that. */
    return number.exponent < 0 ? product(quotient(digits, power), degree) : product(product(digits, degree), power);
}

double degrees_parse(const char *text)
{
    const bool negative = *text == '-';
    const double radians = radians_of(text + (negative || *text == '+')).high;
    return negative ? -radians : radians;
}

/* Adds 1 to the last digit before the exponent, or takes 1 away. False, the text then spoilt, at 9.99... or 0.00... */
static bool step_last_digit(char *text, bool up)
{
    const char from = up ? '9' : '0', to = up ? '0' : '9';
    char *digit = text + strcspn(text, "e") - 1;
    for (; digit >= text && (*digit == from || *digit == '.'); digit--) {
        *digit = *digit == from ? to : '.';
    }
    if (digit < text || *digit == '-') {
        return false;
    }
    *digit = (char)(*digit + (up ? 1 : -1));
    return true;
}

/* The first text beside this many degrees, in steps of the 17th digit, that is taken for these radians. */
static bool find_neighbour(double degrees, bool up, double radians, number_text *found)
{
    enum { FARTHEST = 12 }; /* half a last digit of a double is 11 units of the 17th digit at most */
    snprintf(found->text, sizeof found->text, "%#.*g", DIGITS, degrees);
    bool same = false;
    for (int i = 0; i < FARTHEST && !same && step_last_digit(found->text, up); i++) {
        same = degrees_parse(found->text) == radians;
    }
    return same;
}

const char *degrees_shortest(double radians, number_text *shortest)
{
    const double degrees = copysign(quotient((pair){radians, 0}, degree).high, radians); /* -0 too */
    for (int precision = 6; precision <= DIGITS; precision++) {
        snprintf(shortest->text, sizeof shortest->text, "%.*g", precision, degrees);
        if (degrees_parse(shortest->text) == radians) {
            return shortest->text;
        }
    }
    /* No double of degrees is read as this one, but a decimal number next to the best of them is. */
    if (!find_neighbour(degrees, true, radians, shortest) && !find_neighbour(degrees, false, radians, shortest)) {
        snprintf(shortest->text, sizeof shortest->text, "%.*g", DIGITS, degrees);
    }
    return shortest->text;
}
