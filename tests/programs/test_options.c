/* Options, right and wrong, and what they print. */

#include "programs/programs.h"

#include "unity.h"

#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

/* ---- options that print something ---- */

/* Right answers wait on the input, so that a run that should not have begun would leave its files. */
static void print_with(const tested *program, const char *option, process *process)
{
    const char *const arguments[] = {option, NULL};
    const string what = command_of(program, arguments), folder = folder_new(), input = right_answers(program);
    run_in(folder.text, program, arguments, input.text, process);
    process_check_status(process, 0, what.text);
    text_check("", 0, &process->errors, what.text);
    folder_check(folder.text, "", what.text);
}

static void test_short_options_print_what_long_ones_do(void)
{
    static const char *const pairs[][2] = {{"--help", "-h"}, {"--version", "-V"}, {"--list-errata", "-l"}};
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof pairs / sizeof pairs[0]; j++) {
            process with_long, with_short;
            print_with(&programs[i], pairs[j][0], &with_long);
            print_with(&programs[i], pairs[j][1], &with_short);
            text_check(with_long.output.bytes, with_long.output.length, &with_short.output, pairs[j][1]);
        }
    }
}

static void test_help_names_everything(void)
{
    static const char *const words[] = {
        "-o, --output DIR", "-r, --run N",   "-f, --fix NAME", "-l, --list-errata",
        "-h, --help",       "-V, --version", "`all'",          "Exit status"};
    for (int i = 0; i < PROGRAMS; i++) {
        process process;
        print_with(&programs[i], "--help", &process);
        const char *help = process.output.bytes;
        const string usage = string_of("Usage: %s ", programs[i].name);
        TEST_ASSERT_TRUE_MESSAGE(strncmp(help, usage.text, strlen(usage.text)) == 0, help);
        for (size_t j = 0; j < sizeof words / sizeof words[0]; j++) {
            TEST_ASSERT_TRUE_MESSAGE(strstr(help, words[j]) != NULL, words[j]);
        }
        for (size_t j = 0; j < programs[i].starts[QUESTIONS]; j++) {
            TEST_ASSERT_TRUE_MESSAGE(strstr(help, programs[i].value_names[j]) != NULL,
                                     programs[i].value_names[j]);
        }
        for (int j = 0; j < FILES; j++) {
            const string name = string_of("%s.N", programs[i].files[j]);
            TEST_ASSERT_TRUE_MESSAGE(strstr(help, name.text) != NULL, name.text);
        }
    }
}

static void test_version_is_the_projects(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string expected = string_of("%s (armtol) %s\n", programs[i].name, TEST_VERSION);
        process process;
        print_with(&programs[i], "--version", &process);
        TEST_ASSERT_EQUAL_STRING(expected.text, process.output.bytes);
    }
}

/* Two lines each: the id and what the slip is, then what it touches. */
static void test_list_of_errata(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        process process;
        print_with(&programs[i], "--list-errata", &process);
        const char *line = process.output.bytes;
        for (int j = 0; j < ERRATA; j++) {
            const size_t id = strcspn(line, " \n");
            TEST_ASSERT_TRUE_MESSAGE(id == strlen(errata[j]) && strncmp(line, errata[j], id) == 0, errata[j]);
            TEST_ASSERT_TRUE_MESSAGE(strcspn(line, "\n") > id + 20, errata[j]);
            line += strcspn(line, "\n") + 1;
            const char *touches = line + strspn(line, " ");
            TEST_ASSERT_TRUE_MESSAGE(touches > line && strncmp(touches, "touches: ", 9) == 0, errata[j]);
            TEST_ASSERT_TRUE_MESSAGE(strcspn(touches, "\n") > 12, errata[j]);
            line += strcspn(line, "\n") + 1;
        }
        TEST_ASSERT_EQUAL_STRING_MESSAGE("", line, "after the last erratum");
    }
}

/* Every id that is listed is known to --fix, alone; they come together in test_files. */
static void test_every_listed_erratum_is_known(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        for (int j = 0; j < ERRATA; j++) {
            const char *const arguments[] = {"--fix", errata[j], "--version", NULL};
            const string what = command_of(&programs[i], arguments), folder = folder_new();
            process process;
            run_in(folder.text, &programs[i], arguments, "", &process);
            process_check_status(&process, 0, what.text);
        }
    }
}

/* ---- wrong options ---- */

typedef struct wrong_options {
    const char *arguments[6];
    const char *message; /* words of it */
} wrong_options;

#define UNKNOWN_OPTION "unknown option \""
#define NO_ARGUMENT "an argument is missing after \""
#define STRAY "unexpected argument \""
#define RUN(text) "--run: \"" text "\" is not a run number; expected a whole number from 1 to 999999"

static const wrong_options wrong_ones[] = {
    {{"-x"}, UNKNOWN_OPTION "-x\""},
    {{"--colour"}, UNKNOWN_OPTION "--colour\""},
    {{"--colour=red"}, UNKNOWN_OPTION "--colour=red\""},
    {{"-o", ".", "-x"}, UNKNOWN_OPTION "-x\""},
    {{"--help=me"}, UNKNOWN_OPTION "--help=me\""},
    {{"-?"}, UNKNOWN_OPTION "-?\""},
    {{"-:"}, UNKNOWN_OPTION "-:\""},
    {{"--\033[31m"}, UNKNOWN_OPTION "--?[31m\""},
    {{"-o"}, NO_ARGUMENT "-o\""},
    {{"--output"}, NO_ARGUMENT "--output\""},
    {{"-r"}, NO_ARGUMENT "-r\""},
    {{"--run"}, NO_ARGUMENT "--run\""},
    {{"-f"}, NO_ARGUMENT "-f\""},
    {{"-o", ".", "--fix"}, NO_ARGUMENT "--fix\""},
    {{"200"}, STRAY "200\""},
    {{"-"}, STRAY "-\""},
    {{"--", "-o"}, STRAY "-o\""},
    {{"-o", ".", "input.txt", "-r", "2"}, STRAY "input.txt\""},
    {{"--help", "200"}, STRAY "200\""},
    {{""}, STRAY "\""},
    {{"-r", "0"}, RUN("0")},
    {{"-r", "000"}, RUN("000")},
    {{"-r", "-1"}, RUN("-1")},
    {{"-r", "+1"}, RUN("+1")},
    {{"--run", "1.5"}, RUN("1.5")},
    {{"--run=abc"}, RUN("abc")},
    {{"-r", "1000000"}, RUN("1000000")},
    {{"-r", "4294967297"}, RUN("4294967297")},
    {{"-r", ""}, RUN("")},
    {{"-r", " 1"}, RUN(" 1")},
    {{"-r", "1 "}, RUN("1 ")},
    {{"-r", "0x1"}, RUN("0x1")},
    {{"-r", "1/../1"}, RUN("1/../1")},
    {{"-r", "1", "-r", "no"}, RUN("no")},
};

static void check_wrong_options(const tested *program, const wrong_options *wrong)
{
    const string what = command_of(program, wrong->arguments), folder = folder_new();
    const string input = right_answers(program), line = string_of("%s: ", program->name);
    process process;
    run_in(folder.text, program, wrong->arguments, input.text, &process);
    process_check_status(&process, 2, what.text);
    check_message(&process, program, wrong->message, what.text);
    /* the message is all that is said: no prompt came before it */
    TEST_ASSERT_TRUE_MESSAGE(strncmp(process.errors.bytes, line.text, strlen(line.text)) == 0, what.text);
    TEST_ASSERT_TRUE_MESSAGE(
        strchr(process.errors.bytes, '\n') == process.errors.bytes + process.errors.length - 1, what.text);
    text_check("", 0, &process.output, what.text);
    folder_check(folder.text, "", what.text);
}

static void test_wrong_options(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof wrong_ones / sizeof wrong_ones[0]; j++) {
            check_wrong_options(&programs[i], &wrong_ones[j]);
        }
    }
}

static void test_unknown_erratum_lists_the_known(void)
{
    static const char *const names[][2] = {{"typo", "typo"},
                                           {"", ""},
                                           {",", ""},
                                           {"labels,", ""},
                                           {"labels,,float", ""},
                                           {"labels,flaot", "flaot"},
                                           {"Labels", "Labels"},
                                           {"label", "label"},
                                           {"labelss", "labelss"},
                                           {"labels float", "labels float"},
                                           {"all,none", "none"},
                                           {"mtransf_typo", "mtransf_typo"}};
    string known = {""};
    for (int i = 0; i < ERRATA; i++) {
        strcat(known.text, errata[i]);
        strcat(known.text, ", ");
    }
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof names / sizeof names[0]; j++) {
            const string message =
                string_of("--fix: unknown erratum \"%s\"; known are %sand all", names[j][1], known.text);
            const wrong_options wrong = {{"--fix", names[j][0]}, message.text};
            check_wrong_options(&programs[i], &wrong);
        }
    }
}

/* ---- an output that takes nothing ---- */

static void test_output_that_takes_nothing(void)
{
    static const char *const options[] = {"--help", "--version", "--list-errata"};
    const process_setup full = {.output_path = "/dev/full"};
    const process_setup closed = {.wires = {WIRE_PIPE, WIRE_CLOSED, WIRE_PIPE}};
    const process_setup *const outputs[] = {&full, &closed};
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof options / sizeof options[0]; j++) {
            for (int k = 0; k < 2; k++) {
                const char *const arguments[] = {options[j], NULL};
                process_setup setup = *outputs[k];
                setup.program = programs[i].path;
                setup.arguments = arguments;
                process process;
                process_run(&process, &setup, "");
                process_check_status(&process, 1, options[j]);
                check_message(&process, &programs[i], "cannot write to standard output", options[j]);
            }
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_short_options_print_what_long_ones_do);
    RUN_TEST(test_help_names_everything);
    RUN_TEST(test_version_is_the_projects);
    RUN_TEST(test_list_of_errata);
    RUN_TEST(test_every_listed_erratum_is_known);
    RUN_TEST(test_wrong_options);
    RUN_TEST(test_unknown_erratum_lists_the_known);
    RUN_TEST(test_output_that_takes_nothing);
    return UNITY_END();
}
