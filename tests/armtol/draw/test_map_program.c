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
        const int across = k % 9, up = k / 9;
        const double x = -600 + 150 * across, y = -600 + 150 * up, r = hypot(x, y);
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

/* Round sides that both ranges are a whole number of, 24 to 60 along the longer; else 60, and at least one upwards. */
static void test_squares_where_no_grid_is_asked_for(void)
{
    static const struct {
        const char *range, *points;
    } cases[] = {
        {"200..260,200..230", ", 61 x 31 points "},         /* of 1 mm */
        {"300..300.9,100..100.45", ", 61 x 31 points "},    /* of 0.015 mm */
        {"200..300,200..216", ", 51 x 9 points "},          /* of 2 mm: 1 and 1.5 mm are too many */
        {"200..300,200..233.3", ", 61 x 21 points "},       /* no round side: 60 and 20 of nearly 1.67 mm */
        {"200..300,200..200.1", ", 61 x 2 points "},
        {"-600..600,-300..300", ", 61 x 31 points "},       /* of 20 mm */
    };
    const string folder = folder_with_flat();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        static process process;
        const char *const arguments[] = {"map", "flat.csv", "--plane", "xy", "--range", cases[i].range, LENGTHS, NULL};
        run_well(&process, folder.text, arguments);
        check_says(&process, cases[i].points);
    }
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

/* What follows the words before the place where the picture has `what`. */
static const char *behind(const char *bytes, const char *words, const char *what)
{
    const char *at = strstr(bytes, what);
    TEST_ASSERT_NOT_NULL_MESSAGE(at, what);
    for (; at > bytes && strncmp(at, words, strlen(words)) != 0; at--) {
    }
    return at + strlen(words);
}

static double number_behind(const char *bytes, const char *words, const char *what)
{
    return strtod(behind(bytes, words, what), NULL);
}

/* The pose has the tool at (300, 200), the middle of nine points: its cross is in the middle of that one's cell. */
static void test_a_pose_in_the_plane_is_marked(void)
{
    static process process;
    const string folder = folder_with_flat();
    const char *const arguments[] = {"map", "flat.csv", "--plane", "xy", "--range", "200..400,100..300", "--grid",
                                     "3,3", "--joints", "0,1.5707963267948966", LENGTHS, "--svg", "-", NULL};
    run_well(&process, folder.text, arguments);
    const char *bytes = process.output.bytes, *cell = behind(bytes, "d=\"M", "<title>x 300, y 200: ");
    const char *cross = behind(bytes, "d=\"M", "l10 10m0 -10l-10 10");
    double left, top, right, bottom, x, y;
    TEST_ASSERT_EQUAL_INT(4, sscanf(cell, "%lf %lfH%lfV%lf", &left, &top, &right, &bottom));
    TEST_ASSERT_EQUAL_INT(2, sscanf(cross, "%lf %lf", &x, &y));
    check_within(0.11, (left + right) / 2, x + 5, "across"); /* places are to a tenth */
    check_within(0.11, (top + bottom) / 2, y + 5, "up");
    check_says(&process, ">the pose that was given</text>");
}

/* Seen from the side the base stands on the ground, at the 0 of both axes: the 0 is written 4 below its own line. */
static void test_an_arm_seen_from_the_side(void)
{
    static process process;
    static const char *const planes[] = {"yz", "xz"};
    const string folder = folder_new();
    for (size_t i = 0; i < 2; i++) {
        double x, y;
        const char *const arguments[] = {"map", "puma560", "--plane", planes[i], "--offset", "150", "--range",
                                         "300..600,0..300", "--grid", "3,3", LENGTHS, "--svg", "-", NULL};
        run_well(&process, folder.text, arguments);
        const char *bytes = process.output.bytes, *base = behind(bytes, "d=\"M", "h22l-6 -9h-10z");
        TEST_ASSERT_EQUAL_INT(2, sscanf(base, "%lf %lf", &x, &y));
        const double across = number_behind(bytes, " x=\"", "text-anchor=\"middle\">0</text>");
        const double up = number_behind(bytes, " y=\"", "text-anchor=\"end\">0</text>");
        check_within(0.11, across, x + 11, "%s: across", planes[i]);
        check_within(0.11, up, y, "%s: up", planes[i]);
        titles_of(bytes, process.output.length);
    }
}

/* The first of two poses can be placed, and has its mark; the second moves a joint beyond what numbers can hold. */
static void test_a_pose_beyond_all_numbers_has_no_mark(void)
{
    static process process;
    const string folder = folder_with("far.csv", "units: mm rad\njoint a alpha d theta\nd 0 0 1e300 0\n"
                                                 "theta 1e300 0 0 0\ntheta 1e300 0 0 0\n");
    const string poses = string_of("%s/poses.csv", folder.text);
    const char *const arguments[] = {"map", "far.csv", "--plane", "xy", "--range", "5e299..1.5e300,5e299..1.5e300",
                                     "--grid", "3,3", "--poses", "poses.csv", "--of", "dx", LENGTHS, "--svg", "-",
                                     NULL};
    file_write(poses.text, "-1e300,0,1\n1.7976931348623157e308,0,1\n");
    run_well(&process, folder.text, arguments);
    check_says(&process, ">the pose that was given</text>");
}

static void draw_budget(const char *folder, const char *const arguments[], text *picture)
{
    static process process;
    const string file = string_of("%s/budget.svg", folder);
    run_well(&process, folder, arguments);
    file_read(file.text, picture);
    titles_of(picture->bytes, picture->length);
}

/*
 * 3 / sqrt(3) times the root of the squares: of dx (0.2, 0.2, 0.3), of dy (0.3, 0.3), with theta 1 = 0 and 2 = pi / 2.
 * A motor's share of dx is 0.04 / 0.17, its bar that part of the 560 that are the whole.
 */
static void test_the_bars_of_deviations(void)
{
    static text picture;
    const string folder = folder_with_flat();
    const char *const arguments[] = {"flat.csv", "--joints", "0,1.5707963267948966", "--tolerances",
                                     "motors=.001,lengths=.3", "--method", "rss", "--sigma", "3", "--budget", "--svg",
                                     "budget.svg", NULL};
    draw_budget(folder.text, arguments, &picture);
    TEST_ASSERT_NOT_NULL(strstr(picture.bytes, "Shares of each component's load and deviations"));
    TEST_ASSERT_NOT_NULL(strstr(picture.bytes, ">0.714 mm</text>"));
    TEST_ASSERT_NOT_NULL(strstr(picture.bytes, ">0.735 mm</text>"));
    const double width = number_behind(picture.bytes, " width=\"", "dx, motor of link 1: 23.5 %");
    check_within(0.06, 560 * 0.04 / 0.17, width, "the bar of a motor");
}

/* What is too narrow to be seen has no bar; what has no bound has none either, and says so. */
static void test_budgets_without_bars(void)
{
    static text picture;
    const string folder = folder_with_flat(), table = string_of("%s/t.csv", folder.text);
    const char *const arguments[] = {"flat.csv", "--joints", "0.5,1", "--tolerances", "t.csv", "--budget", "--svg",
                                     "budget.svg", NULL};
    file_write(table.text, "link,parameter,tolerance\n0,a,1e-9\n1,a,1\n");
    draw_budget(folder.text, arguments, &picture);
    TEST_ASSERT_NOT_NULL(strstr(picture.bytes, "dx, machining of link 1: 100.0 %"));
    TEST_ASSERT_NULL(strstr(picture.bytes, "dx, machining of link 0"));
    file_write(table.text, "link,parameter,tolerance\n0,a,inf\n1,a,1\n");
    draw_budget(folder.text, arguments, &picture);
    TEST_ASSERT_NOT_NULL(strstr(picture.bytes, ">without a bound</text>"));
    TEST_ASSERT_NULL(strstr(picture.bytes, "dx, "));
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
        {{MAP, "--plane", "xy", "--range",
          "0.00000000000000000000000000000000000000000000000000000000000..1,0..1", LENGTHS},
         "0...\" is too long; expected A0..A1,B0..B1"},
        {{MAP, RING, "--tolerances", "lengths=1e308"}, "armtol: flat in these poses: a value is not finite"},
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

/* A slide that d and the joint value together bring beyond what numbers can hold. */
#define SLIDE "units: mm rad\njoint a alpha d theta\nd 0 0 1e308 0\ntheta 300 0 0 0\n"

static void check_slide(const char *content, const char *joints, const char *error)
{
    static process process;
    const string folder = folder_with("slide.csv", content);
    const char *const arguments[] = {"map", "slide.csv", RING, LENGTHS, "--joints", joints, "--tsv", "x.tsv", NULL};
    run(&process, folder.text, arguments);
    process_check_status(&process, 2, error);
    TEST_ASSERT_EQUAL_STRING(error, process.errors.bytes);
    folder_check(folder.text, "slide.csv", "nothing is written");
}

/* With four joints the tool's axes in the pose are to be kept, with two the pose is where the arm starts from. */
static void test_a_pose_that_no_number_can_hold(void)
{
    check_slide(SLIDE, "1e308,0", "armtol: slide: a value is not finite\n");
    check_slide(SLIDE "theta 300 0 0 0\ntheta 300 0 0 0\n", "1e308,0,0,0",
                "armtol: slide in this pose: a value is not finite\n");
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
    RUN_TEST(test_squares_where_no_grid_is_asked_for);
    RUN_TEST(test_a_picture_is_well_formed_and_the_same_again);
    RUN_TEST(test_a_picture_of_an_arm_with_a_strange_name);
    RUN_TEST(test_a_picture_of_nothing_and_one_without_a_bound);
    RUN_TEST(test_a_pose_in_the_plane_is_marked);
    RUN_TEST(test_an_arm_seen_from_the_side);
    RUN_TEST(test_a_pose_beyond_all_numbers_has_no_mark);
    RUN_TEST(test_the_bars_of_deviations);
    RUN_TEST(test_budgets_without_bars);
    RUN_TEST(test_the_bars_of_a_budget);
    RUN_TEST(test_what_is_wrong_is_said_by_name);
    RUN_TEST(test_a_pose_that_no_number_can_hold);
    RUN_TEST(test_a_file_that_cannot_grow_is_not_replaced);
    RUN_TEST(test_an_interrupt_writes_nothing);
    return UNITY_END();
}
