/*
 * Runs that are killed (SIGKILL, as by a lack of memory or of electricity) before every system call that writes, or
 * half way through it; and runs that a signal comes to before every such call. Every file is then the old one or the
 * new one, whole. After a kill a hidden draft may be left, and where it comes between the two renames of a pair the
 * first of the pair is new and the second old; after any other signal neither.
 */

#include "faults/commands.h"

#include "unity.h"

#include <signal.h>
#include <stdio.h>

void setUp(void)
{
}

void tearDown(void)
{
    faulted_end();
    process_clean_up();
}

/* ---- killed ---- */

/* A later run is not in the way of what a killed one has left. */
static void check_next_run(const tested *program, const char *folder, const char *what)
{
    static faulted_run run;
    faulted_try(&(fault){0}, &run);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, what);
    TEST_ASSERT_EQUAL_INT_MESSAGE(FILES, check_session_files(folder, program, false, true, what), what);
}

static void kill_at_every_call(const tested *program, fault_action action, bool old)
{
    static faulted_run run;
    const string folder = start_session(program);
    long n = 0, between = 0;
    do {
        const fault fault = {.call = ++n, .action = action};
        const string what = string_of("%s, killed %s call %ld, %s", program->name,
                                      action == ACTION_KILL ? "before" : "within", n, old ? "old" : "new");
        prepare_session(folder.text, program, old);
        faulted_try(&fault, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(run.outcome.happened ? 128 + SIGKILL : 0, run.status, what.text);
        between += check_session_files(folder.text, program, old, true, what.text) % 2;
        check_next_run(program, folder.text, what.text);
    } while (run.outcome.happened);
    TEST_ASSERT_EQUAL_INT_MESSAGE(2, between, "a pair is apart between its renames, and only there");
    printf("%s: killed %s %ld calls, %s; the pairs apart at 2 of them\n", program->name,
           action == ACTION_KILL ? "before" : "within", n - 1, old ? "old" : "new");
}

static void test_killed_at_every_call(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        for (int old = 0; old < 2; old++) {
            kill_at_every_call(&programs[i], ACTION_KILL, old == 1);
            kill_at_every_call(&programs[i], ACTION_HALF_KILL, old == 1);
        }
    }
}

/* ---- signals ---- */

static const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGUSR1, SIGPIPE, SIGXCPU};
enum { SIGNALS = sizeof signals / sizeof signals[0] };

static long signal_at_every_call(const tested *program, const char *folder, int number)
{
    static faulted_run run;
    long n = 0;
    do {
        const fault fault = {.call = ++n, .action = ACTION_SIGNAL, .number = number};
        const string what = string_of("%s, signal %d before call %ld", program->name, number, n);
        prepare_session(folder, program, true);
        faulted_try(&fault, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(run.outcome.happened ? 128 + number : 0, run.status, what.text);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, check_session_files(folder, program, true, false, what.text) % 2, what.text);
    } while (run.outcome.happened);
    return n - 1;
}

static void test_signals_before_every_call(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = start_session(&programs[i]);
        long n = 0;
        for (int j = 0; j < SIGNALS; j++) {
            n += signal_at_every_call(&programs[i], folder.text, signals[j]);
        }
        printf("%s: %ld signals, of %d kinds\n", programs[i].name, n, SIGNALS);
    }
}

static void test_signals_before_every_call_of_armtol(void)
{
    static faulted_run run;
    const string folder = folder_for_commands();
    long signalled = 0;
    for (int command = 0; command < COMMANDS; command++) {
        const string name = name_of_command(command);
        start_command(command, folder.text);
        for (int j = 0; j < SIGNALS; j++) {
            long n = 0;
            do {
                const fault fault = {.call = ++n, .action = ACTION_SIGNAL, .number = signals[j]};
                faulted_try(&fault, &run);
                TEST_ASSERT_EQUAL_INT_MESSAGE(run.outcome.happened ? 128 + signals[j] : 0, run.status, name.text);
            } while (run.outcome.happened);
            signalled += n - 1;
        }
    }
    printf("armtol: %ld signals, of %d kinds\n", signalled, SIGNALS);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_killed_at_every_call);
    RUN_TEST(test_signals_before_every_call);
    RUN_TEST(test_signals_before_every_call_of_armtol);
    printf("%ld runs\n", faulted_count());
    return UNITY_END();
}
