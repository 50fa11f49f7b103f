/* Chains of a URDF as people have them: two-armed robots, coupled joints, quaternions, faults that matter nowhere. */

#include "armtol/arm.h"
#include "armtol/link_transform.h"
#include "armtol/urdf/urdf.h"
#include "console/message.h"

#include "fuzz/motion.h"
#include "support/check.h"
#include "support/said.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_LINKS = 12 };

static const double pi = 3.14159265358979323846;

void setUp(void)
{
}

void tearDown(void)
{
}

static bool read_arm(const char *text, const char *base, const char *tip, arm_model *model, said *said)
{
    FILE *const stream = stream_of(text, strlen(text));
    said_begin();
    const bool fine = urdf_read(stream, "arm.urdf", base, tip, model);
    said_end(said);
    fclose(stream);
    return fine;
}

static void read_fine(const char *text, const char *base, const char *tip, arm_model *model)
{
    said said;
    TEST_ASSERT_TRUE(read_arm(text, base, tip, model, &said));
    TEST_ASSERT_EQUAL_STRING("", said.text);
}

static void check_said(const char *text, const char *base, const char *tip, bool fine, const char *expected)
{
    arm_model model;
    said said;
    TEST_ASSERT_EQUAL_INT(fine, read_arm(text, base, tip, &model, &said));
    TEST_ASSERT_EQUAL_STRING(expected, said.text);
    arm_model_free(&model);
}

/* Where the arm's table puts the tool. */
static armtol_transform tool_of(const arm_model *model, const double q[], size_t n_joints)
{
    armtol_link placed[MOST_LINKS];
    TEST_ASSERT_TRUE(model->arm.n_links <= MOST_LINKS);
    TEST_ASSERT_EQUAL_UINT(n_joints, armtol_arm_joint_count(&model->arm));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_arm_place(&model->arm, q, n_joints, placed));
    return armtol_chain_transform(placed, model->arm.n_links, &armtol_errata_none);
}

static void check_same_tool(const armtol_transform *expected, const armtol_transform *actual)
{
    const motion_difference difference = motion_compare(expected, actual);
    check_within(1e-13, 0, difference.angle, "angle");
    check_within(1e-13, 0, difference.length, "length");
}

/* ---- a robot with two arms ---- */

#define JOINT(name, type, above, below, content) \
    "<joint name='" name "' type='" type "'><parent link='" above "'/><child link='" below "'/>" content "</joint>\n"
#define LINK(name) "<link name='" name "'/>"

static const double left_xyz[] = {0.1, 0.2, 0.3}, left_rpy[] = {0.3, -0.4, 0.5}, left_axis[] = {0, 1, 0};
static const double slide_xyz[] = {0, 0.4, 0}, slide_rpy[] = {0, 0, 0}, slide_axis[] = {1, 0, 1};
static const double right_xyz[] = {-0.1, 0.2, 0.25}, right_rpy[] = {-1, 0.2, 0}, right_axis[] = {0.6, 0, 0.8};
static const double hand_xyz[] = {0, 0, 0.5}, hand_rpy[] = {0.1, 0, 0};

static const char two_arms[] =
    "<robot name='r'>" LINK("torso") LINK("left") LINK("fork") LINK("right") LINK("hand") LINK("eye")
    JOINT("l", "revolute", "torso", "left", "<origin xyz='0.1 0.2 0.3' rpy='0.3 -0.4 0.5'/><axis xyz='0 1 0'/>")
    JOINT("s", "prismatic", "left", "fork", "<origin xyz='0 0.4 0'/><axis xyz='1 0 1'/>")
    JOINT("r", "continuous", "torso", "right", "<origin xyz='-0.1 0.2 0.25' rpy='-1 0.2 0'/><axis xyz='0.6 0 0.8'/>")
    JOINT("h", "fixed", "right", "hand", "<origin xyz='0 0 0.5' rpy='0.1 0 0'/>")
    JOINT("e", "fixed", "torso", "eye", "<origin xyz='0 0 0.7'/>") "</robot>";

static armtol_transform step(const double xyz[3], const double rpy[3], const armtol_transform *moved)
{
    const armtol_transform origin = motion_of_rpy(xyz, rpy);
    return moved != NULL ? motion_product(&origin, moved) : origin;
}

/* The inverse of a rigid motion, by its definition. */
static armtol_transform backwards(const armtol_transform *m)
{
    armtol_transform inverse = {{{0}}};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            inverse.m[i][k] = m->m[k][i];
            inverse.m[i][3] -= m->m[k][i] * m->m[k][3];
        }
    }
    inverse.m[3][3] = 1;
    return inverse;
}

static void test_a_chain_goes_up_to_the_common_link_and_down_again(void)
{
    static const double q[] = {0.07, -0.8, 1.9}; /* from fork: the slide, then the left, then the right */
    const armtol_transform l = motion_about(left_axis, q[1]), s = motion_along(slide_axis, q[0]);
    const armtol_transform r = motion_about(right_axis, q[2]);
    const armtol_transform left = step(left_xyz, left_rpy, &l), slide = step(slide_xyz, slide_rpy, &s);
    const armtol_transform right = step(right_xyz, right_rpy, &r), hand = step(hand_xyz, hand_rpy, NULL);
    const armtol_transform fork = motion_product(&left, &slide), up = backwards(&fork);
    const armtol_transform down = motion_product(&right, &hand), whole = motion_product(&up, &down);
    arm_model model;
    read_fine(two_arms, "fork", "hand", &model);
    const armtol_transform tool = tool_of(&model, q, 3);
    check_same_tool(&whole, &tool);
    arm_model_free(&model);

    /* Up only: the other way round of the way down. */
    read_fine(two_arms, "fork", "torso", &model);
    const armtol_transform top = tool_of(&model, q, 2);
    check_same_tool(&up, &top);
    arm_model_free(&model);
}

static void test_the_tips_are_sorted_by_their_joints_and_a_leaf_that_nothing_moves_is_none(void)
{
    check_said(
        two_arms, NULL, NULL, false,
        "armtol: arm.urdf has several links at the end; choose the tool's with --tip: \"fork\" (2 joints), \"hand\" "
        "(1 joint)\n");
    arm_model model;
    read_fine("<robot name='r'>" LINK("a") LINK("b") LINK("c") JOINT("j", "revolute", "a", "b", "")
              JOINT("k", "fixed", "a", "c", "") "</robot>", NULL, NULL, &model);
    TEST_ASSERT_EQUAL_STRING("URDF file arm.urdf, from a to b", model.arm.source);
    arm_model_free(&model);
}

/* ---- rotations ---- */

static void check_quaternion(const char *quaternion, const double rpy[3])
{
    static const double xyz[] = {0.1, 0, 0.2}, axis[] = {0, 0, 1}, q[] = {0.4};
    char text[600];
    snprintf(text, sizeof text, "<robot name='r' version='1.1'>" LINK("a") LINK("b")
             JOINT("j", "revolute", "a", "b", "<origin xyz='0.1 0 0.2' quat_xyzw='%s'/><axis xyz='0 0 1'/>") "</robot>",
             quaternion);
    const armtol_transform moved = motion_about(axis, q[0]), expected = step(xyz, rpy, &moved);
    arm_model model;
    read_fine(text, NULL, NULL, &model);
    const armtol_transform tool = tool_of(&model, q, 1);
    check_same_tool(&expected, &tool);
    arm_model_free(&model);
}

static void test_a_quaternion_in_place_of_rpy(void)
{
    char text[200];
    check_quaternion("0 0 0 1", (const double[3]){0, 0, 0});
    check_quaternion("-1e-170 0 0 1e-170", (const double[3]){-pi / 2, 0, 0});
    check_quaternion("0 0 3e200 3e200", (const double[3]){0, 0, pi / 2});
    /* half a turn about each axis after the other: closed form of the product of three */
    const double r = 0.35, p = -0.6, y = 1.1;
    const double cr = cos(r), sr = sin(r), cp = cos(p), sp = sin(p), cy = cos(y), sy = sin(y);
    snprintf(text, sizeof text, "%.17g %.17g %.17g %.17g", sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
             cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy);
    check_quaternion(text, (const double[3]){2 * r, 2 * p, 2 * y});
}

static void test_what_is_wrong_with_a_quaternion(void)
{
#define TURNED(attributes) \
    "<robot name='r'>" LINK("a") LINK("b") "\n" JOINT("j", "revolute", "a", "b", "<origin " attributes "/>") "</robot>"
    check_said(TURNED("rpy='0 0 0' quat_xyzw='0 0 0 1'"), NULL, NULL, false,
               "armtol: arm.urdf:2:68: <origin> has both rpy and quat_xyzw; expected one of them\n");
    check_said(TURNED("quat_xyzw='0 0 0 -0'"), NULL, NULL, false,
               "armtol: arm.urdf:2:68: quat_xyzw of <origin> is 0 0 0 0; expected a rotation\n");
    check_said(TURNED("quat_xyzw='0 0 1'"), NULL, NULL, false,
               "armtol: arm.urdf:2:68: quat_xyzw of <origin> is \"0 0 1\"; expected 4 numbers set apart by blanks\n");
}

/* ---- joints that follow ---- */

#define COUPLED(mimic_b, mimic_c)                                                                                      \
    "<robot name='r'>" LINK("a") LINK("b") LINK("c") LINK("d") JOINT("j", "revolute", "a", "b", "<axis xyz='0 0 1'/>") \
        JOINT("k", "prismatic", "b", "c", "<origin xyz='0.5 0 0' rpy='0.2 0 0'/><axis xyz='0 1 0'/>" mimic_b)          \
            JOINT("l", "revolute", "c", "d",                                                                           \
                  "<origin xyz='0 0 0.3'/><axis xyz='1 0 0'/><limit lower='-2' upper='1'/>" mimic_c) "</robot>"

static void check_coupled(const char *text, const double q[], size_t n_joints, const double values[3])
{
    static const double z[] = {0, 0, 1}, y[] = {0, 1, 0}, x[] = {1, 0, 0}, none[] = {0, 0, 0};
    static const double k_xyz[] = {0.5, 0, 0}, k_rpy[] = {0.2, 0, 0}, l_xyz[] = {0, 0, 0.3};
    const armtol_transform j = motion_about(z, values[0]), k = motion_along(y, values[1]),
                           l = motion_about(x, values[2]);
    const armtol_transform one = step(none, none, &j), two = step(k_xyz, k_rpy, &k), three = step(l_xyz, none, &l);
    const armtol_transform both = motion_product(&one, &two), expected = motion_product(&both, &three);
    arm_model model;
    read_fine(text, NULL, NULL, &model);
    const armtol_transform tool = tool_of(&model, q, n_joints);
    check_same_tool(&expected, &tool);
    arm_model_free(&model);
}

static void test_a_joint_follows_another_of_the_chain(void)
{
    static const double q[] = {0.8, 0.3};
    check_coupled(COUPLED("", ""), (const double[3]){0.8, 0.3, -0.4}, 3, (const double[3]){0.8, 0.3, -0.4});
    check_coupled(COUPLED("", "<mimic joint='j' multiplier='-2' offset='0.25'/>"), q, 2,
                  (const double[3]){0.8, 0.3, -2 * 0.8 + 0.25});
    check_coupled(COUPLED("<mimic joint='j'/>", ""), q, 2, (const double[3]){0.8, 0.8, 0.3});
    /* by way of another */
    check_coupled(
        COUPLED("<mimic joint='j' multiplier='0.5' offset='0.1'/>", "<mimic joint='k' multiplier='3' offset='1'/>"), q,
        1, (const double[3]){0.8, 0.5, 2.5});
    /* a leader behind the follower */
    check_coupled(COUPLED("<mimic joint='l' multiplier='0.5'/>", ""), q, 2, (const double[3]){0.8, 0.15, 0.3});
    /* a leader that the chain, or the file, does not have */
    check_coupled(COUPLED("<mimic joint='gone'/>", ""), (const double[3]){0.8, 0.3, -0.4}, 3,
                  (const double[3]){0.8, 0.3, -0.4});
}

static void test_joints_that_follow_themselves(void)
{
    check_said(COUPLED("<mimic joint='l'/>", "<mimic joint='k'/>"), NULL, NULL, false,
               "armtol: arm.urdf:2:1: joint \"k\" mimics itself, by way of others\n");
    check_said(COUPLED("\n<mimic/>", ""), NULL, NULL, false, "armtol: arm.urdf:3:1: <mimic> has no joint\n");
}

/* ---- what does not matter ---- */

static void test_faults_outside_the_chain_do_not_matter(void)
{
    static const char *const faults[] = {
        JOINT("k", "revolute", "a", "c", "<limit lower='2' upper='1'/>"),
        JOINT("k", "revolute", "a", "c", "<axis xyz='0 0 1'/><axis xyz='1 0 0'/>"),
        JOINT("k", "revolute", "a", "c", "<axis xyz='0 0 0'/>"),
        JOINT("k", "ball", "a", "c", ""),
        JOINT("k", "fixed", "a", "c", "<origin xyz='0 0'/><origin xyz='${x}'/>"),
    };
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        char text[600];
        arm_model model;
        said said;
        snprintf(text, sizeof text, "<robot name='r'>" LINK("a") LINK("b") LINK("c") "%s%s</robot>",
                 JOINT("j", "revolute", "a", "b", ""), faults[i]);
        read_fine(text, "a", "b", &model);
        arm_model_free(&model);
        TEST_ASSERT_FALSE_MESSAGE(read_arm(text, "a", "c", &model, &said), faults[i]);
        TEST_ASSERT_TRUE_MESSAGE(strncmp(said.text, "armtol: arm.urdf:2:", 19) == 0, said.text);
    }
}

static void test_xacro_that_only_defines_does_no_harm(void)
{
    arm_model model;
    read_fine("<robot name='r'>" LINK(
                  "a") "<xacro:property name='w' value='${3 * 2}'/><xacro:arg name='x' default='1'/>"
                       "<xacro:macro name='m' params='p'><joint name='${p}'/><xacro:if value='1'/></xacro:macro>" LINK(
                           "b") JOINT("j", "revolute", "a", "b", "") "</robot>",
              NULL, NULL, &model);
    TEST_ASSERT_EQUAL_UINT(1, armtol_arm_joint_count(&model.arm));
    arm_model_free(&model);
}

/* ---- what is improbable ---- */

static void test_millimetres_and_degrees_are_warned_of(void)
{
#define AT(origin) \
    "<robot name='r'>" LINK("a") LINK("b") "\n" JOINT("j", "revolute", "a", "b", "<origin " origin "/>") "</robot>"
    check_said(AT("xyz='0 89.2 425'"), NULL, NULL, true,
               "armtol: warning: arm.urdf: the joints are 434 m apart all together; are these millimetres? A URDF has "
               "metres\n");
    check_said(
        AT("rpy='0 -90 0'"), NULL, NULL, true,
        "armtol: arm.urdf:2:1: warning: joint \"j\" has -90 in its rpy; are these degrees? A URDF has radians\n");
    check_said(AT("xyz='0 0 99' rpy='6.2832 0 0'"), NULL, NULL, true, "");
}

/* ---- a drawing ---- */

static void check_drawn(const char *text, const urdf_units *units, const char *expected)
{
    char drawn[1000];
    FILE *const stream = stream_of(text, strlen(text)), *const into = tmpfile();
    TEST_ASSERT_NOT_NULL(into);
    TEST_ASSERT_TRUE(urdf_draw(stream, "arm.urdf", units, into));
    fclose(stream);
    rewind(into);
    drawn[fread(drawn, 1, sizeof drawn - 1, into)] = '\0';
    fclose(into);
    TEST_ASSERT_EQUAL_STRING(expected, drawn);
}

static void test_the_tree_is_drawn_with_its_joints(void)
{
    static const urdf_units metres = {1, 1, "m", "rad"}, small = {1000, 180 / 3.14159265358979323846, "mm", "deg"};
    check_drawn(two_arms, &metres,
                "torso\n"
                "  left  (l: revolute)\n"
                "    fork  (s: prismatic)\n"
                "  right  (r: continuous)\n"
                "    hand  (h: fixed)\n"
                "  eye  (e: fixed)\n");
    check_drawn("<robot name='r'>" LINK("z") LINK("b") LINK("a")
                    JOINT("j", "prismatic", "a", "b",
                          "<limit upper='0.25'/><mimic joint='&#9;x' multiplier='-2' offset='0.5'/>") "</robot>",
                &small,
                "a\n"
                "  b  (j: prismatic, 0 to 250 mm, -2 x ?x + 500)\n"
                "z\n");
    check_drawn("<robot name='r'>" LINK("a") LINK("b")
                JOINT("j", "revolute", "a", "b", "<limit lower='1' upper='-1'/>") "</robot>", &metres,
                "a\n  b  (j: with a fault)\n");
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_a_chain_goes_up_to_the_common_link_and_down_again);
    RUN_TEST(test_the_tips_are_sorted_by_their_joints_and_a_leaf_that_nothing_moves_is_none);
    RUN_TEST(test_a_quaternion_in_place_of_rpy);
    RUN_TEST(test_what_is_wrong_with_a_quaternion);
    RUN_TEST(test_a_joint_follows_another_of_the_chain);
    RUN_TEST(test_joints_that_follow_themselves);
    RUN_TEST(test_faults_outside_the_chain_do_not_matter);
    RUN_TEST(test_xacro_that_only_defines_does_no_harm);
    RUN_TEST(test_millimetres_and_degrees_are_warned_of);
    RUN_TEST(test_the_tree_is_drawn_with_its_joints);
    return UNITY_END();
}
