#include "1987/options.h"

#include "console/exit_code.h"
#include "console/flags.h"
#include "console/message.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#define RUN_DIGITS 6 /* run numbers up to 999999 */

static bool parse_run(const char *text, int *run)
{
    const size_t length = strlen(text);
    if (length == 0 || length > RUN_DIGITS || strspn(text, "0123456789") != length || atoi(text) == 0) {
        message("--run: %s is not a run number; expected a whole number from 1 to 999999",
                message_quote(text, &(quoted){""}));
        return false;
    }
    *run = atoi(text);
    return true;
}

static void unknown_erratum(const char *id)
{
    char known[512] = "";
    for (size_t i = 0; i < armtol_errata_count(); i++) {
        strncat(known, armtol_erratum(i)->id, sizeof known - strlen(known) - 1);
        strncat(known, ", ", sizeof known - strlen(known) - 1);
    }
    message("--fix: unknown erratum %s; known are %sand all", message_quote(id, &(quoted){""}), known);
}

/* One name of the list, up to a comma or the end. */
static bool fix_one(const char *name, size_t length, armtol_errata *errata)
{
    char id[64];
    const size_t kept = length < sizeof id ? length : sizeof id - 1;
    memcpy(id, name, kept);
    id[kept] = '\0';
    if (armtol_erratum_keep(errata, id, false) != ARMTOL_OK) {
        unknown_erratum(id);
        return false;
    }
    return true;
}

static bool parse_fix(const char *list, armtol_errata *errata)
{
    for (;;) {
        const size_t length = strcspn(list, ",");
        if (!fix_one(list, length, errata)) {
            return false;
        }
        if (list[length] == '\0') {
            return true;
        }
        list += length + 1;
    }
}

static const struct option long_options[] = {
    {"output", required_argument, NULL, 'o'}, {"run", required_argument, NULL, 'r'},
    {"fix", required_argument, NULL, 'f'},    {"list-errata", no_argument, NULL, 'l'},
    {"help", no_argument, NULL, 'h'},         {"version", no_argument, NULL, 'V'},
    {NULL, 0, NULL, 0},
};

static bool take(int option, const char *argument, void *context)
{
    options *options = context;
    switch (option) {
    case 'o':
        options->folder = argument;
        return true;
    case 'r':
        return parse_run(argument, &options->run);
    case 'f':
        return parse_fix(argument, &options->errata);
    case 'l':
        options->action = ACTION_LIST_ERRATA;
        return true;
    case 'h':
        options->action = ACTION_HELP;
        return true;
    default:
        options->action = ACTION_VERSION;
        return true;
    }
}

int options_parse(int argc, char *argv[], options *options)
{
    *options = (struct options){ACTION_RUN, ".", 1, armtol_errata_1987};
    if (!flags_read(argc, argv, "+:o:r:f:lhV", long_options, take, options)) {
        return EXIT_WRONG;
    }
    if (optind < argc) {
        flags_wrong("unexpected argument", argv[optind]);
        return EXIT_WRONG;
    }
    return EXIT_OK;
}
