/*
 * Whole runs of armtol on xacro files, with a program xacro of the test's own on the PATH: it writes its words and a
 * URDF. And what armtol has to do with files beside: --links, --craig, limits, inches.
 */

#include "support/process.h"

#include "unity.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static const char urdf[] = "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='revolute'><parent "
                           "link='a'/><child link='b'/>"
                           "<origin xyz='0.1 0 0'/><axis xyz='0 0 1'/><limit lower='0' upper='0'/></joint></robot>";

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

/* A shell script. */
static void make_xacro(const char *folder, const char *commands)
{
    const string file = string_of("%s/xacro", folder);
    file_write(file.text, string_of("#!/bin/sh\n%s\n", commands).text);
    TEST_ASSERT_EQUAL_INT(0, chmod(file.text, 0755));
}

static void run(process *process, const char *folder, const char *path, const char *const arguments[])
{
    const string variable = string_of("PATH=%s", path);
    const process_setup setup = {.program = TEST_ARMTOL,
                                 .arguments = arguments,
                                 .folder = folder,
                                 .environment = (const char *const[]){variable.text, NULL}};
    process_run(process, &setup, "");
}

static void check_run(const char *folder, const char *path, const char *const arguments[], int status,
                      const char *output, const char *errors)
{
    process process;
    run(&process, folder, path, arguments);
    process_check_status(&process, status, arguments[0]);
    text_check(output, strlen(output), &process.output, "output");
    text_check(errors, strlen(errors), &process.errors, "errors");
}

#define LINKS "a\n  b  (j: revolute, 0 to 0 rad)\n"

static void test_xacro_is_run_with_its_arguments(void)
{
    const string folder = folder_new(), path = string_of("%s:/bin:/usr/bin", folder.text);
    make_xacro(folder.text, "for word; do echo \"[$word]\"; done >words; cat robot.urdf");
    file_write(string_of("%s/robot.urdf", folder.text).text, urdf);
    file_write(string_of("%s/r.xacro", folder.text).text, "<robot/>");
    check_run(folder.text, path.text, (const char *const[]){"r.xacro", "--links", NULL}, 0, LINKS, "");
    file_check(string_of("%s/words", folder.text).text, "[r.xacro]\n", "no arguments");
    check_run(
        folder.text, path.text,
        (const char *const[]){"--links", "robot.urdf", "--xacro", "name:=x y", "side:=$HOME;left", "--degrees", NULL},
        0, "a\n  b  (j: revolute, 0 to 0 deg)\n", "");
    file_check(string_of("%s/words", folder.text).text, "[robot.urdf]\n[name:=x y]\n[side:=$HOME;left]\n", "no shell");
}

static void test_xacro_that_is_not_there_or_fails(void)
{
    const string folder = folder_new(), empty = folder_new();
    file_write(string_of("%s/r.xacro", folder.text).text, "<robot/>");
    check_run(folder.text, empty.text, (const char *const[]){"r.xacro", "--show", NULL}, 2, "",
              "armtol: r.xacro is to be expanded by the program xacro, which is not on the PATH; pip install xacro "
              "gets it\n");
    make_xacro(folder.text, "echo no such macro >&2; exit 3");
    check_run(folder.text, folder.text, (const char *const[]){"r.xacro", "--show", NULL}, 2, "",
              "no such macro\narmtol: r.xacro: xacro could not expand it\n");
    make_xacro(folder.text, "exit 127");
    check_run(folder.text, folder.text, (const char *const[]){"r.xacro", "--show", NULL}, 2, "",
              "armtol: r.xacro is to be expanded by the program xacro, which is not on the PATH; pip install xacro "
              "gets it\n");
    make_xacro(folder.text, "kill -9 $$");
    check_run(folder.text, folder.text, (const char *const[]){"r.xacro", "--show", NULL}, 2, "",
              "armtol: r.xacro: xacro could not expand it\n");
    TEST_ASSERT_EQUAL_INT(0, chmod(string_of("%s/xacro", folder.text).text, 0644));
    check_run(folder.text, folder.text, (const char *const[]){"r.xacro", "--show", NULL}, 1, "",
              "armtol: r.xacro: xacro cannot be run: Permission denied\n");
    check_run(folder.text, folder.text, (const char *const[]){"none.xacro", "--show", NULL}, 2, "",
              "armtol: none.xacro: No such file or directory\n");
}

static void test_too_many_arguments_for_xacro(void)
{
    enum { MOST = 101 };
    const char *arguments[MOST + 4] = {"r.xacro", "--show", "--xacro"};
    for (int i = 0; i < MOST; i++) {
        arguments[3 + i] = "a:=b";
    }
    const string folder = folder_new();
    check_run(folder.text, folder.text, arguments, 2, "", "armtol: --xacro: more than 100 arguments\n");
    check_run(folder.text, folder.text, (const char *const[]){"a:=b", "--show", NULL}, 2, "",
              "armtol: a:=b is neither a built-in arm (see --list) nor a file\n");
}

/* ---- beside ---- */

#define ACCURACY "--accuracy", "1,1,1,1,1,1"

static void test_limits_can_be_set_aside(void)
{
    const string folder = folder_new();
    process process;
    file_write(string_of("%s/r.urdf", folder.text).text, urdf);
    check_run(folder.text, "", (const char *const[]){"r.urdf", "--joints", "0.5", ACCURACY, NULL}, 2, "",
              "armtol: pose 1, joint 1 (j): 0.5 is beyond its limits; expected 0 to 0 rad (limits of 0 and 0 often "
              "mean that none "
              "are known: --ignore-limits sets limits aside)\n");
    run(&process, folder.text, "",
        (const char *const[]){"r.urdf", "--joints", "0.5", ACCURACY, "--ignore-limits", NULL});
    process_check_status(&process, 0, "set aside");
}

static void test_limits_of_a_follower_hold_too(void)
{
    const string folder = folder_new();
    file_write(
        string_of("%s/r.csv", folder.text).text,
        "units: in deg\njoint,a,alpha,d,theta,couple,multiplier,low,high\ntheta,1,0,0,0\ntheta,1,0,0,0,0,-2,-90,90\n");
    check_run(folder.text, "", (const char *const[]){"r.csv", "--joints", "50", ACCURACY, NULL}, 2, "",
              "armtol: pose 1, link 1, which follows link 0: -100 is beyond its limits; expected -90 to 90 deg "
              "(--ignore-limits sets limits aside)\n");
}

static void test_inches_are_25_4_millimetres(void)
{
    const string folder = folder_new();
    process inches, mm;
    file_write(string_of("%s/r.csv", folder.text).text, "units: in deg\njoint,a,alpha,d,theta\ntheta,10,0,0,0\n");
    run(&inches, folder.text, "", (const char *const[]){"r.csv", "--joints", "0", ACCURACY, NULL});
    run(&mm, folder.text, "",
        (const char *const[]){"r.csv", "--joints", "0", "--accuracy", "25.4,25.4,25.4,1,1,1", "--mm", NULL});
    TEST_ASSERT_NOT_NULL(strstr(inches.output.bytes, "tool point 10 0 0"));
    TEST_ASSERT_NOT_NULL(strstr(mm.output.bytes, "tool point 254 0 0"));
    check_run(folder.text, "", (const char *const[]){"r.csv", "--joints", "0", ACCURACY, "--mm", "--inches", NULL}, 2,
              "", "armtol: --mm, --metres and --inches exclude each other\n");
}

static void test_what_has_no_links_to_draw(void)
{
    const string folder = folder_new();
    file_write(string_of("%s/r.csv", folder.text).text, "units: in deg\njoint,a,alpha,d,theta\ntheta,10,0,0,0\n");
    check_run(folder.text, "", (const char *const[]){"r.csv", "--links", NULL}, 2, "",
              "armtol: --links is for URDF files, and r.csv is none\n");
    check_run(folder.text, "", (const char *const[]){"ur5e", "--links", NULL}, 2, "",
              "armtol: --links is for URDF files, and ur5e is a built-in arm\n");
    check_run(folder.text, "", (const char *const[]){"none.urdf", "--links", NULL}, 2, "",
              "armtol: none.urdf: No such file or directory\n");
    check_run(folder.text, "", (const char *const[]){"ur5e", "--joints", "0", ACCURACY, "--craig", NULL}, 2, "",
              "armtol: --craig is for --show\n");
}

/* A joint that counts backwards turns a pinion of 0.02 m, whose rack the second is. */
#define RACK "units: m rad\njoint,a,alpha,d,theta,sign,couple,multiplier,mass,com_x\ntheta,0.1,0,0,0,-1,-,-,2,-0.05\n" \
             "d,0,0,0,0,1,0,0.02,1,0.01\n"

static void check_shown(const char *option, const char *expected)
{
    const string folder = folder_new();
    file_write(string_of("%s/rack.csv", folder.text).text, RACK);
    check_run(folder.text, "", (const char *const[]){"rack.csv", "--show", option, NULL}, 0, expected, "");
}

static void test_a_rack_in_other_units_and_another_order(void)
{
    check_shown("--mm", "name: rack\ntitle: rack\nsource: not given\nunits: mm rad\n\n"
                        "kind, joint,   a, alpha, d, theta, sign, couple, multiplier, mass, com_x\n"
                        "ppr,  theta, 100,     0, 0,     0,   -1,      -,          -,    2,   -50\n"
                        "ppp,  d,       0,     0, 0,     0,    1,      0,         20,    1,    10\n");
    /* a stands in the row below, and the center lies 0.1 - 0.05 from the frame before it */
    check_shown("--craig", "name: rack\ntitle: rack\nsource: not given\norder: craig\nunits: m rad\n\n"
                           "kind, joint,   a, alpha, d, theta, sign, couple, multiplier, mass, com_x\n"
                           "ppr,  theta,   0,     0, 0,     0,   -1,      -,          -,    2,  0.05\n"
                           "ppp,  d,     0.1,     0, 0,     0,    1,      0,       0.02,    1,  0.01\n");
}

static void test_motions_in_json(void)
{
    const string folder = folder_new();
    process process;
    file_write(string_of("%s/rack.csv", folder.text).text, RACK);
    run(&process, folder.text, "", (const char *const[]){"rack.csv", "--show", "--json", NULL});
    process_check_status(&process, 0, "json");
    TEST_ASSERT_NOT_NULL(strstr(process.output.bytes, "\"com_z\": 0,\n      \"sign\": -1\n    }"));
    TEST_ASSERT_NOT_NULL(strstr(process.output.bytes,
                                "\"couple\": 0,\n      \"multiplier\": 0.02,\n      \"offset\": 0\n    }"));
    check_run(folder.text, "", (const char *const[]){"rack.csv", "--show", "--craig", "--json", NULL}, 2, "",
              "armtol: --craig writes a table; expected no --json with it\n");
}

static void test_tips_of_as_many_joints_are_sorted_by_name(void)
{
    const string folder = folder_new();
    file_write(
        string_of("%s/two.urdf", folder.text).text,
        "<robot name='two'><link name='a'/><link name='c'/><link name='b'/>"
        "<joint name='j' type='continuous'><parent link='a'/><child link='c'/><axis xyz='0 0 1'/></joint>"
        "<joint name='k' type='continuous'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/></joint></robot>");
    check_run(folder.text, "", (const char *const[]){"two.urdf", "--show", NULL}, 2, "",
              "armtol: two.urdf has several links at the end; choose the tool's with --tip: \"b\" (1 joint), \"c\" "
              "(1 joint)\n");
}

/* Parallel axes, 1 cm apart: a link for each, and one from the last to the tool. */
static void test_a_chain_may_be_too_long(void)
{
    enum { JOINTS = 1000 };
    static char robot[JOINTS * 170 + 100];
    size_t length = (size_t)snprintf(robot, sizeof robot, "<robot name='long'><link name='l0'/>");
    for (int i = 1; i <= JOINTS; i++) {
        length += (size_t)snprintf(robot + length, sizeof robot - length,
                                   "<link name='l%d'/><joint name='j%d' type='continuous'><parent link='l%d'/>"
                                   "<child link='l%d'/><origin xyz='.01 0 0'/><axis xyz='0 0 1'/></joint>",
                                   i, i, i - 1, i);
    }
    snprintf(robot + length, sizeof robot - length, "</robot>");
    const string folder = folder_new();
    file_write(string_of("%s/long.urdf", folder.text).text, robot);
    check_run(folder.text, "", (const char *const[]){"long.urdf", "--show", NULL}, 2, "",
              "armtol: long.urdf: the chain has 1001 links; expected at most 1000\n");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_rack_in_other_units_and_another_order);
    RUN_TEST(test_motions_in_json);
    RUN_TEST(test_tips_of_as_many_joints_are_sorted_by_name);
    RUN_TEST(test_a_chain_may_be_too_long);
    RUN_TEST(test_xacro_is_run_with_its_arguments);
    RUN_TEST(test_xacro_that_is_not_there_or_fails);
    RUN_TEST(test_too_many_arguments_for_xacro);
    RUN_TEST(test_limits_can_be_set_aside);
    RUN_TEST(test_limits_of_a_follower_hold_too);
    RUN_TEST(test_inches_are_25_4_millimetres);
    RUN_TEST(test_what_has_no_links_to_draw);
    return UNITY_END();
}
