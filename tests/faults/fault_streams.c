/*
 * Standard streams that are closed, or pipes that nobody reads. A number that is free because its stream is closed goes
 * to what a program opens next: no message may be written into a file for that.
 */

#include "faults/commands.h"

#include "unity.h"

#include <signal.h>
#include <stdio.h>
#include <unistd.h>

enum { INPUT = 1 << STDIN_FILENO, OUTPUT = 1 << STDOUT_FILENO, ERRORS = 1 << STDERR_FILENO, ALL = 7 };

void setUp(void)
{
}

void tearDown(void)
{
    faulted_end();
    process_clean_up();
}

/* Without input there is nothing to compute; the other two the files do not depend on. */
static void test_closed_streams_of_the_programs_of_1987(void)
{
    static faulted_run run;
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = start_session(&programs[i]);
        for (int closed = 0; closed <= ALL; closed++) {
            const string what = string_of("%s, closed %d", programs[i].name, closed);
            const bool fine = (closed & INPUT) == 0;
            prepare_session(folder.text, &programs[i], true);
            faulted_try(&(fault){.closed = closed}, &run);
            TEST_ASSERT_EQUAL_INT_MESSAGE(fine ? 0 : 1, run.status, what.text);
            TEST_ASSERT_FALSE_MESSAGE(run.outcome.low, what.text);
            TEST_ASSERT_EQUAL_INT_MESSAGE(
                fine ? FILES : 0, check_session_files(folder.text, &programs[i], true, false, what.text), what.text);
            if (!fine && (closed & ERRORS) == 0) {
                faulted_check_message(&run, programs[i].name, "cannot read the input", what.text);
            }
        }
    }
}

/* A message there is, on a disk that is full, and no stream for it; wherever the disk is full. */
static void test_closed_streams_and_a_full_disk(void)
{
    static faulted_run run;
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = start_session(&programs[i]);
        for (int closed = OUTPUT; closed <= ALL; closed += OUTPUT) {
            for (long room = 0; room < 3600; room += 97) {
                const string what = string_of("%s, closed %d, room for %ld", programs[i].name, closed, room);
                prepare_session(folder.text, &programs[i], true);
                faulted_try(&(fault){.closed = closed, .disk_full = true, .disk_room = room}, &run);
                TEST_ASSERT_EQUAL_INT_MESSAGE(1, run.status, what.text);
                TEST_ASSERT_FALSE_MESSAGE(run.outcome.low, what.text);
                TEST_ASSERT_EQUAL_INT_MESSAGE(
                    0, check_session_files(folder.text, &programs[i], true, false, what.text), what.text);
            }
        }
    }
}

static void test_closed_streams_of_armtol(void)
{
    static faulted_run right, run;
    const string folder = folder_for_commands();
    for (int command = 0; command < COMMANDS; command++) {
        const string name = name_of_command(command);
        start_command(command, folder.text);
        faulted_try(&(fault){0}, &right);
        for (int closed = 0; closed <= ALL; closed++) {
            const string what = string_of("%s, closed %d", name.text, closed);
            const bool fine = (closed & OUTPUT) == 0;
            faulted_try(&(fault){.closed = closed}, &run);
            TEST_ASSERT_EQUAL_INT_MESSAGE(fine ? 0 : 1, run.status, what.text);
            text_check(right.output.bytes, fine ? right.output.length : 0, &run.output, what.text);
            if (!fine && (closed & ERRORS) == 0) {
                faulted_check_message(&run, "armtol", "cannot write to standard output", what.text);
            }
        }
    }
}

/* As behind `| head -n 0`: the signal that a shell expects, or, where it is ignored, a message. */
static void test_output_that_nobody_reads(void)
{
    static faulted_run run;
    const string folder = folder_for_commands();
    for (int command = 0; command < COMMANDS; command++) {
        const string name = name_of_command(command);
        start_command(command, folder.text);
        faulted_try(&(fault){.broken = OUTPUT}, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(128 + SIGPIPE, run.status, name.text);
        TEST_ASSERT_EQUAL_STRING_MESSAGE("", run.errors.bytes, name.text);
        faulted_try(&(fault){.broken = OUTPUT, .pipes_ignored = true}, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(1, run.status, name.text);
        faulted_check_message(&run, "armtol", "cannot write to standard output", name.text);
    }
}

/* The dialogue is on standard error: at the first question that nobody reads a run ends, or it is not missed. */
static void test_dialogue_that_nobody_reads(void)
{
    static faulted_run run;
    for (int i = 0; i < PROGRAMS; i++) {
        const char *name = programs[i].name;
        const string folder = start_session(&programs[i]);
        prepare_session(folder.text, &programs[i], true);
        faulted_try(&(fault){.broken = ERRORS}, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(128 + SIGPIPE, run.status, name);
        TEST_ASSERT_EQUAL_INT(0, check_session_files(folder.text, &programs[i], true, false, name));
        faulted_try(&(fault){.broken = ERRORS, .pipes_ignored = true}, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, name);
        TEST_ASSERT_EQUAL_INT(FILES, check_session_files(folder.text, &programs[i], true, false, name));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_closed_streams_of_the_programs_of_1987);
    RUN_TEST(test_closed_streams_and_a_full_disk);
    RUN_TEST(test_closed_streams_of_armtol);
    RUN_TEST(test_output_that_nobody_reads);
    RUN_TEST(test_dialogue_that_nobody_reads);
    printf("%ld runs\n", faulted_count());
    return UNITY_END();
}
