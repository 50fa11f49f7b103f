#include "armtol/runs.h"

#include "unity.h"

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

void check_says(const process *process, const char *words)
{
    TEST_ASSERT_TRUE_MESSAGE(strstr(process->output.bytes, words) != NULL, words);
}
