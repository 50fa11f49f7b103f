/* armtol --iso9283, run as users run it: arms of slides, whose numbers are known in closed form. */

#include "armtol/runs.h"
#include "support/check.h"
#include "support/process.h"
#include "unity.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

/* Slides along z, y and x of the base, with a noise of 0.02 mm each. */
#define HEAD "units: mm deg\njoint a alpha d theta noise\n"
#define SLIDES HEAD "d 0 90 0 90 0.02\nd 0 90 0 90 0.02\nd 0 90 0 90 0.02\n"
#define ALIKE SLIDES_ARGUMENTS, "--joints", "10,20,30"
#define SLIDES_ARGUMENTS "slides.csv", "--tolerances", "lengths=0"

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

static string arm_folder(void)
{
    const string folder = folder_new();
    file_write(string_of("%s/slides.csv", folder.text).text, SLIDES);
    file_write(string_of("%s/stiff.csv", folder.text).text,
               "units: mm deg\njoint a alpha d theta\nd 0 90 0 90\nd 0 90 0 90\nd 0 90 0 90\n");
    file_write(string_of("%s/endless.csv", folder.text).text, "link,parameter,tolerance\n0,alpha,inf\n");
    return folder;
}

/* sigma (sqrt(8 / pi) + 3 sqrt(3 - 8 / pi)), and of n cycles some 1.7 sigma / sqrt n beside it; in metres too. */
static void test_isotropic_noise(void)
{
    const string folder = arm_folder();
    const double pi = 3.14159265358979323846, rp = 0.02 * (sqrt(8 / pi) + 3 * sqrt(3 - 8 / pi));
    process process;
    run_well(&process, folder.text,
             (const char *const[]){ALIKE, "--verify", "1", "--iso9283", "100000", "--json", NULL});
    check_within(4 * 1.7 * 0.02 / sqrt(100000), rp, json_number(&process, "\"rp\"", "worst"), "RP");
    const double found = json_number(&process, "\"rp\"", "worst");
    check_within(0, 100000, json_number(&process, "\"iso9283\"", "cycles"), "cycles");
    run_well(&process, folder.text,
             (const char *const[]){SLIDES_ARGUMENTS, "--metres", "--joints", ".01,.02,.03", "--verify", "1",
                                   "--iso9283=100000", "--json", NULL});
    check_within(1e-15, found / 1000, json_number(&process, "\"rp\"", "worst"), "RP in metres");
}

/* Of --drives noise does the same as the column; in the worst case three deviations of it count. */
static void test_noise_on_the_command_line(void)
{
    const string folder = arm_folder();
    process of_table, of_drives;
    run_well(&of_table, folder.text, (const char *const[]){ALIKE, "--verify", "50", "--iso9283", "--json", NULL});
    run_well(&of_drives, folder.text,
             (const char *const[]){"stiff.csv", "--tolerances", "lengths=0", "--joints", "10,20,30", "--drives",
                                   "noise=0.02", "--verify", "50", "--iso9283", "--json", NULL});
    const char *same = strstr(of_table.output.bytes, "\"iso9283\"");
    TEST_ASSERT_NOT_NULL(same);
    TEST_ASSERT_EQUAL_STRING(same, strstr(of_drives.output.bytes, "\"iso9283\""));
    check_within(1e-15, 0.06, json_number(&of_drives, "\"components\"", "worst_case"), "dx at worst");
    check_within(0, 30, json_number(&of_drives, "\"iso9283\"", "cycles"), "cycles that are not given");
}

static void test_the_table(void)
{
    const string folder = arm_folder();
    process process;
    run_well(&process, folder.text,
             (const char *const[]){"stiff.csv", "--tolerances", "lengths=.01", "--joints", "10,20,30", "--verify",
                                   "100", "--iso9283", NULL});
    check_says(&process, "\n100 arms that come to the pose 30 times: pose accuracy AP and pose repeatability\n"
                         "RP of the position (ISO 9283), in mm, not exceeded by\n");
    check_says(&process, "\n  1      RP         0       0        0        0        0\n");
}

/* Poses, loads, and of all of them the largest. */
static void test_several_poses_and_loads(void)
{
    const string folder = arm_folder();
    process process;
    string poses = string_of("1 1 1\n");
    for (int i = 0; i < 29; i++) {
        poses = string_of("%s%d %d 3\n", poses.text, i, 2 * i);
    }
    file_write(string_of("%s/poses", folder.text).text, poses.text);
    run_well(&process, folder.text,
             (const char *const[]){SLIDES_ARGUMENTS, "--poses", "poses", "--verify", "100", "--iso9283", "5", NULL});
    check_says(&process, "100 arms that come to each pose 5 times");
    check_says(&process, "\n  largest of all   AP  ");
    check_says(&process, "\n  and 18 more poses (--json has all)\n");
    run_well(&process, folder.text,
             (const char *const[]){ALIKE, "--payload", "1", "--payload", "2", "--drives", "backlash=.5", "--verify",
                                   "100", "--iso9283", NULL});
    check_says(&process, "\n  1, load 2        RP  ");
    run_well(&process, folder.text,
             (const char *const[]){ALIKE, "--payload", "1", "--payload", "2", "--verify", "100", "--iso9283", "--json",
                                   NULL});
    const double first = json_number(&process, "\"rp\"", "worst");
    const char *second = strstr(process.output.bytes, "\"load\": 2,\n        \"ap\"");
    TEST_ASSERT_NOT_NULL(second);
    const double other = json_number(&process, "\"load\": 2,\n        \"ap\"", "worst");
    TEST_ASSERT_TRUE(first > 0 && other > 0);
    const double all = json_number(&process, "\"all\"", "worst");
    TEST_ASSERT_TRUE(all >= other);
}

static void test_what_is_not_known(void)
{
    const string folder = arm_folder();
    process process;
    run_well(&process, folder.text,
             (const char *const[]){"slides.csv", "--tolerances", "endless.csv", "--joints", "10,20,30", "--verify",
                                   "10", "--iso9283", NULL});
    check_says(&process, "\nAP is not known: the position depends on parameters without a bound.\n");
    check_says(&process, "\n  1      AP        -        -        -        -        -\n");
    run_well(&process, folder.text,
             (const char *const[]){"slides.csv", "--tolerances", "endless.csv", "--joints", "10,20,30", "--verify",
                                   "10", "--iso9283", "--json", NULL});
    check_says(&process, "\"ap\": {\n          \"quantiles\": [null, null, null, null],\n          \"worst\": null\n");
}

/* ---- what is wrong ---- */

static void check_refused(const char *const arguments[], const char *words)
{
    const string folder = arm_folder();
    check_refused_run(folder.text, arguments, words);
}

static void test_what_goes_with_it(void)
{
    check_refused((const char *const[]){ALIKE, "--iso9283", NULL},
                  "--iso9283 is for arms that are drawn; expected --verify N with it");
    check_refused((const char *const[]){ALIKE, "--iso9283", "--verify", "10000001", NULL},
                  "--iso9283 keeps the numbers of every arm; expected --verify N of 10000000 at the most");
    check_refused((const char *const[]){ALIKE, "--iso9283", "--verify", "10", "--wish", "motors", NULL},
                  "--wish motors leaves the drives out, and --iso9283 is about them; expected one of the two");
    check_refused((const char *const[]){ALIKE, "--iso9283", "--verify", "10", "--shard", "1/2", "--tally", "t", NULL},
                  "--iso9283 keeps the numbers of every arm, a tally does not; expected no --shard");
    check_refused((const char *const[]){SLIDES_ARGUMENTS, "--iso9283", "--verify", "10", "--region", "q1=0..1", NULL},
                  "--iso9283 is for poses that are listed; expected no --region");
    check_refused((const char *const[]){"slides.csv", "--joints", "1,2,3", "--against", "slides.csv", "--iso9283",
                                        NULL},
                  "--drawing, --weights, --spread, --budget, --verify or --iso9283 beside");
    check_refused((const char *const[]){"map", "slides.csv", "--plane", "xy", "--range", "0..1,0..1", "--iso9283",
                                        NULL},
                  "--verify, --seed, --threads, --iso9283, --budget, --tool-pose and --wish are not for a map");
}

static void test_cycles_that_are_none(void)
{
    check_refused((const char *const[]){ALIKE, "--verify", "10", "--iso9283", "1", NULL}, "--iso9283: \"1\"");
    check_refused((const char *const[]){ALIKE, "--verify", "10", "--iso9283=1000001", NULL}, "--iso9283: \"1000001\"");
    check_refused((const char *const[]){ALIKE, "--verify", "10", "--iso9283=", NULL}, "--iso9283: \"\"");
    check_refused((const char *const[]){ALIKE, "--verify", "10", "--iso9283", "30", "31", NULL},
                  "unexpected argument \"31\"");
    check_refused((const char *const[]){ALIKE, "--verify", "10", "--iso9283", "3o", NULL},
                  "unexpected argument \"3o\"");
    check_refused((const char *const[]){ALIKE, "--iso9283=30", "--verify", "10", "20", NULL},
                  "unexpected argument \"20\"");
    check_refused((const char *const[]){ALIKE, "--iso9283", "--iso9283", NULL}, "--iso9283: is given twice");
    check_refused((const char *const[]){ALIKE, "--verify", "10", "--drives", "noise=-1", NULL},
                  "--drives: \"-1\" is negative");
}

/* All that is left is not begun: who interrupts wants the end. */
static void test_an_interrupt_ends_all(void)
{
    const process_setup setup = {
        .program = TEST_ARMTOL,
        .arguments = (const char *const[]){"puma560", "--joints", "0,0,0,0,0.5,0", "--tolerances", "lengths=.01",
                                           "--spread", "a=normal:3", "--verify", "10000000", "--iso9283", "--threads",
                                           "1", NULL},
        .wires = {WIRE_PIPE, WIRE_PIPE, WIRE_TERMINAL}};
    process process;
    process_start(&process, &setup);
    process_expect(&process, " left");
    kill(process.id, SIGINT);
    process_finish(&process);
    process_check_status(&process, 0, "interrupted");
    check_says(&process, " arms drawn within the tolerances");
    TEST_ASSERT_NULL(strstr(process.output.bytes, "ISO 9283"));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(process.errors.bytes, "armtol: interrupted: no arm comes to its poses again"),
                                 process.errors.bytes);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_isotropic_noise);
    RUN_TEST(test_noise_on_the_command_line);
    RUN_TEST(test_the_table);
    RUN_TEST(test_several_poses_and_loads);
    RUN_TEST(test_what_is_not_known);
    RUN_TEST(test_what_goes_with_it);
    RUN_TEST(test_cycles_that_are_none);
    RUN_TEST(test_an_interrupt_ends_all);
    return UNITY_END();
}
