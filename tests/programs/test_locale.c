/* Numbers have a decimal point, whatever the locale of the environment says. */

#include "programs/programs.h"

#include "unity.h"

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
    unsetenv("LOCPATH");
    process_clean_up();
}

/* A locale whose decimal mark is a comma, as LC_ALL and LOCPATH would have it. */
typedef struct comma_locale {
    string path, all;
    const char *environment[3];
} comma_locale;

/* True if the C library itself takes the locale and then writes 1,5: else nothing would be tested. */
static bool writes_a_comma(const char *name, const char *path)
{
    char one_and_a_half[8] = "";
    setenv("LOCPATH", path, 1);
    if (setlocale(LC_ALL, name) != NULL) {
        snprintf(one_and_a_half, sizeof one_and_a_half, "%.1f", 1.5);
    }
    setlocale(LC_ALL, "C");
    return strcmp(one_and_a_half, "1,5") == 0;
}

static void make_locale(comma_locale *locale)
{
    static const char name[] = "de_DE";
    const string folder = folder_new();
    const process_setup setup = {
        .program = "/bin/sh",
        .arguments =
            (const char *const[]){"-c", "command -v localedef && localedef -i de_DE -f ISO-8859-1 ./de_DE",
                                  NULL},
        .folder = folder.text};
    process process;
    process_run(&process, &setup, "");
    if (process.output.length == 0) {
        process_ignore_test("there is no localedef to make a locale with a decimal comma");
    }
    if (!writes_a_comma(name, folder.text)) {
        process_ignore_test("localedef made no locale with a decimal comma");
    }
    locale->path = string_of("LOCPATH=%s", folder.text);
    locale->all = string_of("LC_ALL=%s", name);
    locale->environment[0] = locale->path.text;
    locale->environment[1] = locale->all.text;
    locale->environment[2] = NULL;
}

static void run_with(const comma_locale *locale, const tested *program, const char *const arguments[],
                     const char *folder, const char *input, process *process)
{
    const process_setup setup = {.program = program->path,
                                 .arguments = arguments,
                                 .environment = locale->environment,
                                 .folder = folder};
    process_run(process, &setup, input);
}

static void test_golden_bytes_with_a_decimal_comma(void)
{
    static const char *const corrected[] = {"--fix", "all", NULL};
    static const char *const *const arguments[] = {NULL, corrected};
    const char *const sets[] = {golden_1987, golden_corrected};
    comma_locale locale;
    make_locale(&locale);
    for (int i = 0; i < PROGRAMS; i++) {
        for (int j = 0; j < 2; j++) {
            const string what = string_of("%s, %s", programs[i].name, sets[j]), folder = folder_new();
            const string input = right_answers(&programs[i]);
            const string golden = golden_of(sets[j], &programs[i], 1, "dialogue");
            text dialogue;
            process process;
            file_read(golden.text, &dialogue);
            run_with(&locale, &programs[i], arguments[j], folder.text, input.text, &process);
            process_check_status(&process, 0, what.text);
            text_check(dialogue.bytes, dialogue.length, &process.errors, what.text);
            check_golden(folder.text, 1, &programs[i], sets[j], 1, FILES, what.text);
        }
    }
}

static void test_a_decimal_comma_is_refused(void)
{
    comma_locale locale;
    make_locale(&locale);
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new();
        process process;
        run_with(&locale, &programs[i], NULL, folder.text, "1,5", &process);
        process_check_status(&process, 2, programs[i].name);
        check_message(&process, &programs[i], "x: \"1,5\" is not a number; expected", programs[i].name);
    }
}

/* What the program answers has a point too. */
static void test_messages_with_a_decimal_comma(void)
{
    static const char *const wishes[PROGRAMS] = {"0.5 0 459.7 0 0 0", "800.5 0 0 0"};
    static const char *const words[PROGRAMS] = {"would be 0.5 mm from", "would be 800.5 mm from"};
    comma_locale locale;
    make_locale(&locale);
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new();
        process process;
        run_with(&locale, &programs[i], NULL, folder.text, wishes[i], &process);
        process_check_status(&process, 2, programs[i].name);
        check_message(&process, &programs[i], words[i], programs[i].name);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_golden_bytes_with_a_decimal_comma);
    RUN_TEST(test_a_decimal_comma_is_refused);
    RUN_TEST(test_messages_with_a_decimal_comma);
    return UNITY_END();
}
