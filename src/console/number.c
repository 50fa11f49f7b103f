#include "console/number.h"

#include "console/message.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static size_t digits(const char *text)
{
    size_t n = 0;
    while (text[n] >= '0' && text[n] <= '9') {
        n++;
    }
    return n;
}

static size_t sign(const char *text)
{
    return *text == '+' || *text == '-' ? 1 : 0;
}

/* strtod takes more (hexadecimal, nan) and less (part of the text) than a person means by a number. */
static bool is_decimal(const char *text)
{
    text += sign(text);
    const size_t whole = digits(text);
    text += whole;
    size_t fraction = 0;
    if (*text == '.') {
        text++;
        fraction = digits(text);
        text += fraction;
    }
    if (whole + fraction == 0) {
        return false;
    }
    if (*text == 'e' || *text == 'E') {
        text++;
        text += sign(text);
        const size_t exponent = digits(text);
        text += exponent;
        return exponent > 0 && *text == '\0';
    }
    return *text == '\0';
}

static bool is_named(const char *text)
{
    text += sign(text);
    return strcasecmp(text, "nan") == 0 || strcasecmp(text, "inf") == 0 ||
           strcasecmp(text, "infinity") == 0;
}

number_fault number_parse(const char *text, double *value)
{
    if (is_named(text)) {
        return NUMBER_NOT_FINITE;
    }
    if (!is_decimal(text)) {
        return NUMBER_NONE;
    }
    const double parsed = strtod(text, NULL);
    if (!isfinite(parsed)) {
        return NUMBER_TOO_LARGE;
    }
    *value = parsed;
    return NUMBER_FINE;
}

size_t number_typeset_minus(const char *text)
{
    return strncmp(text, "\xe2\x88\x92", 3) == 0 || strncmp(text, "\xe2\x80\x93", 3) == 0 ? 3 : 0;
}

const char *number_shortest(double value, const armtol_errata *errata, number_text *shortest)
{
    for (int precision = 6; precision <= 17; precision++) {
        snprintf(shortest->text, sizeof shortest->text, "%.*g", precision, value);
        if (armtol_stored(errata, strtod(shortest->text, NULL)) == value) {
            break;
        }
    }
    return shortest->text;
}

const char *number_fault_text(number_fault fault)
{
    switch (fault) {
    case NUMBER_NOT_FINITE:
        return "is not a finite number";
    case NUMBER_TOO_LARGE:
        return "is too large a number";
    case NUMBER_TOO_LONG:
        return "is too long";
    default:
        return "is not a number";
    }
}

bool whole_number_of(const char *text, uint64_t least, uint64_t most, uint64_t *value)
{
    const size_t length = strlen(text);
    errno = 0;
    const unsigned long long parsed = strtoull(text, NULL, 10);
    const bool whole = length > 0 && strspn(text, "0123456789") == length && errno == 0;
    if (!whole || parsed < least || parsed > most) {
        return false;
    }
    *value = parsed;
    return true;
}

/* 1e6, 2.5e5: where a double holds the number to the last digit. */
static bool whole_decimal_of(const char *text, uint64_t least, uint64_t most, uint64_t *value)
{
    static const double largest = 9007199254740992; /* 2^53 */
    double number;
    if (number_parse(text, &number) != NUMBER_FINE || !(number >= 0 && number <= largest) || number != floor(number)) {
        return false;
    }
    const uint64_t whole = (uint64_t)number;
    *value = whole;
    return whole >= least && whole <= most;
}

bool whole_number_parse(const char *option, const char *text, uint64_t least, uint64_t most, uint64_t *value)
{
    const bool fine = whole_number_of(text, least, most, value) || whole_decimal_of(text, least, most, value);
    if (!fine) {
        message("%s: %s is not a whole number from %llu to %llu", option, message_quote(text, &(quoted){""}),
                (unsigned long long)least, (unsigned long long)most);
    }
    return fine;
}
