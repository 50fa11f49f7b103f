#include "console/flags.h"

#include "console/message.h"

#include <stddef.h>
#include <string.h>

bool flags_wrong(const char *what, const char *argument)
{
    message("%s %s; expected options as in --help", what, message_quote(argument, &(quoted){""}));
    return false;
}

/* getopt takes the beginning of a name for the name: a word that works today would mean another option tomorrow. */
static bool is_whole_name(const char *word, int option, const struct option names[])
{
    const bool is_long = word[0] == '-' && word[1] == '-';
    for (size_t i = 0; is_long && names[i].name != NULL; i++) {
        if (names[i].val == option) {
            const size_t length = strlen(names[i].name);
            return strncmp(word + 2, names[i].name, length) == 0 &&
                   (word[2 + length] == '\0' || word[2 + length] == '=');
        }
    }
    return true;
}

bool flags_read(int argc, char *argv[], const char *letters, const struct option names[], flag_taker *take,
                void *context)
{
    opterr = 0;
    for (;;) {
        const int at = optind == 0 ? 1 : optind; /* 0: getopt starts anew */
        const int option = getopt_long(argc, argv, letters, names, NULL);
        if (option == -1) {
            return true;
        }
        const bool fine = option == '?'   ? flags_wrong("unknown option", argv[at])
                          : option == ':' ? flags_wrong("an argument is missing after", argv[at])
                                          : is_whole_name(argv[at], option, names) ? take(option, optarg, context)
                                                                   : flags_wrong("unknown option", argv[at]);
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
