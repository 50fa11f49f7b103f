/*
 * Maps and pictures as users ask for them. The numbers are held against armtol's own answer in the same pose, which
 * goes another way, and against closed forms; the pictures against another's parser of XML.
 */

#include "armtol/runs.h"
#include "support/check.h"
#include "support/process.h"

#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#ifdef TEST_EXPAT
#include <expat.h>
#endif

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

#define LINKS "units: mm rad\njoint a alpha d theta\ntheta 300 0 0 0\ntheta 200 0 0 0\n"
#define RING "--plane", "xy", "--range", "-600..600,-600..600", "--grid", "9,9"
#define LENGTHS "--tolerances", "motors=0.001,lengths=0.02"

static string folder_with(const char *name, const char *content)
{
    const string folder = folder_new(), file = string_of("%s/%s", folder.text, name);
    file_write(file.text, content);
    return folder;
}

static string folder_with_flat(void)
{
    return folder_with("flat.csv", LINKS);
}

/* ---- numbers ---- */

/* The next line of a table that is no comment and no head; its numbers, `-` being nan. */
static const char *read_row(const char *at, double row[], size_t n)
{
    while (*at == '#' || *at == 'x') {
        at = strchr(at, '\n') + 1;
    }
    for (size_t i = 0; i < n; i++) {
        char *end;
        row[i] = strncmp(at, "-\t", 2) == 0 || strncmp(at, "-\n", 2) == 0 ? (double)NAN : strtod(at, &end);
        at += strcspn(at, "\t\n") + 1;
    }
    return at;
}

/* The two links in closed form: theta moves by the other coordinate, a along its link. */
static void test_a_map_of_two_flat_links_in_closed_form(void)
{
    static process process;
    const string folder = folder_with_flat();
    const char *const arguments[] = {"map", "flat.csv", RING, LENGTHS, "--of", "dx", "--tsv", "-", NULL};
    run_well(&process, folder.text, arguments);
    const char *at = process.output.bytes;
    int reached = 0;
    for (int k = 0; k < 81; k++) {
        double row[7];
        at = read_row(at, row, 7);
        const double x = -600 + 150 * (k % 9), y = -600 + 150 * (k / 9), r = hypot(x, y);
        check_same(x, row[0], "x");
        check_same(y, row[1], "y");
        TEST_ASSERT_TRUE((row[3] != 0) == (r >= 100 && r <= 500));
        if (row[3] == 0) {
            TEST_ASSERT_TRUE(isnan(row[4]) && isnan(row[5]));
            continue;
        }
        const double both = row[5] + row[6];
        const double worst = 0.001 * (fabs(y) + fabs(200 * sin(both))) + 0.02 * (fabs(cos(row[5])) + fabs(cos(both)));
        check_within(1e-9, worst, row[4], "at %g %g", x, y);
        check_within(1e-6, x, 300 * cos(row[5]) + 200 * cos(both), "the joints of x");
        reached++;
    }
    TEST_ASSERT_TRUE(reached > 20 && *at == '\0');
}

/* A number of what armtol answers in JSON. */
static double json_number_of(const process *process, const char *object, const char *member)
{
    const char *at = strstr(process->output.bytes, object);
    TEST_ASSERT_NOT_NULL_MESSAGE(at, object);
    at = strstr(at, member);
    TEST_ASSERT_NOT_NULL_MESSAGE(at, member);
    return strtod(at + strlen(member), NULL);
}

/* Of every point of a row: armtol, asked about the joint values that the map found there. */
static void check_against_answers(const char *const arguments[], const char *what, const char *object,
                                  const char *member)
{
    static process map, answer;
    double row[8];
    run_well(&map, TEST_GOLDEN, arguments);
    const char *at = map.output.bytes;
    int checked = 0;
    while (*at != '\0') {
        at = read_row(at, row, 8);
        if (row[3] == 0) {
            continue;
        }
        const string joints = string_of("%.17g,%.17g,%.17g", row[5], row[6], row[7]);
        const char *const asked[] = {"level.csv", "--joints", joints.text, "--payload", "5", what,
                                     strcmp(what, "--accuracy") == 0 ? ".002,.002,.002,.2,.2,.2"
                                         : "lengths=.0001,motors=.01",
                                     "--json", NULL};
        run_well(&answer, TEST_GOLDEN, asked);
        check_within(1e-12 * fabs(row[4]), json_number_of(&answer, object, member), row[4], "%s at %g %g", member,
                     row[0], row[2]);
        checked++;
    }
    TEST_ASSERT_TRUE(checked >= 6);
}

#define LEVEL "map", "level.csv", "--plane", "xz", "--range", "-.6..0.6,-.1..0.5", "--grid", "4,3", "--payload", "5", \
    "--tsv", "-"

static void test_the_worst_case_is_that_of_armtol_in_the_same_pose(void)
{
    const char *const arguments[] = {LEVEL, "--tolerances", "lengths=.0001,motors=.01", "--of", "dz", NULL};
    check_against_answers(arguments, "--tolerances", "\"dz\"", "\"worst_case\": ");
}

static void test_the_least_tolerance_is_that_of_armtol_in_the_same_pose(void)
{
    const char *const arguments[] = {LEVEL, "--accuracy", ".002,.002,.002,.2,.2,.2", "--what", "tolerance", "--of",
                                     "1.a", NULL};
    check_against_answers(arguments, "--accuracy", "\"link\": 1,\n      \"kind\": \"ppr\",\n      \"parameter\": \"a\"",
                          "\"tolerance\": ");
}

/* Tolerances that a pose asks for: in that pose the map has the accuracy itself, and elsewhere more or less. */
static void test_a_map_of_what_a_pose_asked_for(void)
{
    static process process;
    const string folder = folder_with_flat();
    const char *const arguments[] = {"map", "flat.csv", "--plane", "xy", "--range", "400..600,0..300", "--step", "100",
                                     "--joints", "0,1.5707963267948966", "--of", "dy", "--accuracy", ".1,.1,.1,-,-,-",
                                         "--tsv", "-", NULL};
    /* the pose has the tool at (300, 200), which is no point of the map: 300..500 has it */
    run_well(&process, folder.text, arguments);
    const char *const there[] = {"map", "flat.csv", "--plane", "xy", "--range", "300..500,200..300", "--grid", "3,2",
                                 "--joints", "0,1.5707963267948966", "--of", "dy", "--accuracy", ".1,.1,.1,-,-,-",
                                     "--json", NULL};
    run_well(&process, folder.text, there);
    const char *values = strstr(process.output.bytes, "\"values\": [\n    [");
    TEST_ASSERT_NOT_NULL(values);
    check_within(1e-9, 0.1, strtod(values + strlen("\"values\": [\n    ["), NULL), "dy in the pose asked about");
    check_says(&process, "\"wish\": 0.1");
}

static void test_what_people_are_told(void)
{
    static process process;
    const string folder = folder_with_flat();
    const char *const arguments[] = {"map", "flat.csv", RING, LENGTHS, "--contour", "0.8", NULL};
    run_well(&process, folder.text, arguments);
    check_says(&process, "plane xy at z 0, 9 x 9 points from x -600, y -600 to x 600, y 600\n");
    check_says(&process, "the tool's axes free");
    check_says(&process, "  most: ");
    check_says(&process, "no more than 0.8 mm in ");
    const char *const nowhere[] = {"map", "flat.csv", "--plane", "xz", "--offset", "0", "--range", "700..800,0..9",
                                   "--grid",
                                   "2,2", LENGTHS, NULL};
    run_well(&process, folder.text, nowhere);
    check_says(&process, "  0 of 4 points reached");
}

/* ---- pictures ---- */

#ifdef TEST_EXPAT
static void XMLCALL count_begin(void *context, const XML_Char *name, const XML_Char **attributes)
{
    (void)attributes;
    ((int *)context)[0]++;
    ((int *)context)[1] += strcmp(name, "title") == 0;
}

static int titles_of(const char *bytes, size_t length)
{
    int counts[2] = {0, 0};
    XML_Parser parser = XML_ParserCreate(NULL);
    XML_SetUserData(parser, counts);
    XML_SetStartElementHandler(parser, count_begin);
    const bool fine = XML_Parse(parser, bytes, (int)length, 1) == XML_STATUS_OK;
    XML_ParserFree(parser);
    TEST_ASSERT_TRUE_MESSAGE(fine, "not well-formed");
    return counts[1];
}
#else
static int titles_of(const char *bytes, size_t length)
{
    int titles = 0;
    for (const char *at = bytes; at < bytes + length && (at = strstr(at, "<title")) != NULL; at++) {
        titles++;
    }
    return titles;
}
#endif

/* Two runs give the same bytes; every reached point has a tool tip, and title, arm and ground have one. */
static void check_picture(const char *folder, const char *const arguments[], int titles)
{
    static process first, again;
    static text picture;
    const string file = string_of("%s/map.svg", folder);
    run_well(&first, folder, arguments);
    file_read(file.text, &picture);
    TEST_ASSERT_EQUAL_INT(titles, titles_of(picture.bytes, picture.length));
    TEST_ASSERT_NOT_NULL(strstr(picture.bytes, "prefers-color-scheme: dark"));
    static text same;
    same = picture;
    run_well(&again, folder, arguments);
    file_read(file.text, &picture);
    text_check(same.bytes, same.length, &picture, "a second run");
}

static void test_a_picture_is_well_formed_and_the_same_again(void)
{
    const string folder = folder_with_flat();
    const char *const arguments[] = {"map", "flat.csv", RING, LENGTHS, "--contour", "0.8", "--svg", "map.svg", NULL};
    check_picture(folder.text, arguments, 3 + 36); /* 36 points are 100 to 500 from the base: 12 on the axes, 4 + 8 + 8
                                                      + 4 beside */
}

static void test_a_picture_of_an_arm_with_a_strange_name(void)
{
    const string folder = folder_with("odd.csv", "title: <arm> & \"co\" \xc3\xa9, a name that is longer than any "
                                                 "page is wide and has to be written smaller\n" LINKS);
    const char *const arguments[] = {"map", "odd.csv", RING, LENGTHS, "--svg", "map.svg", NULL};
    check_picture(folder.text, arguments, 3 + 36);
}

static void test_a_picture_of_nothing_and_one_without_a_bound(void)
{
    const string folder = folder_with_flat();
    const char *const nowhere[] = {"map", "flat.csv", "--plane", "xy", "--range", "700..900,0..90", "--grid", "2,2",
                                   LENGTHS,
                                   "--svg", "map.svg", NULL};
    check_picture(folder.text, nowhere, 2);
    const string tolerances = string_of("%s/t.csv", folder.text);
    file_write(tolerances.text, "link,parameter,tolerance\n0,a,inf\n");
    const char *const table[] = {"map", "flat.csv", RING, "--tolerances", "t.csv", "--of", "dx", "--svg", "map.svg",
                                 NULL};
    static text picture;
    static process process;
    const string file = string_of("%s/map.svg", folder.text);
    run_well(&process, folder.text, table);
    check_says(&process, "without a bound: ");
    file_read(file.text, &picture);
    TEST_ASSERT_NOT_NULL(strstr(picture.bytes, "no bound"));
    titles_of(picture.bytes, picture.length);
}

static void test_the_bars_of_a_budget(void)
{
    static process with, without;
    static text picture;
    const string folder = folder_new(), file = string_of("%s/budget.svg", folder.text);
    const char *const plain[] = {"level.csv", "--joints", "10,30,-60", "--accuracy", ".002,.002,.002,.2,.2,.2",
                                 "--payload", "5",
                                 "--budget", NULL};
    const char *const drawn[] = {"level.csv", "--joints", "10,30,-60", "--accuracy", ".002,.002,.002,.2,.2,.2",
                                 "--payload", "5",
                                 "--budget", "--svg", file.text, NULL};
    run_well(&without, TEST_GOLDEN, plain);
    run_well(&with, TEST_GOLDEN, drawn);
    text_check(without.output.bytes, without.output.length, &with.output, "the picture changes nothing of the answer");
    file_read(file.text, &picture);
    TEST_ASSERT_TRUE(titles_of(picture.bytes, picture.length) > 20);
    TEST_ASSERT_NOT_NULL(strstr(picture.bytes, "dz, machining of link 1: "));
}

/* ---- what is wrong ---- */

#define MAP "map", "flat.csv"

static void test_what_is_wrong_is_said_by_name(void)
{
    static const struct {
        const char *arguments[16], *words;
    } cases[] = {
        {{MAP, "--range", "0..1,0..1", LENGTHS}, "the plane is missing; expected --plane xy, xz or yz"},
        {{MAP, "--plane", "xy", LENGTHS}, "the range is missing; expected --range A0..A1,B0..B1"},
        {{MAP, "--plane", "zx", "--range", "0..1,0..1", LENGTHS},
         "--plane: unknown plane \"zx\"; expected xy, xz or yz"},
        {{MAP, "--plane", "xy", "--range", "1..0,0..1", LENGTHS}, "--range: \"1..0,0..1\" is empty, or runs backwards"},
        {{MAP, "--plane", "xy", "--range", "0..0,0..1", LENGTHS}, "is empty, or runs backwards"},
        {{MAP, "--plane", "xy", "--range", "0..1", LENGTHS}, "--range: \"0..1\" is not two ranges"},
        {{MAP, "--plane", "xy", "--range", "0..1,2,3", LENGTHS}, "is not two ranges"},
        {{MAP, "--plane", "xy", "--range", "0..1,23", LENGTHS}, "is not two ranges"},
        {{MAP, "--plane", "xy", "--range", "0..x,0..1", LENGTHS}, "has an end that is not a number"},
        {{MAP, "--plane", "xy", "--range", "-1e308..1e308,0..1", LENGTHS}, "is too large, or too small"},
        {{MAP, "--plane", "xy", "--range", "0..1,0..1", "--grid", "0,5", LENGTHS},
         "--grid: \"0,5\" is wrong; expected NA,NB"},
        {{MAP, "--plane", "xy", "--range", "0..1,0..1", "--grid", "5", LENGTHS},
         "--grid: \"5\" is wrong; expected NA,NB"},
        {{MAP, "--plane", "xy", "--range", "0..1,0..1", "--grid", "2000,2000", LENGTHS}, "is more than 1000000 points"},
        {{MAP, "--plane", "xy", "--range", "0..1,0..1", "--step", "1e-9", LENGTHS}, "is more than 1000000 points"},
        {{MAP, "--plane", "xy", "--range", "0..1,0..1", "--step", "2e-3", "--svg", "x.svg", LENGTHS},
         "--svg: 501 x 501"},
        {{MAP, "--plane", "xy", "--range", "0..1,0..1", "--step", "2", LENGTHS},
         "--step: \"2\" is more than the range"},
        {{MAP, "--plane", "xy", "--range", "0..1,0..1", "--step", "-1", LENGTHS}, "--step: "},
        {{MAP, RING, "--step", "1", LENGTHS}, "--grid and --step exclude each other"},
        {{MAP, RING, "--offset", "high", LENGTHS}, "--offset: "},
        {{MAP, RING, "--what", "heat", LENGTHS}, "--what: unknown value \"heat\"; expected worst, droop,"},
        {{MAP, RING, "--of", "dq", LENGTHS}, "--of: unknown component \"dq\"; expected position, rotation, dx"},
        {{MAP, RING, "--contour", "0", LENGTHS}, "--contour: "},
        {{MAP, RING, "--orientation", "1,2", LENGTHS}, "--orientation: "},
        {{MAP, RING}, "--what worst: what the tolerances are is missing; expected --tolerances, or --accuracy with"},
        {{MAP, RING, "--what", "tolerance", LENGTHS}, "--what tolerance: expected --accuracy, and no --tolerances"},
        {{MAP, RING, "--what", "tolerance", "--of", "all", "--accuracy", "1,1,1,1,1,1"}, "--of: "},
        {{MAP, RING, "--what", "tolerance", "--of", "machining", "--accuracy", "1,1,1,1,1,1"},
         "has lengths and angles"},
        {{MAP, RING, "--what", "tolerance", "--of", "lengths=2", "--accuracy", "1,1,1,1,1,1"}, "expected names alone"},
        {{MAP, RING, "--verify", "9", LENGTHS}, "are not for a map"},
        {{MAP, RING, "--csv", LENGTHS}, "a map has no --csv; expected --tsv FILE, --svg FILE or --json"},
        {{MAP, RING, "--json", "--tsv", "-", LENGTHS}, "there is one standard output"},
        {{MAP, RING, "--svg", "no/such/x.svg", LENGTHS}, "output folder \"no/such\": No such file or directory"},
        {{MAP, RING, "--tsv", "flat.csv/x", LENGTHS}, "output folder \"flat.csv\": Not a directory"},
        {{MAP, RING, "--svg", "/dev/null", LENGTHS}, "exists and is not a regular file"},
        {{"flat.csv", "--plane", "xy", "--joints", "1,1", LENGTHS}, "are for armtol map ARM"},
        {{"flat.csv", "--svg", "x", "--joints", "1,1", LENGTHS}, "--svg is for --budget, and for armtol map ARM"},
        {{MAP, "map", RING, LENGTHS}, "unexpected argument"},
        {{"map"}, "the arm is missing"},
    };
    const string folder = folder_with_flat();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        static process process;
        run(&process, folder.text, cases[i].arguments);
        TEST_ASSERT_TRUE_MESSAGE(process.status == 2 || process.status == 1, cases[i].words);
        TEST_ASSERT_TRUE_MESSAGE(strstr(process.errors.bytes, cases[i].words) != NULL, process.errors.bytes);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(0, process.output.length, cases[i].words);
        folder_check(folder.text, "flat.csv", cases[i].words);
    }
}

/* What stood there stays where the new one cannot be written whole. */
static void test_a_file_that_cannot_grow_is_not_replaced(void)
{
    static process process;
    const string folder = folder_with_flat(), file = string_of("%s/map.svg", folder.text);
    const char *const arguments[] = {MAP, RING, LENGTHS, "--svg", "map.svg", NULL};
    const process_setup setup = {.program = TEST_ARMTOL, .arguments = arguments, .folder = folder.text, .largest_file =
        3000};
    file_write(file.text, "old");
    process_run(&process, &setup, "");
    process_check_status(&process, 1, "a file size limit");
    TEST_ASSERT_NOT_NULL(strstr(process.errors.bytes, "map.svg: File too large"));
    file_check(file.text, "old", "the old picture");
    folder_check(folder.text, "flat.csv map.svg", "no draft is left");
}

static void test_an_interrupt_writes_nothing(void)
{
    static process process;
    const string folder = folder_with_flat();
    const char *const arguments[] = {"map", "puma560", "--plane", "xz", "--range", "-900..900,-900..900", "--grid",
                                     "1000,1000",
                                     LENGTHS, "--tsv", "x.tsv", NULL};
    const process_setup setup = {.program = TEST_ARMTOL, .arguments = arguments, .folder = folder.text,
                                 .wires = ALL_ON_TERMINAL};
    process_start(&process, &setup);
    process_expect(&process, "points reached for");
    process_send(&process, "\x03", 1);
    process_finish(&process);
    process_check_status(&process, 1, "interrupted");
    TEST_ASSERT_NOT_NULL(strstr(process.errors.bytes, "interrupted; nothing is written"));
    folder_check(folder.text, "flat.csv", "nothing is written");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_map_of_two_flat_links_in_closed_form);
    RUN_TEST(test_the_worst_case_is_that_of_armtol_in_the_same_pose);
    RUN_TEST(test_the_least_tolerance_is_that_of_armtol_in_the_same_pose);
    RUN_TEST(test_a_map_of_what_a_pose_asked_for);
    RUN_TEST(test_what_people_are_told);
    RUN_TEST(test_a_picture_is_well_formed_and_the_same_again);
    RUN_TEST(test_a_picture_of_an_arm_with_a_strange_name);
    RUN_TEST(test_a_picture_of_nothing_and_one_without_a_bound);
    RUN_TEST(test_the_bars_of_a_budget);
    RUN_TEST(test_what_is_wrong_is_said_by_name);
    RUN_TEST(test_a_file_that_cannot_grow_is_not_replaced);
    RUN_TEST(test_an_interrupt_writes_nothing);
    return UNITY_END();
}
