#ifndef ARMTOL_CONSOLE_WHOLE_NUMBER_H
#define ARMTOL_CONSOLE_WHOLE_NUMBER_H

#include <stdbool.h>
#include <stdint.h>

/* A whole number, digits only, from least to most; false for anything else. */
bool whole_number_of(const char *text, uint64_t least, uint64_t most, uint64_t *value);

/* An option's whole number; false after a message that names the option. */
bool whole_number_parse(const char *option, const char *text, uint64_t least, uint64_t most, uint64_t *value);

#endif
