/* Whole runs of armtol that ask for norms: what is read, what is told, what is refused. */

#include "armtol/runs.h"
#include "support/check.h"
#include "support/process.h"

#include "unity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A link along x, in its first pose: theta moves the tool by 100 along y, a along x, and alpha turns about x. */
#define LINK "units: mm rad\njoint,kind,a,alpha,d,theta\ntheta,npr,100,0,0,0\n"
#define AT_0 "my.csv", "--joints", "0"
#define MADE AT_0, "--tolerances", "theta=.001,a=.1"

static string folder;

void setUp(void)
{
    folder = folder_new();
    file_write(string_of("%s/my.csv", folder.text).text, LINK);
    file_write(string_of("%s/poses", folder.text).text, "0\n1.5707963267948966\n1\n");
}

void tearDown(void)
{
    process_clean_up();
}

static void test_a_disc_is_told(void)
{
    static const char *const says[] = {
        "\n  xy              0.2    0.141421    0.173205 ",
        "\nxy, the length of (dx, dy), is largest along (0.707, -0.707) (or against it).\n",
        "\n  link            dx     dy   dz   wx   wy     wz    xy\n",
        "\n  0 machining  100.0    0.0  0.0  0.0  0.0    0.0  50.0\n",
        "\n  xy motors    |000000000000000000000000000000\n     machining |000000000000000000000000000000\n",
        "\n  xy, mm  ",
        "1000 of 1000 arms are within the accuracy",
    };
    process process;
    run_well(&process, folder.text,
             (const char *const[]){MADE, "--accuracy", "xy=.2", "--budget", "--verify", "1000", NULL});
    for (size_t i = 0; i < sizeof says / sizeof says[0]; i++) {
        check_says(&process, says[i]);
    }
    run_well(&process, folder.text, (const char *const[]){MADE, "--accuracy", "wxy=1", "--budget", NULL});
    check_says(&process, "\n  dx  motors    |\n      machining |000000"); /* the names line up */
    check_says(&process, "\n  wxy motors    |\n      machining |\n");
}

static void test_numbers_of_a_norm(void)
{
    process process;
    run_well(&process, folder.text, (const char *const[]){MADE, "--accuracy", "xy=.2", "--json", "--sigma", "3",
                                                          "--method", "rss", "--verify", "2000", NULL});
    const char *told = text_after(process.output.bytes, "\"norms\": ["), *drawn = text_after(told, "\"norms\": [");
    check_within(1e-12, sqrt(0.02), number_after(told, "\"worst_case\": "), "worst");
    check_within(1e-12, 0.1 / sqrt(3), number_after(told, "\"standard_deviation\": "), "deviation of any direction");
    check_within(1e-12, 0.1 * sqrt(3), number_after(told, "\"sigmas\": "), "3 sigma");
    check_within(0.01, sqrt(0.02), number_after(drawn, "\"worst_drawn\": "), "of 2,000");
    check_within(1e-4, sqrt(0.02), number_after(drawn, "\"worst_corner\": "), "exact, in a corner");
}

static void test_where_a_norm_holds(void)
{
    process process;
    run_well(&process, folder.text, (const char *const[]){AT_0, "--accuracy", "xy=.2,dz=1", NULL});
    check_says(&process, "It\nholds the tolerances down along (0.707, -0.707) (66.7%)."); /* theta and a of three */
    run_well(&process, folder.text, (const char *const[]){AT_0, "--accuracy", "xy=.2", "--method", "rss", NULL});
    check_says(&process, "The largest tolerances with which 3 standard deviations of every component, and\n"
                         "of norms in every direction, are within its accuracy in this pose;");
    check_says(&process, "\nxy, the length of (dx, dy), by sigma is largest along (");
    run_well(&process, folder.text,
             (const char *const[]){"my.csv", "--poses", "poses", "--accuracy", "xz=.2,w=.1", NULL});
    check_says(&process, ") in pose ");
}

static void test_units_of_norms(void)
{
    process process;
    run_well(&process, folder.text,
             (const char *const[]){AT_0, "--metres", "--degrees", "--accuracy", "r=.002, w=.01", "--json", NULL});
    check_says(&process, "\"name\": \"r\",\n      \"accuracy\": 0.002,\n      \"worst_case\": 0.0019999");
    check_says(&process, "\"name\": \"w\",\n      \"accuracy\": 0.01,\n      \"worst_case\": 0.009999");
}

static void test_blanks_set_apart_too(void)
{
    process process, other;
    run_well(&process, folder.text, (const char *const[]){AT_0, "--accuracy", "r=.2,w=.1,dz=.05", "--csv", NULL});
    run_well(&other, folder.text, (const char *const[]){AT_0, "--accuracy", " r=.2  w=.1 , dz=.05 ", "--csv", NULL});
    text_check(process.output.bytes, process.output.length, &other.output, "blanks");
}

static void test_a_norm_without_a_bound(void)
{
    static const char message[] = "armtol: --verify: the tolerances leave w without a bound; expected finite ones for "
                                  "all that w depends on, or none for it in --accuracy\n";
    process process;
    file_write(string_of("%s/t.csv", folder.text).text, "link,parameter,tolerance\n0,alpha,inf\n");
    run_well(&process, folder.text,
             (const char *const[]){AT_0, "--tolerances", "t.csv", "--accuracy", "w=1,xy=1", "--budget", NULL});
    check_says(&process, "\nw, the length of (wx, wy, wz), has no bound.\n");
    check_says(&process, "\n  w  without a bound\n");
    run(&process, folder.text,
        (const char *const[]){AT_0, "--tolerances", "t.csv", "--accuracy", "w=1,xy=1", "--verify", "10", NULL});
    process_check_status(&process, 2, "a norm without a bound");
    text_check(message, sizeof message - 1, &process.errors, "a norm without a bound");
}

static void test_an_accuracy_below_rounding(void)
{
    process process;
    run_well(&process, folder.text, (const char *const[]){AT_0, "--accuracy", "xy=1e-14", NULL});
    check_says(&process, "\nxy: the accuracy is less than the ");
}

/* By sphere nothing can be asked of norms, and what is given can be held against them. */
static void test_given_tolerances_by_any_method(void)
{
    process process;
    run_well(&process, folder.text, (const char *const[]){MADE, "--accuracy", "xy=.2", "--method", "sphere", NULL});
    check_says(&process, "\n  xy              0.2    0.141421 ");
}

typedef struct wrong {
    const char *arguments[9];
    const char *message;
} wrong;

static const wrong wrong_calls[] = {
    {{AT_0, "--accuracy", "q=2"},
     "--accuracy: unknown name \"q\"; expected dx, dy, dz, wx, wy, wz, r, xy, xz, yz, w, wxy, wxz, wyz, ap "
     "or rp\n"},
    {{AT_0, "--accuracy", "r=2,dx=1,r=3"}, "--accuracy: r is given twice; expected once\n"},
    {{AT_0, "--accuracy", "dx=2,dx=1"}, "--accuracy: dx is given twice; expected once\n"},
    {{AT_0, "--accuracy", "r=2,1"},
     "--accuracy: \"1\" is no NAME=NUMBER; expected names for all numbers, or six numbers without\n"},
    {{AT_0, "--accuracy", "r=2,"},
     "--accuracy: \"\" is no NAME=NUMBER; expected names for all numbers, or six numbers without\n"},
    {{AT_0, "--accuracy", "r=0"}, "--accuracy: r: \"0\" is not greater than zero\n"},
    {{AT_0, "--accuracy", "r="}, "--accuracy: r: \"\" is not a number\n"},
    {{AT_0, "--accuracy", "r=inf"}, "--accuracy: r: \"inf\" is not a finite number\n"},
    {{AT_0, "--accuracy", "xy=1e400"}, "--accuracy: xy: \"1e400\" is too large a number\n"},
    {{AT_0, "--metres", "--accuracy", "r=1e307"}, "--accuracy: r is too large\n"},
    {{AT_0, "--metres", "--accuracy", "r=1,dy=1e307"}, "--accuracy: dy is too large\n"},
    {{AT_0, "--degrees", "--accuracy", "w=1e-323"}, "--accuracy: w is too small\n"},
    {{AT_0, "--accuracy", "r=1.0000000000000000000000000000000000000000000000000000000000000000"},
     "--accuracy: \"r=1.000000000000000000000000000000000000...\" is too long\n"},
    {{AT_0, "--accuracy", "r=1", "--method", "sphere"},
     "--method sphere keeps to components alone; expected no r in --accuracy, or another method\n"},
    {{AT_0, "--accuracy", "w=1,xy=.2", "--given", "theta=.004"},
     "no tolerances: what is given uses 200 % of xy in pose 1: motor of link 0 200 %\n"},
    {{AT_0, "--accuracy", "xy=.2", "--given", "theta=.004", "--method=rss"},
     "no tolerances: what is given uses 346.4 % of xy in pose 1: motor of link 0 346 %\n"},
    {{"my.csv", "--poses", "poses", "--accuracy", "xz=.2", "--drives", "backlash=.004"},
     "no tolerances: the drives alone use 200 % of xz in pose 2: motor of link 0 200 %\n"},
};

static void test_what_is_wrong_is_named(void)
{
    for (size_t i = 0; i < sizeof wrong_calls / sizeof wrong_calls[0]; i++) {
        process process;
        run(&process, folder.text, wrong_calls[i].arguments);
        process_check_status(&process, 2, wrong_calls[i].message);
        TEST_ASSERT_EQUAL_STRING(string_of("armtol: %s", wrong_calls[i].message).text, process.errors.bytes);
        text_check("", 0, &process.output, wrong_calls[i].message);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_disc_is_told);
    RUN_TEST(test_numbers_of_a_norm);
    RUN_TEST(test_where_a_norm_holds);
    RUN_TEST(test_units_of_norms);
    RUN_TEST(test_blanks_set_apart_too);
    RUN_TEST(test_a_norm_without_a_bound);
    RUN_TEST(test_an_accuracy_below_rounding);
    RUN_TEST(test_given_tolerances_by_any_method);
    RUN_TEST(test_what_is_wrong_is_named);
    return UNITY_END();
}
