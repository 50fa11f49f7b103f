#include "armtol/arm.h"
#include "armtol/axes.h"
#include "armtol/craig.h"
#include "armtol/robots.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"
#include "unity.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { MOST_JOINTS = 7, MOST_LINKS = 8 };

void setUp(void)
{
}

void tearDown(void)
{
}

static const double pi = 3.14159265358979323846;

static const armtol_arm *arm_of(const char *name)
{
    const armtol_arm *arm = armtol_arm_named(name);
    TEST_ASSERT_NOT_NULL_MESSAGE(arm, name);
    return arm;
}

/* Where an arm's table puts its tool, by the reference's long doubles. */
static void tool_of(const armtol_arm *arm, const double q[], double tool[4][4])
{
    armtol_link placed[MOST_LINKS];
    TEST_ASSERT_TRUE(arm->n_links <= MOST_LINKS);
    const size_t n_joints = armtol_joint_count(arm->links, arm->n_links);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(arm->links, arm->n_links, q, n_joints,
                                                        &armtol_errata_none, placed));
    reference_chain(placed, arm->n_links, tool);
}

/* ---- by name and by number ---- */

static const char *const names[] = {"intelledex605t", "adeptone", "puma560", "stanford",
                                    "scara",          "ur5e",     "panda",   "iiwa14"};
enum { ARMS = sizeof names / sizeof names[0] };

static void test_every_arm_is_found_by_its_number_and_its_name(void)
{
    TEST_ASSERT_EQUAL_INT(ARMS, armtol_arm_count());
    for (size_t i = 0; i < ARMS; i++) {
        const armtol_arm *arm = armtol_arm_at(i);
        TEST_ASSERT_NOT_NULL(arm);
        TEST_ASSERT_EQUAL_STRING(names[i], arm->name);
        TEST_ASSERT_EQUAL_PTR(arm, armtol_arm_named(names[i]));
    }
}

static void test_there_are_no_others(void)
{
    TEST_ASSERT_NULL(armtol_arm_at(ARMS));
    TEST_ASSERT_NULL(armtol_arm_at((size_t)-1));
    TEST_ASSERT_NULL(armtol_arm_named(""));
    TEST_ASSERT_NULL(armtol_arm_named("puma"));
    TEST_ASSERT_NULL(armtol_arm_named("puma5600"));
    TEST_ASSERT_NULL(armtol_arm_named("PUMA560"));
}

static void test_every_arm_says_what_it_is(void)
{
    for (size_t i = 0; i < ARMS; i++) {
        const armtol_arm *arm = armtol_arm_at(i);
        TEST_ASSERT_NULL_MESSAGE(strpbrk(arm->name, " \t\n"), arm->name);
        TEST_ASSERT_TRUE_MESSAGE(strlen(arm->title) > 0 && strchr(arm->title, '\n') == NULL, arm->name);
        TEST_ASSERT_TRUE_MESSAGE(strlen(arm->source) > 0 && strchr(arm->source, '\n') == NULL, arm->name);
        TEST_ASSERT_EQUAL_INT(ARMTOL_MILLIMETRE, arm->unit);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_check(arm->links, arm->n_links));
        TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_NPR, arm->links[arm->n_links - 1].kind, arm->name);
    }
}

static void test_units_have_names(void)
{
    TEST_ASSERT_EQUAL_STRING("mm", armtol_length_unit_name(ARMTOL_MILLIMETRE));
    TEST_ASSERT_EQUAL_STRING("m", armtol_length_unit_name(ARMTOL_METRE));
    TEST_ASSERT_EQUAL_STRING("?", armtol_length_unit_name(ARMTOL_LENGTH_UNIT_COUNT));
}

/* ---- where the axes are ---- */

#define TURN ARMTOL_REVOLUTE
#define SLIDE ARMTOL_PRISMATIC

/*
 * An arm with all joints at 0, told without link parameters: a point and the direction of each axis, and the
 * tool's frame; base coordinates, mm.
 */
typedef struct geometry {
    const char *arm;
    size_t n_axes;
    armtol_axis axes[MOST_JOINTS];
    double tool[3][4];
} geometry;

static const geometry geometries[] = {
    {"intelledex605t",
     6,
     {{TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {0, 0, 359.7}, {0, 1, 0}},
      {TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {373.4, 0, 0}, {0, 0, 1}},
      {TURN, {373.4 + 279.4, 0, 0}, {0, 0, 1}},
      {TURN, {373.4 + 279.4, 0, 359.7}, {0, -1, 0}}},
     {{0, -1, 0, 373.4 + 279.4}, {0, 0, -1, -100}, {1, 0, 0, 359.7}}},
    {"adeptone",
     4,
     {{TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {425, 0, 0}, {0, 0, 1}},
      {TURN, {425 + 375, 0, 0}, {0, 0, 1}},
      {SLIDE, {0, 0, 0}, {0, 0, 1}}},
     {{1, 0, 0, 425 + 375}, {0, 1, 0, 0}, {0, 0, 1, 203.2}}},
    /* the upper arm along x, the forearm upright, beside the shoulder */
    {"puma560",
     6,
     {{TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {0, 0, 0}, {0, -1, 0}},
      {TURN, {431.8, 0, 0}, {0, -1, 0}},
      {TURN, {431.8 + 20.3, -150.05, 0}, {0, 0, 1}},
      {TURN, {431.8 + 20.3, -150.05, 431.8}, {0, -1, 0}},
      {TURN, {431.8 + 20.3, -150.05, 431.8}, {0, 0, 1}}},
     {{1, 0, 0, 431.8 + 20.3}, {0, 1, 0, -150.05}, {0, 0, 1, 431.8}}},
    /* the boom upright, beside the shoulder */
    {"stanford",
     6,
     {{TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {0, 0, 412}, {0, 1, 0}},
      {SLIDE, {0, 0, 0}, {0, 0, 1}},
      {TURN, {0, 154, 412}, {0, 0, 1}},
      {TURN, {0, 154, 412}, {1, 0, 0}},
      {TURN, {0, 154, 412}, {0, 0, 1}}},
     {{0, 1, 0, 0}, {-1, 0, 0, 154}, {0, 0, 1, 412 + 263}}},
    {"scara",
     4,
     {{TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {325, 0, 0}, {0, 0, 1}},
      {SLIDE, {0, 0, 0}, {0, 0, -1}},
      {TURN, {325 + 275, 0, 0}, {0, 0, -1}}},
     {{1, 0, 0, 325 + 275}, {0, -1, 0, 0}, {0, 0, -1, 387}}},
    /* stretched along -x; axes and offsets of the frames in Universal_Robots_ROS2_Description */
    {"ur5e",
     6,
     {{TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {0, 0, 162.5}, {0, -1, 0}},
      {TURN, {-425, 0, 162.5}, {0, -1, 0}},
      {TURN, {-425 - 392.2, 0, 162.5}, {0, -1, 0}},
      {TURN, {-425 - 392.2, -133.3, 0}, {0, 0, -1}},
      {TURN, {-425 - 392.2, 0, 162.5 - 99.7}, {0, -1, 0}}},
     {{1, 0, 0, -425 - 392.2}, {0, 0, -1, -133.3 - 99.6}, {0, 1, 0, 162.5 - 99.7}}},
    /* upright, the flange down; axes and offsets of the frames in franka_description */
    {"panda",
     7,
     {{TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {0, 0, 333}, {0, 1, 0}},
      {TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {82.5, 0, 333 + 316}, {0, -1, 0}},
      {TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {0, 0, 333 + 316 + 384}, {0, -1, 0}},
      {TURN, {88, 0, 0}, {0, 0, -1}}},
     {{1, 0, 0, 88}, {0, -1, 0, 0}, {0, 0, -1, 333 + 316 + 384 - 107}}},
    /* upright; axes of kuka_lbr_iiwa_support, heights as iiwa_description adds them up */
    {"iiwa14",
     7,
     {{TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {0, 0, 157.5 + 202.5}, {0, 1, 0}},
      {TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {0, 0, 360 + 204.5 + 215.5}, {0, -1, 0}},
      {TURN, {0, 0, 0}, {0, 0, 1}},
      {TURN, {0, 0, 780 + 184.5 + 215.5}, {0, 1, 0}},
      {TURN, {0, 0, 0}, {0, 0, 1}}},
     {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 1180 + 81 + 45}}},
};

/* A free vector turned about a direction (Rodrigues). */
static void turn(const double axis[3], double angle, const double vector[3], double turned[3])
{
    const double along = axis[0] * vector[0] + axis[1] * vector[1] + axis[2] * vector[2];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        turned[i] = cos(angle) * vector[i] + sin(angle) * (axis[j] * vector[k] - axis[k] * vector[j]) +
                    (1 - cos(angle)) * along * axis[i];
    }
}

/* Everything behind a joint moves with it: the columns of the tool's frame. */
static void move(const armtol_axis *axis, double q, double tool[3][4])
{
    for (int column = 0; column < 4; column++) {
        const bool point = column == 3;
        double from[3], to[3];
        for (int i = 0; i < 3; i++) {
            from[i] = tool[i][column] - (point ? axis->point[i] : 0);
        }
        turn(axis->direction, axis->joint == TURN ? q : 0, from, to);
        for (int i = 0; i < 3; i++) {
            const double slid = axis->joint == SLIDE ? q * axis->direction[i] : 0;
            tool[i][column] = to[i] + (point ? axis->point[i] + slid : 0);
        }
    }
}

static void check_frame(const double expected[3][4], double actual[4][4], double length, double angle,
                        const char *what)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            check_within(j < 3 ? angle : length, expected[i][j], actual[i][j], "%s, element %d %d", what, i,
                         j);
        }
    }
}

static void draw_joints(const armtol_arm *arm, random_source *source, double q[])
{
    size_t n = 0;
    for (size_t i = 0; i < arm->n_links; i++) {
        const armtol_joint joint = arm->links[i].joint;
        if (joint != ARMTOL_FIXED) {
            q[n++] = joint == SLIDE ? random_between(source, -500, 500) : random_between(source, -pi, pi);
        }
    }
}

static void check_geometry(const geometry *known)
{
    const armtol_arm *arm = arm_of(known->arm);
    random_source source = {3};
    TEST_ASSERT_EQUAL_INT(known->n_axes, armtol_joint_count(arm->links, arm->n_links));
    for (int draw = 0; draw < 100; draw++) {
        double q[MOST_JOINTS] = {0}, expected[3][4], tool[4][4];
        if (draw > 0) { /* the first is the arm as it is described */
            draw_joints(arm, &source, q);
        }
        memcpy(expected, known->tool, sizeof expected);
        for (size_t i = known->n_axes; i-- > 0;) {
            move(&known->axes[i], q[i], expected);
        }
        tool_of(arm, q, tool);
        check_frame((const double(*)[4])expected, tool, 1e-9, 1e-12, known->arm);
    }
}

static void test_every_arm_moves_about_its_axes(void)
{
    TEST_ASSERT_EQUAL_INT(ARMS, sizeof geometries / sizeof geometries[0]);
    for (size_t i = 0; i < ARMS; i++) {
        check_geometry(&geometries[i]);
    }
}

/* The kind is that of the angle to the next axis; a row that carries the tool is npr. */
static armtol_kind kind_of(const geometry *known, size_t joint)
{
    const armtol_axis *axis = &known->axes[joint], *next = axis + 1;
    if (joint + 1 == known->n_axes) {
        return ARMTOL_NPR;
    }
    double cosine = 0;
    for (int i = 0; i < 3; i++) {
        cosine += axis->direction[i] * next->direction[i];
    }
    const bool parallel = fabs(cosine) == 1;
    return axis->joint == TURN ? (parallel ? ARMTOL_PPR : ARMTOL_NPR) : (parallel ? ARMTOL_PPP : ARMTOL_NPP);
}

static void test_kinds_fit_the_axes(void)
{
    for (size_t i = 2; i < ARMS; i++) { /* those without fixed links: all but the two of 1987 */
        const armtol_arm *arm = arm_of(geometries[i].arm);
        TEST_ASSERT_EQUAL_INT(geometries[i].n_axes, arm->n_links);
        for (size_t link = 0; link < arm->n_links; link++) {
            TEST_ASSERT_EQUAL_STRING_MESSAGE(armtol_kind_name(kind_of(&geometries[i], link)),
                                             armtol_kind_name(arm->links[link].kind), arm->name);
        }
    }
}

/* ---- against what others computed or published ---- */

/*
 * The Robotics Toolbox for Python prints 0.5963, -0.15005, 0.65748 m for its pose qn, with the pedestal of
 * 26.45 in that our table leaves out.
 */
static void test_the_puma_is_where_the_toolbox_has_it(void)
{
    const double q[6] = {0, pi / 4, pi, 0, pi / 4, 0};
    const double expected[3][4] = {{0, 0, 1, 596.3}, {0, 1, 0, -150.05}, {-1, 0, 0, 657.48 - 26.45 * 25.4}};
    double tool[4][4];
    tool_of(arm_of("puma560"), q, tool);
    check_frame(expected, tool, 0.051, 1e-12, "qn");
}

/* Its tests have the Panda's flange, to four decimals and metres. */
static void test_the_panda_is_where_the_toolbox_has_it(void)
{
    const double q[7] = {1, 2, 3, 4, 5, 6, 7};
    const double expected[3][4] = {{-0.5236, 0.6902, 0.4994, 85.75},
                                   {0.8287, 0.5487, 0.1106, 313.2},
                                   {-0.1977, 0.4718, -0.8593, 532.1}};
    double tool[4][4];
    tool_of(arm_of("panda"), q, tool);
    check_frame(expected, tool, 0.051, 5.1e-5, "1 to 7");
}

/* The table as its makers publish it, in Craig's order. */
static void test_the_panda_is_as_published(void)
{
    static const armtol_craig_link published[] = {
        {ARMTOL_REVOLUTE, 0, 0, 333, 0},
        {ARMTOL_REVOLUTE, 0, -1.5707963267948966, 0, 0},
        {ARMTOL_REVOLUTE, 0, 1.5707963267948966, 316, 0},
        {ARMTOL_REVOLUTE, 82.5, 1.5707963267948966, 0, 0},
        {ARMTOL_REVOLUTE, -82.5, -1.5707963267948966, 384, 0},
        {ARMTOL_REVOLUTE, 0, 1.5707963267948966, 0, 0},
        {ARMTOL_REVOLUTE, 88, 1.5707963267948966, 0, 0},
        {ARMTOL_FIXED, 0, 0, 107, 0},
    };
    const armtol_arm *arm = arm_of("panda");
    random_source source = {7};
    for (int draw = 0; draw < 100; draw++) {
        double q[MOST_JOINTS], tool[4][4];
        draw_joints(arm, &source, q);
        const armtol_transform expected = armtol_craig_chain(published, 8, q, &armtol_errata_none);
        tool_of(arm, q, tool);
        check_frame((const double(*)[4])expected.m, tool, 1e-9, 1e-12, "panda");
    }
}

/* Its makers say at which angle of joint 4 it reaches farthest: shoulder, elbow and wrist are in line. */
static void test_the_panda_stretches_at_the_published_angle(void)
{
    const double q[7] = {0, 0, 0, -0.467002423653011, 0, 0, 0};
    const armtol_arm *arm = arm_of("panda");
    double wrist[4][4];
    armtol_link placed[MOST_LINKS];
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                          armtol_links_place(arm->links, 7, q, 7, &armtol_errata_none, placed));
    reference_chain(placed, 5, wrist);
    const double reach = hypot(316, 82.5) + hypot(384, 82.5);
    check_within(1e-9, reach, hypot(wrist[0][3], wrist[2][3] - 333), "from shoulder to wrist");
}

static void check_1987(const char *name, const armtol_robot *robot)
{
    const armtol_arm *arm = arm_of(name);
    armtol_link links[MOST_LINKS];
    robot->links(&armtol_errata_none, links);
    TEST_ASSERT_EQUAL_INT(robot->n_links, arm->n_links);
    TEST_ASSERT_EQUAL_STRING(robot->name, arm->title);
    for (size_t i = 0; i < arm->n_links; i++) {
        TEST_ASSERT_EQUAL_INT(links[i].kind, arm->links[i].kind);
        TEST_ASSERT_EQUAL_INT(links[i].joint, arm->links[i].joint);
        check_same(links[i].a, arm->links[i].a, "a of link %zu", i);
        check_same(links[i].alpha, arm->links[i].alpha, "alpha of link %zu", i);
        check_same(links[i].d, arm->links[i].d, "d of link %zu", i);
        check_same(links[i].theta, arm->links[i].theta, "theta of link %zu", i);
        check_same(links[i].beta, arm->links[i].beta, "beta of link %zu", i);
    }
}

static void test_the_arms_of_1987_have_the_corrected_tables(void)
{
    check_1987("intelledex605t", &armtol_intelledex_605t);
    check_1987("adeptone", &armtol_adept_one);
}

/* ---- drives ---- */

/* How far joints go, as sources print it: degrees, mm. Those of 1987 say nothing. */
typedef struct ranges {
    const char *arm;
    double unit; /* of angles, in radians */
    double ends[MOST_JOINTS][2];
} ranges;

#define NO_RANGE {-INFINITY, INFINITY}

static void check_ranges(const ranges *known, double tolerance)
{
    const armtol_arm *arm = arm_of(known->arm);
    for (size_t i = 0; i < arm->n_links; i++) {
        const double unit = arm->links[i].joint == SLIDE ? 1 : known->unit;
        for (int end = 0; end < 2; end++) {
            const double expected = known->ends[i][end] * unit;
            const double actual = end == 0 ? arm->drives[i].low : arm->drives[i].high;
            if (isinf(expected)) {
                check_same(expected, actual, "%s, joint %zu, end %d", arm->name, i + 1, end);
            } else {
                check_within(tolerance, expected, actual, "%s, joint %zu, end %d", arm->name, i + 1, end);
            }
        }
    }
}

static void test_joints_go_as_far_as_published(void)
{
    const double degree = pi / 180;
    const ranges exact[] = {
        {"puma560", degree, {{-160, 160}, {-45, 225}, {-225, 45}, {-110, 170}, {-100, 100}, {-266, 266}}},
        {"stanford", degree, {{-170, 170}, {-170, 170}, NO_RANGE, {-170, 170}, {-90, 90}, {-170, 170}}},
        {"ur5e", degree, {{-360, 360}, {-360, 360}, {-360, 360}, {-360, 360}, {-360, 360}, {-360, 360}}},
        {"panda",
         1,
         {{-2.8973, 2.8973},
          {-1.7628, 1.7628},
          {-2.8973, 2.8973},
          {-3.0718, -0.0698},
          {-2.8973, 2.8973},
          {-0.0175, 3.7525},
          {-2.8973, 2.8973}}},
    };
    /* printed in radians, rounded or cut off to four decimals, or so */
    const ranges rounded[] = {
        {"scara", 1, {{-1.8326, 1.8326}, {-2.618, 2.618}, {0, 210}, {-6.2832, 6.2832}}},
        {"iiwa14",
         1,
         {{-2.9668, 2.9668},
          {-2.0942, 2.0942},
          {-2.9668, 2.9668},
          {-2.0942, 2.0942},
          {-2.9668, 2.9668},
          {-2.0942, 2.0942},
          {-3.0541, 3.0541}}},
    };
    for (size_t i = 0; i < sizeof exact / sizeof exact[0]; i++) {
        check_ranges(&exact[i], 1e-14);
    }
    for (size_t i = 0; i < sizeof rounded / sizeof rounded[0]; i++) {
        check_ranges(&rounded[i], 3e-4);
    }
}

static void test_nothing_else_is_claimed_of_drives(void)
{
    for (size_t i = 0; i < ARMS; i++) {
        const armtol_arm *arm = armtol_arm_at(i);
        for (size_t link = 0; link < arm->n_links; link++) {
            const armtol_drive *drive = &arm->drives[link];
            TEST_ASSERT_TRUE_MESSAGE(drive->low < drive->high, arm->name);
            TEST_ASSERT_TRUE_MESSAGE(isnan(drive->backlash), arm->name);
            check_same(0, drive->compliance, "%s", arm->name);
            check_same(0, drive->moment, "%s", arm->name);
            TEST_ASSERT_TRUE_MESSAGE(i > 1 || (isinf(drive->low) && isinf(drive->high)), arm->name);
        }
    }
}

static void test_a_drive_is_off_by_backlash_and_by_giving_way(void)
{
    const armtol_drive drive = {-1, 1, 0.001, 0.0002, 30}, stiff = {-1, 1, 0.001, 0, 30};
    check_within(1e-18, 0.007, armtol_drive_error(&drive), "both");
    check_same(0.001, armtol_drive_error(&stiff), "backlash alone");
}

static void test_an_unknown_drive_has_an_unknown_error(void)
{
    const armtol_drive unknown = {-1, 1, NAN, 0.0002, 30};
    TEST_ASSERT_TRUE(isnan(armtol_drive_error(&unknown)));
    TEST_ASSERT_TRUE(isnan(armtol_drive_error(&armtol_drive_unknown)));
    check_same(-INFINITY, armtol_drive_unknown.low, "low");
    check_same(INFINITY, armtol_drive_unknown.high, "high");
    armtol_drive known = armtol_drive_unknown;
    known.backlash = 0.001;
    check_same(0.001, armtol_drive_error(&known), "with its backlash told, and no more");
}

/* A fixed foot, a joint, one that follows it, and another joint: the places in q, there and back. */
static void test_joints_and_links_are_numbered_apart(void)
{
    static const armtol_link links[4] = {{.joint = ARMTOL_FIXED},
                                         {.joint = ARMTOL_REVOLUTE},
                                         {.joint = ARMTOL_REVOLUTE},
                                         {.joint = ARMTOL_PRISMATIC}};
    static const armtol_motion motions[4] = {{.follows = 0},
                                             {.follows = 1, .sign = 1},
                                             {.follows = 1, .multiplier = 2, .sign = 1},
                                             {.follows = 3, .sign = -1}};
    const armtol_arm arm = {.n_links = 4, .links = links, .motions = motions};
    TEST_ASSERT_EQUAL_UINT(2, armtol_arm_joint_count(&arm));
    TEST_ASSERT_EQUAL_UINT(0, armtol_arm_joint_of(&arm, 1));
    TEST_ASSERT_EQUAL_UINT(1, armtol_arm_joint_of(&arm, 3));
    TEST_ASSERT_EQUAL_UINT(1, armtol_arm_link_of(&arm, 0));
    TEST_ASSERT_EQUAL_UINT(3, armtol_arm_link_of(&arm, 1));
    TEST_ASSERT_EQUAL_UINT(4, armtol_arm_link_of(&arm, 2));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_arm_is_found_by_its_number_and_its_name);
    RUN_TEST(test_there_are_no_others);
    RUN_TEST(test_every_arm_says_what_it_is);
    RUN_TEST(test_units_have_names);
    RUN_TEST(test_joints_and_links_are_numbered_apart);
    RUN_TEST(test_every_arm_moves_about_its_axes);
    RUN_TEST(test_kinds_fit_the_axes);
    RUN_TEST(test_the_puma_is_where_the_toolbox_has_it);
    RUN_TEST(test_the_panda_is_where_the_toolbox_has_it);
    RUN_TEST(test_the_panda_is_as_published);
    RUN_TEST(test_the_panda_stretches_at_the_published_angle);
    RUN_TEST(test_the_arms_of_1987_have_the_corrected_tables);
    RUN_TEST(test_joints_go_as_far_as_published);
    RUN_TEST(test_nothing_else_is_claimed_of_drives);
    RUN_TEST(test_a_drive_is_off_by_backlash_and_by_giving_way);
    RUN_TEST(test_an_unknown_drive_has_an_unknown_error);
    return UNITY_END();
}
