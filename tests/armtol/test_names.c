/*
 * Names of links and joints: where tables have them, where people are shown them, and where people type them. What a
 * name means is known from its place in the table; no number depends on it.
 */

#include "armtol/runs.h"
#include "support/process.h"
#include "unity.h"

#include <stdio.h>
#include <string.h>

static string made;
static const char *folder; /* where the tables of a test are */

void setUp(void)
{
    made = folder_new();
    folder = made.text;
}

void tearDown(void)
{
    process_clean_up();
}

static void write_file(const char *name, const char *text)
{
    file_write(string_of("%s/%s", folder, name).text, text);
}

#define KEYS "name: crane\nunits: mm deg\n"
#define ROWS "npr,theta,0,90,400,0\n", "npp,d,0,-90,250,180\n", "auto,fixed,80,0,0,0\n"
#define ASKED "--joints", "30,321", "--accuracy", ".5,.4,.3,.2,.2,.2"

/* The arm of three rows, with these names, which stand in the first column. */
static void write_arm(const char *file, const char *head, const char *const names[3])
{
    static const char *const rows[3] = {ROWS};
    char text[2000];
    int n = snprintf(text, sizeof text, KEYS "%s\n", head);
    for (int i = 0; i < 3; i++) {
        n += snprintf(text + n, sizeof text - (size_t)n, "%s,%s", names[i], rows[i]);
    }
    write_file(file, text);
}

#define HEAD "name,kind,joint,a,alpha,d,theta"

static void write_named(void)
{
    write_arm("named.csv", HEAD, (const char *const[]){"column", "\"boom, \"\"long\"\"\"", "-"});
}

static void write_nameless(void)
{
    write_arm("nameless.csv", HEAD, (const char *const[]){"-", "", "-"});
}

static void check_output(const char *const arguments[], const char *expected)
{
    process process;
    run_well(&process, folder, arguments);
    TEST_ASSERT_EQUAL_STRING(expected, process.output.bytes);
}

static void check_same_output(const char *const one[], const char *const other[])
{
    process process;
    run_well(&process, folder, one);
    const text first = process.output;
    TEST_ASSERT_TRUE(first.length > 0);
    check_output(other, first.bytes);
}

static void check_refused(const char *const arguments[], const char *expected)
{
    check_refused_line(folder, arguments, expected);
}

/* ---- tables ---- */

#define SHOWN                                                             \
    KEYS_SHOWN "name,             kind, joint,  a, alpha,   d, theta\n"   \
               "column,           npr,  theta,  0,    90, 400,     0\n"   \
               "\"boom, \"\"long\"\"\", npp,  d,      0,   -90, 250,   180\n" \
               "-,                npr,  fixed, 80,     0,   0,     0\n"
#define KEYS_SHOWN "name: crane\ntitle: crane\nsource: not given\nunits: mm deg\n\n"

static void test_the_column_is_written_back(void)
{
    write_named();
    check_output((const char *const[]){"named.csv", "--show", NULL}, SHOWN);
    write_file("again.csv", SHOWN);
    check_output((const char *const[]){"again.csv", "--show", NULL}, SHOWN);
    check_same_output((const char *const[]){"named.csv", "--show", "--json", NULL},
                      (const char *const[]){"again.csv", "--show", "--json", NULL});
}

/*
 * The head row begins with a word that is a key too: with quotes around it, between blanks, in capitals, with a
 * comment.
 */
static void test_the_column_may_come_first(void)
{
    const char *const names[] = {"column", "boom", "-"};
    const char *const show[] = {"arm.csv", "--show", NULL};
    process process;
    static const char *const heads[] = {HEAD, "\"name\",\"kind\",\"joint\",\"a\",\"alpha\",\"d\",\"theta\"",
                                        "Name,kind,joint,a,alpha,d,theta # links",
                                        "name , kind,joint,a,alpha_{i-1},d,theta"};
    for (size_t i = 0; i < sizeof heads / sizeof heads[0]; i++) {
        write_arm("arm.csv", heads[i], names);
        run(&process, folder, show);
        if (i < 3) {
            process_check_status(&process, 0, heads[i]);
            check_says(&process, "\nboom,   npp,");
        } else {
            TEST_ASSERT_EQUAL_STRING(
                "armtol: arm.csv:3:21: \"alpha_{i-1}\" is of the link before, as in Craig's order; "
                "expected a line \"order: craig\" above the table\n",
                process.errors.bytes);
        }
    }
    write_file("arm.csv", "name the joint\nunits m rad\nname joint theta a alpha d\nhand theta 0 1 0 0\n");
    run_well(&process, folder, show);
    check_says(&process, "name: the joint\n");
    check_says(&process, "\nhand, ppr,  theta, 1,");
}

static void test_names_that_are_none(void)
{
    const char *const show[] = {"arm.csv", "--show", NULL};
    write_arm("arm.csv", HEAD, (const char *const[]){"boom", "-", "boom"});
    check_refused(show, "arm.csv:6:1: name: a second \"boom\"; the first is in line 4");
    write_arm("arm.csv", HEAD, (const char *const[]){"boom", "#REF!", "-"});
    check_refused(show, "arm.csv:5:1: name: \"#REF!\" begins with #");
    write_arm("arm.csv", HEAD, (const char *const[]){"\"a\tb\"", "-", "-"});
    check_refused(show, "arm.csv:4:1: name: \"a?b\" has a tab in it");
    write_arm("arm.csv", HEAD, (const char *const[]){"a\033[1m", "-", "-"});
    check_refused(show, "arm.csv:4:2: a control character, which has no meaning here");
}

static void test_craigs_order_keeps_them(void)
{
    static const char table[] = "name: c\ntitle: c\nsource: not given\norder: craig\nunits: m deg\n\n"
                                "name,     kind, joint,     a, alpha,     d, theta\n"
                                "shoulder, npr,  theta,     0,     0, 0.333,     0\n"
                                "elbow,    npr,  theta,     0,   -90,     0,     0\n"
                                "flange,   npr,  fixed, 0.088,     0, 0.107,     0\n";
    process process;
    write_file("craig.csv", table);
    check_output((const char *const[]){"craig.csv", "--show", "--craig", NULL}, table);
    run_well(&process, folder, (const char *const[]){"craig.csv", "--show", NULL});
    check_says(&process, "\nelbow,    npr,  theta, 0.088,     0,     0,     0\nflange,   npr,  fixed,");
}

/* Frames of far-off axes are laid anew: joints keep their names, and so does a fixed link at the end. */
static void test_links_that_are_laid_anew_keep_them(void)
{
    process process;
    write_file("far.csv", "units: mm deg\nname joint a alpha d theta\none theta 0 0.1 -229182.88579940918 90\n"
                          "two theta 300 0 229183.23486485 -90\n- fixed 10 90 20 0\ntip fixed 5 0 7 30\n");
    run_well(&process, folder, (const char *const[]){"far.csv", "--show", NULL});
    check_says(&process, "# Laid anew: ");
    check_says(&process, "\none,  ");
    check_says(&process, "\ntwo,  ");
    check_says(&process, "\ntip,  npr,  fixed,");
    run_well(&process, folder, (const char *const[]){"far.csv", "--show", "--json", NULL});
    check_says(&process, "\"laying\": {\n    \"farthest\": 229205.");
    check_says(&process, "\"snapped\": []");
    check_says(&process, "\"name\": \"two\"");
}

/* ---- what is printed ---- */

/* Every line of the one begins with that of the other. */
static void check_begins(const char *line, const char *other)
{
    for (; *other != '\0'; line = strchr(line, '\n') + 1) {
        const size_t length = strcspn(other, "\n");
        TEST_ASSERT_EQUAL_STRING_LEN(other, line, length);
        TEST_ASSERT_NOT_NULL(strchr(line, '\n'));
        other += length + 1;
    }
}

static void test_no_number_depends_on_a_name(void)
{
    static process named, nameless;
    write_named();
    write_nameless();
    run_well(&named, folder, (const char *const[]){"named.csv", ASKED, "--csv", NULL});
    run_well(&nameless, folder, (const char *const[]){"nameless.csv", ASKED, "--csv", NULL});
    check_begins(named.output.bytes, nameless.output.bytes);
    check_says(&named, ",unit,name\n0,npr,theta,");
    check_says(&named, ",mm,\"boom, \"\"long\"\"\"\n");
    check_says(&nameless, ",unit\n0,npr,theta,");
    write_file("made.csv", named.output.bytes); /* what --csv writes can be read again, names and all */
    check_same_output(
        (const char *const[]){"named.csv", "--joints", "30,321", "--tolerances", "made.csv", "--csv", NULL},
        (const char *const[]){"named.csv", ASKED, "--csv", NULL});
}

static void test_tables_and_members_have_them(void)
{
    process process;
    write_named();
    run_well(&process, folder,
             (const char *const[]){"named.csv", ASKED, "--budget", "--drives", "backlash=.001", NULL});
    check_says(&process, "\n  0 column         npr  ");
    check_says(&process, "\n  1 boom, \"long\"   npp  ");
    check_says(&process, "\n  0 column machining  ");
    check_says(&process, "\n  2                npr  ");
    run_well(&process, folder, (const char *const[]){"named.csv", ASKED, "--budget", "--drives", "compliance=.00001",
                                                       "--force", "3,4,5", "--json", NULL});
    check_says(&process, "\"joint_names\": [\n      \"column\",\n      \"boom, \\\"long\\\"\"\n    ]");
    check_says(&process, "\"link\": 1,\n      \"name\": \"boom, \\\"long\\\"\",\n      \"kind\":");
    check_says(&process, "\"link\": 0,\n      \"name\": \"column\",\n      \"distance\":");
    check_says(&process, "\"link\": 0,\n      \"name\": \"column\",\n      \"role\":");
    check_says(&process, "\"link\": 0,\n          \"name\": \"column\",\n          \"moment\":");
    check_says(&process, "\"link\": 2,\n      \"kind\":");
}

static void test_messages_have_them(void)
{
    write_named();
    check_refused(
        (const char *const[]){"named.csv", "--joints", "30,321", "--accuracy", "1,1,1,1,1,1", "--drives",
                              "compliance=1", NULL},
        "the drive of link 0 (column): nothing says what loads its compliance; expected masses in the arm's table, "
        "--payload, --force, or a moment beside the compliance");
    write_file("limited.csv", KEYS HEAD ",low,high\nknee,npr,theta,1,0,0,0,-10,10\n");
    check_refused(
        (const char *const[]){"limited.csv", "--joints", "11", "--accuracy", "1,1,1,1,1,1", NULL},
        "pose 1, joint 1 (knee): 11 is beyond its limits; expected -10 to 10 deg (--ignore-limits sets limits aside)");
    write_file("made.csv", "link,parameter,tolerance\nknee,beta,1\n");
    check_refused((const char *const[]){"limited.csv", "--joints", "1", "--tolerances", "made.csv", NULL},
                  "made.csv:2:6: link 0 (knee), of kind npr, has no parameter \"beta\"; expected theta, d, a, alpha");
    write_file("made.csv", "link,parameter,tolerance\nthigh,beta,1\n");
    check_refused(
        (const char *const[]){"limited.csv", "--joints", "1", "--tolerances", "made.csv", NULL},
        "made.csv:2:1: link \"thigh\": expected a whole number from 0 to 0, the last link, or the name of one");
}

/* No line of what people read has more than 80 characters, tables of long names and of many columns included. */
static void check_width(const char *const arguments[])
{
    process process;
    run_well(&process, folder, arguments);
    TEST_ASSERT_TRUE(process.output.length > 0);
    for (const char *line = process.output.bytes; *line != '\0';) {
        const size_t length = strcspn(line, "\n");
        size_t characters = 0;
        for (size_t i = 0; i < length; i++) {
            characters += ((unsigned char)line[i] & 0xc0) != 0x80;
        }
        TEST_ASSERT_TRUE_MESSAGE(characters <= 80, line);
        line += length + 1;
    }
}

#define LONG "left_arm_\xc3\xbc" "ber_the_shoulder_pan_joint"

static void test_no_line_is_wider_than_eighty(void)
{
    process process;
    write_arm("arm.csv", HEAD,
              (const char *const[]){LONG "_1", LONG "_2", "\xf0\x9f\xa6\xbe\xf0\x9f\xa6\xbe\xf0\x9f\xa6\xbe"});
    check_width(
        (const char *const[]){"arm.csv", ASKED, "--given", "motors=0.001", "--budget", "--verify", "100", NULL});
    check_width((const char *const[]){"arm.csv", ASKED, "--drives", "compliance=0.0001", "--payload", "1", "--payload",
                                      "2", "--force", "3,4,5.123456", "--verify", "100", "--seed",
                                      "18446744073709551615", NULL});
    run_well(&process, folder, (const char *const[]){"arm.csv", ASKED, NULL});
    check_says(&process, "\n  0 left_arm_\xc3\xbc" "ber_the...   npr  ");
    check_width((const char *const[]){"ur5e", "--joints", ".1,-2,2,1,1,.1", "--accuracy", "1,1,1,1,1,1", "--given",
                                      "motors=0.001", NULL});
    check_width((const char *const[]){"ur5e", "--joints", ".1,-2,2,1,1,.1", "--accuracy", "1,1,1,.1,.1,.1", "--method",
                                      "rss", "--budget", "--verify", "100", NULL});
    check_width((const char *const[]){"--list", NULL});
    check_width((const char *const[]){"--help", NULL});
}

/* ---- what is typed ---- */

#define UR5E_JOINTS "shoulder_pan_joint=.1,shoulder_lift_joint=-2,wrist_1_joint=1,wrist_2_joint=1.5,wrist_3_joint=.2"
#define WISH "--accuracy", "1,1,1,.1,.1,.1"

static void test_joints_by_name(void)
{
    static const char all[] = UR5E_JOINTS ", elbow_joint = 2 ", twice[] = UR5E_JOINTS ",wrist_3_joint=1";
    check_same_output((const char *const[]){"ur5e", "--joints", ".1,-2,2,1,1.5,.2", WISH, NULL},
                      (const char *const[]){"ur5e", "--joints", all, WISH, NULL});
    check_refused((const char *const[]){"ur5e", "--joints", UR5E_JOINTS, WISH, NULL},
                  "--joints: no value for the joint of link 2 (elbow_joint); expected one for each of 6 joints");
    check_refused((const char *const[]){"ur5e", "--joints", twice, WISH, NULL},
                  "--joints: \"wrist_3_joint\" is given twice");
    check_refused((const char *const[]){"ur5e", "--joints", "elbow=1", WISH, NULL},
                  "--joints: ur5e has no joint \"elbow\"; it has \"shoulder_pan_joint\", \"shoulder_lift_joint\", "
                  "\"elbow_joint\", \"wrist_1_joint\", \"wrist_2_joint\", \"wrist_3_joint\"");
    check_refused((const char *const[]){"ur5e", "--joints", "elbow_joint=1x", WISH, NULL},
                  "--joints: \"elbow_joint\": \"1x\" is not a number");
    check_refused((const char *const[]){"ur5e", "--joints", "elbow_joint=1,2", WISH, NULL},
                  "--joints: \"2\" is no NAME=VALUE; expected names for all values, or for none");
    check_refused((const char *const[]){"ur5e", "--joints", "elbow_joint=1,", WISH, NULL},
                  "--joints: \"\" is no NAME=VALUE; expected names for all values, or for none");
    check_refused((const char *const[]){"puma560", "--joints", "elbow=1", WISH, NULL},
                  "--joints: the joints of puma560 have no names; expected 6 values without");
}

static void test_joints_that_cannot_be_named(void)
{
    write_file("arm.csv", KEYS HEAD ",couple\na=b,npr,theta,1,90,0,0,-\nfollower,npr,theta,1,90,0,0,0\n"
                                    "end,npr,fixed,1,0,0,0,-\n-,npr,theta,1,0,0,0,-\n");
    check_refused(
        (const char *const[]){"arm.csv", "--joints", "a=b=1", WISH, NULL},
        "--joints: no value for the joint of link 3; expected one for each of 2 joints, without names, since this "
        "one has none");
    check_refused((const char *const[]){"arm.csv", "--joints", "follower=1", WISH, NULL},
                  "--joints: \"follower\" has no value of its own");
    check_refused((const char *const[]){"arm.csv", "--joints", "end=1", WISH, NULL},
                  "--joints: \"end\" has no value of its own");
    write_arm("many.csv", HEAD, (const char *const[]){"1", "0", "x.y"});
    check_refused((const char *const[]){"many.csv", "--joints", "2=1", WISH, NULL},
                  "--joints: crane has no joint \"2\"; it has \"1\", \"0\"");
}

static void test_more_joints_than_a_message_holds(void)
{
    char text[1000] = KEYS HEAD "\n";
    for (int i = 0; i < 10; i++) {
        const size_t n = strlen(text);
        snprintf(text + n, sizeof text - n, "j%d,npr,theta,1,90,0,0\n", i);
    }
    write_file("ten.csv", text);
    check_refused(
        (const char *const[]){"ten.csv", "--joints", "j=1", WISH, NULL},
        "--joints: crane has no joint \"j\"; it has \"j0\", \"j1\", \"j2\", \"j3\", \"j4\", \"j5\", \"j6\", \"j7\" "
        "and 2 more");
}

#define POSED "ur5e", "--joints", ".1,-2,2,1,1.5,.2"

static void test_lists_by_name(void)
{
    check_same_output(
        (const char *const[]){POSED, WISH, "--given", "2.a=0.01,1.motors<=1e-5", NULL},
        (const char *const[]){POSED, WISH, "--given", "elbow_joint.a=0.01,shoulder_lift_joint.motors<=1e-5", NULL});
    check_same_output((const char *const[]){POSED, WISH, "--weights", "2.a=3", NULL},
                      (const char *const[]){POSED, WISH, "--weights", "elbow_joint.a=3", NULL});
    check_same_output((const char *const[]){POSED, WISH, "--drives", "2.backlash=1e-6", NULL},
                      (const char *const[]){POSED, WISH, "--drives", "elbow_joint.backlash=1e-6", NULL});
    write_file("weights.csv", "link,parameter,weight\nelbow_joint,a,3\n");
    check_same_output((const char *const[]){POSED, WISH, "--weights", "2.a=3", NULL},
                      (const char *const[]){POSED, WISH, "--weights", "weights.csv", NULL});
    check_refused((const char *const[]){POSED, WISH, "--given", "elbow.a=0", NULL},
                  "--given: ur5e has no link \"elbow\"");
}

/* A number is a link's; a name that looks like one, and is another link's, has two meanings. */
static void test_names_that_look_like_numbers(void)
{
    write_arm("arm.csv", HEAD, (const char *const[]){"7.5", "x.y", "2"});
    check_same_output((const char *const[]){"arm.csv", ASKED, "--given", "0.alpha=0,2.a=0.001", "--csv", NULL},
                      (const char *const[]){"arm.csv", ASKED, "--given", "7.5.alpha=0,2.a=0.001", "--csv", NULL});
    check_same_output((const char *const[]){"arm.csv", ASKED, "--given", "1.alpha=0", "--csv", NULL},
                      (const char *const[]){"arm.csv", ASKED, "--given", "x.y.alpha=0", "--csv", NULL});
}

static void test_names_with_two_meanings(void)
{
    write_arm("arm.csv", HEAD, (const char *const[]){"1", "x.y", "2"});
    check_refused((const char *const[]){"arm.csv", ASKED, "--given", "1.alpha=0", NULL},
                  "--given: \"1.alpha\" may be link 1, or link 0, which is called so; expected the other one's number");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_column_is_written_back);
    RUN_TEST(test_the_column_may_come_first);
    RUN_TEST(test_names_that_are_none);
    RUN_TEST(test_craigs_order_keeps_them);
    RUN_TEST(test_links_that_are_laid_anew_keep_them);
    RUN_TEST(test_no_number_depends_on_a_name);
    RUN_TEST(test_tables_and_members_have_them);
    RUN_TEST(test_messages_have_them);
    RUN_TEST(test_no_line_is_wider_than_eighty);
    RUN_TEST(test_joints_by_name);
    RUN_TEST(test_joints_that_cannot_be_named);
    RUN_TEST(test_more_joints_than_a_message_holds);
    RUN_TEST(test_lists_by_name);
    RUN_TEST(test_names_that_look_like_numbers);
    RUN_TEST(test_names_with_two_meanings);
    return UNITY_END();
}
