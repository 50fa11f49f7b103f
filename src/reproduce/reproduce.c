/* reproduce: run intella and adpta on the paper's cases and hold what comes out against the paper. */

#include "compare.h"
#include "published.h"
#include "run_case.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct arguments {
    const char *programs, *published, *out;
    bool quiet;
} arguments;

static int usage(void)
{
    fprintf(stderr, "reproduce: expected: reproduce [--quiet] PROGRAMS PUBLISHED OUT\n"
                    "  PROGRAMS   the folder of intella and adpta\n"
                    "  PUBLISHED  the table of the paper's numbers\n"
                    "  OUT        the folder that gets 1987/CASE/ and corrected/CASE/\n"
                    "  --quiet    write the files, print no table\n");
    return 2;
}

static bool parse(int argc, char *argv[], arguments *arguments)
{
    arguments->quiet = argc > 1 && strcmp(argv[1], "--quiet") == 0;
    char **const rest = argv + 1 + arguments->quiet;
    if (argc - 1 - arguments->quiet != 3 || rest[0][0] == '-') {
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

static const char *remark_of(verdict verdict)
{
    switch (verdict) {
    case VERDICT_AGREES:
        return "agrees";
    case VERDICT_AGREES_WITHOUT_SIGN:
        return "agrees; the paper prints no sign";
    case VERDICT_DIFFERS:
        return "DIFFERS";
    default:
        return "MISSING";
    }
}

static void print_number(const published_number *number, const comparison *comparison)
{
    printf("  %-43s %12s %12s   %s\n", number->quantity, number->value, comparison->computed,
           remark_of(comparison->verdict));
}

static void print_case(const published_list *list, size_t first)
{
    printf("\n%s, case %d:", list->numbers[first].program, list->numbers[first].case_number);
    for (size_t i = first; i < list->count && published_same_case(&list->numbers[i], &list->numbers[first]);
         i++) {
        if (list->numbers[i].role == ROLE_WISH) {
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
        const bool agrees = result.verdict == VERDICT_AGREES || result.verdict == VERDICT_AGREES_WITHOUT_SIGN;
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
static bool report(const run_settings *settings, const published_list *list)
{
    tally tally;
    if (!compare_all(settings, list, false, &tally)) {
        return false;
    }
    printf("\n");
    if (tally.reproduced < tally.results && !compare_all(settings, list, true, &tally)) {
        return false;
    }
    printf("%zu of %zu published numbers reproduced\n", tally.reproduced, tally.results);
    return tally.results > 0 && tally.reproduced == tally.results && fflush(stdout) == 0;
}

static bool reproduce(const arguments *arguments, const published_list *list)
{
    char *out_1987 = path_of("%s/1987", arguments->out);
    char *out_corrected = path_of("%s/corrected", arguments->out);
    bool fine = out_1987 != NULL && out_corrected != NULL;
    if (fine) {
        const run_settings as_1987 = {arguments->programs, NULL, out_1987};
        const run_settings corrected = {arguments->programs, "all", out_corrected};
        fine = run_all(&as_1987, list) && run_all(&corrected, list) &&
               (arguments->quiet || report(&as_1987, list));
    }
    free(out_1987);
    free(out_corrected);
    return fine;
}

int main(int argc, char *argv[])
{
    arguments arguments;
    published_list list;
    if (!parse(argc, argv, &arguments)) {
        return usage();
    }
    const bool fine = published_read(arguments.published, &list) && reproduce(&arguments, &list);
    published_free(&list);
    return fine ? 0 : 1;
}
