#include "armtol/tables/expression.h"

#include <math.h>
#include <string.h>
#include <strings.h>

#define PI 3.14159265358979323846

/* What is read, and how far. */
typedef struct cursor {
    const char *at;
    bool has_pi;
    number_fault fault;
} cursor;

static void skip_blanks(cursor *cursor)
{
    cursor->at += strspn(cursor->at, " ");
}

static double fail(cursor *cursor, number_fault fault)
{
    cursor->fault = cursor->fault == NUMBER_FINE ? fault : cursor->fault;
    return 1;
}

/* How many characters a decimal number without a sign has; an exponent may have one. */
static size_t number_length(const char *text)
{
    size_t length = strspn(text, "0123456789.");
    if (length > 0 && (text[length] == 'e' || text[length] == 'E')) {
        length++;
        length += text[length] == '-' || text[length] == '+';
        length += strspn(text + length, "0123456789");
    }
    return length;
}

static double take_number(cursor *cursor)
{
    char word[64];
    double value;
    const size_t length = number_length(cursor->at);
    if (length >= sizeof word) {
        return fail(cursor, NUMBER_TOO_LONG);
    }
    memcpy(word, cursor->at, length);
    word[length] = '\0';
    cursor->at += length;
    const number_fault fault = number_parse(word, &value);
    return fault == NUMBER_FINE ? value : fail(cursor, fault);
}

/* The letter pi of Greek is two bytes as well. */
static double take_factor(cursor *cursor)
{
    const bool pi = strncasecmp(cursor->at, "pi", 2) == 0 || strncmp(cursor->at, "\xcf\x80", 2) == 0;
    if (!pi) {
        return take_number(cursor);
    }
    cursor->at += 2;
    cursor->has_pi = true;
    return PI;
}

static bool take_sign(cursor *cursor)
{
    const bool sign = *cursor->at == '-' || *cursor->at == '+', negative = *cursor->at == '-';
    cursor->at += sign;
    return negative;
}

/* By products: exact for powers of 2, and the same on every machine. */
static double whole_power(double base, unsigned exponent)
{
    double power = 1;
    for (unsigned i = 0; i < exponent; i++) {
        power *= base;
    }
    return power;
}

static double raise(cursor *cursor, double base)
{
    enum { MOST = 1000 };
    cursor->at++;
    skip_blanks(cursor);
    const bool negative = take_sign(cursor);
    const double exponent = take_number(cursor);
    if (exponent != floor(exponent) || exponent > MOST) {
        return fail(cursor, NUMBER_NONE);
    }
    const double power = whole_power(base, (unsigned)exponent);
    return negative ? 1 / power : power;
}

static double take_power(cursor *cursor)
{
    skip_blanks(cursor);
    const double base = take_factor(cursor);
    skip_blanks(cursor);
    const double power = *cursor->at == '^' ? raise(cursor, base) : base;
    skip_blanks(cursor);
    return power;
}

static double take_product(cursor *cursor)
{
    double value = take_power(cursor);
    while (*cursor->at == '*' || *cursor->at == '/') {
        const bool divided = *cursor->at++ == '/';
        const double factor = take_power(cursor);
        value = divided ? value / factor : value * factor;
    }
    return value;
}

number_fault expression_parse(const char *text, double *value, bool *has_pi)
{
    cursor cursor = {.at = text, .fault = NUMBER_FINE};
    const bool negative = take_sign(&cursor);
    const double magnitude = take_product(&cursor);
    if (cursor.fault != NUMBER_FINE) {
        return cursor.fault;
    }
    if (*cursor.at != '\0') {
        return NUMBER_NONE;
    }
    if (!isfinite(magnitude)) {
        return NUMBER_TOO_LARGE;
    }
    *value = negative ? -magnitude : magnitude;
    *has_pi = cursor.has_pi;
    return NUMBER_FINE;
}

bool is_expression(const char *text)
{
    return strpbrk(text, "*/^pP\xcf") != NULL;
}
