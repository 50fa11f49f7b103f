/* The program `reproduce`: the paper's table, altered and broken ones, programs that fail, wrong usage. */

#include "programs/programs.h"

#include "unity.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

static void run_reproduce(const char *const arguments[], process *process)
{
    const process_setup setup = {.program = TEST_REPRODUCE, .arguments = arguments};
    process_run(process, &setup, "");
}

/* The usual call: the programs of this build unless others are given. */
static void reproduce(const char *programs_folder, const char *table, const char *out, process *process)
{
    const char *const arguments[] = {programs_folder, table, out, NULL};
    run_reproduce(arguments, process);
}

static void check_ends_with(const text *said, const char *end)
{
    const size_t length = strlen(end);
    if (said->length < length || strcmp(said->bytes + said->length - length, end) != 0) {
        fail_with("expected the last line \"%s\", got \"%s\"", end, said->bytes);
    }
}

static void check_says(const text *said, const char *words)
{
    if (strstr(said->bytes, words) == NULL) {
        fail_with("expected \"%s\" in \"%s\"", words, said->bytes);
    }
}

/* ---- the paper's table ---- */

static void check_written(const char *out)
{
    const char *const sets[] = {golden_1987, golden_corrected};
    for (int i = 0; i < PROGRAMS; i++) {
        for (int j = 0; j < 2; j++) {
            for (int number = 1; number <= 2; number++) {
                const string folder = string_of("%s/%s/%s-%d", out, sets[j], programs[i].name, number);
                const string input = golden_of(sets[j], &programs[i], number, "input");
                const string dialogue = golden_of(sets[j], &programs[i], number, "dialogue");
                const string written_input = string_of("%s/input", folder.text);
                const string written_dialogue = string_of("%s/dialogue", folder.text);
                file_check_same(input.text, written_input.text, "input");
                file_check_same(dialogue.text, written_dialogue.text, "dialogue");
                check_golden(folder.text, 1, &programs[i], sets[j], number, FILES, "reproduce");
            }
        }
    }
}

static void test_paper_is_reproduced(void)
{
    const string folder = folder_new(), out = string_of("%s/new/below", folder.text);
    process process;
    reproduce(TEST_PROGRAMS, TEST_PUBLISHED, out.text, &process);
    process_check_status(&process, 0, "reproduce");
    text_check("", 0, &process.errors, "standard error");
    check_ends_with(&process.output, "\n66 of 66 published numbers reproduced\n");
    TEST_ASSERT_NULL(strstr(process.output.bytes, "missed"));
    check_written(out.text);
}

/* As `make run` does it a second time. */
static void test_files_of_an_earlier_run_are_replaced(void)
{
    const string out = folder_new();
    process process;
    for (int i = 0; i < 2; i++) {
        reproduce(TEST_PROGRAMS, TEST_PUBLISHED, out.text, &process);
        process_check_status(&process, 0, "reproduce");
    }
    check_written(out.text);
}

static void test_quiet_only_writes(void)
{
    const string out = folder_new();
    const char *const arguments[] = {"--quiet", TEST_PROGRAMS, TEST_PUBLISHED, out.text, NULL};
    process process;
    run_reproduce(arguments, &process);
    process_check_status(&process, 0, "reproduce --quiet");
    text_check("", 0, &process.output, "standard output");
    text_check("", 0, &process.errors, "standard error");
    check_written(out.text);
}

/* ---- other programs than the port ---- */

/* Shell scripts in the programs' place. %s in them is the program of 1987, what it never sets being zero. */
static string fake_programs(const char *script)
{
    const string folder = folder_new();
    const char *place = strstr(script, "%s");
    for (int i = 0; i < PROGRAMS; i++) {
        const string file = string_of("%s/%s", folder.text, programs[i].name);
        const string content = place == NULL ? string_of("%s", script)
                                             : string_of("%.*s%s%s", (int)(place - script), script,
                                                         programs[i].legacy, place + 2);
        file_write(file.text, content.text);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, chmod(file.text, 0755), file.text);
    }
    return folder;
}

/* All that the zero diagonal spoils: the Adept's bounds on angles, and what follows from them. */
static void test_programs_of_1987(void)
{
    const string out = folder_new(), legacy = fake_programs("#!/bin/sh\ntest \"$ERA\" = 1987 && exec '%s'\n");
    const char *const arguments[] = {
        "--misses", "--legacy", "--runner=env ERA=1987", legacy.text, TEST_PUBLISHED, out.text, NULL};
    process process;
    run_reproduce(arguments, &process);
    process_check_status(&process, 1, "the programs of 1987");
    TEST_ASSERT_EQUAL_STRING(
        "missed: adpta, case 1, ggd[0..5]: published 0.005313, computed 0.005315\n"
        "missed: adpta, case 1, td[0..2]: published 0.005313, computed 0.005315\n"
        "missed: adpta, case 2, A bound on the error in angle parameters: published 0.000666, "
        "computed 0.000665\n"
        "missed: adpta, case 2, ggd[0..5]: published 0.006081, computed 0.006080\n"
        "missed: adpta, case 2, td[0..2]: published 0.006081, computed 0.006080\n"
        "61 of 66 published numbers reproduced\n",
        process.output.bytes);
    folder_check(out.text, "1987", "there is nothing corrected");
}

/* ---- altered tables ---- */

/* Write the paper's table to a file, one line changed (NULL: gone). */
static void write_altered(const char *file, const char *line, const char *changed)
{
    text table;
    file_read(TEST_PUBLISHED, &table);
    const string whole = string_of("\n%s\n", line);
    char *found = strstr(table.bytes, whole.text);
    if (found == NULL || strstr(found + 1, whole.text) != NULL) {
        fail_with("expected the line \"%s\" once in the table", line);
    }
    FILE *stream = fopen(file, "w");
    TEST_ASSERT_NOT_NULL_MESSAGE(stream, file);
    fprintf(stream, "%.*s\n", (int)(found - table.bytes), table.bytes);
    if (changed != NULL) {
        fprintf(stream, "%s\n", changed);
    }
    fputs(found + strlen(whole.text), stream);
    fclose(stream);
}

typedef struct altered {
    const char *line, *changed;
    const char *count, *miss; /* last line, and what is said of the miss */
} altered;

static const altered altered_tables[] = {
    {"intella\t1\tresult\ttheta[1]\t1.571237\t-", "intella\t1\tresult\ttheta[1]\t1.571238\t-", "65 of 66",
     "intella, case 1, theta[1]: published 1.571238, computed 1.571237"},
    {"intella\t2\tresult\trd[7]\t0.054521\t-", "intella\t2\tresult\trd[7]\t0.05452\t-", "65 of 66",
     "intella, case 2, rd[7]: published 0.05452, computed 0.054521"},
    {"adpta\t2\tresult\tggd[0..5]\t0.006081\t-", "adpta\t2\tresult\tggd[0..5]\t0.006080\t-", "65 of 66",
     "adpta, case 2, ggd[0..5]: published 0.006080, computed 0.006081"},
    {"adpta\t1\tresult\ttd[0..2]\t0.005313\t-", "adpta\t1\tresult\ttd[0..3]\t0.005313\t-", "65 of 66",
     "adpta, case 1, td[0..3]: published 0.005313, computed -0.055833"},
    {"adpta\t1\tresult\trd[4]\t0.055833\tunsigned", "adpta\t1\tresult\trd[4]\t0.055833\t-", "65 of 66",
     "adpta, case 1, rd[4]: published 0.055833, computed -0.055833"},
    {"intella\t1\tresult\ttheta[1]\t1.571237\t-", "intella\t1\tresult\ttheta[7]\t1.571237\t-", "65 of 66",
     "intella, case 1, theta[7]: published 1.571237, computed nothing"},
    {"adpta\t1\tresult\ttheta[1]\t-0.262798\t-", "adpta\t1\tresult\ttheta[1]\t0.262798\t-", "65 of 66",
     "adpta, case 1, theta[1]: published 0.262798, computed -0.262798"},
    /* fewer and more: the numbers are counted */
    {"intella\t1\tresult\trd[3]\t0.050177\t-", NULL, "65 of 65", NULL},
    {"intella\t1\tresult\trd[3]\t0.050177\t-",
     "intella\t1\tresult\trd[3]\t0.050177\t-\nintella\t1\tresult\tdwx\t0.100000\t-", "67 of 67", NULL},
};

/* With --misses only the miss and the count are printed. */
static void check_misses_only(const altered *altered, const char *table, const char *out)
{
    const char *const arguments[] = {"--misses", TEST_PROGRAMS, table, out, NULL};
    const string expected = string_of(
        "%s%s%s%s published numbers reproduced\n", altered->miss != NULL ? "missed: " : "",
        altered->miss != NULL ? altered->miss : "", altered->miss != NULL ? "\n" : "", altered->count);
    process process;
    run_reproduce(arguments, &process);
    process_check_status(&process, altered->miss != NULL ? 1 : 0, expected.text);
    text_check(expected.text, strlen(expected.text), &process.output, "--misses");
}

static void check_altered(const altered *altered)
{
    const string folder = folder_new(), table = string_of("%s/altered.tsv", folder.text);
    const string out = string_of("%s/out", folder.text);
    const string last = string_of("\n%s published numbers reproduced\n", altered->count);
    const char *what = altered->changed != NULL ? altered->changed : altered->line;
    process process;
    write_altered(table.text, altered->line, altered->changed);
    reproduce(TEST_PROGRAMS, table.text, out.text, &process);
    process_check_status(&process, altered->miss != NULL ? 1 : 0, what);
    check_ends_with(&process.output, last.text);
    if (altered->miss != NULL) {
        check_says(&process.output, altered->miss);
    }
    check_misses_only(altered, table.text, out.text);
}

static void test_altered_tables(void)
{
    for (size_t i = 0; i < sizeof altered_tables / sizeof altered_tables[0]; i++) {
        check_altered(&altered_tables[i]);
    }
}

/* A table without any result reproduces nothing, which is no success. */
static void test_table_without_results(void)
{
    static const char *const tables[] = {"", "# nothing but words\n", "adpta\t1\tposition\tx\t200\t-\n",
                                         "*\t*\tdelta\tdelta\t.1\t-\n"};
    for (size_t i = 0; i < sizeof tables / sizeof tables[0]; i++) {
        const string folder = folder_new(), table = string_of("%s/table.tsv", folder.text);
        process process;
        file_write(table.text, tables[i]);
        reproduce(TEST_PROGRAMS, table.text, folder.text, &process);
        process_check_status(&process, 1, tables[i]);
    }
}

/* ---- broken tables ---- */

/* What is said names the file and the line, and nothing is run. */
static void check_broken(const char *content, int line)
{
    const string folder = folder_new(), table = string_of("%s/broken.tsv", folder.text);
    const string out = string_of("%s/out", folder.text);
    const string place = string_of("reproduce: %s:%d: ", table.text, line);
    process process;
    file_write(table.text, content);
    reproduce(TEST_PROGRAMS, table.text, out.text, &process);
    process_check_status(&process, 1, content);
    check_says(&process.errors, place.text);
    folder_check(folder.text, "broken.tsv", content);
}

static void test_broken_tables(void)
{
    static const struct {
        const char *table;
        int line;
    } rows[] = {
        {"intella\n", 1},
        {"# head\nintella\t1\tposition\tx\t200\n", 2},
        {"# head\n# more\nintella 1 wish x 200 -\n", 3},
        {"intella\t1\tposition\tx\t200\t-\t-\n", 1},
        {"intella\t1\twish\tx\t200\t-\n", 1},
        {"intella\t0\tposition\tx\t200\t-\n", 1},
        {"intella\tone\tposition\tx\t200\t-\n", 1},
        {"\t1\tposition\tx\t200\t-\n", 1},
        {"intella\t1\tposition\t\t200\t-\n", 1},
        {"intella\t1\tposition\tx\t\t-\n", 1},
        {"intella\t1\tposition\tx\t200\t-\n\n", 2},
        {"intella\t*\tdelta\tdelta\t.1\t-\n", 1},
        {"*\t1\tdelta\tdelta\t.1\t-\n", 1},
        {"intella\t1\tposition\tx\t00000000000000000000000000000000200\t-\n", 1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        check_broken(rows[i].table, rows[i].line);
    }
}

static void test_case_that_is_only_partly_a_number(void)
{
    check_broken("intella\t1x\tposition\tx\t200\t-\n", 1);
}

/* ---- what is missing or fails ---- */

static void check_fails(const char *programs_folder, const char *table, const char *out, const char *words)
{
    process process;
    reproduce(programs_folder, table, out, &process);
    process_check_status(&process, 1, words);
    check_says(&process.errors, "reproduce: ");
    check_says(&process.errors, words);
    TEST_ASSERT_NULL_MESSAGE(strstr(process.output.bytes, "66 of 66"), process.output.bytes);
}

static void test_what_is_missing(void)
{
    const string folder = folder_new(), missing = string_of("%s/missing", folder.text);
    const string file = string_of("%s/file", folder.text), below = string_of("%s/below", file.text);
    file_write(file.text, "in the way\n");
    check_fails(TEST_PROGRAMS, missing.text, folder.text, missing.text);
    check_fails(missing.text, TEST_PUBLISHED, folder.text, missing.text);
    check_fails(TEST_PROGRAMS, TEST_PUBLISHED, file.text, file.text);
    check_fails(TEST_PROGRAMS, TEST_PUBLISHED, below.text, file.text);
    file_check(file.text, "in the way\n", "the file in the way");
}

static void test_a_folder_of_too_long_a_name(void)
{
    static char name[5000];
    memset(name, 'a', sizeof name - 1);
    check_fails(TEST_PROGRAMS, TEST_PUBLISHED, name, ": File name too long\n");
}

static void test_no_room_for_the_input(void)
{
    const string out = folder_new(), set = folder_below(out.text, "1987"), first = folder_below(set.text, "intella-1");
    const string input = folder_below(first.text, "input"), words = string_of("%s: Is a directory\n", input.text);
    check_fails(TEST_PROGRAMS, TEST_PUBLISHED, out.text, words.text);
}

static void test_table_that_cannot_be_read(void)
{
    const string folder = folder_new();
    const string words = string_of("%s: cannot be read", folder.text);
    check_fails(TEST_PROGRAMS, folder.text, folder.text, words.text);
}

static void test_programs_that_fail(void)
{
    static const struct {
        const char *script, *words;
    } rows[] = {
        {"#!/bin/sh\necho no use >&2\nexit 3\n", "intella ended with 3"},
        {"#!/bin/sh\nexit 1\n", "intella ended with 1; what it said is in "},
        {"#!/bin/sh\nkill -9 $$\n", "intella ended with 137"},
        {"#!/bin/sh\nexit 0\n", "inttol.1"}, /* and leaves no files */
        {"#!/nowhere/sh\n", "/intella: "},
        {"#!/bin/sh\nmkdir \"${1#--output=}/inttol.1\"\n", "inttol.1: Is a directory\n"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const string fake = fake_programs(rows[i].script), out = folder_new();
        check_fails(fake.text, TEST_PUBLISHED, out.text, rows[i].words);
    }
}

/* Programs that have stopped writing must not be held to be right for what older ones have left. */
static void test_files_of_an_earlier_run_do_not_count(void)
{
    const string fake = fake_programs("#!/bin/sh\nexit 0\n"), out = folder_new();
    process process;
    reproduce(TEST_PROGRAMS, TEST_PUBLISHED, out.text, &process);
    process_check_status(&process, 0, "the right programs");
    check_fails(fake.text, TEST_PUBLISHED, out.text, "inttol.1");
}

/* Whoever starts it may ignore the ends of children, and that is passed on. */
static void test_ends_of_children_that_are_ignored(void)
{
    const string out = folder_new();
    const process_setup setup = {
        .program = TEST_REPRODUCE,
        .arguments = (const char *const[]){"--misses", TEST_PROGRAMS, TEST_PUBLISHED, out.text, NULL},
        .ignored = SIGCHLD};
    process process;
    process_run(&process, &setup, "");
    process_check_status(&process, 0, "SIGCHLD ignored");
    TEST_ASSERT_EQUAL_STRING("66 of 66 published numbers reproduced\n", process.output.bytes);
}

/* ---- what the library computes of the errata ---- */

/* Run with one of the options that print tables, as tab-separated values. */
static void print_tables(const char *option, process *process)
{
    const char *const arguments[] = {option, "--format=tsv", TEST_PUBLISHED, NULL};
    run_reproduce(arguments, process);
    process_check_status(process, 0, option);
    text_check("", 0, &process->errors, option);
}

/* These lines, in this order. */
static void check_lines(const text *said, const char *const lines[], size_t count)
{
    const char *rest = said->bytes;
    for (size_t i = 0; i < count; i++) {
        const string line = string_of("\n%s\n", lines[i]);
        const char *found = strstr(rest, line.text);
        if (found == NULL) {
            fail_with("expected the line \"%s\" in \"%s\"", lines[i], rest);
        }
        rest = found + strlen(line.text) - 1;
    }
}

/* An unknown program, a case without its accuracy, a position out of reach. */
static void test_cases_that_cannot_be_computed(void)
{
    static const struct {
        const char *table, *message;
    } rows[] = {
        {"puma\t1\tposition\tx\t200\t-\n", "reproduce: puma: unknown program\n"},
        {"adpta\t1\tposition\tx\t200\t-\nadpta\t1\tposition\ty\t200\t-\nadpta\t1\tposition\tz\t0\t-\n"
         "adpta\t1\tposition\ttheta\t0\t-\n", "reproduce: adpta, case 1: "},
        {"adpta\t2\tposition\tx\t2000\t-\nadpta\t2\tposition\ty\t200\t-\nadpta\t2\tposition\tz\t0\t-\n"
         "adpta\t2\tposition\ttheta\t0\t-\nadpta\t2\ttolerance\tdx\t.5\t-\nadpta\t2\ttolerance\tdy\t.5\t-\n"
         "adpta\t2\ttolerance\tdz\t.5\t-\nadpta\t2\ttolerance\tdwx\t.1\t-\nadpta\t2\ttolerance\tdwy\t.1\t-\n"
         "adpta\t2\ttolerance\tdwz\t.1\t-\nadpta\t2\tdelta\tdelta\t.1\t-\n", "reproduce: adpta, case 2: "},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const string folder = folder_new(), table = string_of("%s/table.tsv", folder.text);
        process process;
        file_write(table.text, rows[i].table);
        run_reproduce((const char *const[]){"--errata", table.text, NULL}, &process);
        process_check_status(&process, 1, rows[i].message);
        check_says(&process.errors, rows[i].message);
    }
}

/* The report's bounds at the beginning; at the end those that central differences of Eq. (4.1) give. */
static void test_walk_from_1987_to_corrected(void)
{
    static const char *const lines[] = {
        "nothing\t0.035243\t0.000370",  "+ mtransf-typo\t0.043073\t0.000626", "+ gppp-clearing\t0.043073\t0.000599",
        "+ distance-share\t0.049833\t0.000599",
        "nothing\t0.041592\t0.000440", "+ gppp-clearing\t0.043722\t0.000671", "+ distance-share\t0.051587\t0.000671",
        "nothing\t0.043655\t0.000508", "+ gppp-clearing\t0.043655\t0.000730", "+ distance-share\t0.043655\t0.000730",
        "nothing\t0.045870\t0.000666", "+ gppp-clearing\t0.045870\t0.000855", "+ distance-share\t0.074368\t0.000855",
    };
    process process;
    print_tables("--walk", &process);
    check_lines(&process.output, lines, sizeof lines / sizeof lines[0]);
}

static void test_each_erratum_alone(void)
{
    static const char *const lines[] = {
        "(all as of 1987; none)\t0.035243\t0.000370\t0.049833\t0.000599",
        "base-twist\t0.035243\t0.000475\t0.043934\t0.000625",
        "distance-share\t0.040228\t0.000370\t0.043073\t0.000599",
        "(all as of 1987; none)\t0.041592\t0.000440\t0.051587\t0.000671",
        "(all as of 1987; none)\t0.043655\t0.000508\t0.043655\t0.000730",
        "(all as of 1987; none)\t0.045870\t0.000666\t0.074368\t0.000855",
    };
    process process;
    print_tables("--errata", &process);
    check_lines(&process.output, lines, sizeof lines / sizeof lines[0]);
}

/* Number, published, as of 1987 and three other ways; a star marks what differs. As of 1987 nothing does. */
static void test_portability_is_of_66_numbers(void)
{
    int rows = 0;
    process process;
    print_tables("--portability", &process);
    for (const char *line = process.output.bytes; *line != '\0'; line += strcspn(line, "\n") + 1) {
        char number[100], published[24], as_of_1987[24];
        if (sscanf(line, "%99[^\t\n]\t%23[^\t\n]\t%23[^\t\n]", number, published, as_of_1987) == 3 &&
            strchr(published, '.') != NULL) {
            const char *unsigned_1987 = as_of_1987 + (as_of_1987[0] == '-' && published[0] != '-');
            TEST_ASSERT_EQUAL_STRING_MESSAGE(published, unsigned_1987, number);
            rows++;
        }
    }
    TEST_ASSERT_EQUAL_INT(66, rows);
    check_says(&process.output, "\nreproduced\t\t66 of 66\t");
}

static void test_formats_of_tables(void)
{
    static const char *const options[][2] = {{"--format=text", "\n  nothing  "},
                                             {"--format=markdown", "\n| nothing "},
                                             {"--format=tsv", "\nnothing\t"}};
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        const char *const arguments[] = {"--walk", options[i][0], TEST_PUBLISHED, NULL};
        process process;
        run_reproduce(arguments, &process);
        process_check_status(&process, 0, options[i][0]);
        check_says(&process.output, options[i][1]);
    }
}

/* ---- usage, and an output that takes nothing ---- */

static void test_wrong_usage(void)
{
    static const char *const calls[][6] = {
        {NULL},
        {"a"},
        {"a", "b"},
        {"a", "b", "c", "d"},
        {"--quiet"},
        {"--quiet", "a", "b"},
        {"--loud", "a", "b"},
        {"--help"},
        {"--loud", "a", "b", "c"},
        {"--walk"},
        {"--walk", "a", "b"},
        {"--errata", "--format=html", "a"},
        {"--format"},
    };
    for (size_t i = 0; i < sizeof calls / sizeof calls[0]; i++) {
        process process;
        run_reproduce(calls[i], &process);
        process_check_status(&process, 2, calls[i][0] != NULL ? calls[i][0] : "no argument");
        check_says(&process.errors, "reproduce: expected");
        check_says(&process.errors, "PROGRAMS PUBLISHED OUT");
        text_check("", 0, &process.output, "standard output");
    }
}

static void test_a_wrong_option_is_named(void)
{
    static const char *const calls[][3] = {{"--loud", "unknown option \"--loud\""},
                                           {"--format", "an argument is missing after \"--format\""},
                                           {"--walk=3", "\"--walk=3\""}};
    for (size_t i = 0; i < sizeof calls / sizeof calls[0]; i++) {
        const char *const arguments[] = {calls[i][0], NULL};
        process process;
        run_reproduce(arguments, &process);
        process_check_status(&process, 2, calls[i][0]);
        check_says(&process.errors, calls[i][1]);
    }
}

static void test_table_that_cannot_be_printed(void)
{
    const string out = folder_new();
    const process_setup setup = {.program = TEST_REPRODUCE,
                                 .arguments =
                                     (const char *const[]){TEST_PROGRAMS, TEST_PUBLISHED, out.text, NULL},
                                 .output_path = "/dev/full"};
    process process;
    process_run(&process, &setup, "");
    process_check_status(&process, 1, "standard output is full");
    check_says(&process.errors, "reproduce: ");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_paper_is_reproduced);
    RUN_TEST(test_files_of_an_earlier_run_are_replaced);
    RUN_TEST(test_quiet_only_writes);
    RUN_TEST(test_programs_of_1987);
    RUN_TEST(test_altered_tables);
    RUN_TEST(test_table_without_results);
    RUN_TEST(test_broken_tables);
    RUN_TEST(test_case_that_is_only_partly_a_number);
    RUN_TEST(test_what_is_missing);
    RUN_TEST(test_a_folder_of_too_long_a_name);
    RUN_TEST(test_no_room_for_the_input);
    RUN_TEST(test_table_that_cannot_be_read);
    RUN_TEST(test_programs_that_fail);
    RUN_TEST(test_files_of_an_earlier_run_do_not_count);
    RUN_TEST(test_ends_of_children_that_are_ignored);
    RUN_TEST(test_cases_that_cannot_be_computed);
    RUN_TEST(test_walk_from_1987_to_corrected);
    RUN_TEST(test_each_erratum_alone);
    RUN_TEST(test_portability_is_of_66_numbers);
    RUN_TEST(test_formats_of_tables);
    RUN_TEST(test_wrong_usage);
    RUN_TEST(test_a_wrong_option_is_named);
    RUN_TEST(test_table_that_cannot_be_printed);
    return UNITY_END();
}
