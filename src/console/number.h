#ifndef ARMTOL_CONSOLE_NUMBER_H
#define ARMTOL_CONSOLE_NUMBER_H

#include "armtol/errata.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum number_fault {
    NUMBER_FINE,
    NUMBER_NONE,       /* not a decimal number */
    NUMBER_NOT_FINITE, /* nan, inf */
    NUMBER_TOO_LARGE,  /* beyond what a double holds */
    NUMBER_TOO_LONG    /* more characters than a word may have */
} number_fault;

/*
 * A decimal number, with a point whatever the locale of the environment (no program here calls setlocale):
 * sign, digits with at most one point, exponent. The whole text has to be one; *value only changes if it is.
 */
number_fault number_parse(const char *text, double *value);

/* A whole number, digits only, from least to most; false for anything else. */
bool whole_number_of(const char *text, uint64_t least, uint64_t most, uint64_t *value);

/* An option's whole number; false after a message that names the option. */
bool whole_number_parse(const char *option, const char *text, uint64_t least, uint64_t most, uint64_t *value);

/* How many bytes of a typeset minus sign the text begins with: U+2212, or a dash (U+2013) that an editor made of it. */
size_t number_typeset_minus(const char *text);

/* Room for a number: number_shortest(value, errata, &(number_text){""}). */
typedef struct number_text {
    char text[32];
} number_text;

/* The shortest decimal text that is stored as this value again, of six digits or more. Returns shortest->text. */
const char *number_shortest(double value, const armtol_errata *errata, number_text *shortest);

/* What is wrong, to come after the quoted text: "is not a number". */
const char *number_fault_text(number_fault fault);

#endif
