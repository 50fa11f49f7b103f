#include "armtol/urdf/urdf.h"

#include "armtol/arm.h"
#include "armtol/error_matrix.h"
#include "armtol/link_transform.h"
#include "console/message.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"
#include "support/said.h"
#include "unity.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum { MOST_TEXT = 1 << 15, MOST_JOINTS = 12, MOST_LINKS = MOST_JOINTS + 2 };

static const double pi = 3.14159265358979323846;

/* ---- reading, with what is said of it ---- */

void setUp(void)
{
}

void tearDown(void)
{
}

static bool read_stream(FILE *stream, const char *path, const char *base, const char *tip, arm_model *model,
                        said *said)
{
    said_begin();
    const bool fine = urdf_read(stream, path, base, tip, model);
    said_end(said);
    fclose(stream);
    return fine;
}

static void read_text(const char *text, const char *base, const char *tip, arm_model *model)
{
    said said;
    const bool fine = read_stream(stream_of(text, strlen(text)), "some/arm.urdf", base, tip, model, &said);
    TEST_ASSERT_EQUAL_STRING("", said.text);
    TEST_ASSERT_TRUE(fine);
}

static void read_ur5e(const char *base, arm_model *model)
{
    said said;
    FILE *const stream = fopen(TEST_UR5E, "r");
    TEST_ASSERT_NOT_NULL(stream);
    const bool fine = read_stream(stream, TEST_UR5E, base, "tool0", model, &said);
    TEST_ASSERT_EQUAL_STRING("", said.text);
    TEST_ASSERT_TRUE(fine);
}

/* ---- where the joints of a URDF bring its last link, in long double ---- */

typedef enum joint_type { FIXED, REVOLUTE, PRISMATIC } joint_type;

typedef struct joint {
    joint_type type;
    double xyz[3], rpy[3], axis[3];
} joint;

typedef long double matrix[4][4];

static void multiply(matrix left, matrix right)
{
    matrix product = {{0}};
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            for (int k = 0; k < 4; k++) {
                product[i][j] += left[i][k] * right[k][j];
            }
        }
    }
    memcpy(left, product, sizeof product);
}

/* Euler and Rodrigues: a turn about a unit vector. */
static void turn(matrix m, const long double u[3], long double angle)
{
    const long double c = cosl(angle), s = sinl(angle);
    matrix r = {{0}};
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        r[i][i] = c + (1 - c) * u[i] * u[i];
        r[i][j] = (1 - c) * u[i] * u[j] - s * u[k];
        r[i][k] = (1 - c) * u[i] * u[k] + s * u[j];
    }
    r[3][3] = 1;
    multiply(m, r);
}

static void shift(matrix m, const long double by[3])
{
    for (int i = 0; i < 3; i++) {
        m[i][3] += m[i][0] * by[0] + m[i][1] * by[1] + m[i][2] * by[2];
    }
}

static void apply_joint(matrix m, const joint *joint, double q)
{
    static const long double x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
    shift(m, (long double[]){joint->xyz[0], joint->xyz[1], joint->xyz[2]});
    turn(m, z, joint->rpy[2]);
    turn(m, y, joint->rpy[1]);
    turn(m, x, joint->rpy[0]);
    long double u[3] = {joint->axis[0], joint->axis[1], joint->axis[2]};
    const long double length = sqrtl(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    if (joint->type != FIXED) {
        for (int i = 0; i < 3; i++) {
            u[i] *= (joint->type == PRISMATIC ? q : 1) / length;
        }
        joint->type == PRISMATIC ? shift(m, u) : turn(m, u, q);
    }
}

static size_t count_moving(const joint joints[], size_t n)
{
    size_t count = 0;
    for (size_t i = 0; i < n; i++) {
        count += joints[i].type != FIXED;
    }
    return count;
}

/* The arm's tool is where the joints bring it, at values drawn at random and at 0. */
static void check_kinematics(const joint joints[], size_t n, const armtol_arm *arm, random_source *source)
{
    double q[MOST_JOINTS] = {0};
    TEST_ASSERT_EQUAL(count_moving(joints, n), armtol_joint_count(arm->links, arm->n_links));
    for (int pose = 0; pose < 10; pose++) {
        armtol_link placed[MOST_LINKS];
        double actual[4][4];
        matrix expected = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
        size_t moving = 0;
        for (size_t i = 0; i < n; i++) {
            apply_joint(expected, &joints[i], joints[i].type != FIXED ? q[moving++] : 0);
        }
        TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_links_place(arm->links, arm->n_links, q, moving,
                                                        &armtol_errata_none, placed));
        reference_chain(placed, arm->n_links, actual);
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++) {
                check_within(1e-9, (double)expected[i][j], actual[i][j], "row %d, column %d", i, j);
            }
        }
        for (size_t i = 0; i < moving; i++) {
            q[i] = random_between(source, -3, 3);
        }
    }
}

/* The kinds of an arm's links, "npr ppr"; a fixed link's in brackets. */
static void check_kinds(const char *expected, const armtol_arm *arm)
{
    char kinds[MOST_LINKS * 8] = "";
    for (size_t i = 0; i < arm->n_links; i++) {
        const bool fixed = arm->links[i].joint == ARMTOL_FIXED;
        strcat(strcat(strcat(strcat(kinds, i > 0 ? " " : ""), fixed ? "[" : ""),
                      armtol_kind_name(arm->links[i].kind)), fixed ? "]" : "");
    }
    TEST_ASSERT_EQUAL_STRING(expected, kinds);
}

/* ---- the UR5e ---- */

/* The numbers of ur5e.urdf, from base_link to tool0. */
static const joint ur5e[] = {
    {FIXED, {0, 0, 0}, {0, 0, 3.141592653589793}, {0}},
    {REVOLUTE, {0, 0, 0.1625}, {0, 0, 0}, {0, 0, 1}},
    {REVOLUTE, {0, 0, 0}, {1.570796327, 0, 0}, {0, 0, 1}},
    {REVOLUTE, {-0.425, 0, 0}, {0, 0, 0}, {0, 0, 1}},
    {REVOLUTE, {-0.3922, 0, 0.1333}, {0, 0, 0}, {0, 0, 1}},
    {REVOLUTE, {0, -0.0997, -2.044881182297852e-11}, {1.570796327, 0, 0}, {0, 0, 1}},
    {REVOLUTE, {0, 0.09959999999999999, -2.042830148012698e-11},
     {1.570796326589793, 3.141592653589793, 3.141592653589793}, {0, 0, 1}},
    {FIXED, {0, 0, 0}, {0, -1.5707963267948966, -1.5707963267948966}, {0}},
    {FIXED, {0, 0, 0}, {1.5707963267948966, 0, 1.5707963267948966}, {0}},
};

enum { UR5E_JOINTS = sizeof ur5e / sizeof ur5e[0] };

static void test_the_tool_of_the_ur5e_is_where_its_file_puts_it(void)
{
    random_source source = {1};
    arm_model model;
    read_ur5e("base_link", &model);
    check_kinds("npr ppr ppr npr npr npr", &model.arm);
    check_kinematics(ur5e, UR5E_JOINTS, &model.arm, &source);
    arm_model_free(&model);
    read_ur5e("base_link_inertia", &model);
    check_kinds("npr ppr ppr npr npr npr", &model.arm);
    check_kinematics(ur5e + 1, UR5E_JOINTS - 1, &model.arm, &source);
    arm_model_free(&model);
}

static void test_the_ur5e_has_the_lengths_of_its_maker_s_table(void)
{
    static const double d[6] = {0.1625, 0, 0, 0.1333, 0.0997, 0.0996}, a[6] = {0, 0.425, 0.3922, 0, 0, 0};
    arm_model model;
    read_ur5e("base_link", &model);
    for (int i = 0; i < 6; i++) {
        const armtol_link *const link = &model.arm.links[i];
        check_within(1e-12, d[i], fabs(link->d), "d %d", i);
        check_within(1e-12, a[i], link->a, "a %d", i);
        check_within(3e-10, i == 1 || i == 2 || i == 5 ? 0 : pi / 2, fabs(link->alpha), "alpha %d", i);
        check_same(0, link->beta, "beta");
    }
    check_same(0, model.arm.links[1].alpha, "alpha of parallel axes");
    check_same(0, model.arm.links[2].alpha, "alpha of parallel axes");
    check_same(0, model.arm.links[0].a, "a of axes that meet");
    check_same(0, model.arm.links[4].a, "a of axes that meet");
    arm_model_free(&model);
}

static void matrix_of(const armtol_arm *arm, const double q[], double tool[4][4], double matrix[6 * 24])
{
    armtol_link placed[6];
    TEST_ASSERT_EQUAL(6, arm->n_links);
    TEST_ASSERT_EQUAL(24, armtol_column_count(arm->links, arm->n_links));
    TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_links_place(arm->links, 6, q, 6, &armtol_errata_none, placed));
    TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_error_matrix(placed, 6, &armtol_errata_none, matrix, 24));
    reference_chain(placed, 6, tool);
}

/*
 * The same arm, in millimetres and by the maker's table, is built in: the same pose, and the same A but for
 * signs. The URDF has quarter turns to ten digits, 2e-10 off.
 */
static void test_the_ur5e_is_the_built_in_one(void)
{
    random_source source = {2};
    arm_model model;
    const armtol_arm *const built_in = armtol_arm_named("ur5e");
    TEST_ASSERT_NOT_NULL(built_in);
    read_ur5e("base_link_inertia", &model);
    armtol_column columns[24];
    TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_columns(model.arm.links, 6, columns, 24));
    for (int n = 0; n < 20; n++) {
        double q[6], tool[4][4], expected_tool[4][4], matrix[6 * 24], expected[6 * 24];
        for (int i = 0; i < 6; i++) {
            q[i] = random_between(&source, -3, 3);
        }
        matrix_of(&model.arm, q, tool, matrix);
        matrix_of(built_in, q, expected_tool, expected);
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 4; j++) {
                check_within(1e-6, expected_tool[i][j], (j == 3 ? 1000 : 1) * tool[i][j], "row %d, %d", i, j);
            }
        }
        for (int i = 0; i < 6; i++) {
            for (int k = 0; k < 24; k++) {
                const bool turned = i < 3 && !armtol_parameter_is_length(columns[k].parameter);
                check_within(1e-5, fabs(expected[i * 24 + k]), (turned ? 1000 : 1) * fabs(matrix[i * 24 + k]),
                             "A(%d, %d)", i, k);
            }
        }
    }
    for (int i = 0; i < 6; i++) {
        TEST_ASSERT_EQUAL(built_in->links[i].kind, model.arm.links[i].kind);
    }
    arm_model_free(&model);
}

static void test_what_goes_with_the_ur5e(void)
{
    TEST_ASSERT_TRUE(urdf_is_built_in());
    arm_model model;
    read_ur5e("base_link", &model);
    TEST_ASSERT_EQUAL_STRING("ur5e", model.arm.name);
    TEST_ASSERT_EQUAL_STRING("ur5e", model.arm.title);
    TEST_ASSERT_EQUAL_STRING("URDF file ur5e.urdf, from base_link to tool0", model.arm.source);
    TEST_ASSERT_EQUAL(ARMTOL_METRE, model.arm.unit);
    TEST_ASSERT_EQUAL(UNIT_RADIAN, model.angle_unit);
    for (int i = 0; i < 6; i++) {
        check_within(1e-15, i == 2 ? -pi : -2 * pi, model.arm.drives[i].low, "low %d", i);
        check_within(1e-15, i == 2 ? pi : 2 * pi, model.arm.drives[i].high, "high %d", i);
        TEST_ASSERT_TRUE(isnan(model.arm.drives[i].backlash));
    }
    arm_model_free(&model);
}

/* ---- files drawn at random ---- */

static void draw_joint(random_source *source, joint *joint)
{
    static const double turns[] = {0, 1.5707963267948966, -1.5707963267948966, 3.141592653589793};
    joint->type = (joint_type)random_between(source, 0, 3);
    const bool square = random_between(source, 0, 1) < 0.5;
    const int along = (int)random_between(source, 0, 3);
    for (int i = 0; i < 3; i++) {
        joint->xyz[i] = random_between(source, 0, 1) < 0.4 ? 0 : random_between(source, -1, 1);
        joint->rpy[i] = square ? turns[(int)random_between(source, 0, 4)] : random_between(source, -3, 3);
        joint->axis[i] = square ? (i == along ? -1 : 0) : random_between(source, -5, 5);
    }
}

/* Joints come before the links that they join, and between them what is to be passed over. */
static void write_urdf(const joint joints[], size_t n, char *text)
{
    static const char *const types[] = {"fixed", "continuous", "prismatic"};
    text += sprintf(text, "<robot name='random'>\n");
    for (size_t i = 0; i < n; i++) {
        const joint *const j = &joints[i];
        text += sprintf(text, "<joint name='j%zu' type='%s'><axis xyz='%.17g %.17g %.17g'/>"
                        "<origin xyz='\t%.17g\n%.17g  %.17g ' rpy='%.17g %.17g %.17g'/>"
                        "<dynamics damping='x'/><child link='l%zu'/><parent link='l%zu'/></joint>\n",
                        i, types[j->type],
                        j->axis[0], j->axis[1], j->axis[2], j->xyz[0], j->xyz[1], j->xyz[2], j->rpy[0],
                        j->rpy[1], j->rpy[2], i + 1, i);
    }
    for (size_t i = 0; i <= n; i++) {
        text += sprintf(text, "<link name='l%zu'><visual><origin xyz='not read'/></visual></link>\n", i);
    }
    strcpy(text, "</robot>");
}

static void test_files_drawn_at_random(void)
{
    random_source source = {3};
    for (int n = 0; n < 300; n++) {
        static char text[MOST_TEXT];
        joint joints[MOST_JOINTS];
        const size_t n_joints = (size_t)random_between(&source, 1, MOST_JOINTS + 1);
        arm_model model;
        for (size_t i = 0; i < n_joints; i++) {
            draw_joint(&source, &joints[i]);
        }
        joints[n_joints / 2].type = REVOLUTE;
        write_urdf(joints, n_joints, text);
        read_text(text, NULL, NULL, &model);
        check_kinematics(joints, n_joints, &model.arm, &source);
        arm_model_free(&model);
    }
}

/* ---- what is read, and what is taken where nothing is said ---- */

#define TWO_LINKS "<link name='a'/><link name='b'/>"
#define ENDS "<parent link='a'/><child link='b'/>"
#define ROBOT(content) "<robot name='r'>" content "</robot>"
#define JOINT(type, content) "<joint name='j' type='" type "'>" ENDS content "</joint>"
#define ONE_JOINT(type, content) ROBOT(TWO_LINKS JOINT(type, content))

static void test_the_axis_is_x_where_nothing_is_said(void)
{
    const joint expected[] = {{REVOLUTE, {0}, {0}, {1, 0, 0}}};
    random_source source = {4};
    arm_model model;
    read_text(ONE_JOINT("revolute", ""), NULL, NULL, &model);
    check_kinematics(expected, 1, &model.arm, &source);
    arm_model_free(&model);
    read_text(ONE_JOINT("revolute", "<origin/>"), "a", "b", &model);
    check_kinematics(expected, 1, &model.arm, &source);
    arm_model_free(&model);
}

static void check_limits(const char *text, double low, double high)
{
    arm_model model;
    read_text(text, NULL, NULL, &model);
    TEST_ASSERT_EQUAL(ARMTOL_FIXED, model.arm.links[0].joint);
    const armtol_drive *const drive = &model.arm.drives[1];
    check_same(low, drive->low, "low");
    check_same(high, drive->high, "high");
    TEST_ASSERT_TRUE(model.arm.drives[0].low == -(double)INFINITY && model.arm.drives[0].high == (double)INFINITY);
    arm_model_free(&model);
}

static void test_limits(void)
{
    check_limits(ONE_JOINT("revolute", "<limit lower='-1.5' upper='2.5e0' effort='1'/>"), -1.5, 2.5);
    check_limits(ONE_JOINT("prismatic", "<limit lower='0.1' upper='0.1'/>"), 0.1, 0.1);
    check_limits(ONE_JOINT("prismatic", "<limit upper='0.4'/>"), 0, 0.4);
    check_limits(ONE_JOINT("prismatic", "<limit lower='-0.4'/>"), -0.4, 0);
    check_limits(ONE_JOINT("revolute", "<limit effort='1' velocity='1'/>"), -INFINITY, INFINITY);
    check_limits(ONE_JOINT("revolute", ""), -INFINITY, INFINITY);
    check_limits(ONE_JOINT("continuous", "<limit lower='-1.5' upper='2.5'/>"), -INFINITY, INFINITY);
}

#define HEAVY(name, kg, xyz) \
    "<link name='" name "'><inertial><origin xyz='" xyz "'/><mass value='" kg "'/></inertial></link>"

/* On the base, on the arm, welded to it, on a branch whose joint stands at 0, and on another tree's root. */
static void test_masses_are_carried_by_the_joint_before_them(void)
{
    arm_model model;
    read_text("<robot name='r'>" HEAVY("a", "9", "1 1 1") HEAVY("b", "2", "0.1 0 0") HEAVY("c", "1", "0 0 0.3")
              HEAVY("d", "1", "0 0.2 0") HEAVY("e", "7", "0 0 0")
              "<joint name='1' type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/></joint>"
              "<joint name='2' type='fixed'><origin xyz='0.4 0 0'/><parent link='b'/><child link='c'/></joint>"
              "<joint name='3' type='continuous'><origin xyz='0.2 0 0'/><parent link='b'/><child link='d'/></joint>"
              "<joint name='4' type='fixed'><parent link='a'/><child link='e'/></joint></robot>",
              NULL, "c", &model);
    TEST_ASSERT_EQUAL_UINT(1, model.arm.n_links);
    TEST_ASSERT_NOT_NULL(model.arm.masses);
    const armtol_mass *mass = model.arm.masses; /* in the frame of c: 0.4 along x from that of b */
    check_within(1e-15, 4, mass->mass, "mass");
    check_within(1e-15, (2 * 0.1 + 1 * 0.4 + 1 * 0.2) / 4 - 0.4, mass->center[0], "x");
    check_within(1e-15, 0.2 / 4, mass->center[1], "y");
    check_within(1e-15, 0.3 / 4, mass->center[2], "z");
    arm_model_free(&model);
}

static void test_the_rest_of_the_file_is_passed_over(void)
{
    arm_model model;
    read_text("\xef\xbb\xbf<?xml version='1.0' encoding='utf-8'?>\n<!-- c -->\n"
              "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro' version='1.0'>"
              "<material name='grey'><color rgba='0 0 0 1'/></material>"
              "<link name='a'><visual><origin xyz='x'/></visual><joint name='j' type='none'/></link>"
              "<link name='b'><collision><geometry><box size=''/></geometry></collision></link>"
              "<transmission name='t'><joint name='j'><link name='a'/></joint></transmission>"
              "<gazebo reference='a'><link name='a'/><robot/><joint/></gazebo>"
              "text"
              "<joint name='j' type='revolute'><calibration><origin/><axis/></calibration>" ENDS
              "<joint name='k' type='none'/><safety_controller k='?'/>"
              "<origin xyz='0&#9;0&#10;1'><axis xyz='0 0 0'/></origin><axis xyz='0 0 2'/>"
              "</joint></robot>\n<!-- after -->\n", NULL, NULL, &model);
    TEST_ASSERT_EQUAL(1, model.arm.n_links);
    check_within(1e-15, 1, model.arm.links[0].d, "d");
    arm_model_free(&model);
}

/* Both arms of a robot, a tool on one, something that mimics, something that floats. */
static const char two_arms[] =
    ROBOT("<link name='torso'/><link name='left'/><link name='right'/><link name='grip'/><link name='ball'/>"
          "<joint name='l' type='revolute'><parent link='torso'/><child link='left'/></joint>\n"
          "<joint name='r' type='revolute'><parent link='torso'/><child link='right'/></joint>\n"
          "<joint name='g' type='prismatic'><parent link='right'/><child link='grip'/>"
          "<mimic joint='l' multiplier='2'/></joint>\n"
          "<joint name='f' type='floating'><parent link='left'/><child link='ball'/>"
          "<axis xyz='0 0 0'/></joint>");

static void test_base_and_tip_choose_the_chain(void)
{
    arm_model model;
    read_text(two_arms, NULL, "right", &model);
    TEST_ASSERT_EQUAL_STRING("URDF file arm.urdf, from torso to right", model.arm.source);
    arm_model_free(&model);
    read_text(two_arms, "torso", "left", &model);
    TEST_ASSERT_EQUAL_STRING("URDF file arm.urdf, from torso to left", model.arm.source);
    arm_model_free(&model);
    /* Another tree does not matter once it is said where to start: the only leaf is the one below that. */
    read_text(ROBOT("<link name='alone'/>" TWO_LINKS JOINT("revolute", "")), "a", NULL, &model);
    TEST_ASSERT_EQUAL_STRING("URDF file arm.urdf, from a to b", model.arm.source);
    arm_model_free(&model);
}

static void test_names_become_printable(void)
{
    arm_model model;
    read_text("<robot name='my-1.0_ &lt;arm&gt; &#xe9;&#127;&#10;7'><link name='a &#9;'/><link name='b'/>"
              "<joint name='j' type='revolute'><parent link='a &#9;'/><child link='b'/></joint></robot>",
              NULL, NULL, &model);
    TEST_ASSERT_EQUAL_STRING("my-1.0___arm______7", model.arm.name);
    TEST_ASSERT_EQUAL_STRING("my-1.0_ <arm> ????7", model.arm.title);
    TEST_ASSERT_EQUAL_STRING("URDF file arm.urdf, from a ? to b", model.arm.source);
    arm_model_free(&model);
}

static const char *link_name_at(const arm_model *model, size_t link)
{
    return model->arm.names[link] != NULL ? model->arm.names[link] : "";
}

/* Joints are called as in the file; the fixed link at the end, where there is one, as the tip. */
static void test_links_have_the_names_of_joints(void)
{
    static const char *const names[] = {"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint",
                                        "wrist_1_joint",      "wrist_2_joint",       "wrist_3_joint"};
    arm_model model;
    read_ur5e("base_link", &model);
    TEST_ASSERT_EQUAL_UINT(6, model.arm.n_links);
    for (size_t i = 0; i < 6; i++) {
        TEST_ASSERT_EQUAL_STRING(names[i], link_name_at(&model, i));
    }
    arm_model_free(&model);
    read_text(ROBOT(TWO_LINKS "<link name='c'/>" JOINT(
                  "revolute", "<origin rpy='1 0 0'/>") "<joint name='k' type='fixed'><parent link='b'/><child "
                                                       "link='c'/><origin xyz='1 2 3' rpy='1 2 3'/></joint>"),
              NULL, "c", &model);
    TEST_ASSERT_EQUAL_UINT(3, model.arm.n_links);
    TEST_ASSERT_EQUAL_STRING("a", link_name_at(&model, 0));
    TEST_ASSERT_EQUAL_STRING("j", link_name_at(&model, 1));
    TEST_ASSERT_EQUAL_STRING("c", link_name_at(&model, 2));
    arm_model_free(&model);
}

#define TURNS(name, from, to)                                                                                       \
    "<joint name='" name "' type='continuous'><parent link='" from "'/><child link='" to "'/>"                      \
    "<axis xyz='0 0 1'/><origin xyz='1 0 0'/></joint>"

/*
 * What a table could not have as a name is none: nothing but a dash, a fault of spreadsheets, what another link is
 * called.
 */
static void test_names_that_no_table_could_have(void)
{
    arm_model model;
    read_text(ROBOT("<link name='0'/><link name='1'/><link name='2'/><link name='3'/><link name='4'/><link name='5'/>"
                    TURNS("a&#10;b", "0", "1") TURNS("a&#9;b", "1", "2") TURNS("-", "2", "3") TURNS("#REF!", "3", "4")
                    TURNS("&#x2212;", "4", "5")),
              "0", "5", &model);
    TEST_ASSERT_EQUAL_UINT(6, model.arm.n_links);
    TEST_ASSERT_EQUAL_STRING("0", link_name_at(&model, 0));
    TEST_ASSERT_EQUAL_STRING("a?b", link_name_at(&model, 1));
    for (size_t i = 2; i < 6; i++) {
        TEST_ASSERT_EQUAL_STRING("", link_name_at(&model, i));
    }
    arm_model_free(&model);
}

static void test_other_encodings(void)
{
    static const char latin[] = "<?xml version='1.0' encoding='iso-8859-1'?><robot name='\xe9'>" TWO_LINKS
                                JOINT("revolute", "") "</robot>";
    char wide[2 * sizeof latin] = "\xff\xfe";
    const char *const text = ONE_JOINT("revolute", "");
    arm_model model;
    said said;
    read_text(latin, NULL, NULL, &model);
    arm_model_free(&model);
    for (size_t i = 0; i < strlen(text); i++) {
        wide[2 + 2 * i] = text[i];
        wide[3 + 2 * i] = '\0';
    }
    TEST_ASSERT_TRUE(read_stream(stream_of(wide, 2 + 2 * strlen(text)), "wide", NULL, NULL, &model, &said));
    arm_model_free(&model);
}

static void test_a_file_longer_than_a_buffer(void)
{
    static char text[1 << 20];
    size_t at = (size_t)sprintf(text, "<robot name='r'>\n");
    for (int i = 0; i < 3000; i++) {
        at += (size_t)sprintf(text + at, "<link name='l%d'/>\n<!-- %0100d -->\n", i, i);
    }
    for (int i = 1; i < 3000; i++) {
        at += (size_t)sprintf(text + at,
                              "<joint name='j%d' type='%s'><parent link='l%d'/><child link='l%d'/></joint>",
                              i, i % 600 == 0 ? "continuous" : "fixed", i - 1, i);
    }
    sprintf(text + at, "</robot>");
    arm_model model;
    read_text(text, NULL, NULL, &model);
    TEST_ASSERT_EQUAL(4, armtol_joint_count(model.arm.links, model.arm.n_links));
    arm_model_free(&model);
}

/* ---- what is wrong ---- */

typedef struct wrong_file {
    const char *text;
    const char *base, *tip;
    const char *message;
} wrong_file;

static void check_wrong(const wrong_file *wrong)
{
    char expected[1000];
    arm_model model;
    said said;
    FILE *const stream = stream_of(wrong->text, strlen(wrong->text));
    const bool fine = read_stream(stream, "some/arm.urdf", wrong->base, wrong->tip, &model, &said);
    snprintf(expected, sizeof expected, "armtol: some/arm.urdf%s\n", wrong->message);
    TEST_ASSERT_EQUAL_STRING(expected, said.text);
    TEST_ASSERT_FALSE(fine);
}

static void check_all_wrong(const wrong_file wrong[], size_t n)
{
    for (size_t i = 0; i < n; i++) {
        check_wrong(&wrong[i]);
    }
}

#define CHECK_ALL_WRONG(files) check_all_wrong(files, sizeof(files) / sizeof(files)[0])

#define OLD_CODE "; the text is in an older code than UTF-8; save the file as UTF-8"

static void test_what_is_no_urdf(void)
{
    static const wrong_file wrong[] = {
        {"", NULL, NULL, " is empty; expected a URDF, <robot name=\"...\">"},
        {"\n \n", NULL, NULL, ":3:1: not XML: no element found"},
        {"name: puma560\n", NULL, NULL, ":1:1: not XML: syntax error"},
        {"<robot name='r'>\n <link name='a'></robot>", NULL, NULL, ":2:19: not XML: mismatched tag"},
        {"<robot name='r'>\n <link name='a'/>", NULL, NULL, ":2:18: not XML: no element found"},
        {"<robot name='r'/>\n<robot name='s'/>", NULL, NULL, ":2:1: not XML: junk after document element"},
        {"<robot name='r'><link name='a' name='b'/></robot>", NULL, NULL,
         ":1:32: not XML: duplicate attribute"},
        {"<robot name='&r;'/>", NULL, NULL, ":1:1: not XML: undefined entity"},
        {"<?xml version='1.0' encoding='runes'?><robot/>", NULL, NULL, ":1:31: not XML: unknown encoding" OLD_CODE},
        {"<?xml version='1.0'?>\n<!-- Gr\xf6\xdf" "e -->", NULL, NULL,
         ":2:8: not XML: not well-formed (invalid token)" OLD_CODE},
        {"<robot name='\xe9'/>", NULL, NULL, ":1:14: not XML: not well-formed (invalid token)" OLD_CODE},
        {"<robot name='r'>& </robot>", NULL, NULL, ":1:18: not XML: not well-formed (invalid token)"},
        {"<sdf version='1.6'/>", NULL, NULL,
         ":1:1: the file holds \"sdf\"; expected a URDF, <robot name=\"...\">"},
        {"<!DOCTYPE robot [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;'>]><robot name='&b;'/>", NULL, NULL,
         ":1:17: a document type declaration (<!DOCTYPE>); expected a URDF, which needs none"},
        {"<!DOCTYPE robot SYSTEM 'robot.dtd'><robot name='r'/>", NULL, NULL,
         ":1:35: a document type declaration (<!DOCTYPE>); expected a URDF, which needs none"},
        {"<robot/>", NULL, NULL, ":1:1: <robot> has no name"},
        {ROBOT(""), NULL, NULL, " has no <link>"},
        {ROBOT("<xacro:arm prefix=''/>"), NULL, NULL,
         ":1:17: the file holds \"xacro:arm\", which is xacro; expand it with xacro first, or say --xacro"},
        {ROBOT("<gazebo/>\n<xacro:if value='1'/>"), NULL, NULL,
         ":2:1: the file holds \"xacro:if\", which is xacro; expand it with xacro first, or say --xacro"},
        {ROBOT("<link name='${prefix}base'/>"), NULL, NULL,
         ":1:17: <link> holds \"${prefix}base\", which is xacro; expand the file with xacro first, or say --xacro"},
        {ONE_JOINT("revolute", "<origin xyz='0 0 $(arg z)'/>"), NULL, NULL,
         ":1:116: <origin> holds \"0 0 $(arg z)\", which is xacro; expand the file with xacro first, or say --xacro"},
    };
    CHECK_ALL_WRONG(wrong);
}

static void test_what_is_missing_or_no_number(void)
{
    static const wrong_file wrong[] = {
        {ROBOT("\n\n  <link/>"), NULL, NULL, ":3:3: <link> has no name"},
        {ROBOT("<link name=''/>"), NULL, NULL, ":1:17: <link> has no name"},
        {ROBOT("<link of='name' color='red'/>"), NULL, NULL, ":1:17: <link> has no name"},
        {ROBOT("<joint type='fixed'/>"), NULL, NULL, ":1:17: <joint> has no name"},
        {ROBOT(TWO_LINKS "\n<joint name='j'>" ENDS "</joint>"), NULL, NULL, ":2:1: <joint> has no type"},
        {ROBOT(TWO_LINKS "\n" JOINT("ball", "")), NULL, NULL,
         ":2:1: joint \"j\" is of type \"ball\"; expected fixed, revolute, continuous, prismatic, "
         "planar or floating"},
        {ROBOT(TWO_LINKS "\n<joint name='j' type='fixed'><child link='b'/></joint>"), NULL, NULL,
         ":2:1: joint \"j\" has no <parent>"},
        {ROBOT(TWO_LINKS "\n<joint name='j' type='fixed'><parent link='b'/></joint>"), NULL, NULL,
         ":2:1: joint \"j\" has no <child>"},
        {ROBOT(TWO_LINKS "<joint name='j' type='fixed'>\n<parent/>"), NULL, NULL,
         ":2:1: <parent> has no link"},
        {ROBOT(TWO_LINKS "<joint name='j' type='fixed'>\n<child name='b'/>"), NULL, NULL,
         ":2:1: <child> has no link"},
        {ONE_JOINT("revolute", "\n<axis/>"), NULL, NULL, ":2:1: <axis> has no xyz"},
        {ONE_JOINT("revolute", "\n<axis xyz=''/>"), NULL, NULL, ":2:1: <axis> has no xyz"},
        {ONE_JOINT("revolute", "\n<axis xyz=' '/>"), NULL, NULL,
         ":2:1: xyz of <axis> is \" \"; expected 3 numbers set apart by blanks"},
        {ONE_JOINT("revolute", "\n<axis xyz='0 1'/>"), NULL, NULL,
         ":2:1: xyz of <axis> is \"0 1\"; expected 3 numbers set apart by blanks"},
        {ONE_JOINT("revolute", "\n<origin rpy='0 1 2 3'/>"), NULL, NULL,
         ":2:1: rpy of <origin> is \"0 1 2 3\"; expected 3 numbers set apart by blanks"},
        {ONE_JOINT("revolute", "\n<origin xyz='0 1,5 2'/>"), NULL, NULL,
         ":2:1: xyz of <origin>: \"1,5\" is not a number"},
        {ONE_JOINT("revolute", "\n<origin xyz='0 nan 2'/>"), NULL, NULL,
         ":2:1: xyz of <origin>: \"nan\" is not a finite number"},
        {ONE_JOINT("revolute", "\n<origin xyz='0 0 1e999'/>"), NULL, NULL,
         ":2:1: xyz of <origin>: \"1e999\" is too large a number"},
        {ONE_JOINT("revolute", "\n<limit lower='' upper='1'/>"), NULL, NULL,
         ":2:1: lower of <limit> is \"\"; expected 1 number"},
        {ONE_JOINT("revolute", "\n<limit lower='0' upper='pi'/>"), NULL, NULL,
         ":2:1: upper of <limit>: \"pi\" is not a number"},
        {ONE_JOINT("revolute", "\n<limit lower='1' upper='-0.5'/>"), NULL, NULL,
         ":2:1: the limits of joint \"j\" are 1 and -0.5; expected lower <= upper"},
        {ONE_JOINT("prismatic", "\n<limit lower='1'/>"), NULL, NULL,
         ":2:1: the limits of joint \"j\" are 1 and 0; expected lower <= upper"},
        {ONE_JOINT("revolute", "<origin/>\n<origin/>"), NULL, NULL, ":2:1: a second <origin> in joint \"j\""},
        {ROBOT("<link name='a'><inertial><mass value='1'/>\n<mass value='1'/></inertial></link>"), NULL, NULL,
         ":2:1: a second <mass> in link \"a\""},
        {ROBOT("<link name='a'><inertial><mass value='1'/></inertial>\n<inertial/></link>"), NULL, NULL,
         ":2:1: a second <inertial> in link \"a\""},
        {ROBOT("\n<link name='a'><inertial><origin xyz='1 2 3'/></inertial></link>"), NULL, NULL,
         ":2:1: link \"a\" has an <inertial> without a <mass>"},
        {ROBOT("<link name='a'><inertial>\n<mass value='-1'/></inertial></link>"), NULL, NULL,
         ":2:1: the mass of link \"a\" is -1; expected 0 or more"},
        {ROBOT("<link name='a'><inertial>\n<mass/></inertial></link>"), NULL, NULL, ":2:1: <mass> has no value"},
        {ONE_JOINT("revolute", "\n<child link='a'/>"), NULL, NULL, ":2:1: a second <child> in joint \"j\""},
        {ROBOT(TWO_LINKS "\n" JOINT("revolute", "<axis xyz='0 0 -0.0'/>")), NULL, NULL,
         ":2:1: the axis of joint \"j\" is 0 0 0; expected a direction"},
        {ROBOT(TWO_LINKS "\n" JOINT("continuous", "<axis xyz='0 0 0'/>")), NULL, NULL,
         ":2:1: the axis of joint \"j\" is 0 0 0; expected a direction"},
        {ROBOT(TWO_LINKS "\n" JOINT("prismatic", "<axis xyz='0 0 0'/>")), NULL, NULL,
         ":2:1: the axis of joint \"j\" is 0 0 0; expected a direction"},
    };
    CHECK_ALL_WRONG(wrong);
}

static void test_a_number_that_is_too_long(void)
{
    char text[600] = "<robot name='r'><joint name='j' type='fixed'><origin xyz='0 0 0.";
    memset(text + strlen(text), '3', 200);
    strcat(text, "'/><parent link='a'/><child link='b'/></joint><link name='a'/><link name='b'/></robot>");
    check_wrong(&(wrong_file){
        text, NULL, NULL,
        ":1:46: xyz of <origin>: \"0.33333333333333333333333333333333333333...\" is too long"});
}

#define FIXED(name, above, below) \
    "<joint name='" name "' type='fixed'><parent link='" above "'/><child link='" below "'/></joint>"

static void test_what_is_no_tree(void)
{
    static const wrong_file wrong[] = {
        {ROBOT("<link name='a'/>\n<link name='b'/>\n<link name='a'/>"), NULL, NULL,
         ":3:1: a second <link> \"a\"; the first is in line 1"},
        {ROBOT(TWO_LINKS "<link name='a'/>"), NULL, NULL,
         ":1:49: a second <link> \"a\"; the first is in line 1"},
        {ROBOT("<link name='a'/>" FIXED("j", "a", "b") "\n" FIXED("i", "a", "b") "\n" FIXED("j", "b", "c")),
         NULL, NULL, ":3:1: a second <joint> \"j\"; the first is in line 1"},
        {ROBOT(TWO_LINKS "\n" FIXED("j", "c", "b")), NULL, NULL,
         ":2:1: joint \"j\" has the parent \"c\", and there is no <link> of that name"},
        {ROBOT(TWO_LINKS "\n" FIXED("j", "a", "c")), NULL, NULL,
         ":2:1: joint \"j\" has the child \"c\", and there is no <link> of that name"},
        {ROBOT(FIXED("j", "a", "c")), NULL, NULL,
         ":1:17: joint \"j\" has the parent \"a\", and there is no <link> of that name"},
        {ROBOT(TWO_LINKS "<link name='c'/>" FIXED("j", "a", "b") "\n" FIXED("k", "c", "b")), NULL, NULL,
         ":2:1: joint \"k\" has the child \"b\", which joint \"j\" has already; expected a tree"},
        {ROBOT(TWO_LINKS FIXED("j", "a", "b") "\n" FIXED("k", "b", "a")), NULL, NULL,
         ":2:1: joint \"k\" is part of a ring: link \"a\" hangs from itself; expected a tree"},
        {ROBOT(TWO_LINKS "\n" FIXED("j", "b", "b")), NULL, NULL,
         ":2:1: joint \"j\" is part of a ring: link \"b\" hangs from itself; expected a tree"},
        {ROBOT("<link name='z'/>" TWO_LINKS FIXED("j", "a", "b") "\n" FIXED("k", "b", "a")), "z", "z",
         ":2:1: joint \"k\" is part of a ring: link \"a\" hangs from itself; expected a tree"},
    };
    CHECK_ALL_WRONG(wrong);
}

enum { JOINTS = 11 };

/* Names in some order, one of them twice; a line a joint. */
static void check_second_name(int first, int second, int step)
{
    char text[2000] = "<robot name='r'>", complaint[100];
    size_t length = strlen(text);
    for (int i = 0; i < JOINTS; i++) {
        const int name = (i == second ? first : i) * step % JOINTS;
        length += (size_t)snprintf(text + length, sizeof text - length,
                                   "<joint name='j%d' type='fixed'><parent link='a'/><child link='b'/></joint>\n",
                                   name);
    }
    snprintf(text + length, sizeof text - length, "<link name='a'/></robot>\n");
    snprintf(complaint, sizeof complaint, ":%d:%d: a second <joint> \"j%d\"; the first is in line %d", second + 1, 1,
             first * step % JOINTS, first + 1);
    check_wrong(&(wrong_file){text, NULL, NULL, complaint});
}

static void test_a_second_name_is_found_wherever_it_is(void)
{
    for (int second = 1; second < JOINTS; second++) {
        for (int first = 0; first < second; first++) {
            for (int step = 1; step < JOINTS; step++) {
                check_second_name(first, second, step);
            }
        }
    }
}

#define REFUSED "; an arm's joints are fixed, revolute, continuous or prismatic"

static void test_a_chain_that_is_not_there(void)
{
    static const wrong_file wrong[] = {
        {two_arms, "Torso", NULL,
         " has no link \"Torso\"; it has \"ball\", \"grip\", \"left\", \"right\", \"torso\""},
        {two_arms, NULL, "hand",
         " has no link \"hand\"; it has \"ball\", \"grip\", \"left\", \"right\", \"torso\""},
        {two_arms, NULL, NULL,
         " has several links at the end; choose the tool's with --tip: \"grip\" (2 joints), \"ball\" (1 joint)"},
        {ROBOT("<link name='c'/>" TWO_LINKS JOINT("revolute", "")), "c", "b",
         ": no joints lead from link \"c\" to link \"b\"; they are in different trees"},
        {two_arms, "right", "right",
         ": the joints from link \"right\" to link \"right\" make no arm: none of them moves"},
        {two_arms, "torso", "ball",
         ":4:1: joint \"f\" is floating" REFUSED "; begin below it, with --base ball"},
        {ONE_JOINT("planar", ""), NULL, NULL,
         ":1:49: joint \"j\" is planar" REFUSED "; begin below it, with --base b"},
        {ONE_JOINT("fixed", ""), NULL, NULL,
         ": the joints from link \"a\" to link \"b\" make no arm: none of them moves"},
        {ROBOT(TWO_LINKS), NULL, "b",
         " is several trees; choose the link to start from with --base: \"a\", \"b\""},
        {ROBOT("<link name='a'/><link name='b'/><link name='c'/><link name='d'/><link name='e'/>"
               "<link name='f'/><link name='g'/><link name='h'/><link name='i'/><link name='k'/>"),
         NULL, NULL,
         " is several trees; choose the link to start from with --base: \"a\", \"b\", \"c\", \"d\", \"e\", "
         "\"f\", \"g\", \"h\" and 2 more"},
        {ROBOT("<link name='0'/>" TWO_LINKS "<joint name='i' type='fixed'><origin xyz='1.5e308 0 0'/>"
               "<parent link='0'/><child link='a'/></joint>"
               JOINT("revolute", "<origin xyz='1.5e308 0 0'/>")),
         NULL, NULL, ": the joints from link \"0\" to link \"b\" make no arm: a value is not finite"},
    };
    CHECK_ALL_WRONG(wrong);
}

static void test_a_stream_that_cannot_be_read(void)
{
    arm_model model;
    said said;
    FILE *const folder = fopen(".", "r");
    TEST_ASSERT_NOT_NULL(folder);
    TEST_ASSERT_FALSE(read_stream(folder, "some/folder", NULL, NULL, &model, &said));
    TEST_ASSERT_EQUAL_STRING("armtol: some/folder: Is a directory\n", said.text);
}

/* ---- files that something has happened to ---- */

static size_t load_ur5e(char *bytes, size_t room)
{
    FILE *const stream = fopen(TEST_UR5E, "r");
    TEST_ASSERT_NOT_NULL(stream);
    const size_t length = fread(bytes, 1, room, stream);
    fclose(stream);
    TEST_ASSERT_TRUE(length > 1000 && length < room);
    return length;
}

static size_t place_in(random_source *source, size_t length)
{
    return (size_t)random_between(source, 0, (double)length);
}

/* Change a byte, move a piece elsewhere or cut the end off. */
static void damage(random_source *source, char *bytes, size_t *length)
{
    static const char telling[] = "<>/='\"& 0-.e\n";
    const size_t at = place_in(source, *length), to = place_in(source, *length);
    const size_t farther = at > to ? at : to, n = place_in(source, *length - farther);
    const double what = random_between(source, 0, 1);
    if (what < 0.4) {
        bytes[at] = telling[place_in(source, sizeof telling - 1)];
    } else if (what < 0.6) {
        bytes[at] = (char)random_between(source, -128, 128);
    } else if (what < 0.98) {
        memmove(bytes + to, bytes + at, n < 60 ? n : 60);
    } else {
        *length = at + 1;
    }
}

/* It is read, or there is one message, and nothing leaks or crashes. */
static void test_damaged_files(void)
{
    static char whole[MOST_TEXT], bytes[MOST_TEXT];
    const size_t whole_length = load_ur5e(whole, sizeof whole);
    random_source source = {5};
    int n_read = 0;
    for (int n = 0; n < 1500; n++) {
        size_t length = whole_length;
        arm_model model;
        said said;
        memcpy(bytes, whole, length);
        for (size_t i = place_in(&source, 5) + 1; i > 0; i--) {
            damage(&source, bytes, &length);
        }
        if (read_stream(stream_of(bytes, length), "some/arm.urdf", "base_link", "tool0", &model, &said)) {
            TEST_ASSERT_TRUE(said.text[0] == '\0' || strstr(said.text, "warning: ") != NULL);
            TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_links_check(model.arm.links, model.arm.n_links));
            arm_model_free(&model);
            n_read++;
        } else {
            TEST_ASSERT_EQUAL_PTR(said.text, strstr(said.text, "armtol: some/arm.urdf"));
            TEST_ASSERT_TRUE(strchr(said.text, '\n') == said.text + strlen(said.text) - 1);
        }
    }
    TEST_ASSERT_TRUE(n_read > 50 && n_read < 1450);
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_the_tool_of_the_ur5e_is_where_its_file_puts_it);
    RUN_TEST(test_the_ur5e_has_the_lengths_of_its_maker_s_table);
    RUN_TEST(test_the_ur5e_is_the_built_in_one);
    RUN_TEST(test_what_goes_with_the_ur5e);
    RUN_TEST(test_files_drawn_at_random);
    RUN_TEST(test_the_axis_is_x_where_nothing_is_said);
    RUN_TEST(test_limits);
    RUN_TEST(test_masses_are_carried_by_the_joint_before_them);
    RUN_TEST(test_the_rest_of_the_file_is_passed_over);
    RUN_TEST(test_base_and_tip_choose_the_chain);
    RUN_TEST(test_names_become_printable);
    RUN_TEST(test_links_have_the_names_of_joints);
    RUN_TEST(test_names_that_no_table_could_have);
    RUN_TEST(test_other_encodings);
    RUN_TEST(test_a_file_longer_than_a_buffer);
    RUN_TEST(test_what_is_no_urdf);
    RUN_TEST(test_what_is_missing_or_no_number);
    RUN_TEST(test_a_number_that_is_too_long);
    RUN_TEST(test_a_second_name_is_found_wherever_it_is);
    RUN_TEST(test_what_is_no_tree);
    RUN_TEST(test_a_chain_that_is_not_there);
    RUN_TEST(test_a_stream_that_cannot_be_read);
    RUN_TEST(test_damaged_files);
    return UNITY_END();
}
