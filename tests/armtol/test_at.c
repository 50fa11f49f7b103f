/* Positions instead of joints: what --tool-pose says of drawn joints is asked for, and what is asked for is reached. */

#include "armtol/asked.h"
#include "armtol/euler.h"
#include "armtol/runs.h"
#include "support/check.h"
#include "support/random.h"

#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { TEXT = 512 };

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

/* Numbers, separated by commas, with so many digits behind the point; all of them where that is less than 0. */
static void list(char text[TEXT], int decimals, const double values[], size_t count)
{
    text[0] = '\0';
    for (size_t i = 0; i < count; i++) {
        char number[40];
        if (decimals < 0) {
            snprintf(number, sizeof number, "%.17g", values[i]);
        } else {
            snprintf(number, sizeof number, "%.*f", decimals, values[i]);
        }
        strcat(text, i > 0 ? "," : "");
        strcat(text, number);
    }
}

static void draw_joints(random_source *random, const armtol_arm *arm, double q[])
{
    for (size_t i = 0; i < arm->n_links; i++) {
        if (arm->links[i].joint != ARMTOL_FIXED) {
            const bool slides = arm->links[i].joint == ARMTOL_PRISMATIC;
            const armtol_drive *drive = &arm->drives[i];
            const double low = isfinite(drive->low) ? drive->low : slides ? 100 : -3;
            *q++ = random_between(random, low, isfinite(drive->high) ? drive->high : slides ? 300 : 3);
        }
    }
}

/* Where the tool is of a question, x, y, z, gamma, beta, alpha. */
static void pose_of(const cli_options *options, double pose[6])
{
    asked asked;
    armtol_transform frame;
    asked_make(&asked, options);
    armtol_answer_frame(asked.answer, 0, &frame);
    armtol_transform_to_pose(&frame, &armtol_errata_none, pose);
    asked_free(&asked);
}

/* From joints to the pose, typed with so many digits, and back: the same joints, near which it is asked for. */
static void check_way_back(const armtol_arm *arm, random_source *random, int decimals, double slack)
{
    double q[8], pose[6];
    char joints[TEXT], at[TEXT];
    const size_t n_joints = armtol_arm_joint_count(arm);
    asked asked;
    draw_joints(random, arm, q);
    list(joints, -1, q, n_joints);
    cli_options options = question(arm->name, joints, "1,1,1,1,1,1");
    options.tool_offset = "10,20,30";
    pose_of(&options, pose);
    list(at, decimals, pose, 6);
    options.joints = NULL;
    options.near = joints;
    options.at[0] = at;
    options.n_at = 1;
    asked_make(&asked, &options);
    TEST_ASSERT_TRUE(asked.request.taken[0].n_branches > 0);
    for (size_t j = 0; j < n_joints; j++) {
        check_within(slack, q[j], asked.request.q[j], "%s at %s, joint %zu", arm->name, at, j + 1);
    }
    asked_free(&asked);
}

/* With six decimals an arm of four joints cannot be there to the last digit; and singular ones go far. */
static void test_what_tool_pose_prints_can_be_asked_for(void)
{
    random_source random = {3};
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        for (int k = 0; k < 3; k++) {
            check_way_back(armtol_arm_at(i), &random, -1, 1e-6);
            check_way_back(armtol_arm_at(i), &random, 6, 1e-2);
        }
    }
}

/* What the program prints, word for word. */
static void test_from_the_page_back_to_the_joints(void)
{
    process process;
    run_well(&process, NULL, (const char *const[]){"puma560", "--joints", "0,45,-90,0,45,0", "--degrees", "--accuracy",
                                                   "1,1,1,1,1,1", "--tool-pose", NULL});
    /* last lines of the frame: "... x", "... y", "... z", "zyx alpha beta gamma" */
    double rows[3][4], zyx[3];
    const char *at = strstr(process.output.bytes, "tool point");
    TEST_ASSERT_NOT_NULL(at);
    at = strchr(at, '\n') + 1;
    for (int i = 0; i < 3; i++, at = strchr(at, '\n') + 1) {
        TEST_ASSERT_EQUAL_INT(4, sscanf(at, "%lf %lf %lf %lf", &rows[i][0], &rows[i][1], &rows[i][2], &rows[i][3]));
    }
    TEST_ASSERT_EQUAL_INT(3, sscanf(at, " zyx %lf %lf %lf", &zyx[0], &zyx[1], &zyx[2]));
    const double pose[6] = {rows[0][3], rows[1][3], rows[2][3], zyx[2], zyx[1], zyx[0]};
    char text[TEXT];
    list(text, 6, pose, 6);
    run_well(&process, NULL, (const char *const[]){"puma560", "--at", text, "--degrees", "--accuracy", "1,1,1,1,1,1",
                                                   "--near", "0,45,-90,0,45,0", "--csv", NULL});
    double q[6];
    TEST_ASSERT_EQUAL_INT(6, sscanf(process.output.bytes, "# pose 1: branch 1 of %*d, joints %lf %lf %lf %lf %lf %lf",
                                    &q[0], &q[1], &q[2], &q[3], &q[4], &q[5]));
    static const double meant[6] = {0, 45, -90, 0, 45, 0};
    for (int j = 0; j < 6; j++) {
        check_within(1e-4, meant[j], q[j], "joint %d", j + 1);
    }
}

/* One position a line and several options: the poses of one question, those of the command line first. */
static void test_positions_of_options_and_of_a_file(void)
{
    const string folder = folder_new();
    process process;
    file_write(string_of("%s/at.csv", folder.text).text, "# x y z\n300 200 250\n350 100 200 180 0 40\n");
    run_well(&process, folder.text,
             (const char *const[]){"scara", "--degrees", "--at", "400,0,287", "--at-file", "at.csv", "--accuracy",
                                   ".1,.1,.1,-,-,.1", NULL});
    check_says(&process, "pose 1: joints");
    check_says(&process, "tool point 400 ");
    check_says(&process, "tool point 300 200 250, branch 1 of 2");
    check_says(&process, "pose 3: joints");
    check_says(&process, "in these 3 poses");
}

/* The table that --csv writes is read again, remarks and all. */
static void test_a_table_with_its_joints_is_read_again(void)
{
    const string folder = folder_new();
    process process;
    run_well(&process, folder.text, (const char *const[]){"scara", "--at", "400,0,287", "--accuracy",
                                                          ".1,.1,.1,-,-,.1", "--csv", NULL});
    file_write(string_of("%s/made.csv", folder.text).text, process.output.bytes);
    run_well(&process, folder.text,
             (const char *const[]){"scara", "--at", "400,0,287", "--tolerances", "made.csv", "--json", NULL});
    check_says(&process, "\"branches\": 2");
    check_says(&process, "\"inverse\": \"search\"");
}

/* The published position of adpta, by its own inverse kinematics: golden/published.tsv has theta[2] 2.429293. */
static void test_an_arm_of_1987_says_that_it_goes_its_own_way(void)
{
    process process;
    run_well(&process, NULL, (const char *const[]){"adeptone", "--at", "200,200,0,0,0,0", "--accuracy",
                                                   "1,1,1,1,1,1", NULL});
    check_says(&process, "2.4293 ");
    check_says(&process, "own inverse");
    run_well(&process, NULL, (const char *const[]){"adeptone", "--at", "200,200,0,0,0,0", "--branches", NULL});
    check_says(&process, "position 1: 200 200 0 0 0 0 (2 branches)");
    check_says(&process, "arm's own");
    run_well(&process, NULL, (const char *const[]){"adeptone", "--at", "200,200,0,0,0,0", "--branches", "--csv", NULL});
    check_says(&process, "position,branch,joint1,joint2,joint3,joint4,from_near,inverse\n1,1,");
    check_says(&process, ",own\n1,2,");
}

/* Six decimals of an angle that the arm cannot have: near enough, and told. */
static void test_what_is_left_is_told(void)
{
    process process;
    run_well(&process, NULL, (const char *const[]){"adeptone", "--at", "200,200,0,0.000001,0,0", "--accuracy",
                                                   "1,1,1,1,1,1", NULL});
    check_says(&process, "off the position by");
    check_says(&process, "1e-06 rad");
}

static void test_out_of_reach(void)
{
    process process;
    run(&process, NULL, (const char *const[]){"adeptone", "--at", "200,200,0,17.5,0,0", "--degrees", "--accuracy",
                                              "1,1,1,1,1,1", NULL});
    process_check_status(&process, 2, "a tilt");
    text_check("", 0, &process.output, "nothing is printed");
    TEST_ASSERT_NOT_NULL(strstr(process.errors.bytes, "and 17.5 deg off; an arm of 4 joints cannot take any direction: "
                                                      "x,y,z alone leave it free"));
    run(&process, NULL, (const char *const[]){"puma560", "--at", "400,100,200", "--at", "2000,0,0", "--at", "1e300,0,0",
                                              "--branches", "--json", "--ignore-limits", NULL});
    process_check_status(&process, 2, "a position of three");
    check_says(&process, "\"branches\": [],\n      \"nearest\": {");
    check_says(&process, "\"at\": [1e+300, 0, 0],\n      \"branches\": []\n");
    TEST_ASSERT_NOT_NULL(strstr(process.errors.bytes, "armtol: pose 2: the position is out of reach of puma560: the "));
    TEST_ASSERT_NOT_NULL(strstr(process.errors.bytes, "armtol: pose 3: the position is too far off to be measured\n"));
}

static void test_too_many_positions_on_the_command_line(void)
{
    const char *arguments[2 * (MOST_AT + 1) + 2] = {"puma560"};
    process process;
    for (size_t i = 0; i <= MOST_AT; i++) {
        arguments[1 + 2 * i] = "--at";
        arguments[2 + 2 * i] = "1,2,3";
    }
    run(&process, NULL, arguments);
    process_check_status(&process, 2, "too many");
    TEST_ASSERT_EQUAL_STRING("armtol: --at: more than 64 positions; expected a file of them, --at-file\n",
                             process.errors.bytes);
}

/* A pipe may have no end. */
static void test_a_million_positions_are_enough(void)
{
    enum { POSITIONS = 1000001, BLOCK = 1000, LINE = 6 };
    static char block[LINE * BLOCK];
    const process_setup setup = {
        .program = TEST_ARMTOL,
        .arguments = (const char *const[]){"puma560", "--at-file", "/dev/stdin", "--branches", NULL}};
    process process;
    for (size_t i = 0; i < sizeof block; i += LINE) {
        memcpy(block + i, "1,2,3\n", LINE);
    }
    process_start(&process, &setup);
    for (int i = 0; i < POSITIONS; i += BLOCK) {
        process_send(&process, block, sizeof block);
    }
    process_finish(&process);
    process_check_status(&process, 2, "a million positions");
    TEST_ASSERT_EQUAL_STRING("armtol: /dev/stdin:1000001:1: more than 1000000 positions\n", process.errors.bytes);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_what_tool_pose_prints_can_be_asked_for);
    RUN_TEST(test_from_the_page_back_to_the_joints);
    RUN_TEST(test_positions_of_options_and_of_a_file);
    RUN_TEST(test_a_table_with_its_joints_is_read_again);
    RUN_TEST(test_an_arm_of_1987_says_that_it_goes_its_own_way);
    RUN_TEST(test_what_is_left_is_told);
    RUN_TEST(test_out_of_reach);
    RUN_TEST(test_a_million_positions_are_enough);
    RUN_TEST(test_too_many_positions_on_the_command_line);
    return UNITY_END();
}
