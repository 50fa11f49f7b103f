/* Whole runs of armtol that ask in unusual ways: units, weights, files, several poses, the other way round. */

#include "armtol/runs.h"
#include "support/process.h"

#include "unity.h"

#include <math.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define POSE "0,45,-90,0,45,0"
#define WISH ".5,.5,.5,.01,.01,.01"
#define ASKED "puma560", "--joints", POSE, "--degrees", "--accuracy", WISH

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

static void check_same(const process *one, const process *other, const char *what)
{
    text_check(one->output.bytes, one->output.length, &other->output, what);
}

/* ---- units ---- */

static void test_metres_are_a_thousand_millimetres(void)
{
    process plain, mm, metres;
    run_well(&plain, NULL, (const char *const[]){ASKED, "--json", NULL});
    run_well(&mm, NULL, (const char *const[]){ASKED, "--mm", "--json", NULL});
    run_well(&metres, NULL, (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--metres", "--accuracy",
                                                  ".0005,.0005,.0005,.01,.01,.01", "--json", NULL});
    check_same(&plain, &mm, "the Puma's unit");
    const double in_mm = number_after(mm.output.bytes, "\"distance\": "),
                 in_m = number_after(metres.output.bytes, "\"distance\": ");
    TEST_ASSERT_TRUE(in_mm > 0 && fabs(in_m * 1000 / in_mm - 1) < 1e-12);
    /* the first tolerance is a motor's */
    const double of_mm = number_after(mm.output.bytes, "\"tolerance\": "),
                 of_m = number_after(metres.output.bytes, "\"tolerance\": ");
    TEST_ASSERT_TRUE(of_mm > 0 && fabs(of_m / of_mm - 1) < 1e-12);
}

/* The tool's point is taken and shown in the unit of the lengths. */
static void test_the_tool_is_shown_in_metres(void)
{
    process mm, metres;
    run_well(&mm, NULL, (const char *const[]){ASKED, "--tool-offset", "10,-20,103.4", "--json", NULL});
    run_well(&metres, NULL, (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--metres", "--accuracy",
                                                  ".0005,.0005,.0005,.01,.01,.01", "--tool-offset", ".01,-.02,.1034",
                                                  "--json", NULL});
    double in_mm[3], in_m[3];
    TEST_ASSERT_EQUAL_INT(3, sscanf(strstr(mm.output.bytes, "\"tool\": ["), "\"tool\": [%lf, %lf, %lf]", &in_mm[0],
                                    &in_mm[1], &in_mm[2]));
    TEST_ASSERT_EQUAL_INT(3, sscanf(strstr(metres.output.bytes, "\"tool\": ["), "\"tool\": [%lf, %lf, %lf]", &in_m[0],
                                    &in_m[1], &in_m[2]));
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_TRUE(fabs(in_m[i] - in_mm[i] / 1000) < 1e-12);
    }
}

/* ---- the tables ---- */

/* The line that follows *at, which is moved there. */
static const char *next_line(const char **at)
{
    *at = strchr(*at, '\n');
    TEST_ASSERT_NOT_NULL(*at);
    return ++*at;
}

static void check_shown(double exact, double shown, const char *line)
{
    TEST_ASSERT_TRUE_MESSAGE(fabs(shown - exact) <= 1e-5 * fabs(exact), line);
}

/* From the line above a table's head on; the object of the JSON that lists the same. */
typedef struct tables {
    const char *line, *object;
} tables;

static tables find_tables(const process *text, const process *json, const char *head, const char *member)
{
    tables found = {strstr(text->output.bytes, head), strstr(json->output.bytes, member)};
    TEST_ASSERT_NOT_NULL_MESSAGE(found.line, head);
    TEST_ASSERT_NOT_NULL_MESSAGE(found.object, member);
    next_line(&found.line);
    return found;
}

/* The number of the next member of that name. */
static double next_number(tables *tables, const char *member)
{
    tables->object = strstr(tables->object, member);
    TEST_ASSERT_NOT_NULL_MESSAGE(tables->object, member);
    tables->object += strlen(member);
    return strtod(tables->object, NULL);
}

static void check_parameter_rows(tables tables)
{
    int n = 0, link;
    double nominal, tolerance;
    char name[16], other_name[16];
    for (; sscanf(next_line(&tables.line), " %d %*s %15s %*s %lf %lf", &link, name, &nominal, &tolerance) == 4; n++) {
        check_shown(next_number(&tables, "\"link\": "), link, tables.line);
        tables.object = strstr(tables.object, "\"parameter\": ");
        TEST_ASSERT_EQUAL_INT(1, sscanf(tables.object, "\"parameter\": \"%15[a-z]", other_name));
        TEST_ASSERT_EQUAL_STRING(other_name, name);
        check_shown(next_number(&tables, "\"nominal\": "), nominal, tables.line);
        check_shown(next_number(&tables, "\"tolerance\": "), tolerance, tables.line);
    }
    TEST_ASSERT_EQUAL_INT(24, n);
}

static void check_part_rows(tables tables)
{
    int n = 0, link;
    double distance, angle, motor;
    for (; sscanf(next_line(&tables.line), " %d %lf %lf %lf", &link, &distance, &angle, &motor) == 4; n++) {
        check_shown(next_number(&tables, "\"link\": "), link, tables.line);
        check_shown(next_number(&tables, "\"distance\": "), distance, tables.line);
        check_shown(next_number(&tables, "\"angle\": "), angle, tables.line);
        check_shown(next_number(&tables, "\"motor\": "), motor, tables.line);
    }
    TEST_ASSERT_EQUAL_INT(6, n);
}

static void check_component_rows(tables tables)
{
    int n = 0;
    double accuracy, worst, three_deviations, remainder;
    for (; sscanf(next_line(&tables.line), " %*[dwxyz] %lf %lf %lf %lf", &accuracy, &worst, &three_deviations,
                  &remainder) == 4; n++) {
        check_shown(next_number(&tables, "\"accuracy\": "), accuracy, tables.line);
        check_shown(next_number(&tables, "\"worst_case\": "), worst, tables.line);
        check_shown(3 * next_number(&tables, "\"standard_deviation\": "), three_deviations, tables.line);
        check_shown(next_number(&tables, "\"remainder\": "), remainder, tables.line);
    }
    TEST_ASSERT_EQUAL_INT(6, n);
}

/* Each row of a table is an object of the JSON, to six digits. */
static void test_the_tables_are_the_json_in_short(void)
{
    process text, json;
    run_well(&text, NULL, (const char *const[]){ASKED, NULL});
    run_well(&json, NULL, (const char *const[]){ASKED, "--json", NULL});
    check_parameter_rows(find_tables(&text, &json, "\n  link  kind", "\"parameters\""));
    check_part_rows(find_tables(&text, &json, "\n  link   distance", "\"parts\""));
    check_component_rows(find_tables(&text, &json, "\n  component", "\"components\""));
}

/*
 * A link of 100 mm along x, about to turn about z: its motor moves y and turns about z, its length moves x, its alpha
 * and beta, which no wish bounds, turn about x and y, and nothing moves z.
 */
static void test_the_budget_of_one_link(void)
{
    static const char *const says[] = {
        "  link            dx     dy   dz   wx   wy     wz\n",
        "  0 machining  100.0    0.0  0.0    -    -    0.0\n",
        "  0 motor        0.0  100.0  0.0    -    -  100.0\n",
        "  all motors     0.0  100.0  0.0    -    -  100.0\n",
        "a whole component being 60 long\n",
        "  dx motors    |\n     machining |000000000000000000000000000000000000000000000000000000000000\n",
        "  dy motors    |000000000000000000000000000000000000000000000000000000000000\n     machining |\n",
        "  dz motors    |\n     machining |\n",
        "  wx without a bound\n  wy without a bound\n",
        "  wz motors    |000000000000000000000000000000000000000000000000000000000000\n     machining |\n",
    };
    const string folder = folder_new(), file = string_of("%s/my.csv", folder.text);
    process process;
    file_write(file.text, "units: mm rad\njoint,a,alpha,d,theta\ntheta,100,0,0,0\n");
    run_well(&process, folder.text, (const char *const[]){"my.csv", "--joints", "0", "--accuracy", "1,1,1,-,-,-",
                                                          "--budget", NULL});
    for (size_t i = 0; i < sizeof says / sizeof says[0]; i++) {
        check_says(&process, says[i]);
    }
}

/* ---- tolerances without a bound ---- */

/* The link of the budget. Its alpha turns about x, and moves nothing where the tool point is on that line. */
#define ALONG_X "units: mm rad\njoint,kind,a,alpha,d,theta\ntheta,npr,100,0,0,0\n"
#define ALPHA_FREE "link,parameter,tolerance\n0,theta,.001\n0,d,.1\n0,a,.1\n0,alpha,inf\n"

static string with_alpha_free(void)
{
    const string folder = folder_new();
    file_write(string_of("%s/my.csv", folder.text).text, ALONG_X);
    file_write(string_of("%s/t.csv", folder.text).text, ALPHA_FREE);
    return folder;
}

#define GIVEN "my.csv", "--joints", "0", "--tolerances", "t.csv"

static void test_a_table_of_tolerances_says_so(void)
{
    process process;
    run_well(
        &process, NULL,
        (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--accuracy", ".5,.5,.5,-,-,-", "--csv", NULL});
    check_says(&process, "\n5,npr,theta,motor,0,inf,deg\n");
}

static void test_what_depends_on_it_has_no_bound_either(void)
{
    const string folder = with_alpha_free();
    process process;
    run_well(&process, folder.text, (const char *const[]){GIVEN, "--verify", "1000", NULL});
    check_says(&process, "\nWithout a bound: alpha of link 0\n");
    check_says(&process, "\n  dz                -         0.1 "); /* d alone */
    check_says(&process, "\n  wx                -         inf         inf          inf   rad\n");
    check_says(&process, "\n  wx, rad          -          -          -          -          -\n");
    check_says(&process, "\n  wx, rad        -    inf        inf\n");
    run_well(&process, folder.text, (const char *const[]){GIVEN, "--tool-offset", "0,10,0", NULL});
    check_says(&process, "\n  dy                -         0.1 ");
    check_says(&process, "\n  dz                -         inf         inf          inf    mm\n");
}

static void test_what_has_no_bound_is_null_in_json(void)
{
    const string folder = with_alpha_free();
    process process;
    run_well(&process, folder.text, (const char *const[]){GIVEN, "--verify", "1000", "--budget", "--json", NULL});
    check_says(&process, "\"worst_case\": null,\n      \"standard_deviation\": null,\n      \"remainder\": null,\n");
    check_says(&process, "\"shares\": [1, 0, 1, null, 0, 0]");
    check_says(&process, "\"name\": \"wx\",\n        \"prediction\": null,\n        \"remainder\": null,\n"
                         "        \"quantiles\": [null, null, null, null],\n        \"worst_drawn\": null,\n"
                         "        \"worst_corner\": null\n");
}

static void test_a_wish_for_it_is_answered_but_not_verified(void)
{
    static const char message[] =
        "armtol: --verify: the tolerances leave wx without a bound; expected finite ones for all "
        "that wx depends on, or - in its place in --accuracy\n";
    const string folder = with_alpha_free();
    process process;
    run_well(&process, folder.text, (const char *const[]){GIVEN, "--accuracy", "1,1,1,.1,.1,.1", NULL});
    check_says(&process, "\n  wx              0.1         inf ");
    run(&process, folder.text,
        (const char *const[]){GIVEN, "--accuracy", "1,1,1,.1,.1,.1", "--verify", "1000", NULL});
    process_check_status(&process, 2, "a wish without a bound");
    text_check(message, sizeof message - 1, &process.errors, "a wish without a bound");
    text_check("", 0, &process.output, "a wish without a bound");
    run_well(&process, folder.text,
             (const char *const[]){GIVEN, "--accuracy", "1,1,1,-,.1,.1", "--verify", "1000", NULL});
    check_says(&process, "1000 of 1000 arms are within the accuracy");
}

/* ---- limits of joints ---- */

static void test_a_limit_may_stand_on_one_side(void)
{
    static const struct {
        const char *low, *high, *value, *says; /* says NULL: it may be there */
    } cases[] = {
        {"0", "-", "-5", "-5 is beyond its limits; expected 0 to inf deg (--ignore-limits sets limits aside)"},
        {"0", "inf", "-1e-6", "-1e-06 is beyond its limits; expected 0 to inf deg (--ignore-limits sets limits aside)"},
        {"-inf", "90", "450", "450 is beyond its limits; expected -inf to 90 deg (--ignore-limits sets limits aside)"},
        {"-", "90", "90.000001",
         "90.000001 is beyond its limits; expected -inf to 90 deg (--ignore-limits sets limits aside)"},
        {"0", "-", "5000", NULL},
        {"-", "90", "-5000", NULL},
        {"0", "90", "-1e-9", NULL}, /* limits are rounded too */
        {"-90", "0", "1e-9", NULL},
        {"30", "-", "29.99999999", NULL},
        {"-", "-", "1e9", NULL},
    };
    const string folder = folder_new(), file = string_of("%s/my.csv", folder.text);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const string table = string_of("units: mm deg\njoint,a,alpha,d,theta,low,high\ntheta,100,0,0,0,%s,%s\n",
                                       cases[i].low, cases[i].high);
        process process;
        file_write(file.text, table.text);
        run(&process, folder.text,
            (const char *const[]){"my.csv", "--joints", cases[i].value, "--accuracy", "1,1,1,1,1,1", NULL});
        process_check_status(&process, cases[i].says != NULL ? 2 : 0, cases[i].value);
        const bool refused = cases[i].says != NULL;
        const string message = string_of("armtol: pose 1, joint 1: %s\n", refused ? cases[i].says : "");
        text_check(message.text, refused ? strlen(message.text) : 0, &process.errors, cases[i].value);
    }
}

/* ---- weights ---- */

/* A class is the parameters in it: the Puma's motors all turn, in theta. */
static void test_a_class_of_weights_is_its_parameters(void)
{
    static const char *const same[][2] = {{"angles=2", "theta=2,alpha=2,beta=2"},
                                          {"lengths=2", "d=2,a=2"},
                                          {"motors=3", "theta=3"},
                                          {"machining=3", "d=3,a=3,alpha=3,beta=3"}};
    process by_class, by_name;
    for (size_t i = 0; i < sizeof same / sizeof same[0]; i++) {
        run_well(&by_class, NULL, (const char *const[]){ASKED, "--weights", same[i][0], "--csv", NULL});
        run_well(&by_name, NULL, (const char *const[]){ASKED, "--weights", same[i][1], "--csv", NULL});
        check_same(&by_class, &by_name, same[i][0]);
    }
}

static void test_weights_may_be_a_table(void)
{
    const string folder = folder_new(), file = string_of("%s/w.csv", folder.text);
    process listed, read;
    file_write(file.text, "link,parameter,weight\n2,alpha,10\n0,theta,.5\n");
    run_well(&listed, NULL, (const char *const[]){ASKED, "--weights", "2.alpha=10,0.theta=.5", "--csv", NULL});
    run_well(&read, folder.text, (const char *const[]){ASKED, "--weights", "w.csv", "--csv", NULL});
    check_same(&listed, &read, "weights of a table");
}

/* ---- drives and loads ---- */

/* A stiffness is the inverse of a compliance: here both are powers of two. */
static void test_a_stiffness_is_what_a_compliance_is_not(void)
{
    process stiff, yielding;
    run_well(&stiff, NULL, (const char *const[]){"puma560", "--joints", "0,.8,-1.6,0,.8,0", "--accuracy", "5,5,5,1,1,1",
                                                 "--payload", "5", "--json", "--drives", "stiffness=65536", NULL});
    run_well(&yielding, NULL,
             (const char *const[]){"puma560", "--joints", "0,.8,-1.6,0,.8,0", "--accuracy", "5,5,5,1,1,1", "--payload",
                                   "5", "--json", "--drives", "compliance=0.0000152587890625", NULL});
    check_same(&stiff, &yielding, "stiffness");
}

/* Ten links of 100 in a line: the motors turn them on 1000, 900, ... 100 that lie across, and 0.1 may be off. */
static void test_what_leaves_nothing_is_named(void)
{
    static const char message[] =
        "armtol: no tolerances: the drives alone use 5500 % of dy in pose 1 with load 1: motor of link 0 1e+03 %, "
        "motor of link 1 900 %, motor of link 2 800 %, motor of link 3 700 %, motor of link 4 600 %, "
        "motor of link 5 500 %, motor of link 6 400 %, motor of link 7 300 % and 2 more\n";
    const string folder = folder_new();
    text table = {0};
    strcat(table.bytes, "units: mm rad\njoint,a,alpha,d,theta\n");
    for (int i = 0; i < 10; i++) {
        strcat(table.bytes, "theta,100,0,0,0\n");
    }
    file_write(string_of("%s/line.csv", folder.text).text, table.bytes);
    process process;
    run(&process, folder.text, (const char *const[]){"line.csv", "--joints", "0,0,0,0,0,0,0,0,0,0", "--accuracy",
                                                     "10,.1,10,9,9,9", "--drives", "backlash=.001", "--payload", "0",
                                                     "--payload", "1", NULL});
    process_check_status(&process, 2, message);
    text_check(message, sizeof message - 1, &process.errors, "what uses it");
}

/* A table of 24 rows has 12 poses and, without the loads, the same 12. */
static void test_many_loaded_poses_are_counted_and_not_listed(void)
{
    const string folder = folder_new();
    text poses = {0};
    for (int i = 0; i < 40; i++) {
        strcat(poses.bytes, "0,.8,-1.6,0,.8,0\n");
    }
    file_write(string_of("%s/poses.txt", folder.text).text, poses.bytes);
    process process;
    run_well(&process, folder.text,
             (const char *const[]){"puma560", "--poses", "poses.txt", "--accuracy", "5,5,5,1,1,1", "--drives",
                                   "stiffness=65536", "--payload", "5", NULL});
    check_says(&process, "  and 28 more poses (--json has all)\n");
}

static void test_load_cases_have_an_end(void)
{
    enum { MOST = 64 };
    const char *arguments[2 * (MOST + 1) + 2] = {"puma560"};
    for (int i = 0; i <= MOST; i++) {
        arguments[1 + 2 * i] = "--payload";
        arguments[2 + 2 * i] = "1";
    }
    process process;
    run(&process, NULL, arguments);
    process_check_status(&process, 2, "65 loads");
    static const char message[] = "armtol: --payload: more than 64 load cases";
    TEST_ASSERT_EQUAL_STRING_LEN(message, process.errors.bytes, sizeof message - 1);
}

/* ---- the sentences above the tables ---- */

static void test_the_method_is_said(void)
{
    const string folder = folder_new(), file = string_of("%s/t.csv", folder.text);
    process process;
    run_well(&process, NULL, (const char *const[]){ASKED, "--method", "rss", "--sigma", "2.5", NULL});
    check_says(&process, "with which 2.5 standard deviations of every component");
    run_well(&process, NULL, (const char *const[]){ASKED, "--csv", NULL});
    file_write(file.text, process.output.bytes);
    run_well(&process, folder.text, (const char *const[]){"puma560", "--joints", POSE, "--degrees", "--tolerances",
                                                          "t.csv", "--verify", "100", NULL});
    check_says(&process, "The tolerances of t.csv, and the accuracy that they give in this pose;");
    check_says(&process, "100 arms drawn");
    TEST_ASSERT_NULL(strstr(process.output.bytes, "within the accuracy")); /* none is wished */
}

static void test_a_sphere_says_its_bounds_in_json_too(void)
{
    process text, json;
    run_well(&text, NULL, (const char *const[]){ASKED, "--method", "sphere", "--delta", ".1", NULL});
    run_well(&json, NULL, (const char *const[]){ASKED, "--method", "sphere", "--delta", ".1", "--json", NULL});
    TEST_ASSERT_TRUE(fabs(number_after(json.output.bytes, "\"delta\": ") - .1) < 1e-15);
    const string said =
        string_of("corrected: distance %.6g, angle\n%.6g, delta",
                  number_after(json.output.bytes, "\"distance_bound\": "),
                  number_after(json.output.bytes, "\"angle_bound\": "));
    check_says(&text, said.text);
    check_says(&text, "0.1, in this pose;");
}

static void test_many_poses_are_counted_and_not_listed(void)
{
    enum { POSES = 40 };
    const string folder = folder_new(), file = string_of("%s/poses.txt", folder.text);
    text poses = {0};
    for (int i = 0; i < POSES; i++) {
        strcat(poses.bytes, "0,45,-90,0,45,0\n");
    }
    file_write(file.text, poses.bytes);
    process process;
    run_well(&process, folder.text,
             (const char *const[]){"puma560", "--poses", "poses.txt", "--degrees", "--accuracy", WISH, NULL});
    int listed = 0;
    for (const char *at = process.output.bytes; (at = strstr(at, ", tool point")) != NULL; at++) {
        listed++;
    }
    const string rest = string_of("  and %d more poses\n", POSES - listed);
    TEST_ASSERT_TRUE(listed > 0 && listed < POSES);
    check_says(&process, rest.text);
}

/* A pipe may have no end. */
static void test_a_million_poses_are_enough(void)
{
    enum { POSES = 1000001, BLOCK = 1000 };
    static char block[6 * 2 * BLOCK + 1];
    for (size_t i = 0; i + 1 < sizeof block; i += 2) {
        memcpy(block + i, (i + 2) % 12 == 0 ? "1\n" : "1,", 2);
    }
    const process_setup setup = {
        .program = TEST_ARMTOL,
        .arguments = (const char *const[]){"puma560", "--poses", "/dev/stdin", "--accuracy", WISH, NULL}};
    static const char message[] = "armtol: /dev/stdin:1000001:1: more than 1000000 poses\n";
    process process;
    process_start(&process, &setup);
    for (int i = 0; i < POSES; i += BLOCK) {
        process_send(&process, block, sizeof block - 1);
    }
    process_finish(&process);
    process_check_status(&process, 2, "a million poses");
    text_check(message, sizeof message - 1, &process.errors, "a million poses");
}

/* ---- where arms come from ---- */

static void test_an_arm_may_come_through_a_pipe_behind_empty_lines(void)
{
    process shown, again;
    const process_setup setup = {.program = TEST_ARMTOL,
                                 .arguments = (const char *const[]){"/dev/stdin", "--show", NULL}};
    run_well(&shown, NULL, (const char *const[]){"stanford", "--show", NULL});
    const string input = string_of("\n\n%s", shown.output.bytes);
    process_run(&again, &setup, input.text);
    process_check_status(&again, 0, "an arm through a pipe");
    check_same(&shown, &again, "an arm through a pipe");
}

/* One that has no end is left when it is larger than any arm. */
static void test_an_arm_through_a_pipe_has_a_largest_size(void)
{
    enum { LINES = 1 << 9 };
    static char line[1 << 15];
    memset(line, ' ', sizeof line);
    line[sizeof line - 1] = '\n';
    const process_setup setup = {.program = TEST_ARMTOL,
                                 .arguments = (const char *const[]){"/dev/stdin", "--show", NULL}};
    process process;
    process_start(&process, &setup);
    for (int i = 0; i <= LINES; i++) {
        process_send(&process, line, sizeof line);
    }
    process_finish(&process);
    static const char message[] =
        "armtol: /dev/stdin: is too long; expected an arm of at most 16777216 bytes through a pipe\n";
    process_check_status(&process, 2, "17 MiB");
    text_check(message, sizeof message - 1, &process.errors, "17 MiB");
}

static void test_an_arm_through_a_pipe_needs_room(void)
{
    static char line[1 << 14];
    memset(line, '#', sizeof line);
    line[sizeof line - 1] = '\n';
    const process_setup setup = {.program = TEST_ARMTOL,
                                 .arguments = (const char *const[]){"/dev/stdin", "--show", NULL},
                                 .largest_file = 1 << 12};
    static const char message[] = "armtol: /dev/stdin: cannot be copied: File too large\n";
    process process;
    process_start(&process, &setup);
    process_send(&process, line, sizeof line);
    process_finish(&process);
    process_check_status(&process, 1, "16 KiB");
    text_check(message, sizeof message - 1, &process.errors, "16 KiB");
}

/* Sums of such lengths, and such angles moved, are beyond a double. */
static void test_an_arm_of_too_large_numbers_is_refused(void)
{
    static const char *const rows[][3] = {
        {"revolute,1e308,0,1e308,0", "0", "armtol: my in these poses: a value is not finite\n"},
        {"revolute,0,3e306,0,0", "1.7976931348623157e308", "armtol: my in these poses: a value is not finite\n"},
        {"revolute,0,3.2e306,0,0", "0",
         "armtol: my.csv: link 0: theta: 3.2e+306 rad is too large; expected at most 3.1e+306\n"},
        {"prismatic,1e308,0,0,-3.2e306", "0",
         "armtol: my.csv: link 0: alpha: -3.2e+306 rad is too large; expected at most 3.1e+306\n"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const string folder = folder_new(), file = string_of("%s/my.csv", folder.text);
        const string content =
            string_of("units: mm rad\njoint,d,theta,a,alpha\n%s\nfixed,1e308,0,1e308,0\n", rows[i][0]);
        process process;
        file_write(file.text, content.text);
        run(&process, folder.text, (const char *const[]){"my.csv", "--joints", rows[i][1], "--accuracy", WISH, NULL});
        process_check_status(&process, 2, rows[i][0]);
        text_check(rows[i][2], strlen(rows[i][2]), &process.errors, rows[i][0]);
        text_check("", 0, &process.output, rows[i][0]);
    }
}

/* What a table may say can be told in degrees too. */
static void test_large_angles_in_degrees(void)
{
    const string folder = folder_new(), file = string_of("%s/my.csv", folder.text);
    process process;
    file_write(file.text, "units: mm rad\njoint,a,alpha,d,theta\ntheta,1,0,0,3e306\n");
    run_well(&process, folder.text, (const char *const[]){"my.csv", "--joints", "0", "--degrees", "--accuracy",
                                                          "1,1,1,1,1,1", "--csv", NULL});
    const double told = number_after(process.output.bytes, ",theta,motor,"), meant = 3e306 / acos(-1) * 180;
    TEST_ASSERT_TRUE(fabs(told / meant - 1) < 1e-15);
}

/* A file may be called anything; an arm without a name is called after it, in characters that its table may have. */
static void test_an_arm_called_after_its_file(void)
{
    static const char *const names[][2] = {
        {"a\nb", "a?b"}, {"a\tb", "a?b"}, {"a\xff", "a?"}, {"\xc2\x80", "??"}, {"\xc3\xb6l", "\xc3\xb6l"},
    };
    const string folder = folder_new();
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const string file = string_of("%s/%s.csv", folder.text, names[i][0]);
        const string line = string_of("name: %s\n", names[i][1]);
        const string again = string_of("%s/again", folder.text);
        process shown, back;
        file_write(file.text, "units: mm rad\njoint,a,alpha,d,theta\ntheta,1,0,0,0\n");
        run_well(&shown, NULL, (const char *const[]){file.text, "--show", NULL});
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, strncmp(shown.output.bytes, line.text, strlen(line.text)), shown.output.bytes);
        file_write(again.text, shown.output.bytes);
        run_well(&back, NULL, (const char *const[]){again.text, "--show", NULL});
        check_same(&shown, &back, line.text);
    }
}

/* Weights that are 600 orders of magnitude apart: the optimum is not found, and no other is taken for it. */
static void test_an_optimum_that_is_not_found(void)
{
    static const char message[] = "armtol: no tolerances: the iteration did not converge\n";
    process process;
    run(&process, NULL,
        (const char *const[]){"puma560", "--joints", "0,0.8,-3,0,0.8,0", "--accuracy", WISH, "--weights",
                              "theta=1e300,d=1e-300", NULL});
    process_check_status(&process, 1, "far weights");
    text_check(message, sizeof message - 1, &process.errors, "far weights");
    text_check("", 0, &process.output, "far weights");
}

/* A prismatic joint's motor moves its d. */
static void test_motors_turn_and_push(void)
{
    process process;
    run_well(&process, NULL, (const char *const[]){"stanford", "--joints", "0,0,500,0,0,0", "--accuracy", WISH, "--csv",
                                                   NULL});
    int motors = 0, parts = 0;
    for (const char *at = strchr(process.output.bytes, '\n'); at[1] != '\0'; at = strchr(at + 1, '\n')) {
        char moves, parameter[8], role[16]; /* a kind is npr, ppr, npp or ppp: its joint turns or pushes */
        TEST_ASSERT_EQUAL_INT(3, sscanf(at + 1, "%*d,%*2c%c,%7[a-z],%15[a-z],", &moves, parameter, role));
        const bool motor = strcmp(parameter, moves == 'r' ? "theta" : "d") == 0;
        TEST_ASSERT_EQUAL_STRING(motor ? "motor" : "machining", role);
        motors += motor;
        parts++;
    }
    TEST_ASSERT_EQUAL_INT(6, motors);
    TEST_ASSERT_TRUE(parts > motors);
}

/* RFC 8259, section 7. */
static void test_a_title_is_escaped_in_json(void)
{
    const string folder = folder_new(), file = string_of("%s/my.csv", folder.text);
    process process;
    file_write(file.text,
               "name: my\ntitle: \"x \"\"a\"\" \\ \tb\"\nunits: mm rad\njoint,a,alpha,d,theta\ntheta,100,0,0,0\n");
    run_well(&process, folder.text, (const char *const[]){"my.csv", "--joints", "0", "--accuracy", "1,1,-,-,-,.1",
                                                          "--json", NULL});
    check_says(&process, "\"x \\\"a\\\" \\\\ \\u0009b\"");
}

/* ---- how far it is ---- */

static double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* The first bar is drawn after a second; it tells how long the rest takes, in a unit of which there are two or more. */
static void check_time_left(const char *bar, double total, double longest)
{
    static const struct {
        const char *name;
        double seconds;
    } units[] = {{"s", 1}, {"min", 60}, {"h", 3600}, {"d", 86400}};
    double done, left;
    char name[4];
    TEST_ASSERT_EQUAL_INT_MESSAGE(3, sscanf(bar, "%*d %% %lf of %*f arms, %lf %3s left", &done, &left, name), bar);
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        left *= strcmp(name, units[i].name) == 0 ? units[i].seconds : 1;
    }
    const double rest = (total - done) / done;
    TEST_ASSERT_TRUE_MESSAGE(0.75 * rest <= left && left <= 1.25 * longest * rest, bar);
}

static void test_a_terminal_sees_how_far_it_is_and_an_interrupt_prints_what_there_is(void)
{
    const process_setup setup = {
        .program = TEST_ARMTOL,
        .arguments = (const char *const[]){ASKED, "--verify", "10000000000", "--threads", "1", NULL},
        .wires = {WIRE_PIPE, WIRE_PIPE, WIRE_TERMINAL}};
    process process;
    const double started = seconds_now();
    process_start(&process, &setup);
    process_expect(&process, " left");
    const char *bar = strchr(process.errors.bytes, ']');
    TEST_ASSERT_NOT_NULL_MESSAGE(bar, process.errors.bytes);
    check_time_left(bar + 1, 1e10, seconds_now() - started);
    kill(process.id, SIGINT);
    process_finish(&process);
    check_says(&process, "arms are within the accuracy");
}

/* ---- what is refused ---- */

typedef struct wrong_call {
    const char *arguments[14];
    const char *message; /* how the line begins */
} wrong_call;

static const wrong_call wrong_calls[] = {
    {{"puma560", "--joints", POSE, "--poses", "p.txt", "--accuracy", WISH, NULL},
     "armtol: --joints and --poses exclude each other"},
    {{ASKED, "--mm", "--metres", NULL}, "armtol: --mm, --metres and --inches exclude each other"},
    {{ASKED, "--method", "sphere", "--weights", "theta=2", NULL},
     "armtol: --weights is for the methods worst and rss"},
    {{"puma560", "--joints", POSE, "--tolerances", "t.csv", "--weights", "theta=2", NULL},
     "armtol: --weights is for the methods worst and rss"},
    {{"puma560", "--joints", POSE, "--tolerances", "t.csv", "--delta", ".1", NULL},
     "armtol: --delta is for --method sphere"},
    {{"puma560", "--joints", POSE, "--degrees", "--metres", "--accuracy", "1,1,1e307,1,1,1", NULL},
     "armtol: --accuracy: component 3 is too large; expected six values > 0, or - for free ones\n"},
    {{"my.csv", "--joints", "0", "--metres", "--tolerances", "t.csv", NULL},
     "armtol: --tolerances: t.csv: a of link 0: the tolerance is too large\n"},
    {{ASKED, "--csv", "--budget", NULL}, "armtol: --csv writes tolerances only"},
    {{ASKED, "--csv", "--verify", "10", NULL}, "armtol: --csv writes tolerances only"},
    {{ASKED, "--method", "sphere", "--delta", "x", NULL}, "armtol: --delta: \"x\" is not a number\n"},
    {{ASKED, "--method", "sphere", "--delta", ".6", NULL},
     "armtol: no tolerances: delta is not between zero and the smallest linear tolerance\n"},
    /* in metres it is below the least double */
    {{"metres.csv", "--joints", "0", "--mm", "--accuracy", WISH, "--method", "sphere", "--delta", "1e-322", NULL},
     "armtol: no tolerances: delta is not between zero and the smallest linear tolerance\n"},
    {{ASKED, "--weights", "123456.alpha=2", NULL}, "armtol: --weights: puma560 has no parameter \"123456.alpha\"\n"},
    {{ASKED, "--weights", "1234567.alpha=2", NULL}, "armtol: --weights: puma560 has no link \"1234567\"\n"},
    {{ASKED, "--weights", "theta=2,alpha", NULL}, "armtol: --weights: \"alpha\" is no NAME=NUMBER"},
    {{ASKED, "--weights", "none.csv", NULL}, "armtol: --weights: none.csv: No such file or directory"},
    {{"my.csv", "--tip", "hand", "--show", NULL}, "armtol: --base and --tip are for URDF files, and my.csv is none"},
};

static void test_what_contradicts_itself_is_refused(void)
{
    const string folder = folder_new(), file = string_of("%s/my.csv", folder.text);
    file_write(file.text, "units: mm rad\njoint,a,alpha,d,theta\ntheta,100,0,0,0\n");
    file_write(string_of("%s/metres.csv", folder.text).text, "units: m rad\njoint,a,alpha,d,theta\ntheta,.1,0,0,0\n");
    file_write(string_of("%s/t.csv", folder.text).text,
               "link,parameter,tolerance\n0,theta,1\n0,a,1e307\n0,alpha,inf\n0,beta,1\n");
    for (size_t i = 0; i < sizeof wrong_calls / sizeof wrong_calls[0]; i++) {
        const wrong_call *call = &wrong_calls[i];
        process process;
        run(&process, folder.text, call->arguments);
        process_check_status(&process, 2, call->message);
        text_check("", 0, &process.output, call->message);
        TEST_ASSERT_TRUE_MESSAGE(strncmp(process.errors.bytes, call->message, strlen(call->message)) == 0,
                                 process.errors.bytes);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_metres_are_a_thousand_millimetres);
    RUN_TEST(test_the_tool_is_shown_in_metres);
    RUN_TEST(test_the_tables_are_the_json_in_short);
    RUN_TEST(test_the_budget_of_one_link);
    RUN_TEST(test_a_table_of_tolerances_says_so);
    RUN_TEST(test_what_depends_on_it_has_no_bound_either);
    RUN_TEST(test_what_has_no_bound_is_null_in_json);
    RUN_TEST(test_a_wish_for_it_is_answered_but_not_verified);
    RUN_TEST(test_a_limit_may_stand_on_one_side);
    RUN_TEST(test_a_class_of_weights_is_its_parameters);
    RUN_TEST(test_weights_may_be_a_table);
    RUN_TEST(test_a_stiffness_is_what_a_compliance_is_not);
    RUN_TEST(test_what_leaves_nothing_is_named);
    RUN_TEST(test_many_loaded_poses_are_counted_and_not_listed);
    RUN_TEST(test_load_cases_have_an_end);
    RUN_TEST(test_the_method_is_said);
    RUN_TEST(test_a_sphere_says_its_bounds_in_json_too);
    RUN_TEST(test_many_poses_are_counted_and_not_listed);
    RUN_TEST(test_a_million_poses_are_enough);
    RUN_TEST(test_an_arm_may_come_through_a_pipe_behind_empty_lines);
    RUN_TEST(test_an_arm_through_a_pipe_has_a_largest_size);
    RUN_TEST(test_an_arm_through_a_pipe_needs_room);
    RUN_TEST(test_an_arm_of_too_large_numbers_is_refused);
    RUN_TEST(test_large_angles_in_degrees);
    RUN_TEST(test_an_arm_called_after_its_file);
    RUN_TEST(test_an_optimum_that_is_not_found);
    RUN_TEST(test_motors_turn_and_push);
    RUN_TEST(test_a_title_is_escaped_in_json);
    RUN_TEST(test_a_terminal_sees_how_far_it_is_and_an_interrupt_prints_what_there_is);
    RUN_TEST(test_what_contradicts_itself_is_refused);
    return UNITY_END();
}
