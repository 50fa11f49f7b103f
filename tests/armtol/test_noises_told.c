/* armtol --accuracy with ap and rp, run as users run it: arms of slides, whose numbers are known in closed form. */

#include "armtol/runs.h"
#include "support/check.h"
#include "support/process.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Slides along z, y and x of the base. */
#define HEAD "units: mm deg\nname, joint, a, alpha, d, theta, resolution, backlash, noise\n"
#define AT "slides.csv", "--joints", "10,20,30"
#define RSS "--method", "rss"

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
    file_write(string_of("%s/slides.csv", folder.text).text,
               HEAD "pillar, d, 0, 90, 0, 90, 0, -, 0.01\n"
               "carriage, d, 0, 90, 0, 90, 0, -, 0\nram, d, 0, 90, 0, 90, 0, -, 0\n");
    file_write(string_of("%s/loose.csv", folder.text).text,
               HEAD "pillar, d, 0, 90, 0, 90, 0.02, -, 0\n"
               ", d, 0, 90, 0, 90, 0, 0.04, 0\nram, d, 0, 90, 0, 90, 0, -, 0\n");
    file_write(string_of("%s/boom.csv", folder.text).text,
               "units: mm deg\njoint, a, alpha, d, theta\n"
               "theta, 100, 0, 0, 0\nfixed, 50, 0, 0, 0\ntheta, 0, 0, 0, 0\n");
    return folder;
}

/* A normal error along one line has an RP of 2.60632 deviations: the bound. */
static const double bound = 2.60631538577;

static void test_rp_alone(void)
{
    const string folder = arm_folder();
    process process;
    run_well(&process, folder.text, (const char *const[]){AT, "--accuracy", "rp=.03", RSS, NULL});
    check_says(&process, "for a pose repeatability RP of 0.03 mm or less in the pose, steps and free plays\ncounted:");
    check_says(&process, "\n  link        noise     largest  unit\n  0 pillar     0.01  0.00664559    mm\n"
                         "  1 carriage      0  0.00664559    mm\n  2 ram           0  0.00664559    mm\n");
    check_within(1e-8, 0.03 / bound / sqrt(3), 0.00664559, "by hand");
    check_says(&process, "\nWith the noise that the drives have RP is at most 0.02606 mm.\n");
    TEST_ASSERT_NULL(strstr(process.output.bytes, "Parameters"));
    TEST_ASSERT_NULL(strstr(process.output.bytes, "largest tolerances"));
    run_well(&process, folder.text,
             (const char *const[]){AT, "--metres", "--accuracy", "rp=3e-5", RSS, "--json", NULL});
    check_within(1e-15, 3e-5, json_number(&process, "\"rp\": {", "wish"), "wish");
    check_within(1e-9, 1e-5 * bound, json_number(&process, "\"rp\": {", "bound"), "bound");
    check_within(1e-12, 1e-5, json_number(&process, "\"rp\": {", "noise"), "noise");
    check_within(1e-12, 3e-5 / bound / sqrt(3), json_number(&process, "\"rp\": {", "largest"), "largest");
}

/* What is allotted, given to the drives: the arms drawn come back within the wish. */
static void test_there_and_back(void)
{
    const string folder = arm_folder();
    process process;
    run_well(&process, folder.text, (const char *const[]){AT, "--accuracy", "rp=.03", RSS, "--json", NULL});
    const string drives = string_of("noise=%.17g", json_number(&process, "\"rp\": {", "largest"));
    run_well(&process, folder.text,
             (const char *const[]){AT, "--accuracy", "rp=.03", RSS, "--drives", drives.text, "--verify", "1",
                                   "--iso9283", "100000", "--json", NULL});
    check_within(1e-12, 0.03, json_number(&process, "\"rp\": {", "bound"), "bound");
    const double worst = json_number(&process, "\"rp\": {\n        \"quantiles\"", "worst");
    TEST_ASSERT_TRUE(worst > 0.79 * 0.03 && worst < 0.81 * 0.03); /* 0.801 of the bound, three being alike */
    run_well(&process, folder.text,
             (const char *const[]){AT, "--accuracy", "rp=.03", RSS, "--verify", "10", "--iso9283", "5", NULL});
    check_says(&process, "10 arms that come to the pose 5 times");
    TEST_ASSERT_NULL(strstr(process.output.bytes, "drawn within"));
}

static void test_any_noise_in_several_poses(void)
{
    const string folder = arm_folder();
    process process;
    file_write(string_of("%s/poses", folder.text).text, "0 1\n1 2\n");
    run_well(&process, folder.text,
             (const char *const[]){"boom.csv", "--radians", "--poses", "poses", "--accuracy", "rp=.3", RSS, NULL});
    check_says(&process, "RP of 0.3 mm or less in each pose,");
    check_says(&process, "\n  0         0  0.000767");
    check_says(&process, "\n  2         0          any   rad\n");
    check_within(1e-6, 0.3 / bound / 150, 0.000767, "by hand");
    TEST_ASSERT_NULL(strstr(process.output.bytes, "\n  1  "));
}

/* The ball of r and a remark. */
static void test_ap(void)
{
    const string folder = arm_folder();
    process process, other;
    run_well(&process, folder.text, (const char *const[]){AT, "--accuracy", "ap=.3", RSS, NULL});
    check_says(&process, "It was asked for as ap: one arrival keeps to it, and the mean\nof several is nearer.");
    run_well(&process, folder.text, (const char *const[]){AT, "--accuracy", "ap=.3,wx=1", RSS, "--csv", NULL});
    run_well(&other, folder.text, (const char *const[]){AT, "--accuracy", "r=.3,wx=1", RSS, "--csv", NULL});
    text_check(process.output.bytes, process.output.length, &other.output, "ap as r");
    run_well(&process, folder.text, (const char *const[]){AT, "--accuracy", "ap=.3,w=1", RSS, "--json", NULL});
    check_says(&process, "\"asked_as\": \"ap\"");
    TEST_ASSERT_NULL(strstr(strstr(process.output.bytes, "asked_as") + 1, "asked_as"));
}

static void test_both_and_beside_tolerances(void)
{
    const string folder = arm_folder();
    process process;
    run_well(&process, folder.text, (const char *const[]){AT, "--accuracy", "ap=.3,rp=.03", RSS, NULL});
    check_says(&process, "\nParameters\n");
    check_says(&process, "\n  2 ram           0  0.00664559    mm\n");
    run_well(&process, folder.text,
             (const char *const[]){AT, "--tolerances", "lengths=.1", "--accuracy", "rp=.03", RSS, NULL});
    check_says(&process, "\nThe tolerances of lengths=.1, and the accuracy that they give in this pose;");
    check_says(&process, "\n  2 ram           0  0.00664559    mm\n");
    TEST_ASSERT_NULL(strstr(process.output.bytes, "free  "));
}

/* ---- what is wrong ---- */

static void check_refused(const char *const arguments[], const char *words)
{
    const string folder = arm_folder();
    check_refused_run(folder.text, arguments, words);
}

/* Squares of half a step and half a play: 0.01^2 and 0.02^2, a fifth and four. */
static void test_nothing_is_left(void)
{
    const double percent = 100 * bound * sqrt(5e-4 / 3) / 0.03;
    check_refused((const char *const[]){"loose.csv", "--joints", "1,2,3", "--accuracy", "rp=.03", RSS, NULL},
                  string_of("no noise: steps and plays alone make an RP of %.4g %% of rp in pose 1; of its square: "
                            "link 0 (pillar) 20 %%, link 1 80 %%\n", percent).text);
    check_refused((const char *const[]){"loose.csv", "--joints", "1,2,3", "--accuracy", "rp=.03", RSS, "--payload",
                                        "0", "--payload", "1", NULL}, " in pose 1 with load 1; of its square: ");
}

static void test_many_joints_that_leave_nothing(void)
{
    const string folder = arm_folder();
    string table = string_of("%s", HEAD);
    process process;
    for (int i = 0; i < 10; i++) {
        table = string_of("%s, d, 0, 90, 0, 90, 0.02, -, 0\n", table.text);
    }
    file_write(string_of("%s/ten.csv", folder.text).text, table.text);
    run(&process, folder.text,
        (const char *const[]){"ten.csv", "--joints", "1,2,3,4,5,6,7,8,9,10", "--accuracy", "rp=.01", RSS, NULL});
    process_check_status(&process, 2, "ten slides");
    TEST_ASSERT_NOT_NULL(strstr(process.errors.bytes, "link 7 10 % and 2 more\n"));
}

static void test_what_goes_with_them(void)
{
    check_refused((const char *const[]){AT, "--accuracy", "rp=.03", NULL},
                  "--accuracy: ap and rp are about standard deviations; expected --method rss with them");
    check_refused((const char *const[]){AT, "--accuracy", "ap=.03", "--method", "sphere", NULL},
                  "--accuracy: ap and rp are about standard deviations; expected --method rss with them");
    check_refused((const char *const[]){AT, "--accuracy", "ap=.03,r=.03", RSS, NULL},
                  "--accuracy: ap and r are the same ball about where the tool should be; expected one of them");
    check_refused((const char *const[]){AT, "--accuracy", "r=.03,ap=.03", RSS, NULL}, "ap and r are the same ball");
    check_refused((const char *const[]){AT, "--accuracy", "ap=.03,ap=.03", RSS, NULL}, "ap is given twice");
    check_refused((const char *const[]){AT, "--accuracy", "rp=.03,rp=.03", RSS, NULL}, "rp is given twice");
    check_refused((const char *const[]){AT, "--accuracy", "rp=0", RSS, NULL}, "rp: \"0\" is not greater than zero");
    check_refused((const char *const[]){AT, "--metres", "--accuracy", "rp=1e307", RSS, NULL}, "rp is too large");
    check_refused((const char *const[]){AT, "--accuracy", "rp=1e-300", RSS, NULL}, "armtol: no tolerances: ");
    check_refused((const char *const[]){AT, "--accuracy", "ap=1,rp=.03", RSS, "--wish", "motors", NULL},
                  "--wish motors leaves the drives out, and rp in --accuracy is about them; expected one of the two");
    check_refused((const char *const[]){AT, "--accuracy", "ap=1,rp=.03", RSS, "--csv", NULL},
                  "--csv writes tolerances only; expected --json, or nothing, with rp in --accuracy");
    check_refused((const char *const[]){"slides.csv", "--region", "q1=0..1;q2=0;q3=0", "--accuracy", "ap=1,rp=1", RSS,
                                        NULL},
                  "--accuracy: rp is for poses that are listed; expected none with --region and maps");
    check_refused((const char *const[]){"map", "scara", "--plane", "xy", "--range", "100..200,100..200", "--accuracy",
                                        "rp=1", RSS, NULL}, "rp is for poses that are listed");
}

static void test_rp_alone_asks_nothing_of_parts(void)
{
    static const char *const options[][2] = {
        {"--budget", NULL}, {"--grades", NULL}, {"--write-drawing", "-"}, {"--verify", "10"}};
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        check_refused((const char *const[]){AT, "--accuracy", "rp=1", RSS, options[i][0], options[i][1], NULL},
                      "--accuracy: rp alone asks nothing of parts; expected ap or another name beside it");
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_rp_alone);
    RUN_TEST(test_there_and_back);
    RUN_TEST(test_any_noise_in_several_poses);
    RUN_TEST(test_ap);
    RUN_TEST(test_both_and_beside_tolerances);
    RUN_TEST(test_nothing_is_left);
    RUN_TEST(test_many_joints_that_leave_nothing);
    RUN_TEST(test_what_goes_with_them);
    RUN_TEST(test_rp_alone_asks_nothing_of_parts);
    return UNITY_END();
}
