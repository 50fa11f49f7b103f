#include "lab/yield/options.h"

#include "console/exit_code.h"
#include "console/flags.h"
#include "console/message.h"
#include "console/number.h"
#include "console/word.h"

#include <stdio.h>

enum { SAMPLES = 100000, MOST_SAMPLES = 10000000, SEED = 1987 };

void yield_options_help(void)
{
    printf("Usage: yield [OPTION]... PUBLISHED\n"
           "Draws arms built to the tolerances of 1987, and to the corrected ones, for every\n"
           "case of PUBLISHED, the table of the paper's numbers; prints how many of them keep\n"
           "to the accuracy asked for, and what the worst of them do.\n"
           "\n"
           "  -n, --samples N         arms to draw for each case and set (default: %d)\n"
           "  -s, --seed N            the draws to take, a whole number (default: %d)\n"
           "  -l, --lengths READING   what a length may be off: `share', its share of the bound\n"
           "                          (default), or `rd', the link's distance tolerance, where\n"
           "                          that is a link's only length\n"
           "  -f, --format FORMAT     text (default), markdown or tsv\n"
           "  -h, --help              show this and exit\n"
           "  -V, --version           show the version and exit\n"
           "\n"
           "Exit status: 0 done, 2 wrong input or usage, 1 any other failure.\n",
           SAMPLES, SEED);
}

static bool parse_samples(const char *text, size_t *samples)
{
    uint64_t value;
    const bool fine = whole_number_parse("--samples", text, 1, MOST_SAMPLES, &value);
    *samples = fine ? (size_t)value : *samples;
    return fine;
}

static bool parse_reading(const char *text, length_reading *reading)
{
    static const char *const names[LENGTH_READING_COUNT] = {"share", "rd"};
    *reading = (length_reading)word_among(text, names, LENGTH_READING_COUNT);
    if (*reading == LENGTH_READING_COUNT) {
        message("--lengths: unknown reading %s; expected share or rd", message_quote(text, &(quoted){""}));
    }
    return *reading < LENGTH_READING_COUNT;
}

static const struct option long_options[] = {
    {"samples", required_argument, NULL, 'n'}, {"seed", required_argument, NULL, 's'},
    {"lengths", required_argument, NULL, 'l'}, {"format", required_argument, NULL, 'f'},
    {"help", no_argument, NULL, 'h'},          {"version", no_argument, NULL, 'V'},
    {NULL, 0, NULL, 0},
};

static bool take(int option, const char *argument, void *context)
{
    yield_options *options = context;
    switch (option) {
    case 'n':
        return parse_samples(argument, &options->samples);
    case 's':
        return whole_number_parse("--seed", argument, 0, UINT64_MAX, &options->seed);
    case 'l':
        return parse_reading(argument, &options->reading);
    case 'f':
        return table_format_parse(argument, &options->format);
    default:
        options->action = option == 'h' ? YIELD_HELP : YIELD_VERSION;
        return true;
    }
}

int yield_options_parse(int argc, char *argv[], yield_options *options)
{
    *options = (yield_options){YIELD_RUN, SAMPLES, SEED, LENGTHS_SHARE, FORMAT_TEXT, NULL};
    if (!flags_read(argc, argv, "+:n:s:l:f:hV", long_options, take, options)) {
        return EXIT_WRONG;
    }
    if (options->action != YIELD_RUN) {
        return EXIT_OK;
    }
    options->published = flags_argument(argc, argv, "the table of the paper's numbers",
                                        "yield [OPTION]... PUBLISHED");
    return options->published != NULL ? EXIT_OK : EXIT_WRONG;
}
