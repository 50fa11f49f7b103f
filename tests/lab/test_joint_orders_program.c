/* The program joint-orders, run as its users run it. */

#include "support/process.h"
#include "unity.h"

#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

static process process_of;

/* Named from their folder: messages quote the beginning of a name only, and a clone may lie anywhere. */
#define PUBLISHED "published.tsv"

/* Run it on the published numbers; arguments go up to a NULL. */
static void run(const char *const arguments[], const char *output_path)
{
    const char *all[8] = {NULL};
    size_t n = 0;
    for (; arguments[n] != NULL; n++) {
        all[n] = arguments[n];
    }
    all[n] = PUBLISHED;
    const process_setup setup = {
        .program = TEST_JOINT_ORDERS, .arguments = all, .folder = TEST_GOLDEN, .output_path = output_path};
    process_run(&process_of, &setup, "");
}

#define WITH(...) ((const char *const[]){__VA_ARGS__, NULL})

static void check_says(const char *words)
{
    if (strstr(process_of.output.bytes, words) == NULL) {
        fail_with("expected \"%s\" in \"%s\"", words, process_of.output.bytes);
    }
}

static void check_refuses(const char *const arguments[], const char *expected)
{
    run(arguments, NULL);
    process_check_status(&process_of, 2, arguments[0]);
    TEST_ASSERT_EQUAL_STRING(expected, process_of.errors.bytes);
    TEST_ASSERT_EQUAL_STRING("", process_of.output.bytes);
}

static void test_the_chain_misses_joint_4_of_case_2(void)
{
    run(WITH("--show=histogram,misses", "--given=elbow=chain", "--format=tsv"), NULL);
    process_check_status(&process_of, 0, "the chain");
    TEST_ASSERT_EQUAL_STRING("", process_of.errors.bytes);
    check_says("\nright\tintella\tadpta\tpairs\n20\t\t\t0\n");
    /* Counted by hand: last-link with right-angle 3, constants with base 3, sines, d and last 2 each. */
    check_says("\nany\t72\t512\t36864\n");
    check_says("\ntheta[4] of case 2\t-1.666827\t-1.666826\t");
    check_says("\ntheta[3] of case 2\t-3.737291\t2.545889\t96\tturns=wrapped\n");
}

static void test_the_same_words_every_time(void)
{
    static text first;
    run(WITH("--show=choices,open,all", "--given=elbow=chain", "--given=sines=float"), NULL);
    process_check_status(&process_of, 0, "the first time");
    first = process_of.output;
    run(WITH("--show=choices,open,all", "--given=elbow=chain", "--given=sines=float"), NULL);
    text_check(first.bytes, first.length, &process_of.output, "the second time");
}

static void test_formats(void)
{
    run(WITH("-s", "margins", "-f", "markdown"), NULL);
    check_says("\n### intella: how far");
    check_says("\n| theta[4] of case 2 | -1.666827 |   -1.666826512 |");
    run(WITH("-s", "family", "-f", "tsv"), NULL);
    check_says("\nwrist=t05\tthe wrist\tthe position of T05\n");
    run(WITH("-s", "family"), NULL);
    check_says("\n  wrist: the wrist\n    t06  ");
    run(WITH("-s", "family", "-f", "markdown"), NULL);
    check_says("\n- `wrist`: the wrist\n  - `t06`: the position of T06 less");
}

/* What the library does is among what fits. */
static void test_the_library_fits(void)
{
    run(WITH("--show=all",
             "--given=sines=double,base=inverse,constants=double,order=q6,last-link=matrix",
             "--given=right-angle=float,plane=written,q345=x5,wrist=t06"), NULL);
    process_check_status(&process_of, 0, "the library");
    check_says("(the library's)");
}

static void test_more_cases_than_there_is_room_for(void)
{
    const string folder = folder_new(), path = string_of("%s/five.tsv", folder.text);
    text table = {0};
    for (int number = 1; number <= 5; number++) {
        for (int i = 0; i < 6; i++) {
            static const char *const names[] = {"x", "y", "z", "gamma", "beta", "alpha"};
            const string line = string_of("intella\t%d\tposition\t%s\t%s\t-\n", number, names[i], i < 2 ? "200" : "0");
            strcat(table.bytes, line.text);
        }
        for (int i = 1; i <= 6; i++) {
            const string line = string_of("intella\t%d\tresult\ttheta[%d]\t0.500000\t-\n", number, i);
            strcat(table.bytes, line.text);
        }
    }
    file_write(path.text, table.bytes);
    const char *const five[] = {path.text, NULL};
    const process_setup setup = {.program = TEST_JOINT_ORDERS, .arguments = five};
    process_run(&process_of, &setup, "");
    TEST_ASSERT_TRUE(process_of.status == 1 || process_of.status == 2);
    TEST_ASSERT_EQUAL_STRING("joint-orders: intella: more than 4 cases\n", process_of.errors.bytes);
}

static void test_wrong_usage_is_named(void)
{
    check_refuses(WITH("--show=choices,colours"),
                  "joint-orders: --show: unknown part \"colours\"; expected parts as in --help\n");
    check_refuses(WITH("--given=sines=float,root=half"),
                  "joint-orders: --given: unknown option \"root=half\"; "
                  "expected CHOICE=OPTION as in --show=family\n");
    check_refuses(WITH("--format=html"),
                  "joint-orders: --format: unknown format \"html\"; expected text, markdown or tsv\n");
    check_refuses(WITH("--colour"),
                  "joint-orders: unknown option \"--colour\"; expected options as in --help\n");
    check_refuses(WITH("here"), "joint-orders: unexpected argument \"" PUBLISHED
                                "\"; expected joint-orders [OPTION]... PUBLISHED\n");
    check_refuses(WITH("--show"), "joint-orders: --show: unknown part \"" PUBLISHED
                                  "\"; expected parts as in --help\n");
}

static void test_the_published_numbers_are_needed(void)
{
    const string folder = folder_new();
    const string nowhere = string_of("%s/nothing.tsv", folder.text);
    const string expected = string_of("joint-orders: %s: No such file or directory\n", nowhere.text);
    const char *const missing[] = {nowhere.text, NULL};
    const process_setup setup = {.program = TEST_JOINT_ORDERS, .arguments = missing};
    process_run(&process_of, &setup, "");
    process_check_status(&process_of, 2, "no such file");
    TEST_ASSERT_EQUAL_STRING(expected.text, process_of.errors.bytes);
    const process_setup bare = {.program = TEST_JOINT_ORDERS};
    process_run(&process_of, &bare, "");
    process_check_status(&process_of, 2, "no argument");
}

static void test_help_and_version(void)
{
    run(WITH("--help"), NULL);
    process_check_status(&process_of, 0, "--help");
    check_says("Usage: joint-orders ");
    run(WITH("--version"), NULL);
    process_check_status(&process_of, 0, "--version");
    TEST_ASSERT_EQUAL_STRING("joint-orders (armtol) " TEST_VERSION "\n", process_of.output.bytes);
}

static void test_a_full_disk_is_no_success(void)
{
    run(WITH("--show=family"), "/dev/full");
    process_check_status(&process_of, 1, "/dev/full");
    TEST_ASSERT_EQUAL_STRING("joint-orders: cannot write to standard output\n", process_of.errors.bytes);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_chain_misses_joint_4_of_case_2);
    RUN_TEST(test_the_same_words_every_time);
    RUN_TEST(test_formats);
    RUN_TEST(test_the_library_fits);
    RUN_TEST(test_more_cases_than_there_is_room_for);
    RUN_TEST(test_wrong_usage_is_named);
    RUN_TEST(test_the_published_numbers_are_needed);
    RUN_TEST(test_help_and_version);
    RUN_TEST(test_a_full_disk_is_no_success);
    return UNITY_END();
}
