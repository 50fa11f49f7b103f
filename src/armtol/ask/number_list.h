#ifndef ARMTOL_ASK_NUMBER_LIST_H
#define ARMTOL_ASK_NUMBER_LIST_H

#include <stdbool.h>
#include <stddef.h>

/*
 * The argument of an option that takes numbers, separated by commas or blanks: "0,45,-90". It has to hold exactly
 * `count`; what they are ("dx,dy,dz") goes into the message of a wrong one. Where may_be_free, `-` or `inf` stands for
 * infinity. False after a message that names the option.
 */
bool number_list_parse(const char *option, const char *text, const char *what, bool may_be_free, size_t count,
                       double values[]);

/* An option's single number, and one that has to be positive. */
bool number_option_parse(const char *option, const char *text, double *value);
bool number_option_positive(const char *option, const char *text, double *value);

#endif
