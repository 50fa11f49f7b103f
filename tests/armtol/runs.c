#include "armtol/runs.h"

#include "unity.h"

#include <stdlib.h>
#include <string.h>

void run(process *process, const char *folder, const char *const arguments[])
{
    const process_setup setup = {.program = TEST_ARMTOL, .arguments = arguments, .folder = folder};
    process_run(process, &setup, "");
}

void run_well(process *process, const char *folder, const char *const arguments[])
{
    run(process, folder, arguments);
    process_check_status(process, 0, arguments[0]);
    text_check("", 0, &process->errors, arguments[0]);
}

void check_refused_run(const char *folder, const char *const arguments[], const char *words)
{
    process process;
    run(&process, folder, arguments);
    process_check_status(&process, 2, words);
    text_check("", 0, &process.output, words);
    TEST_ASSERT_TRUE_MESSAGE(strstr(process.errors.bytes, words) != NULL, process.errors.bytes);
}

void check_refused_line(const char *folder, const char *const arguments[], const char *message)
{
    process process;
    const string line = string_of("armtol: %s\n", message);
    run(&process, folder, arguments);
    process_check_status(&process, 2, message);
    text_check("", 0, &process.output, message);
    text_check(line.text, strlen(line.text), &process.errors, message);
}

void check_says(const process *process, const char *words)
{
    TEST_ASSERT_TRUE_MESSAGE(strstr(process->output.bytes, words) != NULL, words);
}

const char *text_after(const char *text, const char *words)
{
    const char *at = strstr(text, words);
    TEST_ASSERT_NOT_NULL_MESSAGE(at, words);
    return at + strlen(words);
}

double number_after(const char *text, const char *words)
{
    char *end;
    const char *at = text_after(text, words);
    const double value = strtod(at, &end);
    TEST_ASSERT_TRUE_MESSAGE(end != at, words);
    return value;
}

double json_number(const process *process, const char *words, const char *name)
{
    const char *from = strstr(process->output.bytes, words);
    TEST_ASSERT_NOT_NULL_MESSAGE(from, words);
    return number_after(from, string_of("\"%s\": ", name).text);
}
