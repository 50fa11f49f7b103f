/* Arms of files whose frames are laid anew: robots whose angles are rounded, tables with frames far off the arm. */

#include "armtol/ask/arm_source.h"
#include "armtol/ask/options.h"
#include "armtol/tables/arm_laying.h"

#include "armtol/runs.h"
#include "support/check.h"
#include "support/process.h"
#include "support/random.h"
#include "support/reference.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

static void check_silent(const process *process, const char *words)
{
    TEST_ASSERT_TRUE_MESSAGE(strstr(process->output.bytes, words) == NULL, words);
}

/* ---- tables ---- */

/* As an identification in plain Denavit-Hartenberg gives two axes 300 apart and 0.05 degrees from parallel. */
#define FAR                                                                                                            \
    "units: mm deg\njoint a alpha d theta low high mass com_x com_y com_z\n"                                           \
    "fixed 0 0 40 0 - - 9 1 1 1\ntheta 0 0.05 -343774.5898120269 90 -170 - 2 10 20 343774\n"                           \
    "theta 250 0 343774.7207117291 -90 - 100 3 -90 5 6\nfixed 0 90 0 30 - - 1 7 8 9\n"

static void read_far(const char *folder, bool as_is, arm_model *model)
{
    const string file = string_of("%s/far.csv", folder);
    const cli_options options = {.arm = file.text, .as_is = as_is};
    file_write(file.text, FAR);
    TEST_ASSERT_EQUAL_INT(0, arm_source_read(&options, model));
}

static void test_a_table_laid_anew_is_the_same_arm(void)
{
    const string folder = folder_new();
    random_source source = {1};
    arm_model as_is, anew;
    read_far(folder.text, true, &as_is);
    read_far(folder.text, false, &anew);
    TEST_ASSERT_EQUAL(0, as_is.laying.farthest);
    check_within(1, 343774.5, anew.laying.farthest, "off the arm");
    const double tilt = 0.05 * 3.14159265358979323846 / 180; /* the base's origin is 40 below the arm */
    check_within(1e-7, 300 - 40 * tan(tilt), anew.arm.links[0].a, "a");
    check_within(1e-9, tilt, anew.arm.links[0].beta, "beta");
    check_same(as_is.arm.drives[1].low, anew.arm.drives[0].low, "the drive goes with its joint");
    check_same(as_is.arm.drives[2].high, anew.arm.drives[1].high, "the drive goes with its joint");
    for (int n = 0; n < 20; n++) {
        const double q[2] = {random_between(&source, -3, 3), random_between(&source, -3, 3)};
        armtol_link placed[5];
        double expected[4][4], actual[4][4];
        armtol_links_place(as_is.arm.links, as_is.arm.n_links, q, 2, &armtol_errata_none, placed);
        reference_chain(placed, as_is.arm.n_links, expected);
        armtol_links_place(anew.arm.links, anew.arm.n_links, q, 2, &armtol_errata_none, placed);
        reference_chain(placed, anew.arm.n_links, actual);
        for (int i = 0; i < 16; i++) {
            check_within(1e-9, expected[i / 4][i % 4], actual[i / 4][i % 4], "element %d", i);
        }
    }
    arm_model_free(&as_is);
    arm_model_free(&anew);
}

/* The second joint counts backwards and follows the first, twice as far. */
static void test_motions_go_with_their_joints(void)
{
    const string folder = folder_new(), file = string_of("%s/far.csv", folder.text);
    cli_options options = {.arm = file.text, .as_is = true};
    arm_model as_is, anew;
    file_write(file.text, "units: mm deg\njoint a alpha d theta sign couple multiplier\nfixed 0 0 40 0 - - -\n"
                          "theta 0 0.05 -343774.5898120269 90 1 - -\ntheta 250 0 343774.7207117291 -90 -1 1 2\n");
    TEST_ASSERT_EQUAL_INT(0, arm_source_read(&options, &as_is));
    options.as_is = false;
    TEST_ASSERT_EQUAL_INT(0, arm_source_read(&options, &anew));
    TEST_ASSERT_TRUE(anew.laying.farthest > 0);
    TEST_ASSERT_NOT_NULL(anew.arm.motions);
    TEST_ASSERT_EQUAL(0, anew.arm.motions[1].follows);
    check_same(-1, anew.arm.motions[1].sign, "sign");
    check_same(2, anew.arm.motions[1].multiplier, "multiplier");
    for (int n = -3; n <= 3; n++) {
        const double q = n;
        armtol_link placed[5];
        double expected[4][4], actual[4][4];
        TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_arm_place(&as_is.arm, &q, 1, placed));
        reference_chain(placed, as_is.arm.n_links, expected);
        TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_arm_place(&anew.arm, &q, 1, placed));
        reference_chain(placed, anew.arm.n_links, actual);
        for (int i = 0; i < 16; i++) {
            check_within(1e-9, expected[i / 4][i % 4], actual[i / 4][i % 4], "element %d", i);
        }
    }
    arm_model_free(&as_is);
    arm_model_free(&anew);
}

/* Mass times center, in the base's coordinates, of what moves with each of two joints. */
static void find_moments(const arm_model *model, const double q[], double moments[2][4])
{
    armtol_link placed[5];
    size_t joints = 0;
    memset(moments, 0, 2 * sizeof moments[0]);
    armtol_links_place(model->arm.links, model->arm.n_links, q, 2, &armtol_errata_none, placed);
    for (size_t i = 0; i < model->arm.n_links; i++) {
        const armtol_mass *mass = &model->arm.masses[i];
        double frame[4][4];
        reference_chain(placed, i + 1, frame);
        joints += placed[i].joint != ARMTOL_FIXED;
        for (int k = 0; k < 4 && joints > 0; k++) {
            const double *row = frame[k], *c = mass->center;
            moments[joints - 1][k] += mass->mass * (row[0] * c[0] + row[1] * c[1] + row[2] * c[2] + row[3]);
        }
    }
}

static void test_masses_stay_where_they_are(void)
{
    const string folder = folder_new();
    arm_model as_is, anew;
    read_far(folder.text, true, &as_is);
    read_far(folder.text, false, &anew);
    for (int n = 0; n < 7; n++) {
        const double q = -1 + 0.6 * n;
        double expected[2][4], actual[2][4];
        find_moments(&as_is, (const double[]){q, 2 * q}, expected);
        find_moments(&anew, (const double[]){q, 2 * q}, actual);
        for (int i = 0; i < 8; i++) {
            check_within(1e-8, expected[i / 4][i % 4], actual[i / 4][i % 4], "joint %d, %d", i / 4 + 1, i % 4);
        }
    }
    arm_model_free(&as_is);
    arm_model_free(&anew);
}

static void test_a_table_laid_anew_says_so(void)
{
    static const char said[] =
        "Laid anew: frames of the table lie up to 343775 mm off the arm (--as-is keeps\nthem).\n";
    const string folder = folder_new(), file = string_of("%s/far.csv", folder.text);
    process process;
    file_write(file.text, FAR);
    run_well(&process, folder.text, (const char *const[]){"far.csv", "--show", NULL});
    check_says(&process, "# Laid anew: frames of the table lie up to 343775 mm off the arm (--as-is keeps them).\n");
    run_well(&process, folder.text, (const char *const[]){"far.csv", "--show", "--as-is", NULL});
    check_silent(&process, "Laid anew");
    run_well(&process, folder.text,
             (const char *const[]){"far.csv", "--joints", "20,40", "--accuracy", ".1,.1,.1,.1,.1,.1", NULL});
    check_says(&process, said);
    run_well(&process, folder.text, (const char *const[]){"far.csv", "--joints", "20,40", "--accuracy",
                                                          ".1,.1,.1,.1,.1,.1", "--json", NULL});
    check_says(&process, "\"laying\": {\n    \"farthest\": 343774.");
    run_well(&process, folder.text, (const char *const[]){"far.csv", "--joints", "20,40", "--accuracy",
                                                          ".1,.1,.1,.1,.1,.1", "--json", "--as-is", NULL});
    check_silent(&process, "laying");
}

/* What has nothing to be laid along, and what is too large to be laid, stays as it is. */
static void test_what_cannot_be_laid_stays(void)
{
    static const armtol_link fixed = {.d = 4}, far[2] = {{ARMTOL_NPR, ARMTOL_REVOLUTE, .d = 1e308},
                                                         {ARMTOL_NPR, ARMTOL_REVOLUTE, .d = 1e308}};
    static const armtol_drive drives[2];
    arm_model model;
    armtol_arm arm = {.name = "", .title = "", .source = "", .n_links = 1, .links = &fixed, .drives = drives};
    TEST_ASSERT_TRUE(arm_model_make(&model, &arm, UNIT_RADIAN));
    TEST_ASSERT_TRUE(arm_laying_gather(&model) && arm_laying_snap(&model, ARMTOL_USUAL_SNAP));
    TEST_ASSERT_EQUAL(1, model.arm.n_links);
    arm_model_free(&model);
    arm.links = far;
    arm.n_links = 2;
    TEST_ASSERT_TRUE(arm_model_make(&model, &arm, UNIT_RADIAN));
    TEST_ASSERT_TRUE(arm_laying_gather(&model) && arm_laying_snap(&model, ARMTOL_USUAL_SNAP));
    TEST_ASSERT_EQUAL(2, model.arm.n_links);
    TEST_ASSERT_EQUAL(0, model.laying.farthest);
    arm_model_free(&model);
}

/* Of its names that of the fixed foot, whose joint is tilted, stays as well. */
static void test_names_of_what_is_laid_anew(void)
{
    const string folder = folder_new(), file = string_of("%s/named.csv", folder.text);
    process process;
    file_write(file.text, "units: mm deg\nname joint a alpha d theta\nfoot fixed 0 90 40 0\n"
                          "swing theta 0 0.05 -343774.5898120269 90\nlift theta 250 0 343774.7207117291 -90\n"
                          "hand fixed 0 90 0 30\n");
    run_well(&process, folder.text, (const char *const[]){"named.csv", "--show", NULL});
    check_says(&process, "# Laid anew: ");
    const char *at = process.output.bytes;
    for (size_t i = 0; i < 4; i++) {
        static const char *const names[] = {"foot", "swing", "lift", "hand"};
        at = strstr(at, names[i]);
        TEST_ASSERT_NOT_NULL_MESSAGE(at, names[i]);
    }
}

static void test_snap_has_a_range(void)
{
    static const char *const wrong[] = {"-1e-9", "0.02", "x"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        process process;
        run(&process, NULL, (const char *const[]){"ur5e", "--show", "--snap", wrong[i], NULL});
        process_check_status(&process, 2, wrong[i]);
        TEST_ASSERT_TRUE_MESSAGE(strncmp(process.errors.bytes, "armtol: --snap: ", 16) == 0, process.errors.bytes);
    }
}

#ifdef TEST_URDF

/* ---- robots ---- */

/* A wrist whose tool is turned by half a turn, that of an arm on a tilted foot; both written with so many digits. */
static void write_robot(const char *file, const char *half, const char *quarter, const char *back)
{
    char text[4000];
    snprintf(
        text, sizeof text,
        "<robot name='pecker'><link name='a'/><link name='b'/><link name='c'/><link name='d'/><link name='e'/>\n"
        "<joint name='j1' type='continuous'><parent link='a'/><child link='b'/><origin xyz='0 0 0.3' rpy='%s 0 0'/>"
        "<axis xyz='0 0 -1'/></joint>\n"
        "<joint name='j2' type='continuous'><parent link='b'/><child link='c'/><origin xyz='0 0 -0.1' rpy='%s 0 0'/>"
        "<axis xyz='0 0 1'/></joint>\n"
        "<joint name='j3' type='continuous'><parent link='c'/><child link='d'/><origin xyz='0.3 0 0.05' rpy='0 0 %s'/>"
        "<axis xyz='0 0 1'/></joint>\n"
        "<joint name='f' type='fixed'><parent link='d'/><child link='e'/><origin xyz='0 0 0.09' rpy='%s 0 %s'/></joint>"
        "</robot>\n",
        half, quarter, back, half, quarter);
    file_write(file, text);
}

#define ASKED "pecker.urdf", "--joints", ".4,-.7,.3", "--accuracy", ".0005,.0005,.0005,.002,.002,.002"

/* All but the last digits of every number of two tables are the same. */
static void check_same_tolerances(const process *expected, const process *actual)
{
    const char *one = expected->output.bytes, *other = actual->output.bytes;
    while (*one != '\0') {
        char *end_of_one, *end_of_other;
        const double value = strtod(one, &end_of_one), is = strtod(other, &end_of_other);
        if (end_of_one == one) {
            TEST_ASSERT_EQUAL_STRING_LEN(one, other, 1);
            one++, other++;
        } else {
            check_within(0.01 * fabs(value) + 2e-5, value, is, "%.20s", one);
            one = end_of_one, other = end_of_other;
        }
    }
    TEST_ASSERT_EQUAL('\0', *other);
}

static void test_digits_decide_nothing(void)
{
    static const char *const numbers[][3] = {
        {"3.141592653589793", "-1.5707963267948966", "1.5707963267948966"},
        {"3.14159265359", "-1.570796326795", "1.570796326795"},
        {"3.1415926536", "-1.5707963268", "1.5707963268"},
        {"3.141593", "-1.570796", "1.570796"},
        {"3.14159", "-1.5708", "1.5708"},
        {"-3.14159", "-1.5708", "1.5708"},
    };
    const string folder = folder_new(), file = string_of("%s/pecker.urdf", folder.text);
    process exact, rounded;
    write_robot(file.text, numbers[0][0], numbers[0][1], numbers[0][2]);
    run_well(&exact, folder.text, (const char *const[]){ASKED, "--csv", NULL});
    for (size_t i = 1; i < sizeof numbers / sizeof numbers[0]; i++) {
        write_robot(file.text, numbers[i][0], numbers[i][1], numbers[i][2]);
        run_well(&rounded, folder.text, (const char *const[]){ASKED, "--csv", NULL});
        check_same_tolerances(&exact, &rounded);
    }
}

static void test_what_is_taken_for_exact_is_said(void)
{
    const string folder = folder_new(), file = string_of("%s/pecker.urdf", folder.text);
    process process;
    write_robot(file.text, "3.14159", "-1.5707963267948966", "0");
    run_well(&process, folder.text, (const char *const[]){ASKED, NULL});
    check_says(&process, "Taken for exact (--snap): the base's z axis and axis 1 coincide (but for\n2.65e-06 rad and ");
    check_says(&process, "Taken for exact (--snap): axis 3 and the tool's z axis coincide (but for\n2.65e-06 rad and ");
    run_well(&process, folder.text, (const char *const[]){ASKED, "--json", NULL});
    check_says(&process, "\"snapped\": [\n      {\n        \"axis\": 0,\n        \"relation\": \"coincident\",\n"
                         "        \"angle\": 2.6535897");
    run_well(&process, folder.text, (const char *const[]){ASKED, "--snap", "0", NULL});
    check_silent(&process, "Taken for exact");
    run_well(&process, folder.text, (const char *const[]){"pecker.urdf", "--show", "--degrees", NULL});
    check_says(&process,
               "# Taken for exact (--snap): axis 3 and the tool's z axis coincide (but for 0.000152 deg and ");
}

static void test_neighbours_that_are_parallel(void)
{
    const string folder = folder_new(), file = string_of("%s/pair.urdf", folder.text);
    process process;
    file_write(file.text,
               "<robot name='pair'><link name='a'/><link name='b'/><link name='c'/>"
               "<joint name='j1' type='continuous'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/></joint>"
               "<joint name='j2' type='continuous'><parent link='b'/><child link='c'/>"
               "<origin xyz='0.3 0 0' rpy='0.000003 0 0'/><axis xyz='0 0 1'/></joint></robot>");
    run_well(&process, folder.text, (const char *const[]){"pair.urdf", "--show", NULL});
    check_says(&process, "# Taken for exact (--snap): axes 1 and 2 are parallel (but for 3e-06 rad and 0 m).\n");
}

#endif

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_table_laid_anew_is_the_same_arm);
    RUN_TEST(test_motions_go_with_their_joints);
    RUN_TEST(test_masses_stay_where_they_are);
    RUN_TEST(test_a_table_laid_anew_says_so);
    RUN_TEST(test_names_of_what_is_laid_anew);
    RUN_TEST(test_what_cannot_be_laid_stays);
    RUN_TEST(test_snap_has_a_range);
#ifdef TEST_URDF
    RUN_TEST(test_digits_decide_nothing);
    RUN_TEST(test_what_is_taken_for_exact_is_said);
    RUN_TEST(test_neighbours_that_are_parallel);
#endif
    return UNITY_END();
}
