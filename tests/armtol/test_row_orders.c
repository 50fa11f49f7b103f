/*
 * Tables in Craig's order, held against a plain product in that order; signs, coupled joints, numbers as expressions.
 */

#include "armtol/arm.h"
#include "armtol/link_transform.h"
#include "armtol/tables/arm_file.h"
#include "armtol/tables/expression.h"
#include "console/message.h"

#include "fuzz/motion.h"
#include "support/check.h"
#include "support/random.h"
#include "support/said.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_ROWS = 10, MOST_TEXT = 4000 };

static const double pi = 3.14159265358979323846;

void setUp(void)
{
}

void tearDown(void)
{
}

static bool read_text(const char *text, arm_model *model, said *said)
{
    FILE *const stream = stream_of(text, strlen(text));
    said_begin();
    const bool fine = arm_file_read(stream, "arm.csv", model);
    said_end(said);
    fclose(stream);
    return fine;
}

static void read_fine(const char *text, arm_model *model)
{
    said said;
    const bool fine = read_text(text, model, &said);
    TEST_ASSERT_EQUAL_STRING("", said.text);
    TEST_ASSERT_TRUE(fine);
}

static void check_refused(const char *expected, const char *text)
{
    arm_model model;
    said said;
    char line[1000];
    TEST_ASSERT_FALSE_MESSAGE(read_text(text, &model, &said), text);
    snprintf(line, sizeof line, "armtol: arm.csv:%s\n", expected);
    TEST_ASSERT_EQUAL_STRING(line, said.text);
}

static void write_text(const armtol_arm *arm, row_order order, angle_unit unit, char text[MOST_TEXT])
{
    FILE *const stream = tmpfile();
    TEST_ASSERT_NOT_NULL(stream);
    TEST_ASSERT_TRUE(arm_file_write(arm, order, unit, stream));
    rewind(stream);
    text[fread(text, 1, MOST_TEXT - 1, stream)] = '\0';
    fclose(stream);
}

static void check_same_tool(const armtol_transform *expected, const armtol_arm *arm, const double q[], size_t n_joints)
{
    armtol_link placed[MOST_ROWS + 1];
    TEST_ASSERT_TRUE(arm->n_links <= MOST_ROWS + 1);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_arm_place(arm, q, n_joints, placed));
    const armtol_transform tool = armtol_chain_transform(placed, arm->n_links, &armtol_errata_none);
    const motion_difference difference = motion_compare(expected, &tool);
    check_within(1e-12, 0, difference.angle, "angle");
    check_within(1e-10, 0, difference.length, "length");
}

/* ---- Craig's order ---- */

static const double x[] = {1, 0, 0}, y[] = {0, 1, 0}, z[] = {0, 0, 1};

/* Rot(x, alpha) Trans(a, 0, 0) Rot(y, beta) Rot(z, theta) Trans(0, 0, d), row after row. */
static armtol_transform product_of(const armtol_link rows[], size_t n_rows, const double q[])
{
    armtol_transform product = motion_along(x, 0);
    for (size_t i = 0; i < n_rows; i++) {
        const armtol_link *row = &rows[i];
        const double moved = row->joint == ARMTOL_FIXED ? 0 : *q++;
        const armtol_transform steps[] = {
            motion_about(x, row->alpha), motion_along(x, row->a), motion_about(y, row->beta),
            motion_about(z, row->theta + (row->joint == ARMTOL_REVOLUTE ? moved : 0)),
            motion_along(z, row->d + (row->joint == ARMTOL_PRISMATIC ? moved : 0))};
        for (size_t k = 0; k < sizeof steps / sizeof steps[0]; k++) {
            product = motion_product(&product, &steps[k]);
        }
    }
    return product;
}

static const char *const joint_names[] = {
    [ARMTOL_FIXED] = "fixed", [ARMTOL_REVOLUTE] = "theta", [ARMTOL_PRISMATIC] = "d"};

static void print_rows(const armtol_link rows[], size_t n_rows, char text[MOST_TEXT])
{
    size_t at = (size_t)snprintf(text, MOST_TEXT, "order: craig\nunits: mm rad\njoint,a,alpha,d,theta,beta\n");
    for (size_t i = 0; i < n_rows; i++) {
        at += (size_t)snprintf(text + at, MOST_TEXT - at, "%s,%.17g,%.17g,%.17g,%.17g,%.17g\n",
                               joint_names[rows[i].joint], rows[i].a, rows[i].alpha, rows[i].d, rows[i].theta,
                               rows[i].beta);
    }
}

/* Some numbers are 0, at the ends of the table too. */
static double draw(random_source *random, double most)
{
    return random_between(random, 0, 3) < 1 ? 0 : random_between(random, -most, most);
}

static size_t draw_rows(random_source *random, armtol_link rows[MOST_ROWS])
{
    const size_t n = 1 + (size_t)random_between(random, 0, MOST_ROWS);
    for (size_t i = 0; i < n; i++) {
        rows[i] = (armtol_link){
            .joint = (armtol_joint)random_between(random, 0, ARMTOL_JOINT_COUNT),
            .a = draw(random, 500),
            .alpha = draw(random, pi),
            .d = draw(random, 500),
            .theta = draw(random, pi),
            .beta = random_between(random, 0, 4) < 1 ? draw(random, 0.1) : 0,
        };
    }
    return n;
}

static size_t count_joints(const armtol_link rows[], size_t n_rows)
{
    size_t count = 0;
    for (size_t i = 0; i < n_rows; i++) {
        count += rows[i].joint != ARMTOL_FIXED;
    }
    return count;
}

/* The tool is where the plain product has it, and the table in that order stays the same once it was written. */
static void check_drawn(random_source *random)
{
    static char text[MOST_TEXT], once[MOST_TEXT], twice[MOST_TEXT];
    armtol_link rows[MOST_ROWS];
    double q[MOST_ROWS];
    arm_model model, again;
    const size_t n = draw_rows(random, rows), n_joints = count_joints(rows, n);
    for (size_t i = 0; i < n_joints; i++) {
        q[i] = random_between(random, -3, 3);
    }
    const armtol_transform expected = product_of(rows, n, q);
    print_rows(rows, n, text);
    read_fine(text, &model);
    check_same_tool(&expected, &model.arm, q, n_joints);
    write_text(&model.arm, ORDER_CRAIG, UNIT_RADIAN, once);
    read_fine(once, &again);
    check_same_tool(&expected, &again.arm, q, n_joints);
    write_text(&again.arm, ORDER_CRAIG, UNIT_RADIAN, twice);
    TEST_ASSERT_EQUAL_STRING(once, twice);
    arm_model_free(&model);
    arm_model_free(&again);
}

static void test_a_table_in_craigs_order_has_the_kinematics_of_its_product(void)
{
    random_source random = {1986};
    for (int i = 0; i < 400; i++) {
        check_drawn(&random);
    }
}

static const char craig_table[] =
    "name: arm\n"
    "title: arm\n"
    "source: not given\n"
    "order: craig\n"
    "units: mm deg\n"
    "\n"
    "kind, joint,     a, alpha,     d, theta, sign, couple, multiplier, offset, low, high\n"
    "npr,  theta,    50,   180,   100,     0,    1,      -,          -,      -,  -9,    9\n"
    "ppr,  theta,     0,   -90, 243.5,    30,   -1,      -,          -,      -,   -,    -\n"
    "npr,  theta, 431.8,     0, -93.4,     0,    1,      1,       -0.5,     10,   -,    -\n"
    "npp,  d,     -20.3,    90, 433.1,    90,    1,      -,          -,      -,   0,   30\n"
    "npr,  fixed,   0.5,     0,    25,     0,    -,      -,          -,      -,   -,    -\n"
    "npr,  fixed,     0,    45,     0,     0,    -,      -,          -,      -,   -,    -\n";

static void test_a_table_in_craigs_order_is_shown_as_it_was(void)
{
    static char text[MOST_TEXT];
    arm_model model;
    read_fine(craig_table, &model);
    write_text(&model.arm, ORDER_CRAIG, UNIT_DEGREE, text);
    TEST_ASSERT_EQUAL_STRING(craig_table, text);

    /* In ours a and alpha are one row higher, what the first row has is a fixed link, and the last row is none. */
    TEST_ASSERT_EQUAL_UINT(6, model.arm.n_links);
    const armtol_link *links = model.arm.links;
    TEST_ASSERT_EQUAL_INT(ARMTOL_FIXED, links[0].joint);
    check_same(50, links[0].a, "a of the base");
    check_same(pi, links[0].alpha, "alpha of the base");
    check_same(-pi / 2, links[1].alpha, "alpha of joint 1");
    check_same(431.8, links[2].a, "a of joint 2");
    check_same(pi / 4, links[5].alpha, "alpha of the tool");
    TEST_ASSERT_EQUAL_UINT(2, model.arm.motions[3].follows);
    arm_model_free(&model);
}

/* The other way round: an arm of ours is not changed by the way through Craig's order, also at ends that do nothing. */
static void test_every_built_in_arm_is_the_same_in_craigs_order(void)
{
    static char text[MOST_TEXT], before[MOST_TEXT], after[MOST_TEXT];
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        arm_model model;
        write_text(armtol_arm_at(i), ORDER_CRAIG, UNIT_RADIAN, text);
        read_fine(text, &model);
        write_text(armtol_arm_at(i), ORDER_PAUL, UNIT_RADIAN, before);
        write_text(&model.arm, ORDER_PAUL, UNIT_RADIAN, after);
        TEST_ASSERT_EQUAL_STRING(before, after);
        arm_model_free(&model);
    }
}

#define HEAD "units: mm rad\njoint,a,alpha,d,theta\n"

static void test_which_order_it_is(void)
{
    arm_model model;
    read_fine("order: Modified\nunits: mm rad\njoint,a_{i-1},alpha(i-1),d,theta\ntheta,0,0,0,0\ntheta,3,1,0,0\n",
              &model);
    check_same(3, model.arm.links[0].a, "a");
    arm_model_free(&model);
    read_fine("order: standard\n" HEAD "theta,3,1,0,0\n", &model);
    check_same(3, model.arm.links[0].a, "a");
    arm_model_free(&model);
    check_refused(
        "1:8: unknown order \"denavit\"; expected paul (standard: a row has a and alpha of its own link, often 0 in "
        "the last row) or craig (modified: of the link before, often 0 in the first row)",
        "order: denavit\n" HEAD "theta,0,0,0,0\n");
    check_refused("2:1: a second \"order\"", "order: craig\norder: craig\n" HEAD);
}

static void test_columns_of_the_link_before_ask_for_the_order(void)
{
    check_refused(
        "2:9: \"alpha_i-1\" is of the link before, as in Craig's order; expected a line \"order: craig\" above the "
        "table",
        "units: mm rad\njoint,a,alpha_i-1,d,theta\ntheta,0,0,0,0\n");
    check_refused("3:7: unknown column \"d_{i-1}\"; expected name, kind, joint, a, alpha, d, theta, beta, sign, "
                  "couple, multiplier, "
                  "offset, low, high, backlash, compliance or stiffness, moment, resolution or bits, friction, noise, "
                  "mass, com_x, com_y "
                  "or com_z",
                  "order: craig\nunits: mm rad\njoint,d_{i-1},alpha,a,theta\ntheta,0,0,0,0\n");
}

/* ---- signs and coupled joints ---- */

static void test_what_a_joint_follows(void)
{
    static const double q[] = {0.4, 0.3};
    arm_model model;
    read_fine("units: mm deg\njoint,a,alpha,d,theta,sign,couple,multiplier,offset\n"
              "theta,100,0,0,10,-1,-,-,-\nd,0,90,50,0,1,,,\ntheta,7,0,0,0,-1,0,0.5,30\nd,0,0,0,0,1,0,20,5\n", &model);
    TEST_ASSERT_EQUAL_UINT(2, armtol_arm_joint_count(&model.arm));
    armtol_link placed[4];
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_arm_place(&model.arm, q, 2, placed));
    check_within(1e-15, pi / 18 - 0.4, placed[0].theta, "a joint that counts the other way");
    check_within(1e-15, 50.3, placed[1].d, "a joint of its own");
    check_within(1e-15, -(0.5 * 0.4 + pi / 6), placed[2].theta, "a follower that counts the other way");
    check_within(1e-15, 20 * 0.4 + 5, placed[3].d, "lengths for a radian");
    check_within(0, 20 * 0.4 + 5, armtol_arm_joint_value(&model.arm, q, 3), "its value");
    arm_model_free(&model);
}

#define COUPLED(rows) "units: mm rad\njoint,a,alpha,d,theta,sign,couple,multiplier\n" rows

static void test_what_cannot_be_followed(void)
{
    check_refused("3:19: couple: the joint follows that of row 7, and there is no such row; rows are counted from 0",
                  COUPLED("theta,0,0,0,0,1,  7,1\n"));
    check_refused("4:17: couple: the joint follows that of row 0, which has no joint",
                  COUPLED("fixed,0,0,0,0\ntheta,0,0,0,0,1,0,1\n"));
    check_refused(
        "4:17: couple: the joint follows that of row 2, which follows another itself; expected the row of the joint "
        "that the motor moves",
        COUPLED("theta,0,0,0,0\ntheta,0,0,0,0,1,2\ntheta,0,0,0,0,1,0\n"));
    check_refused("3:17: couple: the joint follows that of row 0, which is its own", COUPLED("theta,0,0,0,0,1,0\n"));
    check_refused("3:17: couple: \"-1\" is not the number of a row", COUPLED("theta,0,0,0,0,1,-1\n"));
    check_refused("3:17: couple: \"1000000\" is not the number of a row", COUPLED("theta,0,0,0,0,1,1000000\n"));
    check_refused("3:18: multiplier without couple; expected the number of the row whose joint this one follows",
                  COUPLED("theta,0,0,0,0,1,,2\n"));
    check_refused("3:15: sign: \"-\" is neither 1 nor -1", COUPLED("theta,0,0,0,0,-\n"));
    check_refused("3:15: sign: \"2\" is neither 1 nor -1", COUPLED("theta,0,0,0,0,2\n"));
    check_refused("4:15: a fixed link has no sign; expected - or an empty cell",
                  COUPLED("theta,0,0,0,0\nfixed,0,0,0,0,1\n"));
    check_refused("4:17: a fixed link has no couple; expected - or an empty cell",
                  COUPLED("theta,0,0,0,0\nfixed,0,0,0,0,-,0\n"));
}

static void test_a_motion_that_is_wrong(void)
{
    static const armtol_link links[] = {
        {ARMTOL_NPR, ARMTOL_REVOLUTE}, {ARMTOL_NPR, ARMTOL_REVOLUTE}, {ARMTOL_NPR, ARMTOL_FIXED}};
    static const double q[] = {0.1, 0.2};
    armtol_motion motions[] = {{0, 1, 0, 1}, {0, 2, 0.5, -1}, {9, 0, 0, 0}};
    const armtol_arm arm = {.n_links = 3, .links = links, .motions = motions};
    armtol_link placed[3] = {{.a = 7}};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_arm_check(&arm));
    TEST_ASSERT_EQUAL_INT(ARMTOL_WRONG_SIZE, armtol_arm_place(&arm, q, 2, placed));
    motions[1].follows = 2;
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_JOINT, armtol_arm_place(&arm, q, 1, placed));
    motions[1].follows = 3;
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_JOINT, armtol_arm_check(&arm));
    motions[1] = (armtol_motion){0, 2, 0, 0.5};
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_JOINT, armtol_arm_check(&arm));
    motions[1] = (armtol_motion){0, (double)NAN, 0, 1};
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_arm_check(&arm));
    motions[1] = (armtol_motion){0, 1e300, 0, 1};
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_arm_place(&arm, (const double[]){1e10}, 1, placed));
    motions[1] = (armtol_motion){1, (double)NAN, (double)NAN, 1};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_arm_check(&arm));
    check_same(7, placed[0].a, "untouched");
    check_same(0, armtol_arm_joint_value(&arm, q, 2), "of a fixed link");
}

/* ---- numbers ---- */

static void check_number(double expected, bool expected_pi, const char *text)
{
    double value = -7;
    bool has_pi;
    TEST_ASSERT_EQUAL_INT_MESSAGE(NUMBER_FINE, expression_parse(text, &value, &has_pi), text);
    check_within(0, expected, value, "%s", text);
    TEST_ASSERT_EQUAL_INT_MESSAGE(expected_pi, has_pi, text);
}

static void test_numbers_as_papers_write_them(void)
{
    check_number(0x1.921fb54442d18p+0, true, "pi/2");
    check_number(-0x1.2d97c7f3321d2p+1, true, "-3*pi/4");
    check_number(0x1.921fb54442d18p+1, true, "+PI");
    check_number(0x1.921fb54442d18p+2, true, "2 * \xcf\x80");
    check_number(0x1p-13, false, "2^-13");
    check_number(-0x1p-13, false, "-2^-13");
    check_number(0x1p10, false, "2^+10");
    check_number(1, false, "7^0");
    check_number(0.75, false, "3/2/2");
    check_number(300, false, "1e2*3");
    check_number(0.5, false, ".5");
    check_number(9, true, "9*pi/pi");
}

static void test_what_is_no_number(void)
{
    static const struct {
        number_fault fault;
        const char *text;
    } wrong[] = {
        {NUMBER_NONE, ""},
        {NUMBER_NONE, "pi/"},
        {NUMBER_NONE, "*2"},
        {NUMBER_NONE, "--2"},
        {NUMBER_NONE, "2pi"},
        {NUMBER_NONE, "pi 2"},
        {NUMBER_NONE, "2^0.5"},
        {NUMBER_NONE, "2^1001"},
        {NUMBER_NONE, "2^pi"},
        {NUMBER_NONE, "2^"},
        {NUMBER_NONE, "2^^2"},
        {NUMBER_NONE, "2+3"},
        {NUMBER_NONE, "(2)"},
        {NUMBER_NONE, "2*-3"},
        {NUMBER_NONE, "1.2.3*1"},
        {NUMBER_TOO_LARGE, "1/0"},
        {NUMBER_TOO_LARGE, "0/0"},
        {NUMBER_TOO_LARGE, "10^999"},
        {NUMBER_TOO_LARGE, "1e200*1e200"},
        {NUMBER_TOO_LARGE, "2*1e999"},
        {NUMBER_TOO_LONG, "2*1000000000000000000000000000000000000000000000000000000000000000000000000000000000000"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        double value = -7;
        bool has_pi;
        TEST_ASSERT_EQUAL_INT_MESSAGE(wrong[i].fault, expression_parse(wrong[i].text, &value, &has_pi), wrong[i].text);
        check_same(-7, value, "untouched");
    }
}

static void test_expressions_in_a_table(void)
{
    arm_model model;
    read_fine("units: in deg\njoint;a;alpha;d;theta;low\ntheta;2^-13;360/8;-3,5*2;0;-720/2\n", &model);
    TEST_ASSERT_EQUAL_INT(ARMTOL_INCH, model.arm.unit);
    check_same(0x1p-13, model.arm.links[0].a, "a");
    check_same(pi / 4, model.arm.links[0].alpha, "alpha");
    check_same(-7, model.arm.links[0].d, "d");
    check_same(-2 * pi, model.arm.drives[0].low, "low");
    arm_model_free(&model);
    read_fine(HEAD "theta,0,-pi/2,0,0\n", &model);
    check_same(-pi / 2, model.arm.links[0].alpha, "alpha");
    arm_model_free(&model);
    check_refused("3:9: alpha: \"pi/2\" has pi in it, and the table is in degrees",
                  "units: mm deg\njoint,a,alpha,d,theta\ntheta,0,pi/2,0,0\n");
    check_refused("3:7: a: \"1/0\" is too large a number", HEAD "theta,1/0,0,0,0\n");
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_a_table_in_craigs_order_has_the_kinematics_of_its_product);
    RUN_TEST(test_a_table_in_craigs_order_is_shown_as_it_was);
    RUN_TEST(test_every_built_in_arm_is_the_same_in_craigs_order);
    RUN_TEST(test_which_order_it_is);
    RUN_TEST(test_columns_of_the_link_before_ask_for_the_order);
    RUN_TEST(test_what_a_joint_follows);
    RUN_TEST(test_what_cannot_be_followed);
    RUN_TEST(test_a_motion_that_is_wrong);
    RUN_TEST(test_numbers_as_papers_write_them);
    RUN_TEST(test_what_is_no_number);
    RUN_TEST(test_expressions_in_a_table);
    return UNITY_END();
}
