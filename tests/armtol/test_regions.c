/* Regions on the command line and in files: what they mean, what is wrong with them, how runs of them end. */

#include "armtol/runs.h"
#include "support/check.h"

#include "unity.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static process first, second;

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

/* ---- what words mean ---- */

#define WISH "--accuracy", "xy=.02"

static double bound_of(const process *process)
{
    const char *at = strstr(process->output.bytes, "\"bound\": ");
    TEST_ASSERT_NOT_NULL(at);
    return strtod(at + strlen("\"bound\": "), NULL);
}

/* Tolerances of the motor of the first joint alone: xy is that times the tool's distance from its axis. */
static void check_bound(double expected, const char *region)
{
    run_well(&first, NULL, (const char *const[]){"scara", "--degrees", "--region", region, "--tolerances",
                                                 "0.theta=0.1",
                                                 "--accuracy", "xy=5", "--json", NULL});
    const double bound = bound_of(&first);
    TEST_ASSERT_TRUE_MESSAGE(bound >= expected * (1 - 1e-9) && bound <= expected * 1.01 * (1 + 1e-9), region);
}

static void test_what_words_mean(void)
{
    const double turn = 0.1 * 0.017453292519943295;
    check_bound(600 * turn, "q1=-90..90");
    check_bound(600 * turn, " q2 = 0 ; q3=0..10;");
    check_bound(425.7346 * turn, "q2=90..100"); /* sqrt(325^2 + 275^2) */
    check_bound(400 * turn, "cylinder=200..400");
    check_bound(400 * turn, "cylinder=-..400,200..300");
    check_bound(500 * turn, "cylinder=0..100,-,400,0");
    check_bound(412.3106 * turn, "box=0..400,-100..100,-");
    check_bound(405 * turn, "path=5:300,0,250:400,0,250");
    check_bound(600 * turn, "direction=0,0,-1;cone=1");
    check_bound(400 * turn, "direction=0,0,-1;cone=1;cylinder=200..400");
    check_bound(600 * turn, "elbow=2+");
}

/* The slide of a SCARA gives way along z by its compliance times the weight, the heavier one of two. */
static void test_loads_bend_the_drives(void)
{
    run_well(&first, NULL, (const char *const[]){"scara", "--region", "cylinder=200..400", "--drives",
                                                 "2.compliance=0.01,2.backlash=0.02", "--payload", "2", "--payload",
                                                 "5", "--tolerances", "lengths=0", "--accuracy", "dz=5", "--json",
                                                 NULL});
    const double bound = bound_of(&first), expected = 0.01 * 5 * 9.80665 + 0.02;
    TEST_ASSERT_TRUE(bound >= expected * (1 - 1e-9) && bound <= expected * (1 + 1e-9));
}

/* A file says what words do. */
static void test_files(void)
{
    FILE *file = fopen("ring.region", "w");
    TEST_ASSERT_NOT_NULL(file);
    fputs("# a ring\r\ncylinder = 200..400 # and no more\n\nq1=-90..90;q4=0\n", file);
    fclose(file);
    run_well(&first, NULL, (const char *const[]){"scara", "--degrees", "--region", "ring.region", WISH, "--csv", NULL});
    run_well(&second, NULL, (const char *const[]){"scara", "--degrees", "--region",
                                                  "cylinder=200..400;q1=-90..90;q4=0", WISH,
                                                  "--csv", NULL});
    TEST_ASSERT_EQUAL_STRING(first.output.bytes, second.output.bytes);
    remove("ring.region");
}

/* Which elbow: joint 3 of a Puma is not stretched at 0, but where its forearm, 20.3 off, is in line: by atan(20.3 /
   431.8). */
static void test_the_elbow_of_a_puma(void)
{
    const char *const below = "q1=0;q2=0;q4=0;q5=0;q6=0;q3=-90..-87.4;elbow=3-", *const none = "q3=-87..-80;elbow=3-";
    run(&first, NULL, (const char *const[]){"puma560", "--degrees", "--region", below, "--tolerances", "1.theta=.1",
                                            NULL});
    TEST_ASSERT_EQUAL_INT(0, first.status);
    run(&second, NULL, (const char *const[]){"puma560", "--degrees", "--region", none, "--tolerances", "1.theta=.1",
                                             NULL});
    TEST_ASSERT_EQUAL_STRING("armtol: --region: elbow: no value of joint 3 is on that side\n", second.errors.bytes);
}

/* ---- what is wrong ---- */

typedef struct wrong_region {
    const char *region, *message;
} wrong_region;

static const wrong_region wrong_regions[] = {
    {"q5=1", "\"q5\" is no joint of scara; expected q1 to q4"},
    {"q=1", "unknown name \"q\""},
    {"p2=1", "unknown name \"p2\"; expected q1 to q4, box, cylinder, path, direction, cone or elbow"},
    {"=1", "unknown name \"\""},
    {"q2=1;3", "\"3\" has no value; expected NAME=VALUE"},
    {"q2=1;q2=2", "q2 is given twice"},
    {"q2=30..-30", "q2: \"30..-30\" runs down; expected the smaller number first"},
    {"q2=x..3", "q2: \"x\" is not a number"},
    {"q2=1..1e400", "q2: \"1e400\" is too large"},
    {"q2=-..3", "q2: \"-\" is not a number"},
    {"q2=-151..0", "the joint of link 1 gets to -151, beyond its limits; expected -150 to 150 deg"},
    {"box=1..x,3..4,-", "box: \"x\" is not a number"},
    {"box=1..2,3..4", "box: expected three ranges"},
    {"box=1..2,3..4,-,-", "box: expected three ranges"},
    {"box=1..2,3..4,4..3", "box: \"4..3\" runs down"},
    {"box=-,-,-;box=-,-,-", "box is given twice"},
    {"cylinder=-5..6", "cylinder: a radius is not negative"},
    {"cylinder=-..-6", "the cylinder is none"},
    {"cylinder=5..6,1..2,3", "cylinder: too few numbers"},
    {"cylinder=5..6,1..2,3,4,5", "cylinder: too many numbers"},
    {"cylinder=a..6", "cylinder: \"a\" is not a number"},
    {"cylinder=5..6;cylinder=5..6", "cylinder is given twice"},
    {"path=5", "path: expected a radius >= 0 and points"},
    {"path=x:1,2,3", "path: \"x\" is not a number"},
    {"path=-5:1,2,3", "path: expected a radius >= 0 and points"},
    {"path=5:1,2", "path: too few numbers"},
    {"path=5:1,2,3;path=5:1,2,3", "path is given twice"},
    {"direction=0,0,1", "direction and cone go together"},
    {"cone=1", "direction and cone go together"},
    {"direction=0,0,0;cone=1", "direction: 0,0,0 is none"},
    {"direction=0,x,1;cone=1", "direction: \"x\" is not a number"},
    {"direction=0,0;cone=1", "direction: too few numbers"},
    {"direction=0,0,1;cone=-1", "cone: an angle is not negative"},
    {"direction=0,0,1;cone=w", "cone: \"w\" is not a number"},
    {"elbow=2", "elbow: \"2\" is none; expected a joint and a sign"},
    {"elbow=", "elbow: \"\" is none"},
    {"elbow=1+", "joint 1 is no elbow"},
    {"elbow=12345678901234567890+", "is none"},
    {"q2=10..20;elbow=2-", "elbow: no value of joint 2 is on that side"},
    {"direction=0,0,1;cone=80", "no pose of scara is in it"},
    {"cylinder=700..800", "no pose of scara is in it"},
    {"no-such.region", "no-such.region"},
};

static void test_regions_that_are_wrong(void)
{
    for (size_t i = 0; i < sizeof wrong_regions / sizeof wrong_regions[0]; i++) {
        const wrong_region *wrong = &wrong_regions[i];
        run(&first, NULL, (const char *const[]){"scara", "--degrees", "--region", wrong->region, WISH, NULL});
        process_check_status(&first, 2, wrong->region);
        TEST_ASSERT_TRUE_MESSAGE(strstr(first.errors.bytes, wrong->message) != NULL, wrong->message);
        TEST_ASSERT_TRUE_MESSAGE(strchr(first.errors.bytes, '\n') == first.errors.bytes + first.errors.length - 1,
                                 wrong->message);
        TEST_ASSERT_EQUAL_STRING("", first.output.bytes);
    }
}

typedef struct wrong_call {
    const char *arguments[14];
    const char *message;
} wrong_call;

static const wrong_call wrong_calls[] = {
    {{"scara", "--region", "q2=0", "--joints", "0,0,0,0", WISH}, "--region has poses of its own"},
    {{"scara", "--region", "q2=0", "--at", "1,2,3", WISH}, "--region has poses of its own"},
    {{"scara", "--region", "q2=0", "--against", "scara"},
     "--against and --deviations are for poses; expected no --region"},
    {{"scara", "--region", "q2=0", WISH, "--verify", "9", "--shard", "1/2", "--tally", "t"},
     "--shard draws arms in poses that are listed; expected no --region"},
    {{"scara", "--joints", "0,0,0,0", WISH, "--gap", "1"}, "--gap and --most are for --region R"},
    {{"scara", "--region", "q2=0", WISH, "--gap", "0"},
     "--gap: \"0\" is out of range; expected 0.0001 to 1000 (percent)"},
    {{"scara", "--region", "q2=0", WISH, "--gap", "x"}, "--gap: \"x\" is not a number"},
    {{"scara", "--region", "q2=0", WISH, "--most", "0"}, "--most"},
    {{"scara", "--region", "q2=0", "--accuracy", "1,1,1,1,1,1", "--method", "sphere"}, "--method sphere is for poses"},
    {{"scara", "--region", "q2=0", WISH, "--given", "motors=1"}, "no tolerances: in some pose of the region"},
    {{"scara", "--metres", "--region", "box=0..1e306,-,-", WISH}, "--region: box: \"1e306\" is too large"},
    {{"adeptone", "--region", "q2=0", WISH}, "slides and has no limits; expected its range"},
};

static void test_calls_that_are_wrong(void)
{
    for (size_t i = 0; i < sizeof wrong_calls / sizeof wrong_calls[0]; i++) {
        run(&first, NULL, wrong_calls[i].arguments);
        process_check_status(&first, 2, wrong_calls[i].message);
        TEST_ASSERT_TRUE_MESSAGE(strstr(first.errors.bytes, wrong_calls[i].message) != NULL, wrong_calls[i].message);
    }
}

/* One turn is the range of a joint that has an end at most: here that is none. */
static void test_a_joint_without_a_range(void)
{
    const string folder = folder_new();
    file_write(string_of("%s/arm.csv", folder.text).text,
               "units: mm deg\njoint,a,alpha,d,theta,low\ntheta,100,0,0,0,200\n");
    run(&first, folder.text, (const char *const[]){"arm.csv", "--ignore-limits", "--region", "box=-,-,-", WISH, NULL});
    process_check_status(&first, 2, "no range");
    TEST_ASSERT_EQUAL_STRING("armtol: --region: joint 1 has no range\n", first.errors.bytes);
}

/* wx has no bound where alpha, of a link that turns about its own x, has none. */
static void test_tolerances_without_a_bound(void)
{
    const string folder = folder_new();
    file_write(string_of("%s/t.csv", folder.text).text, "link,parameter,tolerance\n0,theta,.001\n0,alpha,inf\n");
    run(&first, folder.text, (const char *const[]){"scara", "--region", "q2=0", "--tolerances", "t.csv", WISH, NULL});
    process_check_status(&first, 2, "no bound");
    TEST_ASSERT_EQUAL_STRING("armtol: --region: the tolerances leave a component without a bound of what is asked "
                             "there\n", first.errors.bytes);
}

/* ---- ends ---- */

static void test_a_pose_that_is_not_found(void)
{
    static const char edge[] = "q1=-1..1;q2=-1..1;q3=0..200;box=0..599.9,0..0.05,-;cylinder=599.99..700";
    run(&first, NULL, (const char *const[]){"scara", "--region", edge, WISH, "--most", "2", NULL});
    process_check_status(&first, 1, "two boxes");
    TEST_ASSERT_EQUAL_STRING("armtol: --region: no pose of scara was found in it; --most has the boxes to look for "
                             "one\n", first.errors.bytes);
}

static void test_an_interrupted_run_tells_what_it_has(void)
{
    const process_setup setup = {
        .program = TEST_ARMTOL,
        .arguments = (const char *const[]){"puma560", "--ignore-limits", "--region", "q1=-1..1", "--accuracy", "r=.5",
                                           "--gap", ".0001", "--most", "1000000000", NULL},
        .wires = {WIRE_PIPE, WIRE_PIPE, WIRE_TERMINAL}};
    process_start(&first, &setup);
    process_expect(&first, " boxes");
    kill(first.id, SIGINT);
    process_finish(&first);
    process_check_status(&first, 1, "interrupted");
    TEST_ASSERT_NOT_NULL(strstr(first.errors.bytes,
                                "\rarmtol: interrupted before the gap was 0.0001 %; what is proved is told\n"));
    check_says(&first, "r: that the accuracy is kept everywhere in the region is NOT proved.");
}

static void test_boxes_that_are_not_enough(void)
{
    run(&first, NULL, (const char *const[]){"puma560", "--region", "q1=0..1", "--accuracy", "r=.5", "--most", "3",
                                            NULL});
    process_check_status(&first, 1, "three boxes");
    TEST_ASSERT_EQUAL_STRING("armtol: --most: 3 boxes were not enough for a gap of 1 %; what is proved is told\n",
                             first.errors.bytes);
    check_says(&first, "r: that the accuracy is kept everywhere in the region is NOT proved.");
}

static void test_tolerances_that_are_too_wide(void)
{
    run_well(&first, NULL, (const char *const[]){"scara", "--region", "q4=0", "--tolerances", "motors=.001", WISH,
                                                 "--gap", "5",
                                                 NULL});
    check_says(&first, "xy: the accuracy is NOT kept in the region.");
    check_says(&first, "and the accuracy that they give");
}

static void test_arms_are_drawn_in_poses_of_the_region(void)
{
    run_well(&first, NULL, (const char *const[]){"scara", "--region", "cylinder=300..400", WISH, "--verify", "1000",
                                                 NULL});
    check_says(&first, "1000 of 1000 arms are within the accuracy");
    check_says(&first, "everywhere in the region");
    check_says(&first, "not for the rest of the region.");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_what_words_mean);
    RUN_TEST(test_loads_bend_the_drives);
    RUN_TEST(test_files);
    RUN_TEST(test_the_elbow_of_a_puma);
    RUN_TEST(test_regions_that_are_wrong);
    RUN_TEST(test_calls_that_are_wrong);
    RUN_TEST(test_a_joint_without_a_range);
    RUN_TEST(test_tolerances_without_a_bound);
    RUN_TEST(test_a_pose_that_is_not_found);
    RUN_TEST(test_an_interrupted_run_tells_what_it_has);
    RUN_TEST(test_boxes_that_are_not_enough);
    RUN_TEST(test_tolerances_that_are_too_wide);
    RUN_TEST(test_arms_are_drawn_in_poses_of_the_region);
    return UNITY_END();
}
