/* The program armtol, run as its users run it. */

#include "armtol/runs.h"
#include "support/process.h"

#include "unity.h"

#include <stdlib.h>
#include <string.h>

#define POSE "0,45,-90,0,45,0"
#define WISH ".5,.5,.5,.01,.01,.01"

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

/* ---- what it prints ---- */

static void test_list_names_every_arm_and_each_can_be_shown(void)
{
    static const char *const names[] = {"intelledex605t", "adeptone", "puma560", "stanford",
                                        "scara",          "ur5e",     "panda",   "iiwa14"};
    process list;
    run_well(&list, NULL, (const char *const[]){"--list", NULL});
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        process show;
        check_says(&list, names[i]);
        run_well(&show, NULL, (const char *const[]){names[i], "--show", NULL});
        check_says(&show, names[i]);
    }
}

static void test_help_goes_to_standard_output_and_version_is_one_line(void)
{
    process process;
    run_well(&process, NULL, (const char *const[]){"--help", NULL});
    TEST_ASSERT_TRUE(strncmp(process.output.bytes, "Usage: armtol ARM ", 18) == 0);
    run_well(&process, NULL, (const char *const[]){"--version", NULL});
    TEST_ASSERT_EQUAL_STRING("armtol " TEST_VERSION "\n", process.output.bytes);
}

static void test_an_arm_that_is_shown_can_be_read_and_is_the_same(void)
{
    const string folder = folder_new();
    const string file = string_of("%s/my.arm", folder.text);
    process shown, again, built_in, from_file;
    for (int degrees = 0; degrees < 2; degrees++) {
        const char *unit = degrees ? "--degrees" : "--radians";
        run_well(&shown, NULL, (const char *const[]){"panda", "--show", unit, NULL});
        file_write(file.text, shown.output.bytes);
        run_well(&again, folder.text, (const char *const[]){"my.arm", "--show", NULL});
        text_check(shown.output.bytes, shown.output.length, &again.output, unit);
        const char *joints = ".1,.2,.3,-1.4,.5,1.6,.7";
        run_well(&built_in, NULL,
                 (const char *const[]){"panda", "--joints", joints, "--accuracy", WISH, "--csv", NULL});
        run_well(&from_file, folder.text, (const char *const[]){"my.arm", "--joints", joints, "--radians", "--accuracy",
                                                                WISH, "--csv", NULL});
        text_check(built_in.output.bytes, built_in.output.length, &from_file.output, unit);
    }
}

static void test_the_arm_may_stand_anywhere_among_the_options(void)
{
    process first, last;
    run_well(&first, NULL, (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, NULL});
    run_well(&last, NULL, (const char *const[]){"--degrees", "--accuracy", WISH, "puma560", "--joints", POSE, NULL});
    text_check(first.output.bytes, first.output.length, &last.output, "the arm between options");
}

/* The number behind the n-th appearance of a member's name. */
static double member(const process *process, const char *name, int n)
{
    const string quoted = string_of("\"%s\": ", name);
    const char *at = process->output.bytes;
    for (int i = 0; i <= n; i++) {
        at = strstr(at, quoted.text);
        TEST_ASSERT_NOT_NULL_MESSAGE(at, name);
        at += strlen(quoted.text);
    }
    return strtod(at, NULL);
}

static void test_tolerances_read_back_give_the_accuracy_that_they_were_made_for(void)
{
    const string folder = folder_new();
    const string file = string_of("%s/t.csv", folder.text);
    process made, back;
    run_well(&made, NULL,
             (const char *const[]){"ur5e", "--joints", "10,-80,70,-60,50,40", "--degrees", "--accuracy", WISH, "--csv",
                                   NULL});
    file_write(file.text, made.output.bytes);
    run_well(&back, folder.text,
             (const char *const[]){"ur5e", "--joints", "10,-80,70,-60,50,40", "--degrees", "--tolerances", "t.csv",
                                   "--json", NULL});
    double fullest = 0;
    for (int i = 0; i < 6; i++) {
        const double used = member(&back, "worst_case", i) / (i < 3 ? .5 : .01);
        TEST_ASSERT_TRUE(used <= 1 + 1e-9);
        fullest = used > fullest ? used : fullest;
    }
    TEST_ASSERT_TRUE(fullest > 1 - 1e-9);
}

/* Eqs (4.20), (4.34): backlash + compliance x moment, 0.125 + 0.0625 x 2, against the motor's tolerance. */
static void test_a_drive_is_good_enough_up_to_the_motor_s_tolerance(void)
{
    static const struct {
        const char *theta, *verdict;
    } cases[] = {{"0.2499", "NO"}, {"0.25", "yes"}, {"0.2501", "yes"}};
    const string folder = folder_new();
    file_write(string_of("%s/one.arm", folder.text).text,
               "name: one\n"
               "units: mm rad\n"
               "kind, joint, a, alpha, d, theta, backlash, compliance, moment\n"
               "npr, theta, 100, 0, 0, 0, 0.125, 0.0625, 2\n");
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const string table =
            string_of("link,parameter,tolerance\n0,theta,%s\n0,d,1\n0,a,1\n0,alpha,1\n", cases[i].theta);
        process process;
        file_write(string_of("%s/t.csv", folder.text).text, table.text);
        run_well(&process, folder.text,
                 (const char *const[]){"one.arm", "--joints", "0", "--tolerances", "t.csv", "--wish", "motors", NULL});
        check_says(&process, "its drive  good enough\n");
        check_says(&process, string_of("%s   rad       0.25  %11s\n", cases[i].theta, cases[i].verdict).text);
    }
}

static void test_a_free_component_is_free(void)
{
    process process;
    run_well(&process, NULL,
             (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--accuracy", "-,inf,.5,-,-,-", NULL});
    check_says(&process, "free");
    check_says(&process, "Not seen here, and so without a bound:");
}

static void test_the_budget_adds_up(void)
{
    process process;
    run_well(&process, NULL, (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH,
                                                   "--budget", "--json", NULL});
    double sums[6] = {0};
    const char *at = strstr(process.output.bytes, "\"budget\"");
    TEST_ASSERT_NOT_NULL(at);
    while ((at = strstr(at, "\"shares\": [")) != NULL) {
        char *end = strchr(at, '[');
        for (int i = 0; i < 6; i++) {
            sums[i] += strtod(end + 1, &end);
        }
        at = end;
    }
    for (int i = 0; i < 6; i++) {
        TEST_ASSERT_TRUE(sums[i] > 1 - 1e-9 && sums[i] < 1 + 1e-9);
    }
    run_well(&process, NULL, (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH,
                                                   "--budget", NULL});
    check_says(&process, "Where the error comes from");
    check_says(&process, "all motors");
}

static void test_a_verification_depends_on_its_seed_and_not_on_the_threads(void)
{
    process one, three, other;
    run_well(&one, NULL, (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--verify",
                                               "30000", "--threads", "1", NULL});
    run_well(&three, NULL, (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH,
                                                 "--verify", "30000", "--threads", "3", NULL});
    run_well(&other, NULL, (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH,
                                                 "--verify", "30000", "--seed", "2", NULL});
    text_check(one.output.bytes, one.output.length, &three.output, "three threads");
    TEST_ASSERT_TRUE(strcmp(one.output.bytes, other.output.bytes) != 0);
    check_says(&one, "30000 arms drawn");
    check_says(&one, "0 are outside by more than the remainder");
}

static void test_what_cannot_be_written_is_a_failure(void)
{
    const process_setup setup = {.program = TEST_ARMTOL,
                                 .arguments = (const char *const[]){"--list", NULL},
                                 .output_path = "/dev/full"};
    process process;
    process_run(&process, &setup, "");
    process_check_status(&process, 1, "a full disk");
    TEST_ASSERT_EQUAL_STRING("armtol: cannot write to standard output\n", process.errors.bytes);
}

/* ---- wrong calls ---- */

typedef struct wrong_call {
    const char *arguments[12];
    const char *message;
} wrong_call;

static const wrong_call wrong_calls[] = {
    {{NULL}, "armtol: the arm is missing; expected a name of --list or a file"},
    {{"puma560", NULL},
     "armtol: the pose is missing; expected --joints Q, --poses FILE, --at POSITION, --at-file FILE or --region R"},
    {{"puma560", "--joints", POSE, "--at", "1,2,3", NULL}, "armtol: --at and --at-file exclude --joints and --poses"},
    {{"puma560", "--poses", "p", "--at-file", "f", NULL}, "armtol: --at and --at-file exclude --joints and --poses"},
    {{"puma560", "--joints", POSE, "--near", POSE, "--accuracy", WISH, NULL},
     "armtol: --near is for --at and --at-file"},
    {{"puma560", "--joints", POSE, "--branches", NULL},
     "armtol: the position is missing; expected --at x,y,z,gamma,beta,alpha or --at-file FILE with --branches"},
    {{"puma560", "--at", "1,2,3", NULL}, "armtol: the accuracy is missing; expected --accuracy"},
    {{"puma560", "--at", "1,2", "--branches", NULL},
     "armtol: --at: 2 numbers are given; expected 6: x,y,z,gamma,beta,alpha, or 3: x,y,z"},
    {{"puma560", "--at", "1,2,3,4,5,6,7", "--branches", NULL}, "armtol: --at: 7 numbers are given; expected 6"},
    {{"puma560", "--at", "1,y,3", "--branches", NULL}, "armtol: --at: \"y\" is not a number"},
    {{"puma560", "--at", "1,2,inf", "--branches", NULL}, "armtol: --at: \"inf\" is not a finite number"},
    {{"puma560", "--at-file", "no.csv", "--branches", NULL}, "armtol: --at-file: no.csv: No such file or directory"},
    {{"puma560", "--at", "1,2,3", "--near", "1,2", "--branches", NULL},
     "armtol: --near: 2 numbers are given; expected 6: a value for each joint"},
    {{"puma560", "--at", "1,2,3", "--tool-offset", "1.5e308,1.5e308,1.5e308", "--branches", NULL},
     "armtol: puma560: no joint values: a value is not finite"},
    {{"puma560", "--at", "1,2,3", "--tool-offset", "1", "--branches", NULL},
     "armtol: --tool-offset: 1 number is given; expected 3: x,y,z"},
    {{"puma560", "--at", "1000,0,0", "--accuracy", WISH, NULL},
     "armtol: pose 1: the position is out of reach of puma560 within its limits: the nearest found is "},
    {{"puma560", "--joints", POSE, NULL},
     "armtol: the accuracy is missing; expected --accuracy dx,dy,dz,wx,wy,wz (or --tolerances FILE)"},
    {{"puma561", "--joints", POSE, "--accuracy", WISH, NULL},
     "armtol: puma561 is neither a built-in arm (see --list) nor a file"},
    {{"./no.arm", "--joints", POSE, "--accuracy", WISH, NULL}, "armtol: ./no.arm: No such file or directory"},
    {{"puma560", "stanford", NULL}, "armtol: unexpected argument \"stanford\"; expected options as in --help"},
    {{"puma560", "--joints", "1,2,3", "--accuracy", WISH, NULL},
     "armtol: --joints: 3 numbers are given; expected 6: a value for each joint of puma560"},
    {{"puma560", "--joints", "1,2,3,4,5,x", "--accuracy", WISH, NULL}, "armtol: --joints: \"x\" is not a number"},
    {{"puma560", "--joints", "0,45,-90,0,450,0", "--degrees", "--accuracy", WISH, NULL},
     "armtol: pose 1, joint 5: 450 is beyond its limits"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", ".5,.5", NULL},
     "armtol: --accuracy: 2 numbers are given; expected 6: dx,dy,dz,wx,wy,wz"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", ".5,.5,0,1,1,1", NULL},
     "armtol: --accuracy: component 3 is not greater than zero"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", "-,-,-,-,-,-", NULL},
     "armtol: --accuracy: all components are free; expected at least one number"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--method", "best", NULL},
     "armtol: --method: unknown method \"best\"; expected worst, rss or sphere"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--frame", "world", NULL},
     "armtol: --frame: unknown frame \"world\"; expected base or tool"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--sigma", "3", NULL},
     "armtol: --sigma is for --method rss"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--delta", ".1", NULL},
     "armtol: --delta is for --method sphere"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--seed", "3", NULL},
     "armtol: --seed and --threads are for --verify N"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--verify", "0", NULL},
     "armtol: --verify: \"0\" is not a whole number from 1 to "},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--weights", "gamma=2", NULL},
     "armtol: --weights: unknown name \"gamma\"; expected theta, d, a,"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--weights", "30.alpha=2", NULL},
     "armtol: --weights: puma560 has no parameter \"30.alpha\""},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--weights", "theta=-2", NULL},
     "armtol: --weights: \"-2\" is not greater than zero"},
    {{"puma560", "--joints", POSE, "--degrees", "--radians", "--accuracy", WISH, NULL},
     "armtol: --degrees and --radians exclude each other"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--json", "--csv", NULL},
     "armtol: --json and --csv exclude each other"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--base", "world", NULL},
     "armtol: --base, --tip and --xacro are for URDF files, and puma560 is a built-in arm"},
    {{"puma560", "--joints", POSE, "--tool-offset", "1,2", "--accuracy", WISH, NULL},
     "armtol: --tool-offset: 2 numbers are given; expected 3: x,y,z"},
    {{"puma560", "--poses", "no.txt", "--accuracy", WISH, NULL}, "armtol: --poses: no.txt: No such file or directory"},
    {{"puma560", "--joints", POSE, "--degrees", "--tolerances", "no.csv", NULL},
     "armtol: --tolerances: no.csv: No such file or directory"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--given", "motors", NULL},
     "armtol: --given: \"motors\" is no NAME=NUMBER, NAME=LEAST..LARGEST, NAME>=LEAST or NAME<=LARGEST"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--given", "motors<2", NULL},
     "armtol: --given: \"motors\" is no NAME=NUMBER, NAME=LEAST..LARGEST, NAME>=LEAST or NAME<=LARGEST"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--given", "motors=-2", NULL},
     "armtol: --given: \"-2\" is negative"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--given", "motors=2..1", NULL},
     "armtol: --given: \"2..1\": the least is above the largest"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--given", "motors>=x", NULL},
     "armtol: --given: \"x\" is not a number"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--given", "knees=1", NULL},
     "armtol: --given: unknown name \"knees\"; expected theta, d, a,"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--given", "motors=.1", "--tolerances", "d=0",
      NULL},
     "armtol: --given is for tolerances that are asked for"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--given", "motors=1", NULL},
     "armtol: no tolerances: what is given uses"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--method", "sphere", "--given", "a<=1", NULL},
     "armtol: no tolerances: a tolerance's range is none, or none that this method keeps to"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--drives", "torque=1", NULL},
     "armtol: --drives: unknown name \"torque\"; expected backlash, compliance, moment,"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--drives", "bits=1.5", NULL},
     "armtol: --drives: bits: \"1.5\" is no whole number from 1 to 64"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--drives", "stiffness=0", NULL},
     "armtol: --drives: stiffness: \"0\" is not greater than zero"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--drives", "9.backlash=0", NULL},
     "armtol: --drives: puma560 has no joint with \"9.backlash\""},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--drives", "backlash=-1", NULL},
     "armtol: --drives: \"-1\" is negative"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--drives", "compliance=1", NULL},
     "armtol: the drive of link 0: nothing says what loads its compliance; expected masses"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--drives", "backlash=1", NULL},
     "armtol: no tolerances: the drives alone use"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--payload", "1,2", NULL},
     "armtol: --payload: 2 numbers are given; expected 4: kg,x,y,z"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--payload", "-1", NULL},
     "armtol: --payload: \"-1\": a mass is not negative"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--gravity", "1", NULL},
     "armtol: --gravity: 1 number is given; expected 3: x,y,z"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--force", "1,2,z", NULL},
     "armtol: --force: \"z\" is not a number"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--compensated", "x", NULL},
     "armtol: --compensated: \"x\" is not a number"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--compensated", "1.1", NULL},
     "armtol: --compensated: \"1.1\" is not from 0 to 1"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--wish", "links", NULL},
     "armtol: --wish: unknown wish \"links\"; expected tolerances or motors"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--tolerances", "d>=1", NULL},
     "armtol: --tolerances: \"d\" is no NAME=NUMBER"},
    {{"puma560", "--frobnicate", NULL}, "armtol: unknown option \"--frobnicate\"; expected options as in --help"},
    {{"puma560", "--joints", POSE, "--acc", WISH, NULL}, "armtol: unknown option \"--acc\"; expected options as"},
    {{"puma560", "--joints", POSE, "--joints=0", NULL}, "armtol: --joints: is given twice; expected once"},
    {{"puma560", "--show", "--csv", NULL}, "armtol: --csv writes tolerances only; expected --json, or nothing"},
    {{"--list", "--csv", NULL}, "armtol: --csv writes tolerances only; expected --json, or nothing"},
    {{"puma560", "--joints", POSE, "--accuracy", WISH, "--verify", "1.5", NULL},
     "armtol: --verify: \"1.5\" is not a whole"},
    {{"puma560", "--joints", NULL}, "armtol: an argument is missing after \"--joints\"; expected options as in --help"},
    {{"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH, "--method", "sphere", NULL}, NULL},
};

static void test_wrong_calls_are_named_and_answered_with_2(void)
{
    for (size_t i = 0; i < sizeof wrong_calls / sizeof wrong_calls[0]; i++) {
        const wrong_call *call = &wrong_calls[i];
        process process;
        run(&process, NULL, call->arguments);
        if (call->message == NULL) { /* the right call beside them */
            process_check_status(&process, 0, "a right call");
            continue;
        }
        process_check_status(&process, 2, call->message);
        text_check("", 0, &process.output, call->message);
        TEST_ASSERT_TRUE_MESSAGE(strncmp(process.errors.bytes, call->message, strlen(call->message)) == 0,
                                 process.errors.bytes);
    }
}

/* From the table to the message: 5 degrees of play and 10 of compliance are 15 degrees on 300 and 600 mm. */
static void test_drives_that_are_too_much_are_told_with_their_share(void)
{
    const string folder = folder_new();
    process process;
    file_write(string_of("%s/play.csv", folder.text).text,
               "units: mm deg\n"
               "joint, a, alpha, d, theta, backlash, compliance, moment\n"
               "theta, 300, 0, 0, 0, 5, 1, 10\n"
               "theta, 300, 0, 0, 0, 5, 1, 10\n");
    run(&process, folder.text,
        (const char *const[]){"play.csv", "--joints", "0,0", "--accuracy", ".1,.1,.1,1,1,1", NULL});
    process_check_status(&process, 2, "drives");
    const double percent = 100 * 15 * 3.14159265358979323846 / 180 * 300 / .1;
    TEST_ASSERT_EQUAL_STRING(
        string_of("armtol: no tolerances: the drives alone use %.4g %% of dy in pose 1: motor of link 0 "
                  "%.3g %%, motor of link 1 %.3g %%\n",
                  3 * percent, 2 * percent, percent)
            .text,
        process.errors.bytes);
}

/* ---- what is said, and how ---- */

static void check_says_not(const process *process, const char *words)
{
    TEST_ASSERT_TRUE_MESSAGE(strstr(process->output.bytes, words) == NULL, words);
}

static void test_the_poses_are_named_and_the_one_that_binds(void)
{
    const string folder = folder_new();
    process process;
    run_well(&process, NULL, (const char *const[]){"scara", "--joints", "10,20,100,0", "--degrees", "--accuracy",
                                                   ".1,.1,.1,-,-,-", NULL});
    check_says(&process, "that guarantee the accuracy in this pose; elsewhere is\nunknown.");
    check_says_not(&process, "pose 1");
    file_write(string_of("%s/poses.txt", folder.text).text, "0 0 100 0\n90 0 100 0\n");
    /* dx is held by the pose that has the arm along y, dy by the other */
    run_well(&process, folder.text, (const char *const[]){"scara", "--poses", "poses.txt", "--degrees", "--accuracy",
                                                          ".1,.1,-,-,-,-", NULL});
    check_says(&process, "the accuracy in these 2 poses; elsewhere\nis unknown.");
    check_says(&process, "  pose 2: joints 90 0 100 0, tool point");
    check_says(&process, "unit  pose   binds");
    run_well(&process, folder.text, (const char *const[]){"scara", "--poses", "poses.txt", "--degrees", "--accuracy",
                                                          ".1,.1,-,-,-,-", "--json", NULL});
    check_says(&process, "\"pose\": 2");
}

/* A turn by 30 degrees about z, then by 90 about x. */
static void test_the_tool_s_pose_is_told_on_request(void)
{
    const string folder = folder_new();
    process process;
    file_write(string_of("%s/one.arm", folder.text).text,
               "units: mm deg\nkind, joint, a, alpha, d, theta\nnpr, theta, 100, 90, 7, 0\n");
    run_well(&process, folder.text, (const char *const[]){"one.arm", "--joints", "30", "--accuracy", "1,1,1,1,1,1",
                                                          "--tool-pose", NULL});
    check_says(&process, "     0.866025404   0.000000000   0.500000000       86.602540\n");
    check_says(&process, "     0.500000000   0.000000000  -0.866025404       50.000000\n");
    check_says(&process, "     0.000000000   1.000000000   0.000000000        7.000000\n");
    check_says(&process, "    zyx 30.000000 0.000000 90.000000\n");
    run_well(&process, folder.text, (const char *const[]){"one.arm", "--joints", "30", "--accuracy", "1,1,1,1,1,1",
                                                          "--tool-pose", "--json", NULL});
    check_says(&process, "\"matrix\": [\n        [0.866025403784438");
    check_says(&process, "\"zyx\": [");
}

static void test_why_sigma_can_be_more_than_the_worst_case(void)
{
    const string folder = folder_new();
    process process;
    file_write(string_of("%s/one.arm", folder.text).text,
               "units: mm deg\nkind, joint, a, alpha, d, theta\nppr, theta, 100, 0, 0, 0\n");
    run_well(&process, folder.text,
             (const char *const[]){"one.arm", "--joints", "0", "--accuracy", "1,1,-,-,-,-", NULL});
    check_says(&process, "\ndx, dy, wz: 3 sigma is more than the worst case.");
    run_well(&process, NULL, (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--accuracy",
                                                   "1,-,-,-,-,-", NULL});
    check_says_not(&process, "more than the worst case");
}

/* What reads the same is the same: 0.3 degrees of play, and 0.1 + 0.2. */
static void test_what_is_equal_on_paper_is_equal(void)
{
    const string folder = folder_new();
    process process;
    file_write(string_of("%s/one.arm", folder.text).text,
               "units: mm deg\nkind, joint, a, alpha, d, theta, low, high, backlash, compliance, moment\n"
               "npr, theta, 100, 0, 0, 0, -300, 300, 0.1, 0.1, 2\n");
    file_write(string_of("%s/t.csv", folder.text).text,
               "link,parameter,tolerance\n0,theta,0.3\n0,d,1\n0,a,1\n0,alpha,1\n");
    run_well(&process, folder.text,
             (const char *const[]){"one.arm", "--joints", "300", "--tolerances", "t.csv", "--wish", "motors", NULL});
    check_says(&process, "deg        0.3          yes\n");
    run_well(&process, folder.text,
             (const char *const[]){"one.arm", "--joints", "300", "--tolerances", "t.csv", "--json", NULL});
    check_says(&process, "\"joints\": [\n        300\n      ]");
    run(&process, folder.text, (const char *const[]){"one.arm", "--joints", "301", "--tolerances", "t.csv", NULL});
    process_check_status(&process, 2, "beyond");
    TEST_ASSERT_TRUE(strstr(process.errors.bytes, "301 is beyond its limits; expected -300 to 300 deg (") != NULL);
}

static void test_an_arm_is_shown_in_the_units_that_are_asked_for(void)
{
    const string folder = folder_new();
    process mm, metres, back;
    run_well(&mm, NULL, (const char *const[]){"stanford", "--show", "--mm", NULL});
    run_well(&metres, NULL, (const char *const[]){"stanford", "--show", "--metres", NULL});
    TEST_ASSERT_TRUE(strstr(mm.output.bytes, "units: mm ") != NULL && strstr(metres.output.bytes, "units: m ") != NULL);
    file_write(string_of("%s/m.arm", folder.text).text, metres.output.bytes);
    run_well(&back, folder.text, (const char *const[]){"m.arm", "--show", "--mm", NULL});
    text_check(mm.output.bytes, mm.output.length, &back.output, "there and back");
    file_write(string_of("%s/far.arm", folder.text).text,
               "units: m rad\nkind, joint, a, alpha, d, theta\nnpr, theta, 1e306, 0, 0, 0\n");
    run(&back, folder.text, (const char *const[]){"far.arm", "--show", "--mm", NULL});
    process_check_status(&back, 2, "too large in mm");
}

static void test_lists_and_tables_for_programs(void)
{
    process process;
    run_well(&process, NULL, (const char *const[]){"--list", "--json", NULL});
    check_says(&process, "\"name\": \"puma560\"");
    TEST_ASSERT_TRUE(process.output.bytes[0] == '{');
    run_well(&process, NULL, (const char *const[]){"panda", "--show", "--json", "--degrees", "--metres", NULL});
    check_says(&process, "\"length\": \"m\",\n    \"angle\": \"deg\"");
    check_says(&process, "\"alpha\": -90,\n      \"d\": 0.333,");
    check_says_not(&process, "null");
}

/* null is what has no bound; what does not exist is not there. */
static void test_null_means_one_thing(void)
{
    process process;
    run_well(&process, NULL, (const char *const[]){"scara", "--joints", "10,20,100,0", "--degrees", "--accuracy",
                                                   ".1,.1,.1,.1,.1,.1", "--json", NULL});
    check_says_not(&process, "null");
    check_says(&process, "\"link\": 2,\n      \"angle\":"); /* the slide has no distance */
    run_well(&process, NULL, (const char *const[]){"scara", "--joints", "10,20,100,0", "--degrees", "--accuracy",
                                                   ".1,.1,.1,.1,.1,-", "--json", NULL});
    check_says(&process, "\"accuracy\": null");
}

static void test_a_number_of_arms_may_have_an_exponent(void)
{
    process process;
    run_well(&process, NULL, (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--accuracy", WISH,
                                                   "--verify", "1.5e3", NULL});
    check_says(&process, "1500 arms drawn");
}

static void test_an_accuracy_below_rounding_is_said_to_be_so(void)
{
    process process;
    run_well(&process, NULL, (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--accuracy",
                                                   "1e-12,1,1,1,1,1", NULL});
    check_says(&process, "dx: the accuracy is less than the ");
    check_says_not(&process, "dy: the accuracy");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_list_names_every_arm_and_each_can_be_shown);
    RUN_TEST(test_help_goes_to_standard_output_and_version_is_one_line);
    RUN_TEST(test_an_arm_that_is_shown_can_be_read_and_is_the_same);
    RUN_TEST(test_the_arm_may_stand_anywhere_among_the_options);
    RUN_TEST(test_tolerances_read_back_give_the_accuracy_that_they_were_made_for);
    RUN_TEST(test_a_drive_is_good_enough_up_to_the_motor_s_tolerance);
    RUN_TEST(test_drives_that_are_too_much_are_told_with_their_share);
    RUN_TEST(test_a_free_component_is_free);
    RUN_TEST(test_the_budget_adds_up);
    RUN_TEST(test_a_verification_depends_on_its_seed_and_not_on_the_threads);
    RUN_TEST(test_what_cannot_be_written_is_a_failure);
    RUN_TEST(test_the_poses_are_named_and_the_one_that_binds);
    RUN_TEST(test_the_tool_s_pose_is_told_on_request);
    RUN_TEST(test_why_sigma_can_be_more_than_the_worst_case);
    RUN_TEST(test_what_is_equal_on_paper_is_equal);
    RUN_TEST(test_an_arm_is_shown_in_the_units_that_are_asked_for);
    RUN_TEST(test_lists_and_tables_for_programs);
    RUN_TEST(test_null_means_one_thing);
    RUN_TEST(test_a_number_of_arms_may_have_an_exponent);
    RUN_TEST(test_an_accuracy_below_rounding_is_said_to_be_so);
    RUN_TEST(test_wrong_calls_are_named_and_answered_with_2);
    return UNITY_END();
}
