#include "console/flags.h"

#include "console/message.h"

#include <stddef.h>

bool flags_wrong(const char *what, const char *argument)
{
    message("%s %s; expected options as in --help", what, message_quote(argument, &(quoted){""}));
    return false;
}

bool flags_read(int argc, char *argv[], const char *letters, const struct option names[], flag_taker *take,
                void *context)
{
    opterr = 0;
    for (;;) {
        const int at = optind;
        const int option = getopt_long(argc, argv, letters, names, NULL);
        if (option == -1) {
            return true;
        }
        const bool fine = option == '?'   ? flags_wrong("unknown option", argv[at])
                          : option == ':' ? flags_wrong("an argument is missing after", argv[at])
                                          : take(option, optarg, context);
        if (!fine) {
            return false;
        }
    }
}

const char *flags_argument(int argc, char *argv[], const char *what, const char *call)
{
    if (optind == argc) {
        message("%s is missing; expected %s", what, call);
        return NULL;
    }
    if (optind + 1 < argc) {
        message("unexpected argument %s; expected %s", message_quote(argv[optind + 1], &(quoted){""}), call);
        return NULL;
    }
    return argv[optind];
}
