/* Little memory, few descriptors, small files, no threads: a message, or the right answer. */

#include "faults/commands.h"

#include "unity.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

void setUp(void)
{
}

void tearDown(void)
{
    faulted_end();
    process_clean_up();
}

static void check_command(const faulted_run *right, const faulted_run *run, const char *words, const char *what)
{
    if (!run->outcome.ended || run->status > 1 || run->outcome.live != 0) {
        fail_with("%s: status %d, %ld blocks not freed; it said \"%s\"", what, run->status, run->outcome.live,
                  run->errors.bytes);
    }
    if (run->status == 0) {
        text_check(right->output.bytes, right->output.length, &run->output, what);
    } else {
        faulted_check_message(run, "armtol", words, what);
    }
}

static void check_session(const tested *program, const char *folder, const faulted_run *run, const char *what)
{
    const int n_new = check_session_files(folder, program, true, false, what);
    TEST_ASSERT_TRUE_MESSAGE(run->outcome.ended && run->outcome.live == 0, what);
    TEST_ASSERT_TRUE_MESSAGE(run->status == 0 ? n_new == FILES : run->status == 1 && n_new % 2 == 0, what);
    if (run->status == 1) {
        faulted_check_message(run, program->name, NULL, what);
    }
}

/* Finely where it matters, then twice as much each time. */
static long more_memory(long memory)
{
    enum { PAGE = 4096, FINE = 128 * PAGE };
    return memory < FINE ? memory + PAGE : 2 * memory;
}

static void test_little_memory(void)
{
    static faulted_run right, run;
    const string folder = folder_for_commands();
    for (int command = 0; command < COMMANDS; command++) {
        const string name = name_of_command(command);
        start_command(command, folder.text);
        faulted_try(&(fault){0}, &right);
        int failed = 0;
        for (long memory = 4096; memory < 64L << 20; memory = more_memory(memory)) {
            const string what = string_of("%s, %ld bytes", name.text, memory);
            faulted_try(&(fault){.memory = memory}, &run);
            check_command(&right, &run, "memory", what.text);
            failed += run.status;
        }
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, name.text);
        printf("%s: %d of the limits too small\n", name.text, failed);
    }
    for (int i = 0; i < PROGRAMS; i++) {
        const string out = start_session(&programs[i]);
        for (long memory = 4096; memory < 64L << 20; memory = more_memory(memory)) {
            const string what = string_of("%s, %ld bytes", programs[i].name, memory);
            prepare_session(out.text, &programs[i], true);
            faulted_try(&(fault){.memory = memory}, &run);
            check_session(&programs[i], out.text, &run, what.text);
        }
    }
}

static void test_few_descriptors(void)
{
    static faulted_run right, run;
    const string folder = folder_for_commands();
    for (int command = 0; command < COMMANDS; command++) {
        const string name = name_of_command(command);
        start_command(command, folder.text);
        faulted_try(&(fault){0}, &right);
        for (int most = 1; most <= 6; most++) {
            const string what = string_of("%s, %d descriptors", name.text, most);
            faulted_try(&(fault){.descriptors = most}, &run);
            check_command(&right, &run, "Too many open files", what.text);
        }
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, name.text);
    }
    for (int i = 0; i < PROGRAMS; i++) {
        const string out = start_session(&programs[i]);
        for (int most = 1; most <= 6; most++) {
            const string what = string_of("%s, %d descriptors", programs[i].name, most);
            prepare_session(out.text, &programs[i], true);
            faulted_try(&(fault){.descriptors = most}, &run);
            check_session(&programs[i], out.text, &run, what.text);
            TEST_ASSERT_EQUAL_INT_MESSAGE(most < 5, run.status, what.text);
        }
    }
}

/* Standard output is a file here. A limit stops it with a signal unless that is ignored. */
static void test_small_files(void)
{
    static faulted_run right, run;
    const string folder = folder_for_commands();
    for (int command = 0; command < COMMANDS; command++) {
        const string name = name_of_command(command);
        start_command(command, folder.text);
        faulted_try(&(fault){0}, &right);
        const long length = (long)right.output.length;
        for (long size = 1; size <= length; size += size + 61 <= length || size == length ? 61 : length - size) {
            const string what = string_of("%s, files of %ld bytes", name.text, size);
            faulted_try(&(fault){.file_size = size}, &run);
            TEST_ASSERT_EQUAL_INT_MESSAGE(size < length, run.status, what.text);
            text_check(right.output.bytes, (size_t)size, &run.output, what.text);
        }
    }
}

/* Without more threads one does all the work, and gives the same bytes. The limit does not bind root. */
static void test_no_threads(void)
{
    static faulted_run right, run;
    const string folder = folder_for_commands();
    const uid_t user = geteuid() == 0 ? 65534 : 0;
    start_command(1, folder.text);
    faulted_try(&(fault){0}, &right);
    faulted_try(&(fault){.user = user, .one_process = true}, &run);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, run.errors.bytes);
    text_check(right.output.bytes, right.output.length, &run.output, "no threads");
    TEST_ASSERT_TRUE_MESSAGE(run.outcome.allocations < right.outcome.allocations, "threads were to be had");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_little_memory);
    RUN_TEST(test_few_descriptors);
    RUN_TEST(test_small_files);
    RUN_TEST(test_no_threads);
    printf("%ld runs\n", faulted_count());
    return UNITY_END();
}
