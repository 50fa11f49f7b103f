/*
 * Memory runs out at every allocation of a whole run, for that one alone and from that one on: a message and status 1,
 * or the right answer where libc or the program can do without; nothing half written, nothing kept.
 */

#include "faults/commands.h"

#include "unity.h"

#include <stdio.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
    faulted_end();
    process_clean_up();
}

static void check_ended(const faulted_run *run, const char *name, const char *what)
{
    if (!run->outcome.ended || run->status > 1) {
        fail_with("%s: expected an end with status 0 or 1, got %d; it said \"%s\"", what, run->status,
                  run->errors.bytes);
    }
    if (run->outcome.live != 0) {
        fail_with("%s: %ld blocks are not freed", what, run->outcome.live);
    }
    if (run->status == 1) {
        faulted_check_message(run, name, "memory", what);
    }
}

static void check_command(int command, bool all_after)
{
    static faulted_run right, run;
    const string folder = folder_for_commands(), name = name_of_command(command);
    long n = 0, failed = 0;
    start_command(command, folder.text);
    faulted_try(&(fault){0}, &right);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, right.status, right.errors.bytes);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, right.outcome.live, name.text);
    do {
        const fault fault = {.allocation = ++n, .all_after = all_after};
        const string what = string_of("%s, allocation %ld%s", name.text, n, all_after ? " and all after" : "");
        faulted_try(&fault, &run);
        check_ended(&run, "armtol", what.text);
        if (run.status == 0) {
            text_check(right.output.bytes, right.output.length, &run.output, what.text);
        }
        failed += run.status == 1;
    } while (run.outcome.happened);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, name.text);
    printf("%s: %ld allocations%s, %ld of them needed\n", name.text, n - 1, all_after ? " and all after" : "", failed);
}

static void test_armtol(void)
{
    for (int command = 0; command < COMMANDS; command++) {
        check_command(command, false);
        check_command(command, true);
    }
}

static void check_session(const tested *program, bool all_after)
{
    static faulted_run run;
    const string folder = start_session(program);
    long n = 0, failed = 0;
    do {
        const fault fault = {.allocation = ++n, .all_after = all_after};
        const string what = string_of("%s, allocation %ld%s", program->name, n, all_after ? " and all after" : "");
        prepare_session(folder.text, program, true);
        faulted_try(&fault, &run);
        check_ended(&run, program->name, what.text);
        const int n_new = check_session_files(folder.text, program, true, false, what.text);
        TEST_ASSERT_TRUE_MESSAGE(n_new == FILES || (run.status == 1 && n_new % 2 == 0), what.text);
        failed += run.status == 1;
    } while (run.outcome.happened);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, program->name);
    TEST_ASSERT_TRUE_MESSAGE(failed >= 8, "the analysis needs more allocations than that");
    printf("%s: %ld allocations%s, %ld of them needed\n", program->name, n - 1, all_after ? " and all after" : "",
           failed);
}

static void test_programs_of_1987(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        check_session(&programs[i], false);
        check_session(&programs[i], true);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_armtol);
    RUN_TEST(test_programs_of_1987);
    printf("%ld runs\n", faulted_count());
    return UNITY_END();
}
