/* The bar that says how far it is, on a clock and a terminal of the test's own. Built with --wrap. */

#include "console/progress.h"

#include "support/said.h"

#include "unity.h"

#include <math.h>
#include <string.h>
#include <time.h>

static double seconds;
static bool on_a_terminal;

int __wrap_clock_gettime(clockid_t clock, struct timespec *time);
int __wrap_isatty(int descriptor);

int __wrap_clock_gettime(clockid_t clock, struct timespec *time)
{
    TEST_ASSERT_TRUE(clock == CLOCK_MONOTONIC);
    time->tv_sec = (time_t)floor(seconds);
    time->tv_nsec = lround(1e9 * (seconds - floor(seconds)));
    return 0;
}

int __wrap_isatty(int descriptor)
{
    (void)descriptor;
    return on_a_terminal;
}

void setUp(void)
{
    seconds = 1000.25;
    on_a_terminal = true;
}

void tearDown(void)
{
}

static void check_said(const char *expected, const said *said)
{
    TEST_ASSERT_EQUAL_STRING(expected, said->text);
}

/* A bar drawn after ten seconds, one of `parts` equal parts being done: the others take as long each. */
static void check_bar(uint64_t parts, const char *expected)
{
    progress progress;
    said said;
    said_begin();
    progress_start(&progress, "arms", parts);
    seconds += 10;
    progress_show(&progress, 1);
    said_end(&said);
    check_said(expected, &said);
}

/* The largest unit of which there are two. */
static void test_the_time_that_is_left(void)
{
    check_bar(2, "\r[##########..........]  50 %  1 of 2 arms, 10 s left");
    check_bar(12, "\r[#...................]   8 %  1 of 12 arms, 110 s left");
    check_bar(14, "\r[#...................]   7 %  1 of 14 arms, 2 min left");         /* 130 s */
    check_bar(715, "\r[....................]   0 %  1 of 715 arms, 119 min left");    /* 7140 s */
    check_bar(727, "\r[....................]   0 %  1 of 727 arms, 2 h left");        /* 7260 s */
    check_bar(16921, "\r[....................]   0 %  1 of 16921 arms, 47 h left");   /* 169200 s */
    check_bar(17311, "\r[....................]   0 %  1 of 17311 arms, 2 d left");    /* 173100 s */
    check_bar(864001, "\r[....................]   0 %  1 of 864001 arms, 100 d left");
}

/* A text in the place of the bar: after the first second, ten times a second, and wiped like it. */
static void test_a_text_in_its_place(void)
{
    progress progress;
    said said;
    said_begin();
    progress_start(&progress, "boxes", 1);
    progress_say(&progress, "too early");
    seconds += 2;
    progress_say(&progress, "gap 12 %");
    seconds += 0.05;
    progress_say(&progress, "too soon");
    seconds += 0.1;
    progress_say(&progress, "gap 9 %");
    progress_end(&progress);
    said_end(&said);
    check_said("\rgap 12 %\rgap 9 % \r          \r", &said);
    on_a_terminal = false;
    said_begin();
    progress_start(&progress, "boxes", 1);
    seconds += 2;
    progress_say(&progress, "nobody looks");
    progress_end(&progress);
    said_end(&said);
    check_said("", &said);
}

static void test_it_is_drawn_ten_times_a_second_after_the_first(void)
{
    static const struct {
        double at;
        uint64_t done;
        const char *drawn;
    } steps[] = {
        {0.5, 10, ""},
        {0.99, 20, ""},
        {1.25, 25, "\r[#####...............]  25 %  25 of 100 arms, 4 s left"},
        {1.34, 30, ""},
        {1.5, 50, "\r[##########..........]  50 %  50 of 100 arms, 2 s left"},
        {1.75, 100, "\r[####################] 100 %  100 of 100 arms, 0 s left"},
    };
    progress progress;
    progress_start(&progress, "arms", 100);
    const double started = seconds;
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
        said said;
        seconds = started + steps[i].at;
        said_begin();
        progress_show(&progress, steps[i].done);
        said_end(&said);
        check_said(steps[i].drawn, &said);
    }
}

/* Nothing of a longer line stays, and in the end nothing at all, nor of a ^C behind it. */
static void test_it_wipes_what_it_has_drawn(void)
{
    static const char longer[] = "[##..................]  10 %  10 of 100 arms, 90 s left";
    static const char shorter[] = "[##################..]  90 %  90 of 100 arms, 1 s left";
    progress progress;
    said said;
    progress_start(&progress, "arms", 100);
    said_begin();
    seconds += 10;
    progress_show(&progress, 10);
    progress_show(&progress, 90);
    seconds += 1;
    progress_show(&progress, 90);
    said_end(&said);
    char expected[300];
    snprintf(expected, sizeof expected, "\r%s\r%s%*s", longer, shorter, (int)(strlen(longer) - strlen(shorter)), "");
    check_said(expected, &said);
    for (int i = 0; i < 2; i++) {
        said_begin();
        progress_end(&progress);
        said_end(&said);
        snprintf(expected, sizeof expected, "\r%*s\r", (int)strlen(longer) + 2, "");
        check_said(i == 0 ? expected : "", &said);
    }
}

static void test_nothing_is_drawn_where_there_is_no_terminal_or_nothing_done(void)
{
    for (int terminal = 0; terminal < 2; terminal++) {
        progress progress;
        said said;
        on_a_terminal = terminal;
        said_begin();
        progress_start(&progress, "arms", 100);
        seconds += 10;
        progress_show(&progress, terminal ? 0 : 50);
        progress_end(&progress);
        said_end(&said);
        check_said("", &said);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_time_that_is_left);
    RUN_TEST(test_a_text_in_its_place);
    RUN_TEST(test_it_is_drawn_ten_times_a_second_after_the_first);
    RUN_TEST(test_it_wipes_what_it_has_drawn);
    RUN_TEST(test_nothing_is_drawn_where_there_is_no_terminal_or_nothing_done);
    return UNITY_END();
}
