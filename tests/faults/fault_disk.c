/*
 * A disk, or what standard output goes to, that is full after every number of bytes; every system call that writes or
 * changes files failing; writes that take a byte at a time.
 */

#include "faults/commands.h"

#include "unity.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

void setUp(void)
{
}

void tearDown(void)
{
    faulted_end();
    process_clean_up();
}

/* ---- a full disk ---- */

static void sizes_of(const tested *program, long sizes[FILES])
{
    for (int i = 0; i < FILES; i++) {
        const string name = string_of("%s.1", program->files[i]);
        const string path = golden_of(golden_1987, program, 1, name.text);
        struct stat status;
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, stat(path.text, &status), path.text);
        sizes[i] = (long)status.st_size;
    }
}

/* The file that is not whole when there is room for so many bytes; FILES where all are. */
static int first_unwritten(const long sizes[FILES], long room)
{
    int file = 0;
    for (; file < FILES && room >= sizes[file]; file++) {
        room -= sizes[file];
    }
    return file;
}

static void check_full_disk(const tested *program, const char *folder, const long sizes[FILES], long room, bool old)
{
    static faulted_run run;
    const string what = string_of("%s, room for %ld bytes, %s", program->name, room, old ? "old" : "new");
    const int file = first_unwritten(sizes, room);
    prepare_session(folder, program, old);
    faulted_try(&(fault){.disk_full = true, .disk_room = room}, &run);
    const int n_new = check_session_files(folder, program, old, false, what.text);
    TEST_ASSERT_EQUAL_INT_MESSAGE(file < FILES ? 1 : 0, run.status, what.text);
    TEST_ASSERT_EQUAL_INT_MESSAGE(file / 2 * 2, n_new, what.text);
    TEST_ASSERT_TRUE_MESSAGE(run.outcome.ended && run.outcome.live == 0, what.text);
    if (file < FILES) {
        const string words = string_of("/%s.1: No space left on device", program->files[file]);
        faulted_check_message(&run, program->name, words.text, what.text);
    }
}

/* Up to the last step of a pair, its renames, old files make no difference: without them less is tried. */
static void test_disk_full_after_every_byte(void)
{
    enum { NEW_STEP = 17 };
    for (int i = 0; i < PROGRAMS; i++) {
        long sizes[FILES], sum = 0;
        const string folder = start_session(&programs[i]);
        sizes_of(&programs[i], sizes);
        for (int j = 0; j < FILES; j++) {
            sum += sizes[j];
        }
        for (long room = 0; room <= sum; room++) {
            check_full_disk(&programs[i], folder.text, sizes, room, true);
        }
        for (long room = 0; room <= sum; room += NEW_STEP) {
            check_full_disk(&programs[i], folder.text, sizes, room, false);
        }
        printf("%s: disk full after 0 to %ld bytes, over old files; every %d, without any\n", programs[i].name, sum,
               NEW_STEP);
    }
}

/* ---- full standard output ---- */

/* What comes out is a beginning of what should. */
static void check_full_output(int command, const char *folder, long step)
{
    static faulted_run right, run;
    const string name = name_of_command(command);
    start_command(command, folder);
    faulted_try(&(fault){0}, &right);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, right.status, right.errors.bytes);
    const long length = (long)right.output.length;
    for (long room = 0; room <= length; room += room + step <= length || room == length ? step : length - room) {
        const string what = string_of("%s, room for %ld bytes", name.text, room);
        faulted_try(&(fault){.output_full = true, .output_room = room}, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(room < length, run.status, what.text);
        text_check(right.output.bytes, (size_t)room, &run.output, what.text);
        TEST_ASSERT_TRUE_MESSAGE(run.outcome.ended && run.outcome.live == 0, what.text);
        if (room < length) {
            faulted_check_message(&run, "armtol", "cannot write to standard output", what.text);
        }
    }
    printf("%s: standard output full after 0 to %ld bytes, step %ld\n", name.text, length, step);
}

/*
 * Commands that take long are tried with every 13th or 61st number of bytes: where output fails is a matter of libc's
 * buffer, which is the same for all, and they print by the same routines.
 */
static void test_output_full_after_every_byte(void)
{
    static const long steps[COMMANDS] = {1, 61, 13, 1, 13, 1, 1, 1, 1, 13, 13, 13, 13, 13, 13, 13};
    const string folder = folder_for_commands();
    for (int command = 0; command < COMMANDS; command++) {
        TEST_ASSERT_TRUE_MESSAGE(steps[command] > 0, "a command without a step");
        check_full_output(command, folder.text, steps[command]);
    }
}

/* ---- calls that fail ---- */

/* A message that could not be written is not there; the status tells all the same. */
static void check_message_if_any(const faulted_run *run, const char *name, const char *what)
{
    if (run->errors.length > 0 && run->errors.bytes[run->errors.length - 1] == '\n') {
        faulted_check_message(run, name, NULL, what);
    }
}

static long fail_calls_of_session(const tested *program, const char *folder, int number)
{
    static faulted_run run;
    long n = 0, odd = 0;
    do {
        const fault fault = {.call = ++n, .action = ACTION_ERROR, .number = number};
        const string what = string_of("%s, call %ld: %s", program->name, n, strerror(number));
        prepare_session(folder, program, true);
        faulted_try(&fault, &run);
        const int n_new = check_session_files(folder, program, true, false, what.text);
        TEST_ASSERT_TRUE_MESSAGE(run.outcome.ended && run.outcome.live == 0, what.text);
        TEST_ASSERT_TRUE_MESSAGE(run.status == (n_new == FILES ? 0 : 1), what.text);
        odd += n_new % 2;
        if (run.status == 1) {
            check_message_if_any(&run, program->name, what.text);
        }
    } while (run.outcome.happened);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, program->name);
    /* where the second of two renames fails the first stays, and nowhere else */
    TEST_ASSERT_EQUAL_INT_MESSAGE(2, odd, program->name);
    return n - 1;
}

static const int errors[] = {EIO, ENOSPC, EDQUOT, EROFS, EINTR, EBADF};
enum { ERRORS = sizeof errors / sizeof errors[0] };

static void test_every_call_fails(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = start_session(&programs[i]);
        long n = 0;
        for (int j = 0; j < ERRORS; j++) {
            n += fail_calls_of_session(&programs[i], folder.text, errors[j]);
        }
        printf("%s: %ld failing calls, of %d errors\n", programs[i].name, n, ERRORS);
    }
}

static long fail_calls_of_command(int command, int number)
{
    static faulted_run right, run;
    const string name = name_of_command(command);
    long n = 0;
    faulted_try(&(fault){0}, &right);
    do {
        const fault fault = {.call = ++n, .action = ACTION_ERROR, .number = number};
        const string what = string_of("%s, call %ld: %s", name.text, n, strerror(number));
        faulted_try(&fault, &run);
        TEST_ASSERT_TRUE_MESSAGE(run.outcome.ended && run.outcome.live == 0 && run.status <= 1, what.text);
        if (run.status == 0) {
            text_check(right.output.bytes, right.output.length, &run.output, what.text);
        } else {
            faulted_check_message(&run, "armtol", "cannot write to standard output", what.text);
        }
    } while (run.outcome.happened);
    return n - 1;
}

static void test_every_call_of_armtol_fails(void)
{
    const string folder = folder_for_commands();
    long n = 0;
    for (int command = 0; command < COMMANDS; command++) {
        start_command(command, folder.text);
        for (int j = 0; j < ERRORS; j++) {
            n += fail_calls_of_command(command, errors[j]);
        }
    }
    printf("armtol: %ld failing calls, of %d errors\n", n, ERRORS);
}

/* ---- writes that take less than they are given ---- */

static void test_a_byte_at_a_time(void)
{
    static faulted_run right, run;
    const string folder = folder_for_commands();
    for (int i = 0; i < PROGRAMS; i++) {
        const string out = start_session(&programs[i]);
        faulted_try(&(fault){.short_writes = true}, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, programs[i].name);
        TEST_ASSERT_EQUAL_INT(FILES, check_session_files(out.text, &programs[i], false, false, programs[i].name));
    }
    for (int command = 0; command < COMMANDS; command++) {
        const string name = name_of_command(command);
        start_command(command, folder.text);
        faulted_try(&(fault){0}, &right);
        faulted_try(&(fault){.short_writes = true}, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, name.text);
        TEST_ASSERT_TRUE_MESSAGE(run.outcome.calls >= (long)right.output.length, name.text);
        text_check(right.output.bytes, right.output.length, &run.output, name.text);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_disk_full_after_every_byte);
    RUN_TEST(test_output_full_after_every_byte);
    RUN_TEST(test_every_call_fails);
    RUN_TEST(test_every_call_of_armtol_fails);
    RUN_TEST(test_a_byte_at_a_time);
    printf("%ld runs\n", faulted_count());
    return UNITY_END();
}
