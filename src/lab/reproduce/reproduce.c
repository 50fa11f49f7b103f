/* reproduce: run intella and adpta on the paper's cases and hold what comes out against the paper. */

#include "console/exit_code.h"
#include "console/flags.h"
#include "console/message.h"
#include "console/rounding.h"
#include "lab/published.h"
#include "lab/reproduce/compare.h"
#include "lab/reproduce/measure.h"
#include "lab/reproduce/run_case.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum mode { MODE_RUN, MODE_ERRATA, MODE_WALK, MODE_PORTABILITY } mode;

typedef struct arguments {
    mode mode;
    table_format format;
    bool quiet, only_misses, legacy;
    const char *runner;
    const char *programs, *published, *out;
} arguments;

static int usage(void)
{
    message("expected one of");
    message_note("  reproduce [--quiet | --misses] [--legacy [--runner=COMMAND]] PROGRAMS PUBLISHED OUT\n"
                 "  reproduce --errata | --walk | --portability [--format=text|markdown|tsv] PUBLISHED\n"
                 "\n"
                 "  PROGRAMS       the folder of intella and adpta\n"
                 "  PUBLISHED      the table of the paper's numbers\n"
                 "  OUT            the folder that gets 1987/CASE/ and corrected/CASE/\n"
                 "  --quiet        write the files, print nothing\n"
                 "  --misses       print what differs and the count, not the tables\n"
                 "  --legacy       the programs are those of legacy/, which know no corrections\n"
                 "  --runner       what to start them with: an emulator\n"
                 "  --errata       the bounds with each erratum corrected alone, and with each kept alone\n"
                 "  --walk         the bounds from 1987 to all corrected, an erratum at a time\n"
                 "  --portability  the published numbers for float and double storage, 3.14159 and pi");
    return EXIT_WRONG;
}

enum { OPTION_FORMAT = 1000, OPTION_QUIET, OPTION_MISSES, OPTION_LEGACY, OPTION_RUNNER };

static const struct option long_options[] = {
    {"quiet", no_argument, NULL, OPTION_QUIET},
    {"misses", no_argument, NULL, OPTION_MISSES},
    {"legacy", no_argument, NULL, OPTION_LEGACY},
    {"runner", required_argument, NULL, OPTION_RUNNER},
    {"errata", no_argument, NULL, MODE_ERRATA},
    {"walk", no_argument, NULL, MODE_WALK},
    {"portability", no_argument, NULL, MODE_PORTABILITY},
    {"format", required_argument, NULL, OPTION_FORMAT},
    {NULL, 0, NULL, 0},
};

static bool apply(int option, const char *argument, void *context)
{
    arguments *arguments = context;
    switch (option) {
    case OPTION_QUIET:
        arguments->quiet = true;
        return true;
    case OPTION_MISSES:
        arguments->only_misses = true;
        return true;
    case OPTION_LEGACY:
        arguments->legacy = true;
        return true;
    case OPTION_RUNNER:
        arguments->runner = argument;
        return true;
    case OPTION_FORMAT:
        return table_format_parse(argument, &arguments->format);
    default:
        arguments->mode = (mode)option;
        return true;
    }
}

static bool parse(int argc, char *argv[], arguments *arguments)
{
    *arguments = (struct arguments){.mode = MODE_RUN, .format = FORMAT_TEXT, .runner = ""};
    if (!flags_read(argc, argv, "+:", long_options, apply, arguments)) {
        return false;
    }
    char **rest = argv + optind;
    if (arguments->mode != MODE_RUN) {
        arguments->published = rest[0];
        return argc - optind == 1;
    }
    if (argc - optind != 3) {
        return false;
    }
    arguments->programs = rest[0];
    arguments->published = rest[1];
    arguments->out = rest[2];
    return true;
}

static bool run_all(const run_settings *settings, const published_list *list)
{
    bool fine = true;
    for (size_t i = 0; i < list->count; i++) {
        fine = fine && (!published_begins_case(list, i) || run_case(settings, list, i));
    }
    return fine;
}

static void print_number(const published_number *number, const comparison *comparison)
{
    static const char *const remarks[] = {
        [VERDICT_AGREES] = "agrees", [VERDICT_AGREES_WITHOUT_SIGN] = "agrees; the paper prints no sign",
        [VERDICT_DIFFERS] = "DIFFERS", [VERDICT_MISSING] = "MISSING",
    };
    printf("  %-43s %12s %12s   %s\n", number->quantity, number->value, comparison->computed,
           remarks[comparison->verdict]);
}

static void print_case(const published_list *list, size_t first)
{
    printf("\n%s, case %d:", list->numbers[first].program, list->numbers[first].case_number);
    for (size_t i = first; i < list->count && published_same_case(&list->numbers[i], &list->numbers[first]);
         i++) {
        if (list->numbers[i].role == ROLE_POSITION) {
            printf(" %s = %s", list->numbers[i].quantity, list->numbers[i].value);
        }
    }
    printf("\n\n  %-43s %12s %12s\n", "", "published", "computed");
}

typedef struct tally {
    size_t results, reproduced;
} tally;

/* Compare the case that begins at `first`. False where its files cannot be read. */
static bool compare_case(const run_settings *settings, const published_list *list, size_t first,
                         bool only_misses, tally *tally)
{
    char *files = run_case_results(settings, &list->numbers[first]);
    if (files == NULL) {
        return false;
    }
    for (size_t i = first; i < list->count && published_same_case(&list->numbers[i], &list->numbers[first]);
         i++) {
        const published_number *number = &list->numbers[i];
        if (number->role != ROLE_RESULT) {
            continue;
        }
        const comparison result = compare_number(number, files);
        const bool agrees = compare_agrees(&result);
        tally->results++;
        tally->reproduced += agrees;
        if (!only_misses) {
            print_number(number, &result);
        } else if (!agrees) {
            printf("missed: %s, case %d, %s: published %s, computed %s\n", number->program,
                   number->case_number, number->quantity, number->value,
                   result.verdict == VERDICT_MISSING ? "nothing" : result.computed);
        }
    }
    free(files);
    return true;
}

static bool compare_all(const run_settings *settings, const published_list *list, bool only_misses,
                        tally *tally)
{
    bool fine = true;
    *tally = (struct tally){0, 0};
    for (size_t i = 0; i < list->count && fine; i++) {
        if (published_begins_case(list, i)) {
            if (!only_misses) {
                print_case(list, i);
            }
            fine = compare_case(settings, list, i, only_misses, tally);
        }
    }
    return fine;
}

/* The tables, the misses once more, the count. */
static bool report(const run_settings *settings, const published_list *list, bool only_misses)
{
    tally tally;
    if (!compare_all(settings, list, only_misses, &tally)) {
        return false;
    }
    if (!only_misses) {
        printf("\n");
        if (tally.reproduced < tally.results && !compare_all(settings, list, true, &tally)) {
            return false;
        }
    }
    printf("%zu of %zu published numbers reproduced\n", tally.reproduced, tally.results);
    return tally.results > 0 && tally.reproduced == tally.results;
}

static bool run_and_compare(const arguments *arguments, const published_list *list)
{
    path out_1987, out_corrected;
    const run_settings as_1987 = {arguments->programs, NULL, out_1987.text, arguments->legacy, arguments->runner};
    const run_settings corrected = {arguments->programs, "all", out_corrected.text, false, ""};
    return path_of(&out_1987, "%s/1987", arguments->out) && path_of(&out_corrected, "%s/corrected", arguments->out) &&
           run_all(&as_1987, list) && (arguments->legacy || run_all(&corrected, list)) &&
           (arguments->quiet || report(&as_1987, list, arguments->only_misses));
}

static bool reproduce(const arguments *arguments, const published_list *list)
{
    switch (arguments->mode) {
    case MODE_ERRATA:
        return measure_errata(list, arguments->format);
    case MODE_WALK:
        return measure_walk(list, arguments->format);
    case MODE_PORTABILITY:
        return measure_portability(list, arguments->format);
    default:
        return run_and_compare(arguments, list);
    }
}

int main(int argc, char *argv[])
{
    arguments arguments;
    published_list list;
    rounding_to_double();
    message_start("reproduce");
    signal(SIGCHLD, SIG_DFL); /* whoever starts it may ignore it: children are then not to be waited for */
    if (!parse(argc, argv, &arguments)) {
        return usage();
    }
    const bool fine = published_read(arguments.published, &list) && reproduce(&arguments, &list);
    published_free(&list);
    return exit_code_of_output(fine ? EXIT_OK : EXIT_FAILED);
}
