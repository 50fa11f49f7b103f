/* What armtol answers, held against the programs of 1987 with their errata corrected and against closed forms. */

#include "1987/analysis.h"
#include "armtol/ask/arm_source.h"
#include "armtol/asked.h"
#include "armtol/urdf/urdf.h"
#include "console/exit_code.h"
#include "console/message.h"
#include "support/check.h"
#include "support/process.h"
#include "support/said.h"

#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

enum { TEXT = 256 };

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

static void join(const double values[], size_t n, char text[TEXT])
{
    text[0] = '\0';
    for (size_t i = 0; i < n; i++) {
        char number[40];
        snprintf(number, sizeof number, "%s%.17g", i > 0 ? "," : "", values[i]);
        strcat(text, number);
    }
}

/* ---- the report's bounds ---- */

static const double accuracy_1987[6] = {.5, .5, .5, .1, .1, .1};

static void run_corrected(const armtol_robot *robot, const double wish[], analysis *analysis)
{
    TEST_ASSERT_TRUE(analysis_start(analysis, robot, &armtol_errata_none));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, analysis_place(analysis, wish));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, analysis_matrix(analysis, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, analysis_tolerances(analysis, accuracy_1987, .1));
}

static void check_parts(const analysis *expected, const asked *asked, const char *what)
{
    size_t joint = 0;
    for (size_t i = 0; i < asked->answer->n_links; i++) {
        const armtol_part *part = &asked->answer->parts[i];
        check_within(1e-12, expected->machining[i], part->distance, "%s, rd[%zu]", what, i);
        check_within(1e-15, expected->shares.angle, part->angle, "%s, ggd[%zu]", what, i);
        if (asked->answer->links[i].joint != ARMTOL_FIXED) {
            check_within(1e-12, expected->motor[joint++], part->motor, "%s, motor of link %zu", what, i);
        }
    }
}

static void check_case(const armtol_robot *robot, const char *arm, const double wish[])
{
    analysis expected;
    asked asked;
    char joints[TEXT];
    run_corrected(robot, wish, &expected);
    join(expected.q, robot->n_joints, joints);
    cli_options options = question(arm, joints, ".5,.5,.5,.1,.1,.1");
    options.method = ARMTOL_METHOD_SPHERE;
    options.delta = ".1";
    asked_make(&asked, &options);
    const size_t n = expected.n_columns;
    TEST_ASSERT_TRUE(n == asked.answer->n_columns);
    for (size_t i = 0; i < 6 * n; i++) {
        check_within(1e-10, expected.matrix[i], asked.answer->matrices[i], "%s, A[%zu]", arm, i);
    }
    check_within(1e-13, expected.bounds.distance, asked.answer->bounds.distance, "%s, distance bound", arm);
    check_within(1e-15, expected.bounds.angle, asked.answer->bounds.angle, "%s, angle bound", arm);
    check_parts(&expected, &asked, arm);
    asked_free(&asked);
    analysis_free(&expected);
}

static void test_method_sphere_is_what_the_corrected_programs_of_1987_print(void)
{
    const double intelledex[][6] = {{200, 200, 0, 0, 1.57, 0}, {200, -300, 300, 0, 1.57, 0}};
    const double adept[][4] = {{200, 200, 0, 0}, {300, 300, 100, 1.57}};
    for (int i = 0; i < 2; i++) {
        check_case(&armtol_intelledex_605t, "intelledex605t", intelledex[i]);
        check_case(&armtol_adept_one, "adeptone", adept[i]);
    }
}

/* ---- root of summed squares ---- */

static double deviation_of(const asked *asked, size_t row)
{
    const armtol_answer *answer = asked->answer;
    double variance = 0;
    for (size_t k = 0; k < answer->n_columns; k++) {
        const double error = answer->matrices[row * answer->n_columns + k] * asked->answer->bounded[k];
        variance += error * error / 3; /* of an error that is even within its tolerance */
    }
    return sqrt(variance);
}

static void test_sigma_standard_deviations_are_within_the_accuracy(void)
{
    static const double sigmas[] = {1, 3, 6};
    for (int s = 0; s < 3; s++) {
        asked asked;
        double fullest = 0;
        cli_options options = question("puma560", "0.1,0.7,-1.5,0.2,0.8,0.3", ".5,.5,.5,.01,.01,.01");
        options.method = ARMTOL_METHOD_RSS;
        options.sigma = sigmas[s];
        asked_make(&asked, &options);
        for (size_t i = 0; i < 6; i++) {
            const double used = sigmas[s] * deviation_of(&asked, i) / asked.request.accuracy[i];
            TEST_ASSERT_TRUE(used <= 1 + 1e-12);
            fullest = fmax(fullest, used);
        }
        check_within(1e-9, 1, fullest, "%g sigma", sigmas[s]);
        asked_free(&asked);
    }
}

/* ---- weights ---- */

/* One component bounded: the tolerance of column k is weight_k / (sum of weights) of what it would be alone. */
static void test_weights_loosen_what_costs_more(void)
{
    asked asked;
    cli_options options = question("puma560", "0.1,0.7,-1.5,0.2,0.8,0.3", "-,-,.5,-,-,-");
    options.weights = "lengths=2,motors=5,3.alpha=10";
    asked_make(&asked, &options);
    const armtol_answer *answer = asked.answer;
    double total = 0;
    for (size_t k = 0; k < answer->n_columns; k++) {
        total += isinf(asked.answer->tolerances[k]) ? 0 : asked.request.weights[k];
    }
    for (size_t k = 0; k < answer->n_columns; k++) {
        const double element = fabs(answer->matrices[2 * answer->n_columns + k]);
        if (!isinf(asked.answer->tolerances[k])) {
            check_within(1e-9, asked.request.weights[k] / total * .5, element * asked.answer->tolerances[k],
                         "column %zu", k);
        }
    }
    check_same(10, asked.request.weights[asked_column(&asked, 3, ARMTOL_ALPHA)], "named last");
    check_same(5, asked.request.weights[asked_column(&asked, 3, ARMTOL_THETA)], "a motor");
    check_same(2, asked.request.weights[asked_column(&asked, 3, ARMTOL_D)], "a length");
    check_same(1, asked.request.weights[asked_column(&asked, 0, ARMTOL_ALPHA)], "not named");
    asked_free(&asked);
}

/* ---- units, tool, frame ---- */

static void test_degrees_and_metres_change_the_units_and_nothing_else(void)
{
    asked plain, other;
    cli_options options = question("puma560", "0,0.78539816339744828,-1.5707963267948966,0,0.78539816339744828,0",
                                   ".5,.5,.5,.01,.01,.01");
    asked_make(&plain, &options);
    options = question("puma560", "0,45,-90,0,45,0",
                       ".0005,.0005,.0005,.57295779513082321,.57295779513082321,.57295779513082321");
    options.angle = UNITS_SMALL;
    options.length = UNITS_LARGE;
    asked_make(&other, &options);
    for (size_t k = 0; k < plain.answer->n_columns; k++) {
        const double expected = plain.answer->tolerances[k];
        if (isfinite(expected)) {
            check_within(1e-9 * expected, expected, other.answer->tolerances[k], "column %zu", k);
        }
    }
    asked_free(&plain);
    asked_free(&other);
}

/* The tool link of the AdeptOne lengthened by 100 mm is the same as an offset of 100 mm. */
static void test_a_tool_offset_moves_the_point_that_is_meant(void)
{
    asked asked;
    cli_options options = question("adeptone", "0.3,0.5,0.7,-200", ".5,.5,.5,.01,.01,.01");
    options.tool_offset = "10,20,30";
    asked_make(&asked, &options);
    const double offset[3] = {10, 20, 30};
    double point[3], expected[3];
    const armtol_transform tool =
        armtol_chain_transform(asked.answer->links, asked.answer->n_links, &armtol_errata_none);
    armtol_answer_tool(asked.answer, 0, point);
    for (int i = 0; i < 3; i++) {
        expected[i] = tool.m[i][3];
        for (int j = 0; j < 3; j++) {
            expected[i] += tool.m[i][j] * offset[j];
        }
        check_within(1e-9, expected[i], point[i], "component %d", i);
    }
    /* the base's theta turns the point about z: (-y, x, 0) */
    const size_t theta = asked_column(&asked, 0, ARMTOL_THETA), n = asked.answer->n_columns;
    check_within(1e-9, -expected[1], asked.answer->matrices[theta], "dx");
    check_within(1e-9, expected[0], asked.answer->matrices[n + theta], "dy");
    asked_free(&asked);
}

/* ---- one arm, described twice ---- */

/* The file writes pi / 2 as 1.570796327: its frames are turned by some 2e-10, and with them the tolerances. */
static void test_the_ur5e_of_a_urdf_has_the_tolerances_of_its_table(void)
{
    asked table, urdf;
    if (!urdf_is_built_in()) {
        TEST_IGNORE_MESSAGE("built without expat");
    }
    cli_options options = question("ur5e", ".1,-1,1,-1,1,.5", ".1,.2,.3,.001,.002,.003");
    asked_make(&table, &options);
    options.arm = TEST_UR5E;
    options.base = "base_link";
    options.tip = "tool0";
    options.length = UNITS_SMALL;
    asked_make(&urdf, &options);
    const size_t n = table.answer->n_columns;
    TEST_ASSERT_TRUE(n == 24 && n == urdf.answer->n_columns);
    for (size_t k = 0; k < n; k++) {
        const armtol_column *column = &table.answer->columns[k], *other = &urdf.answer->columns[k];
        const bool is_length = armtol_parameter_is_length(column->parameter);
        const double expected = units_shown(&table.request.units, is_length, table.answer->tolerances[k]);
        TEST_ASSERT_TRUE(column->link == other->link && column->parameter == other->parameter);
        check_within(1e-7 * expected, expected,
                     units_shown(&urdf.request.units, is_length, urdf.answer->tolerances[k]), "column %zu", k);
    }
    asked_free(&table);
    asked_free(&urdf);
}

static void test_an_arm_from_a_pipe(void)
{
    static const char table[] = "units: mm rad\njoint,a,alpha,d,theta\ntheta,100,0,0,0\n";
    int pair[2];
    asked piped, read;
    const string folder = folder_new(), file = string_of("%s/arm.csv", folder.text);
    file_write(file.text, table);
    TEST_ASSERT_EQUAL_INT(0, pipe(pair));
    TEST_ASSERT_EQUAL_INT(sizeof table - 1, write(pair[1], table, sizeof table - 1));
    close(pair[1]);
    const string path = string_of("/dev/fd/%d", pair[0]);
    const cli_options from_pipe = question(path.text, "0.5", "1,1,-,-,-,.1");
    const cli_options from_file = question(file.text, "0.5", "1,1,-,-,-,.1");
    asked_make(&piped, &from_pipe);
    asked_make(&read, &from_file);
    for (size_t k = 0; k < read.answer->n_columns; k++) {
        check_same(read.answer->tolerances[k], piped.answer->tolerances[k], "column %zu", k);
    }
    asked_free(&piped);
    asked_free(&read);
    close(pair[0]);
}

/* Its copy takes a descriptor more than the pipe. */
static void test_an_arm_from_a_pipe_needs_a_descriptor(void)
{
    int pair[2];
    TEST_ASSERT_EQUAL_INT(0, pipe(pair));
    close(pair[1]);
    const string path = string_of("/dev/fd/%d", pair[0]);
    const string complaint = string_of("armtol: %s: cannot be copied: Too many open files\n", path.text);
    const cli_options options = question(path.text, "0", "1,1,1,1,1,1");
    struct rlimit before;
    arm_model model;
    said said;
    message_start("armtol");
    said_begin();
    const int lowest = lowest_free_descriptor();
    TEST_ASSERT_EQUAL_INT(0, getrlimit(RLIMIT_NOFILE, &before));
    const struct rlimit one_more = {(rlim_t)lowest + 1, before.rlim_max};
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_NOFILE, &one_more));
    const int code = arm_source_read(&options, &model);
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_NOFILE, &before));
    said_end(&said);
    close(pair[0]);
    TEST_ASSERT_EQUAL_INT(EXIT_FAILED, code);
    TEST_ASSERT_EQUAL_STRING(complaint.text, said.text);
}

/* ---- several poses ---- */

static void test_several_poses_are_as_narrow_as_each_of_them(void)
{
    static const char *const joints[] = {"0.1,0.7,-1.5,0.2,0.8,0.3", "1,-0.3,0.5,1,-0.8,0.3"};
    const string folder = folder_new(), file = string_of("%s/poses.txt", folder.text);
    file_write(file.text, string_of("%s\n%s\n", joints[0], joints[1]).text);
    asked both;
    cli_options options = question("puma560", NULL, ".5,.5,.5,.01,.01,.01");
    options.poses = file.text;
    asked_make(&both, &options);
    double fullest = 0;
    const size_t size = 6 * both.answer->n_columns * sizeof(double);
    for (size_t pose = 0; pose < 2; pose++) {
        asked one;
        options = question("puma560", joints[pose], ".5,.5,.5,.01,.01,.01");
        asked_make(&one, &options);
        TEST_ASSERT_EQUAL_MEMORY(one.answer->matrices, armtol_answer_matrix(both.answer, pose), size);
        for (size_t i = 0; i < 6; i++) {
            double sum = 0;
            for (size_t k = 0; k < one.answer->n_columns; k++) {
                sum += fabs(one.answer->matrices[i * one.answer->n_columns + k]) * both.answer->bounded[k];
            }
            TEST_ASSERT_TRUE(sum <= one.request.accuracy[i] * (1 + 1e-12));
            fullest = fmax(fullest, sum / one.request.accuracy[i]);
        }
        asked_free(&one);
    }
    check_within(1e-9, 1, fullest, "the fullest component of either pose");
    asked_free(&both);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_method_sphere_is_what_the_corrected_programs_of_1987_print);
    RUN_TEST(test_sigma_standard_deviations_are_within_the_accuracy);
    RUN_TEST(test_weights_loosen_what_costs_more);
    RUN_TEST(test_degrees_and_metres_change_the_units_and_nothing_else);
    RUN_TEST(test_a_tool_offset_moves_the_point_that_is_meant);
    RUN_TEST(test_the_ur5e_of_a_urdf_has_the_tolerances_of_its_table);
    RUN_TEST(test_an_arm_from_a_pipe);
    RUN_TEST(test_an_arm_from_a_pipe_needs_a_descriptor);
    RUN_TEST(test_several_poses_are_as_narrow_as_each_of_them);
    return UNITY_END();
}
