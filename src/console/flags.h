#ifndef ARMTOL_CONSOLE_FLAGS_H
#define ARMTOL_CONSOLE_FLAGS_H

#include <getopt.h>
#include <stdbool.h>

/* Takes one option; false, after a message, where its argument is wrong. */
typedef bool flag_taker(int option, const char *argument, void *context);

/*
 * Give every option of a command line to the taker; names are to be written out. letters are getopt's, and begin with
 * "+:". False after a message; else optind is the first argument behind the options.
 */
bool flags_read(int argc, char *argv[], const char *letters, const struct option names[], flag_taker *take,
                void *context);

/*
 * The one argument behind the options, or NULL after a message: what it is ("the table") and how the program is called
 * go into that.
 */
const char *flags_argument(int argc, char *argv[], const char *what, const char *call);

/* "unknown option", say, and which. Always false. */
bool flags_wrong(const char *what, const char *argument);

#endif
