/*
 * Two runs at once in one folder. With run numbers of their own neither knows of the other. With the same number both
 * succeed, every file is whole and of the one or the other, and nothing else is left. A pair is of one run, but where
 * the other run's renames come between this one's.
 */

#include "faults/commands.h"

#include "unity.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static long pairs_of_runs;

void setUp(void)
{
}

void tearDown(void)
{
    faulted_end();
    process_clean_up();
}

/* 1 or 2: the paper's case that the file is of. It has to be whole. */
static int case_of(const tested *program, const char *folder, int file, int run)
{
    static text found, golden;
    const string name = string_of("%s.1", program->files[file]);
    const string path = string_of("%s/%s.%d", folder, program->files[file], run);
    file_read(path.text, &found);
    for (int number = 1; number <= 2; number++) {
        const string right = golden_of(golden_1987, program, number, name.text);
        file_read(right.text, &golden);
        if (found.length == golden.length && memcmp(found.bytes, golden.bytes, found.length) == 0) {
            return number;
        }
    }
    fail_with("%s is of neither run", path.text);
    return 0;
}

/* How many of the two pairs are of two runs. */
static int mixed_pairs(const tested *program, const char *folder)
{
    int mixed = 0;
    for (int file = 0; file < FILES; file += 2) {
        mixed += case_of(program, folder, file, 1) != case_of(program, folder, file + 1, 1);
    }
    return mixed;
}

/* ---- one within the other ---- */

/* Every case of one run standing still before a call, while another goes from its beginning to its end. */
static void check_run_within(const tested *program)
{
    static faulted_run run;
    static text input;
    const string folder = start_session(program), listing = listing_of(program, 2, 1);
    const string other = golden_of(golden_1987, program, 2, "input");
    long n = 0, mixed = 0;
    file_read(other.text, &input);
    for (;;) {
        const fault fault = {.call = ++n, .action = ACTION_SIGNAL, .number = SIGSTOP};
        const string what = string_of("%s, a run within call %ld", program->name, n);
        process second;
        prepare_session(folder.text, program, false);
        faulted_try(&fault, &run);
        if (!run.outcome.happened) {
            break;
        }
        TEST_ASSERT_EQUAL_INT_MESSAGE(128 + SIGSTOP, run.status, what.text);
        run_in(folder.text, program, NULL, input.bytes, &second);
        process_check_status(&second, 0, what.text);
        faulted_resume(&run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, what.text);
        folder_check(folder.text, listing.text, what.text);
        mixed += mixed_pairs(program, folder.text);
        pairs_of_runs++;
    }
    printf("%s: a run within another, at %ld calls; pairs of two runs: %ld\n", program->name, n - 1, mixed);
    /* the other's pair is between the two renames of this one's: once a pair */
    TEST_ASSERT_EQUAL_INT_MESSAGE(2, mixed, program->name);
}

static void test_one_run_within_another(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        check_run_within(&programs[i]);
    }
}

/* ---- both at once ---- */

static pid_t start(const tested *program, const char *folder, int number, const char *run)
{
    const string input = golden_of(golden_1987, program, number, "input");
    const pid_t id = fork();
    if (id == 0) {
        const int from = open(input.text, O_RDONLY), nowhere = open("/dev/null", O_WRONLY);
        if (from >= 0 && nowhere >= 0 && dup2(from, STDIN_FILENO) >= 0 && dup2(nowhere, STDERR_FILENO) >= 0) {
            execl(program->path, program->name, "--output", folder, "--run", run, (char *)NULL);
        }
        _exit(127);
    }
    return id;
}

static void check_ended(pid_t id, const char *what)
{
    int status = -1;
    while (waitpid(id, &status, 0) < 0 && errno == EINTR) {
    }
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, what);
}

static void test_both_at_once(void)
{
    enum { TIMES = 150 };
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new(), listing = listing_of(&programs[i], 2, 1);
        int mixed = 0;
        for (int n = 0; n < TIMES; n++) {
            prepare_session(folder.text, &programs[i], true);
            const pid_t one = start(&programs[i], folder.text, 1, "1");
            const pid_t other = start(&programs[i], folder.text, 2, "1");
            check_ended(one, programs[i].name);
            check_ended(other, programs[i].name);
            folder_check(folder.text, listing.text, programs[i].name);
            mixed += mixed_pairs(&programs[i], folder.text);
            pairs_of_runs++;
        }
        printf("%s: %d times two runs of one number; pairs of two runs: %d\n", programs[i].name, TIMES, mixed);
    }
}

static void test_both_at_once_with_numbers_of_their_own(void)
{
    enum { TIMES = 150 };
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new();
        for (int n = 0; n < TIMES; n++) {
            prepare_session(folder.text, &programs[i], false);
            const pid_t one = start(&programs[i], folder.text, 1, "1");
            const pid_t other = start(&programs[i], folder.text, 2, "2");
            check_ended(one, programs[i].name);
            check_ended(other, programs[i].name);
            check_golden(folder.text, 1, &programs[i], golden_1987, 1, FILES, programs[i].name);
            check_golden(folder.text, 2, &programs[i], golden_1987, 2, FILES, programs[i].name);
            pairs_of_runs++;
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_one_run_within_another);
    RUN_TEST(test_both_at_once);
    RUN_TEST(test_both_at_once_with_numbers_of_their_own);
    printf("%ld runs\n", pairs_of_runs);
    return UNITY_END();
}
