#ifndef ARMTOL_TABLES_EXPRESSION_H
#define ARMTOL_TABLES_EXPRESSION_H

#include "console/number.h"

#include <stdbool.h>

/*
 * A number as papers and spreadsheets write it: -3*pi/4, 2^-13, pi/2. Numbers in the sense of number_parse and pi,
 * joined by * and /, from left to right, each one raised to a whole power with ^, which binds closest; signs before
 * all, and in an exponent. No blanks but around * / and ^, no sums, no brackets. *has_pi: whether pi is in it. What is
 * wrong comes as of a number; *value then stays. Sizes that no double holds are NUMBER_TOO_LARGE, also on the way, as
 * is a division by 0.
 */
number_fault expression_parse(const char *text, double *value, bool *has_pi);

/* Whether a text is more than one decimal number. */
bool is_expression(const char *text);

#endif
