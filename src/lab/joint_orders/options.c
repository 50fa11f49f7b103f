#include "lab/joint_orders/options.h"

#include "console/exit_code.h"
#include "console/flags.h"
#include "console/message.h"
#include "console/word.h"

#include <string.h>

void orders_options_help(void)
{
    printf("Usage: joint-orders [OPTION]... PUBLISHED\n"
           "The listing of 1987 prints every routine but invintell and invadept, the inverse\n"
           "kinematics. Runs a family of ways in which these two may have been written, on the\n"
           "cases of PUBLISHED, the table of the paper's numbers. What the listing prints is the\n"
           "same in all of them. Prints how many of the joint values each gives, and what that\n"
           "decides and leaves open.\n"
           "\n"
           "  -s, --show PART[,PART]  family     the choices and their options\n"
           "                          histogram  configurations by how many values are right\n"
           "                          choices    what the values say of each option\n"
           "                          margins    how near each value is to another last digit\n"
           "                          open       how much those that fit differ elsewhere\n"
           "                          misses     those with one wrong value\n"
           "                          all        every one that fits, a long list\n"
           "                          (default: every part but the last)\n"
           "  -g, --given CHOICE=OPTION[,CHOICE=OPTION]\n"
           "                          leave out what is written otherwise, in each program\n"
           "                          that has the choice\n"
           "  -f, --format FORMAT     text (default), markdown or tsv\n"
           "  -h, --help              show this and exit\n"
           "  -V, --version           show the version and exit\n"
           "\n"
           "Exit status: 0 done, 2 wrong input or usage, 1 any other failure.\n");
}

static bool parse_part(const char *name, void *context)
{
    orders_options *options = context;
    const size_t part = word_among(name, orders_part_names, PART_COUNT);
    if (part == PART_COUNT) {
        message("--show: unknown part %s; expected parts as in --help", message_quote(name, &(quoted){""}));
        return false;
    }
    options->show[part] = true;
    return true;
}

static bool parse_given(const char *text, void *context)
{
    orders_options *options = context;
    bool known = false;
    for (int i = 0; i < FAMILIES; i++) {
        known = family_restrict(families[i], text, &options->given[i]) || known;
    }
    if (!known) {
        message("--given: unknown option %s; expected CHOICE=OPTION as in --show=family",
                message_quote(text, &(quoted){""}));
    }
    return known;
}

static const struct option long_options[] = {
    {"show", required_argument, NULL, 's'},   {"given", required_argument, NULL, 'g'},
    {"format", required_argument, NULL, 'f'}, {"help", no_argument, NULL, 'h'},
    {"version", no_argument, NULL, 'V'},      {NULL, 0, NULL, 0},
};

static bool take(int option, const char *argument, void *context)
{
    orders_options *options = context;
    switch (option) {
    case 's':
        memset(options->show, 0, sizeof options->show);
        return words_each(argument, parse_part, options);
    case 'g':
        return words_each(argument, parse_given, options);
    case 'f':
        return table_format_parse(argument, &options->format);
    default:
        options->action = option == 'h' ? ORDERS_HELP : ORDERS_VERSION;
        return true;
    }
}

int orders_options_parse(int argc, char *argv[], orders_options *options)
{
    *options = (orders_options){.action = ORDERS_RUN, .format = FORMAT_TEXT};
    for (int i = 0; i < PART_COUNT; i++) {
        options->show[i] = i != PART_ALL;
    }
    if (!flags_read(argc, argv, "+:s:g:f:hV", long_options, take, options)) {
        return EXIT_WRONG;
    }
    if (options->action != ORDERS_RUN) {
        return EXIT_OK;
    }
    options->published = flags_argument(argc, argv, "the table of the paper's numbers",
                                        "joint-orders [OPTION]... PUBLISHED");
    return options->published != NULL ? EXIT_OK : EXIT_WRONG;
}
