/* Who waits for arms to be drawn: interrupts, and the bar. */

#include "armtol/ask/watched.h"
#include "console/interrupt.h"
#include "lib/engine/one_link.h"
#include "support/check.h"
#include "support/process.h"

#include "unity.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

static volatile sig_atomic_t handled;

static void handle(int number)
{
    (void)number;
    handled = 1;
}

static void test_a_second_interrupt_is_not_held_up(void)
{
    struct sigaction before, now;
    const struct sigaction ours = {.sa_handler = handle};
    sigaction(SIGINT, &ours, NULL);
    interrupt_watch(&before);
    TEST_ASSERT_FALSE(interrupt_came());
    raise(SIGINT);
    TEST_ASSERT_TRUE(interrupt_came());
    sigaction(SIGINT, NULL, &now);
    TEST_ASSERT_TRUE(now.sa_handler == SIG_DFL);
    interrupt_restore(&before);
    TEST_ASSERT_FALSE(handled);
    raise(SIGINT);
    TEST_ASSERT_TRUE(handled);
    interrupt_watch(&before);
    TEST_ASSERT_FALSE(interrupt_came());
    interrupt_restore(&before);
    signal(SIGINT, SIG_DFL);
}

static void test_drawing_leaves_interrupts_as_they_were(void)
{
    const struct sigaction ours = {.sa_handler = handle};
    struct sigaction now;
    one_link one;
    armtol_answer *answer;
    armtol_verification found;
    one_link_make(&one, 10);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&one.question, &answer, NULL));
    sigaction(SIGINT, &ours, NULL);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, watched_verify(answer, &one.draw, &found, NULL));
    armtol_answer_destroy(answer);
    sigaction(SIGINT, NULL, &now);
    TEST_ASSERT_TRUE(now.sa_handler == handle);
    signal(SIGINT, SIG_DFL);
}

static void test_ignored_interrupts_stay_ignored(void)
{
    struct sigaction before, now;
    signal(SIGINT, SIG_IGN);
    interrupt_watch(&before);
    raise(SIGINT);
    TEST_ASSERT_FALSE(interrupt_came());
    interrupt_restore(&before);
    sigaction(SIGINT, NULL, &now);
    TEST_ASSERT_TRUE(now.sa_handler == SIG_IGN);
    signal(SIGINT, SIG_DFL);
}

static double seconds(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* What stands on the terminal's last line when all is written. */
static void last_line_on_terminal(const text *said, char line[200])
{
    size_t at = 0;
    memset(line, ' ', 199);
    line[199] = '\0';
    for (size_t i = 0; i < said->length; i++) {
        if (said->bytes[i] == '\r') {
            at = 0;
        } else if (at < 199) {
            line[at++] = said->bytes[i];
        }
    }
}

static void check_interrupted(const process *process)
{
    unsigned long long drawn = 0, within = 0;
    double worst = 0, median = 0;
    process_check_status(process, 0, "interrupted");
    const int read = sscanf(process->output.bytes, "drawn %llu, within %llu, worst %lf, median %lf", &drawn,
                            &within, &worst, &median);
    if (read != 4) {
        fail_with("the interrupted program printed \"%s\"", process->output.bytes);
    }
    TEST_ASSERT_TRUE(drawn > 1000 && drawn < 1000000000000u && within == drawn);
    check_within(0.0001, 0.004, worst, "worst of what was drawn");
    check_within(0.0002, 0.002, median, "median of what was drawn");
}

static void test_the_bar_on_a_terminal(void)
{
    static process process;
    char line[200];
    const process_setup setup = {.program = TEST_ENDLESS, .wires = {WIRE_TERMINAL, WIRE_PIPE, WIRE_TERMINAL}};
    const double started = seconds();
    process_start(&process, &setup);
    process_expect(&process, "\r[....................]   0 %  ");
    TEST_ASSERT_TRUE(seconds() - started > 0.99);
    process_expect(&process, " of 9223372036854775807 arms, ");
    process_expect(&process, " d left");
    process_expect(&process, "\r[");
    process_say(&process, "\003"); /* Ctrl-C */
    process_finish(&process);
    check_interrupted(&process);
    last_line_on_terminal(&process.errors, line);
    if (strspn(line, " ") != strlen(line)) {
        fail_with("left on the terminal: \"%s\"", line);
    }
    TEST_ASSERT_NULL(strchr(process.errors.bytes, '\n'));
    TEST_ASSERT_EQUAL_INT('\r', process.errors.bytes[process.errors.length - 1]);
}

static void test_no_bar_on_a_pipe(void)
{
    static process process;
    const process_setup setup = {.program = TEST_ENDLESS};
    const struct timespec pause = {.tv_sec = 1, .tv_nsec = 500000000};
    process_start(&process, &setup);
    nanosleep(&pause, NULL);
    kill(process.id, SIGINT);
    process_finish(&process);
    check_interrupted(&process);
    TEST_ASSERT_EQUAL_INT(0, process.errors.length);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_second_interrupt_is_not_held_up);
    RUN_TEST(test_drawing_leaves_interrupts_as_they_were);
    RUN_TEST(test_ignored_interrupts_stay_ignored);
    RUN_TEST(test_the_bar_on_a_terminal);
    RUN_TEST(test_no_bar_on_a_pipe);
    return UNITY_END();
}
