/* Whole runs of armtol that say how errors are distributed: what is read, what is told, what is refused. */

#include "armtol/runs.h"
#include "support/check.h"
#include "support/process.h"

#include "unity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Two links along x: a of each moves the tool along x, theta of the first by 200 along y. */
#define ARM "units: mm rad\nname,joint,kind,a,alpha,d,theta\nbase,theta,ppr,100,0,0,0\nelbow,theta,ppr,100,0,0,0\n"
#define POSED "my.csv", "--joints", "0,0"
#define REGION "q1=0..1;q2=0..1"
#define MAP "my.csv", "--plane", "xy", "--range", "0..1,0..1"
#define MADE POSED, "--tolerances", "a=.1"

static string folder;

void setUp(void)
{
    folder = folder_new();
    file_write(string_of("%s/my.csv", folder.text).text, ARM);
    file_write(string_of("%s/spread.csv", folder.text).text,
               "link,parameter,distribution,shift,group\n0,a,triangular,.02,mill\nelbow,a,triangular,,mill\n");
    file_write(string_of("%s/ends.csv", folder.text).text, "link,parameter,upper,lower\n0,a,.1,-.02\n1,a,.03,0\n");
}

void tearDown(void)
{
    process_clean_up();
}

static void check_refused(const char *expected, const char *const arguments[])
{
    check_refused_line(folder.text, arguments, expected);
}

/* Of dx: two errors within 0.1. */
static void check_deviation(double expected, const char *const arguments[])
{
    process process;
    run_well(&process, folder.text, arguments);
    const char *dx = text_after(process.output.bytes, "\"components\"");
    check_within(1e-9, expected, number_after(dx, "\"standard_deviation\": "), "standard deviation");
    check_within(1e-9, 0.2, number_after(dx, "\"worst_case\": "), "worst case");
}

static void test_a_list(void)
{
    check_deviation(0.1 * sqrt(2.0 / 3), (const char *const[]){MADE, "--json", NULL});
    check_deviation(0.1 * sqrt(2.0 / 6),
                    (const char *const[]){MADE, "--json", "--spread", "lengths=triangular,motors=normal:3", NULL});
    check_deviation(0.1 * sqrt(1.0 / 3 + 1),
                    (const char *const[]){MADE, "--json", "--spread", "a=ends,elbow.a=uniform", NULL});
}

static void test_a_list_is_told(void)
{
    process process;
    run_well(&process, folder.text,
             (const char *const[]){MADE, "--spread", "machining=normal:2.5", "--verify", "100", NULL});
    check_says(&process, "  link     kind  parameter   moved by  nominal  tolerance  unit      spread\n"
                         "  0 base    ppr      theta      motor        0          0   rad     uniform\n"
                         "  0 base    ppr          a  machining      100        0.1    mm  normal:2.5\n");
    check_says(&process, "100 arms drawn within the tolerances, spread as above (seed 1987): errors");
}

static void test_a_table_is_told(void)
{
    process process;
    run_well(&process, folder.text, (const char *const[]){MADE, "--spread", "spread.csv", NULL});
    check_says(&process, "nominal  tolerance  unit  shift\n");
    check_says(&process, "  0 base    ppr          a  machining      100        0.1    mm   0.02\n");
    /* too wide for a line: what a row is about stands in both parts */
    check_says(&process, "\n\n  link     kind  parameter      spread\n"
                         "  0 base    ppr      theta     uniform\n"
                         "  0 base    ppr          a  triangular\n");
    check_says(&process, "\nGroup mill, of one draw: a of link 0 (base), a of link 1 (elbow)\n");
    /* 0.02 + 0.2, and 0.02 + 3 (0.2 / sqrt 6) */
    check_says(&process, "\n  component  accuracy  worst case   3 sigma  shift    remainder  unit\n"
                         "  dx                -        0.22  0.264949   0.02  ");
    check_says(&process, "An error that is cut at its tolerance");
}

/* What --csv writes is the tolerances and the distributions that it is read as again. */
static void test_a_table_is_written(void)
{
    process first, again;
    run_well(&first, folder.text, (const char *const[]){MADE, "--spread", "spread.csv", "--csv", NULL});
    TEST_ASSERT_NOT_NULL(strstr(first.output.bytes, ",unit,name,distribution,shift,group\n"));
    TEST_ASSERT_NOT_NULL(strstr(first.output.bytes, "1,ppr,a,machining,100,0.1,mm,elbow,triangular,0,mill\n"));
    file_write(string_of("%s/again.csv", folder.text).text, first.output.bytes);
    run_well(&again, folder.text,
             (const char *const[]){POSED, "--tolerances", "again.csv", "--spread", "again.csv", "--csv", NULL});
    TEST_ASSERT_EQUAL_STRING(first.output.bytes, again.output.bytes);
}

static void test_json_has_distributions(void)
{
    process process;
    run_well(&process, folder.text, (const char *const[]){MADE, "--spread", "spread.csv", "--json", NULL});
    check_says(&process, "\"distribution\": \"triangular\",\n      \"shift\": 0.02,\n      \"group\": \"mill\"\n");
    check_says(&process, "\"distribution\": \"uniform\",\n      \"shift\": 0\n");
}

/* +0.1/-0.02 and +0.03/0: half widths 0.06 and 0.015 about 0.04 and 0.015. */
static void test_ends_of_tolerances(void)
{
    process process;
    run_well(&process, folder.text,
             (const char *const[]){POSED, "--tolerances", "ends.csv", "--accuracy", "dx=.13", "--budget", "--verify",
                                   "1000", NULL});
    check_says(&process, "  0 base    ppr          a  machining      100       0.06    mm   0.04\n");
    check_says(&process, "  dx             0.13        0.13  ");
    check_says(&process, "1000 of 1000 arms are within the accuracy");
    check_says(&process, "\n  0 base shift       30.8 ");  /* 0.04 of 0.13 */
    check_says(&process, "\n  1 elbow shift      11.5 ");
    check_says(&process, "\n  all shifts         42.3 ");
    check_says(&process, "     shifts    |0000000000000000001111111\n");
}

/* Beside a spread's shift, which adds to the middle. */
static void test_ends_and_shifts(void)
{
    process process;
    run_well(&process, folder.text,
             (const char *const[]){POSED, "--tolerances", "ends.csv", "--spread", "spread.csv", "--budget", "--svg",
                                   "-", NULL});
    check_says(&process, "class=\"shift part\"");
    run_well(&process, folder.text,
             (const char *const[]){POSED, "--tolerances", "ends.csv", "--spread", "spread.csv", NULL});
    check_says(&process, "  0 base    ppr          a  machining      100       0.06    mm   0.06\n");
}

static void test_loads_and_shifts_are_told_apart(void)
{
    process process;
    const char *const arguments[] = {MADE, "--drives", "compliance=1e-5", "--force", "0,10,0", "--spread", "motors.csv",
                                     "--json", "--budget", NULL};
    file_write(string_of("%s/motors.csv", folder.text).text, "link,parameter,shift\n1,theta,0.001\n");
    run_well(&process, folder.text, arguments);
    /* 10 N, 0.2 and 0.1 m ahead: 2 and 1 N m, 2e-5 and 1e-5 rad; the mean is not the load's */
    const char *elbow = text_after(text_after(process.output.bytes, "\"loads\""), "\"elbow\"");
    check_within(1e-12, 1e-5, number_after(elbow, "\"shift\": "), "by the load");
    const char *droop = text_after(process.output.bytes, "\"droop\": [");
    check_within(1e-8, 2e-5 * 200 + 1e-5 * 100, number_after(droop, ","), "no mean in the droop");
    check_says(&process, "\"role\": \"shift\"");
}

static void test_what_is_refused(void)
{
    check_refused("--spread: motors: unknown distribution \"even\"; expected uniform, normal:K (K from 0.01 to 30), "
                  "triangular or ends", (const char *const[]){MADE, "--spread", "motors=even", NULL});
    check_refused("--spread: \"motors\" is no NAME=DISTRIBUTION",
                  (const char *const[]){MADE, "--spread", "motors>=ends", NULL});
    check_refused("--spread: my has no parameter \"0.d\"",
                  (const char *const[]){MADE, "--spread", "0.d=ends", NULL});
    check_refused("--spread: none.csv: No such file or directory; expected NAME=DISTRIBUTION,... or a file",
                  (const char *const[]){MADE, "--spread", "none.csv", NULL});
    check_refused("--spread is for poses that are listed; expected none with --region and maps",
                  (const char *const[]){"my.csv", "--region", REGION, "--accuracy", "r=1", "--spread", "a=ends", NULL});
    check_refused("--spread is for poses that are listed; expected none with --region and maps",
                  (const char *const[]){"map", MAP, "--tolerances", "a=.1", "--spread", "a=ends", NULL});
    check_refused("--against and --deviations compare two arms; expected no --accuracy, --tolerances, --given, "
                  "--drawing, --weights, --spread, --budget, --verify or --iso9283 beside them",
                  (const char *const[]){POSED, "--against", "my.csv", "--spread", "a=ends", NULL});
    check_refused("--tolerances: ends.csv: upper and lower are for poses that are listed; expected a column tolerance "
                  "with --region and maps",
                  (const char *const[]){"my.csv", "--region", REGION, "--tolerances", "ends.csv", NULL});
    check_refused("--tolerances: ends.csv: upper and lower are for poses that are listed; expected a column tolerance "
                  "with --region and maps",
                  (const char *const[]){"map", MAP, "--tolerances", "ends.csv", NULL});
}

static void test_shifts_that_are_too_large(void)
{
    file_write(string_of("%s/far.csv", folder.text).text, "link,parameter,shift\n1,a,1e308\n");
    check_refused("--spread: a of link 1 (elbow): the shift is too large",
                  (const char *const[]){MADE, "--metres", "--spread", "far.csv", NULL});
    file_write(string_of("%s/far.csv", folder.text).text, "link,parameter,upper,lower\n1,a,1e308,1e308\n");
    check_refused("--tolerances: far.csv: a of link 1 (elbow): the tolerance is too large",
                  (const char *const[]){POSED, "--metres", "--tolerances", "far.csv", NULL});
}

static void test_groups_that_are_refused(void)
{
    file_write(string_of("%s/unlike.csv", folder.text).text,
               "link,parameter,distribution,group\n0,a,normal:3,mill\n1,a,normal:2,mill\n");
    check_refused("--spread: group mill is normal:3 in a of link 0 (base), and normal:2 in a of link 1 (elbow); "
                  "expected one distribution", (const char *const[]){MADE, "--spread", "unlike.csv", NULL});
    check_refused("--method rss shares nothing out within a group, and a of link 0 (base) is in group mill; "
                  "expected --tolerances, --given for all of the group, or --method worst",
                  (const char *const[]){POSED, "--accuracy", "r=1", "--method", "rss", "--spread", "spread.csv", NULL});
}

static void test_what_is_in_a_disc(void)
{
    file_write(string_of("%s/drawing.csv", folder.text).text, "link,angle\n1,.001\n");
    check_refused("--spread: alpha of link 1 (elbow) is in a disc; expected uniform, and no group",
                  (const char *const[]){POSED, "--drawing", "drawing.csv", "--spread", "angles=ends", NULL});
}

static void test_a_shift_that_leaves_nothing(void)
{
    check_refused("no tolerances: what is given uses 200 % of dx in pose 1: shift of link 0 (base) 200 %",
                  (const char *const[]){POSED, "--accuracy", "dx=.01", "--spread", "spread.csv", NULL});
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_list);
    RUN_TEST(test_a_list_is_told);
    RUN_TEST(test_a_table_is_told);
    RUN_TEST(test_a_table_is_written);
    RUN_TEST(test_json_has_distributions);
    RUN_TEST(test_ends_of_tolerances);
    RUN_TEST(test_ends_and_shifts);
    RUN_TEST(test_loads_and_shifts_are_told_apart);
    RUN_TEST(test_what_is_refused);
    RUN_TEST(test_shifts_that_are_too_large);
    RUN_TEST(test_groups_that_are_refused);
    RUN_TEST(test_what_is_in_a_disc);
    RUN_TEST(test_a_shift_that_leaves_nothing);
    return UNITY_END();
}
