#include "1987/help.h"

#include "armtol/armtol.h"

#include <stdio.h>

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

void help_print(action action, const program *program)
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
