#include "1987/options.h"

#include "armtol/armtol.h"
#include "console/exit_code.h"
#include "console/flags.h"
#include "console/message.h"
#include "console/number.h"
#include "console/word.h"

#include <stdio.h>
#include <string.h>

static void print_help(const program *program)
{
    printf("Usage: %s [OPTION]...\n"
           "Tolerances for the links, joints and motors of %s, from a desired position\n"
           "of its tool and the accuracy required there, as the program of 1987 computed them.\n"
           "Asks on standard error, reads standard input: the position (",
           program->name, program->title);
    for (size_t i = 0; i < program->robot->n_wish; i++) {
        printf("%s%s", i > 0 ? " " : "", program->wish_names[i]);
    }
    printf("),\n"
           "the six tolerances (dx dy dz dwx dwy dwz) and delta, in mm and radians.\n"
           "Writes %sa.N, %sat.N, %stol.N and %smach.N.\n"
           "\n"
           "  -o, --output DIR            write the files into DIR (default: the current folder)\n"
           "  -r, --run N                 the run number in their names (default: 1)\n"
           "  -f, --fix NAME[,NAME]...    correct the named errata of 1987; `all' for every one\n"
           "  -l, --list-errata           list the errata and what each touches in %s\n"
           "  -h, --help                  show this and exit\n"
           "  -V, --version               show the version and exit\n"
           "\n"
           "Exit status: 0 done, 2 wrong input or usage, 1 any other failure.\n",
           program->file_prefix, program->file_prefix, program->file_prefix, program->file_prefix, program->name);
}

static void print_errata(const program *program)
{
    for (size_t i = 0; i < armtol_errata_count(); i++) {
        const armtol_erratum_info *erratum = armtol_erratum(i);
        printf("%-16s %s\n%-16s touches: %s", erratum->id, erratum->slip, "", erratum->touches);
        if (program_shows_erratum(program, i)) {
            putchar('\n');
        } else {
            printf("; changes nothing in %s\n", program->name);
        }
    }
}

void options_answer(action action, const program *program)
{
    switch (action) {
    case ACTION_LIST_ERRATA:
        print_errata(program);
        break;
    case ACTION_HELP:
        print_help(program);
        break;
    default:
        printf("%s (armtol) %s\n", program->name, armtol_version());
        break;
    }
}

static bool parse_run(const char *text, int *run)
{
    enum { RUN_DIGITS = 6 };
    uint64_t value;
    if (strlen(text) > RUN_DIGITS || !whole_number_of(text, 1, 999999, &value)) {
        message("--run: %s is not a run number; expected a whole number from 1 to 999999",
                message_quote(text, &(quoted){""}));
        return false;
    }
    *run = (int)value;
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

static bool fix_one(const char *id, void *errata)
{
    const bool known = armtol_erratum_keep(errata, id, false) == ARMTOL_OK;
    if (!known) {
        unknown_erratum(id);
    }
    return known;
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
        return words_each(argument, fix_one, &options->errata);
    default:
        options->action = option == 'l' ? ACTION_LIST_ERRATA : option == 'h' ? ACTION_HELP : ACTION_VERSION;
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
