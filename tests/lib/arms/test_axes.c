#include "armtol/axes.h"

#include "armtol/arm.h"
#include "armtol/link_transform.h"
#include "armtol/robots.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"
#include "unity.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

enum { MOST_AXES = 9, MOST_LINKS = ARMTOL_LINKS_OF_AXES(MOST_AXES) };

static const double pi = 3.14159265358979323846;

static const armtol_transform tool_at_base = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

/* An arm as it is given, and what the library makes of it. */
typedef struct arm {
    size_t n_axes;
    armtol_axis axes[MOST_AXES];
    armtol_transform tool;
    size_t n_links;
    armtol_link links[MOST_LINKS];
    double snap;
    size_t n_snapped;
    armtol_snapped snapped[MOST_LINKS];
} arm;

static void convert(arm *arm)
{
    const armtol_status status = armtol_links_of_axes(arm->axes, arm->n_axes, &arm->tool, arm->snap, arm->links,
                                                      &arm->n_links, arm->snapped, &arm->n_snapped);
    TEST_ASSERT_EQUAL_STRING(armtol_status_text(ARMTOL_OK), armtol_status_text(status));
    TEST_ASSERT_TRUE(arm->n_links <= ARMTOL_LINKS_OF_AXES(arm->n_axes));
}

/* ---- where the axes bring the tool: Rodrigues' formula, in long double, last axis first ---- */

typedef long double vector[3];

static long double length_of(const double v[3])
{
    return sqrtl((long double)v[0] * v[0] + (long double)v[1] * v[1] + (long double)v[2] * v[2]);
}

static void turn(const vector unit, long double angle, vector v)
{
    const long double c = cosl(angle), s = sinl(angle);
    const long double along = (1 - c) * (unit[0] * v[0] + unit[1] * v[1] + unit[2] * v[2]);
    const vector w = {v[0], v[1], v[2]};
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        v[i] = c * w[i] + s * (unit[j] * w[k] - unit[k] * w[j]) + along * unit[i];
    }
}

/* Move a point, or with `free` a vector, by one joint. */
static void move(const armtol_axis *axis, double q, bool free, vector v)
{
    const double *const u = axis->direction;
    const long double length = length_of(u);
    const vector unit = {u[0] / length, u[1] / length, u[2] / length};
    if (axis->joint == ARMTOL_REVOLUTE) {
        for (int i = 0; i < 3; i++) {
            v[i] -= free ? 0 : axis->point[i];
        }
        turn(unit, q, v);
        for (int i = 0; i < 3; i++) {
            v[i] += free ? 0 : axis->point[i];
        }
    } else if (!free) {
        for (int i = 0; i < 3; i++) {
            v[i] += unit[i] * q;
        }
    }
}

static void tool_by_axes(const arm *arm, const double q[], double tool[4][4])
{
    for (int column = 0; column < 4; column++) {
        vector v = {arm->tool.m[0][column], arm->tool.m[1][column], arm->tool.m[2][column]};
        for (size_t i = arm->n_axes; i-- > 0;) {
            move(&arm->axes[i], q[i], column < 3, v);
        }
        for (int row = 0; row < 3; row++) {
            tool[row][column] = (double)v[row];
        }
        tool[3][column] = column == 3;
    }
}

static void check_tools(double expected[4][4], double actual[4][4], double tolerance, const char *what)
{
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            check_within(tolerance, expected[i][j], actual[i][j], "%s: row %d, column %d", what, i, j);
        }
    }
}

static void draw_joints(random_source *source, const arm *arm, double q[])
{
    for (size_t i = 0; i < arm->n_axes; i++) {
        q[i] = arm->axes[i].joint == ARMTOL_REVOLUTE ? random_between(source, -4, 4)
                                                      : random_between(source, -300, 300);
    }
}

/* The links do what the axes do, at the joint values 0 and at others. */
static void check_kinematics(const arm *arm, random_source *source, const char *what)
{
    double q[MOST_AXES] = {0};
    for (int n = 0; n < 5; n++) {
        armtol_link placed[MOST_LINKS];
        double by_axes[4][4], by_links[4][4];
        TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_links_place(arm->links, arm->n_links, q, arm->n_axes,
                                                        &armtol_errata_none, placed));
        reference_chain(placed, arm->n_links, by_links);
        tool_by_axes(arm, q, by_axes);
        check_tools(by_axes, by_links, 1e-9, what);
        draw_joints(source, arm, q);
    }
}

/* ---- what holds of every arm ---- */

/* Somebody would have to read a -0. */
static void check_sign_of_zero(double value, const char *what)
{
    TEST_ASSERT_TRUE_MESSAGE(value != 0 || !signbit(value), what);
}

static void check_angle(double angle, const char *what)
{
    check_sign_of_zero(angle, what);
    const double quarters = angle / (pi / 2), off = fabs(quarters - round(quarters)) * pi / 2;
    TEST_ASSERT_TRUE_MESSAGE(angle > -pi && angle <= pi, what);
    TEST_ASSERT_TRUE_MESSAGE(off <= 4 * DBL_EPSILON || off > 0.99e-13, what);
}

static void check_link_form(const armtol_link *link, const char *what)
{
    const bool parallel = link->kind == ARMTOL_PPR || link->kind == ARMTOL_PPP;
    const bool prismatic = link->joint == ARMTOL_PRISMATIC;
    check_angle(link->theta, what);
    check_angle(link->alpha, what);
    check_angle(link->beta, what);
    check_sign_of_zero(link->d, what);
    check_sign_of_zero(link->a, what);
    TEST_ASSERT_TRUE_MESSAGE(link->a == 0 || link->a > 1e-12, what);
    TEST_ASSERT_TRUE_MESSAGE(link->d == 0 || fabs(link->d) > 1e-12, what);
    const double most_tilt = 1.01 * pi / 4;
    TEST_ASSERT_TRUE_MESSAGE(link->beta == 0 || parallel || link->joint == ARMTOL_FIXED, what);
    TEST_ASSERT_TRUE_MESSAGE(fabs(link->beta) < most_tilt, what);
    TEST_ASSERT_TRUE_MESSAGE(link->d == 0 || link->kind != ARMTOL_PPR, what);
    TEST_ASSERT_TRUE_MESSAGE(prismatic == (link->kind == ARMTOL_NPP || link->kind == ARMTOL_PPP), what);
    TEST_ASSERT_TRUE_MESSAGE(link->a == 0 || !prismatic, what);
}

/* The moving links in the order of the axes; fixed ones only before and behind them, and never idle. */
static void check_form(const arm *arm, const char *what)
{
    size_t moving = 0;
    for (size_t i = 0; i < arm->n_links; i++) {
        const armtol_link *const link = &arm->links[i];
        check_link_form(link, what);
        if (link->joint == ARMTOL_FIXED) {
            TEST_ASSERT_TRUE_MESSAGE(moving == 0 || moving == arm->n_axes, what);
            TEST_ASSERT_TRUE_MESSAGE(link->theta != 0 || link->d != 0 || link->a != 0 || link->alpha != 0 ||
                                         link->beta != 0, what);
        } else {
            TEST_ASSERT_EQUAL_MESSAGE(arm->axes[moving].joint, link->joint, what);
            moving++;
        }
    }
    TEST_ASSERT_EQUAL_MESSAGE(arm->n_axes, moving, what);
}

/* The kinds of an arm's links, "npr ppr"; a fixed link's in brackets. */
static void check_kinds(const char *expected, const arm *arm)
{
    char kinds[MOST_LINKS * 8] = "";
    for (size_t i = 0; i < arm->n_links; i++) {
        const bool fixed = arm->links[i].joint == ARMTOL_FIXED;
        strcat(strcat(strcat(strcat(kinds, i > 0 ? " " : ""), fixed ? "[" : ""),
                      armtol_kind_name(arm->links[i].kind)), fixed ? "]" : "");
    }
    TEST_ASSERT_EQUAL_STRING(expected, kinds);
}

static void check_link(double theta, double d, double a, double alpha, double beta, const armtol_link *link)
{
    check_within(1e-12, theta, link->theta, "theta");
    check_within(1e-10, d, link->d, "d");
    check_within(1e-10, a, link->a, "a");
    check_within(1e-12, alpha, link->alpha, "alpha");
    check_within(1e-12, beta, link->beta, "beta");
}

/* ---- arms drawn at random ---- */

static void draw_vector(random_source *source, double size, double v[3])
{
    for (int i = 0; i < 3; i++) {
        v[i] = random_between(source, -size, size);
    }
}

static double dot(const double v[3], const double w[3])
{
    return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

static void make_unit(double v[3])
{
    const double length = (double)length_of(v);
    for (int i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

/* A unit vector that makes this angle with the unit vector v. */
static void draw_tilted(random_source *source, const double v[3], double angle, double tilted[3])
{
    double side[3];
    draw_vector(source, 1, side);
    const double along = dot(side, v);
    for (int i = 0; i < 3; i++) {
        side[i] -= along * v[i];
    }
    make_unit(side);
    for (int i = 0; i < 3; i++) {
        tilted[i] = cos(angle) * v[i] + sin(angle) * side[i];
    }
}

typedef enum relation {
    ANY,
    MEETING,
    PARALLEL,
    ANTIPARALLEL,
    COINCIDENT,
    REVERSED, /* the same line, the other way */
    NEARLY_PARALLEL,
    NEARLY_ANTIPARALLEL,
    NEARLY_COINCIDENT, /* meets it at less than a degree */
    HALF_A_DEGREE_MORE,
    SQUARE,
    RELATIONS
} relation;

static double angle_of(random_source *source, relation relation)
{
    const double degree = pi / 180;
    switch (relation) {
    case PARALLEL:
    case COINCIDENT:
        return 0;
    case ANTIPARALLEL:
    case REVERSED:
        return pi;
    case NEARLY_PARALLEL:
    case NEARLY_COINCIDENT:
        return 0.3 * degree;
    case NEARLY_ANTIPARALLEL:
        return pi - 0.999 * degree;
    case HALF_A_DEGREE_MORE:
        return 1.5 * degree;
    case SQUARE:
        return pi / 2;
    default:
        return random_between(source, 0.1, 3);
    }
}

static bool is_exact(relation relation)
{
    return relation == PARALLEL || relation == COINCIDENT || relation == ANTIPARALLEL || relation == REVERSED;
}

/* A line (point, unit direction) in a relation to another. */
static void draw_line(random_source *source, relation relation, const double from_point[3],
                      const double from[3], double point[3], double direction[3])
{
    const bool shared = relation == MEETING || relation == COINCIDENT || relation == REVERSED ||
                        relation == NEARLY_COINCIDENT;
    double shift[3] = {0};
    draw_tilted(source, from, angle_of(source, relation), direction);
    if (is_exact(relation)) {
        const double sense = relation == PARALLEL || relation == COINCIDENT ? 1 : -1;
        for (int i = 0; i < 3; i++) {
            direction[i] = sense * from[i];
        }
    }
    if (!shared) {
        draw_vector(source, 300, shift);
    }
    const double before = random_between(source, -300, 300), behind = random_between(source, -300, 300);
    for (int i = 0; i < 3; i++) {
        point[i] = from_point[i] + before * from[i] + shift[i] + behind * direction[i];
    }
}

/* A tool on the line, turned about it by any angle. */
static void draw_tool(random_source *source, const double point[3], const double z[3], armtol_transform *tool)
{
    double x[3];
    draw_tilted(source, z, pi / 2, x);
    *tool = (armtol_transform){{{0}, {0}, {0}, {0, 0, 0, 1}}};
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        tool->m[i][0] = x[i];
        tool->m[i][1] = z[j] * x[k] - z[k] * x[j];
        tool->m[i][2] = z[i];
        tool->m[i][3] = point[i];
    }
}

static relation draw_relation(random_source *source)
{
    return (relation)random_between(source, 0, RELATIONS);
}

/* Directions are not of length 1, and a slide's point is far from anything. */
static void draw_arm(random_source *source, double share_of_slides, arm *arm)
{
    double point[3] = {0}, direction[3] = {0, 0, 1};
    arm->n_axes = (size_t)random_between(source, 1, MOST_AXES + 1);
    for (size_t i = 0; i <= arm->n_axes; i++) {
        double next_point[3], next[3];
        draw_line(source, draw_relation(source), point, direction, next_point, next);
        memcpy(point, next_point, sizeof point);
        memcpy(direction, next, sizeof direction);
        make_unit(direction);
        if (i < arm->n_axes) {
            armtol_axis *const axis = &arm->axes[i];
            const double scale = exp(random_between(source, -20, 20));
            axis->joint = random_between(source, 0, 1) < share_of_slides ? ARMTOL_PRISMATIC : ARMTOL_REVOLUTE;
            for (int k = 0; k < 3; k++) {
                axis->point[k] = axis->joint == ARMTOL_REVOLUTE ? point[k] : 1e7 * direction[k];
                axis->direction[k] = scale * direction[k];
            }
        }
    }
    draw_tool(source, point, direction, &arm->tool);
}

static void check_random_arms(double share_of_slides, uint64_t seed)
{
    random_source source = {seed};
    for (int n = 0; n < 600; n++) {
        arm arm = {.snap = 0};
        char what[40];
        draw_arm(&source, share_of_slides, &arm);
        convert(&arm);
        snprintf(what, sizeof what, "arm %d", n);
        check_form(&arm, what);
        check_kinematics(&arm, &source, what);
    }
}

static void test_links_of_revolute_axes_move_as_the_axes_do(void)
{
    check_random_arms(0, 1);
}

static void test_links_of_mixed_axes_move_as_the_axes_do(void)
{
    check_random_arms(0.4, 2);
}

static void test_links_of_prismatic_axes_move_as_the_axes_do(void)
{
    check_random_arms(1, 3);
}

/* ---- the relations, one by one: two axes, the first on the base's z, the tool on the second ---- */

static void draw_pair(random_source *source, relation relation, arm *arm)
{
    const double origin[3] = {0}, z[3] = {0, 0, 1};
    arm->n_axes = 2;
    arm->axes[0] = (armtol_axis){ARMTOL_REVOLUTE, {0, 0, random_between(source, -500, 500)}, {0, 0, 2}};
    arm->axes[1].joint = ARMTOL_REVOLUTE;
    draw_line(source, relation, origin, z, arm->axes[1].point, arm->axes[1].direction);
    draw_tool(source, arm->axes[1].point, arm->axes[1].direction, &arm->tool);
}

/* The distance of the lines and the angle between their directions, from their definitions. */
static double distance_of(const arm *arm)
{
    const double *const p = arm->axes[1].point, *const u = arm->axes[1].direction;
    const double sine = hypot(u[0], u[1]);
    return sine > 1e-9 ? fabs(p[0] * u[1] - p[1] * u[0]) / sine : hypot(p[0], p[1]);
}

static void test_two_axes_have_the_kind_length_and_twist_of_their_relation(void)
{
    random_source source = {4};
    for (int n = 0; n < 50 * RELATIONS; n++) {
        const relation relation = (enum relation)(n % RELATIONS);
        arm arm = {.snap = 0};
        draw_pair(&source, relation, &arm);
        convert(&arm);
        const armtol_link *const link = &arm.links[0];
        const double cosine = arm.axes[1].direction[2] / (double)length_of(arm.axes[1].direction);
        /* the tool is on axis 2: the reach is what is between the axes */
        const bool parallel = fabs(cosine) > sqrt(0.5);
        check_kinds(parallel ? "ppr npr" : "npr npr", &arm);
        check_within(1e-12, cosine, cos(link->alpha) * cos(link->beta), "twist, relation %d", relation);
        if (!parallel) {
            check_within(1e-8, distance_of(&arm), link->a, "distance, relation %d", relation);
        } else if (is_exact(relation)) {
            check_same(relation == PARALLEL || relation == COINCIDENT ? 0 : pi, link->alpha, "alpha");
            check_same(0, link->beta, "beta");
            check_within(1e-10, distance_of(&arm), link->a, "distance, relation %d", relation);
        }
    }
}

/* Rounding is nothing: axes that meet, or are one, are off by the like of it. */
static void test_what_rounding_leaves_is_set_to_zero(void)
{
    arm arm = {.n_axes = 3,
               .axes = {{ARMTOL_REVOLUTE, {3e-12, -2e-12, 0}, {1e-16, 2e-16, 1}},
                        {ARMTOL_REVOLUTE, {2e-12, 3e-12, 400}, {6.1e-17, -1, 3e-16}},
                        {ARMTOL_REVOLUTE, {425, 7, 400 + 1e-12}, {-1e-16, -1, -2e-16}}},
               .tool = {{{1, 1e-16, 0, 425}, {0, -1e-16, 1, -93}, {0, -1, 1e-16, 400}, {0, 0, 0, 1}}}};
    convert(&arm);
    check_kinds("npr ppr npr", &arm);
    check_same(400, arm.links[0].d, "d");
    check_same(0, arm.links[0].theta, "theta, along the cross product");
    check_same(0, arm.links[0].a, "a");
    check_same(pi / 2, arm.links[0].alpha, "alpha");
    check_same(0, arm.links[1].theta, "theta to the next axis");
    check_same(0, arm.links[1].d, "d of parallel axes");
    check_same(425, arm.links[1].a, "a");
    check_same(0, arm.links[1].alpha, "alpha of parallel axes");
    check_same(0, arm.links[1].beta, "beta of parallel axes");
    check_same(0, arm.links[2].theta, "theta to the tool");
    check_same(0, arm.links[2].a, "a to the tool");
    check_same(pi, arm.links[2].alpha, "alpha to the tool");
    check_within(1e-12, 93, arm.links[2].d, "length of the tool");
}

/* x of axes that meet is along their cross product on whichever side of the other rounding has put one. */
static void test_rounding_does_not_choose_a_direction(void)
{
    for (int n = 0; n < 3; n++) {
        arm arm = {.n_axes = 2,
                   .axes = {{ARMTOL_REVOLUTE, {0}, {0, 0, 1}},
                            {ARMTOL_REVOLUTE, {1e-12 * (n - 1), 1e-12 * (n - 1), 1e-12}, {0, -1, 0}}},
                   .tool = {{{1, 0, 0, 0}, {0, 0, -1, -40}, {0, 1, 0, 0}, {0, 0, 0, 1}}}};
        convert(&arm);
        check_kinds("npr npr", &arm);
        check_same(0, arm.links[0].theta, "theta");
        check_same(0, arm.links[0].d, "d");
        check_same(0, arm.links[0].a, "a");
        check_same(pi / 2, arm.links[0].alpha, "alpha");
    }
    const double angle = 0.3 * pi / 180;
    arm arm = {.n_axes = 2,
               .axes = {{ARMTOL_REVOLUTE, {0}, {0, 0, 1}},
                        {ARMTOL_REVOLUTE, {40, 0, 0}, {1e-16, -sin(angle), cos(angle)}}},
               .tool = tool_at_base};
    convert(&arm);
    check_within(1e-15, angle, arm.links[0].alpha, "alpha");
    check_same(0, arm.links[0].beta, "beta");
}

/* The size of an arm is in its revolute axes too; what a slide has as its point does not count. */
static void test_rounding_is_judged_by_the_size_of_the_arm(void)
{
    arm arm = {.n_axes = 2,
               .axes = {{ARMTOL_REVOLUTE, {0}, {0, 0, 1}}, {ARMTOL_REVOLUTE, {1e-8, 0, 1e6}, {0, -1, 0}}},
               .tool = tool_at_base};
    convert(&arm);
    check_same(0, arm.links[0].a, "a beside 1e6");
    arm.axes[1].point[2] = 1e4;
    convert(&arm);
    check_within(1e-20, 1e-8, arm.links[0].a, "a beside 1e4");
    arm.axes[1].point[2] = 1;
    arm.axes[0] = (armtol_axis){ARMTOL_PRISMATIC, {0, 0, 1e6}, {1, 0, 0}};
    arm.axes[1].point[1] = 1e-8;
    convert(&arm);
    check_within(1e-20, 1e-8, arm.links[0].a, "a beside a slide");
}

/* A tilt that is more than rounding is kept: 5e-12 rad on 1000 mm would show. */
static void test_a_small_tilt_is_no_rounding(void)
{
    random_source source = {5};
    arm arm = {.n_axes = 2,
               .axes = {{ARMTOL_REVOLUTE, {0}, {0, 0, 1}},
                        {ARMTOL_REVOLUTE, {1000, 0, 0}, {3e-12, 4e-12, 1}}},
               .tool = {{{1, 0, 0, 1000}, {0, 1, 0, 0}, {0, 0, 1, 500}, {0, 0, 0, 1}}}};
    convert(&arm);
    check_kinds("ppr npr [npr]", &arm); /* the tool's axis crosses axis 2 500 below it */
    check_within(1e-20, 3e-12, arm.links[0].beta, "beta: z leans to x");
    check_within(1e-20, -4e-12, arm.links[0].alpha, "alpha: z leans to y");
    check_kinematics(&arm, &source, "tilted by 5e-12");
}

/* The common perpendiculars of axes that are little more than a degree apart are far away. */
static void test_axes_that_are_hardly_not_parallel(void)
{
    random_source source = {11};
    for (int n = 0; n < 500; n++) {
        arm arm = {.n_axes = 5};
        double point[3] = {0}, direction[3] = {0, 0, 1};
        for (size_t i = 0; i <= arm.n_axes; i++) {
            double next[3];
            draw_tilted(&source, direction, 1.01 * pi / 180, next);
            memcpy(direction, next, sizeof direction);
            draw_vector(&source, 500, point);
            if (i < arm.n_axes) {
                arm.axes[i].joint = i % 2 == 0 ? ARMTOL_REVOLUTE : ARMTOL_PRISMATIC;
                memcpy(arm.axes[i].point, point, sizeof point);
                memcpy(arm.axes[i].direction, direction, sizeof direction);
            }
        }
        draw_tool(&source, point, direction, &arm.tool);
        convert(&arm);
        check_form(&arm, "1.01 degrees");
        check_kinematics(&arm, &source, "1.01 degrees");
    }
}

/*
 * Axis 2 is 300 from axis 1 and the tool 250 from axis 2: a reach of 550. By the tilt about y the axes cross 300 / tan
 * below, by that about x they do so where they are. Neither counts: the kind is that of the angle.
 */
static void test_the_common_perpendicular_is_near_within_the_reach(void)
{
    random_source source = {6};
    const double edge = atan(300.0 / 550);
    for (int n = 0; n < 20; n++) {
        const double angle = edge * (n % 2 == 0 ? 0.998 : 1.001), s = sin(angle), c = cos(angle);
        const double about = random_between(&source, -pi, pi);
        arm arm = {.n_axes = 2,
                   .axes = {{ARMTOL_REVOLUTE, {0, 0, random_between(&source, -900, 900)}, {0, 0, 1}},
                            {ARMTOL_REVOLUTE, {300, 0, 0}, {s * cos(about), s * sin(about), c}}}};
        double beside[3] = {-sin(about), cos(about), 0}; /* square to axis 2 */
        for (int i = 0; i < 3; i++) {
            beside[i] = arm.axes[1].point[i] + 250 * beside[i];
        }
        draw_tool(&source, beside, arm.axes[1].direction, &arm.tool);
        for (int i = 0; i < 3; i++) { /* the same axis, given by a point that is elsewhere on it */
            arm.axes[1].point[i] += 1e3 * (n - 10) * arm.axes[1].direction[i];
        }
        convert(&arm);
        check_kinds(n % 2 == 0 ? "ppr ppr [npr]" : "npr ppr [npr]", &arm);
        check_kinematics(&arm, &source, "either side of the reach");
    }
}

/*
 * Coaxial joints have no distance that would tell: below a tangent of 0.1 they count as nearly parallel; a tool does
 * not.
 */
static void test_axes_that_cross_at_small_angles(void)
{
    random_source source = {12};
    for (int n = 0; n < 6; n++) {
        static const double tangents[] = {0.02, 0.0999, 0.1001};
        const double angle = atan(tangents[n % 3]);
        const bool slides = n >= 3;
        arm arm = {.n_axes = 2,
                   .axes = {{slides ? ARMTOL_PRISMATIC : ARMTOL_REVOLUTE, {0}, {0, 0, 1}},
                            {ARMTOL_REVOLUTE, {0}, {sin(angle), 0, cos(angle)}}}};
        double z[3];
        draw_tilted(&source, arm.axes[1].direction, angle, z);
        draw_tool(&source, (double[]){0, 400, 0}, z, &arm.tool);
        convert(&arm);
        check_kinds(n % 3 == 2 ? (slides ? "npp ppr [npr]" : "npr ppr [npr]")
                               : (slides ? "ppp ppr [npr]" : "ppr ppr [npr]"),
                    &arm);
        draw_tool(&source, arm.axes[1].point, z, &arm.tool);
        convert(&arm);
        TEST_ASSERT_EQUAL(ARMTOL_NPR, arm.links[1].kind);
        check_kinematics(&arm, &source, "small angles");
    }
}

/* ---- the base and the tool ---- */

static void test_the_base_has_a_link_unless_axis_1_is_its_z(void)
{
    const double s = sin(pi / 180 * 0.3), c = cos(pi / 180 * 0.3);
    arm arm = {.n_axes = 1, .axes = {{ARMTOL_REVOLUTE, {0, 0, 7}, {0, 0, 1}}}, .tool = tool_at_base};
    convert(&arm);
    check_kinds("npr", &arm);

    arm.axes[0] = (armtol_axis){ARMTOL_REVOLUTE, {0, 30, 7}, {0, 0, 1}};
    convert(&arm);
    check_kinds("[npr] ppr [npr]", &arm);
    check_link(pi / 2, 0, 30, 0, 0, &arm.links[0]);
    check_link(pi, 0, 30, 0, 0, &arm.links[1]);
    check_link(pi / 2, 0, 0, 0, 0, &arm.links[2]);

    arm.axes[0] = (armtol_axis){ARMTOL_REVOLUTE, {0, 0, 7}, {0, 0, -1}};
    convert(&arm);
    check_kinds("[npr] npr", &arm);
    check_link(0, 0, 0, pi, 0, &arm.links[0]);
    check_link(0, 0, 0, pi, 0, &arm.links[1]);

    arm.axes[0] = (armtol_axis){ARMTOL_REVOLUTE, {30, 0, 7}, {0, -1, 0}};
    convert(&arm);
    check_link(0, 7, 30, pi / 2, 0, &arm.links[0]);
    TEST_ASSERT_EQUAL(ARMTOL_NPR, arm.links[0].kind);

    arm.axes[0] = (armtol_axis){ARMTOL_REVOLUTE, {30, 0, 0}, {s, 0, c}};
    convert(&arm);
    check_link(0, 0, 30, 0, 0.3 * pi / 180, &arm.links[0]);
    TEST_ASSERT_EQUAL(ARMTOL_NPR, arm.links[0].kind);
}

/* Axis 1 is the base's z axis; the tool's z axis lies on it, beside it, across it. */
static void test_the_tool_has_a_link_unless_its_z_is_the_last_axis(void)
{
    arm arm = {.n_axes = 1,
               .axes = {{ARMTOL_REVOLUTE, {0}, {0, 0, 1}}},
               .tool = {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 95}, {0, 0, 0, 1}}}};
    convert(&arm);
    check_kinds("npr", &arm);
    check_link(pi / 2, 95, 0, 0, 0, &arm.links[0]);

    arm.tool = (armtol_transform){{{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, -1, 95}, {0, 0, 0, 1}}};
    convert(&arm);
    check_kinds("npr", &arm);
    check_link(pi / 2, 95, 0, pi, 0, &arm.links[0]);

    arm.tool = (armtol_transform){{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 95}, {0, 0, 0, 1}}};
    convert(&arm);
    check_link(pi, 95, 0, pi, 0, &arm.links[0]);

    arm.tool = (armtol_transform){{{1, 0, 0, 60}, {0, 1, 0, 80}, {0, 0, 1, 95}, {0, 0, 0, 1}}};
    convert(&arm);
    check_kinds("ppr [npr]", &arm);
    check_link(atan2(4, 3), 0, 100, 0, 0, &arm.links[0]);
    check_link(-atan2(4, 3), 95, 0, 0, 0, &arm.links[1]);

    arm.tool = (armtol_transform){{{0, 0, 1, 60}, {0, 1, 0, 80}, {-1, 0, 0, 95}, {0, 0, 0, 1}}};
    convert(&arm);
    check_kinds("npr [npr]", &arm);
    check_link(pi / 2, 95, 80, pi / 2, 0, &arm.links[0]);
    check_link(-pi / 2, 60, 0, 0, 0, &arm.links[1]);

    arm.axes[0].joint = ARMTOL_PRISMATIC;
    arm.tool = (armtol_transform){{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 95}, {0, 0, 0, 1}}};
    convert(&arm);
    check_kinds("ppp", &arm);
    check_link(pi / 2, 95, 0, 0, 0, &arm.links[0]);
}

/* ---- prismatic joints ---- */

/* x, y and z in turn, a rotating head under them: slides go through the point of the head's axis. */
static void test_a_gantry(void)
{
    random_source source = {7};
    arm arm = {.n_axes = 4,
               .axes = {{ARMTOL_PRISMATIC, {9, 9, 9}, {1, 0, 0}},
                        {ARMTOL_PRISMATIC, {8, 8, 8}, {0, 1, 0}},
                        {ARMTOL_PRISMATIC, {7, 7, 7}, {0, 0, -1}},
                        {ARMTOL_REVOLUTE, {100, 200, 300}, {0, 0, -1}}},
               .tool = {{{1, 0, 0, 100}, {0, -1, 0, 200}, {0, 0, -1, 250}, {0, 0, 0, 1}}}};
    convert(&arm);
    check_kinds("[npr] npp npp ppp npr", &arm);
    /* To the line along x through (100, 200, 300): it crosses 200 beside z, 300 up; z x x = y. */
    check_link(pi / 2, 300, 200, pi / 2, 0, &arm.links[0]);
    check_within(1e-10, 100, arm.links[1].d, "d along x");
    check_link(arm.links[1].theta, 100, 0, pi / 2, 0, &arm.links[1]);
    check_link(arm.links[2].theta, 0, 0, pi / 2, 0, &arm.links[2]);
    check_link(0, 0, 0, 0, 0, &arm.links[3]);
    check_within(1e-10, 50, arm.links[4].d, "length of the tool");
    check_kinematics(&arm, &source, "gantry");
}

/* A lift below an axis that is parallel to it; two slides that are parallel but for 0.3 degrees. */
static void test_slides_parallel_to_what_follows_have_no_length(void)
{
    random_source source = {8};
    arm arm = {.n_axes = 2,
               .axes = {{ARMTOL_PRISMATIC, {0}, {0, 0, 1}}, {ARMTOL_REVOLUTE, {0, 0, 40}, {0, 0, 1}}},
               .tool = {{{1, 0, 0, 300}, {0, 1, 0, 0}, {0, 0, 1, 100}, {0, 0, 0, 1}}}};
    convert(&arm);
    check_kinds("ppp ppr [npr]", &arm);
    check_link(0, 40, 0, 0, 0, &arm.links[0]);
    check_link(0, 0, 300, 0, 0, &arm.links[1]);
    check_link(0, 60, 0, 0, 0, &arm.links[2]);

    const double angle = 0.3 * pi / 180;
    arm.axes[1] = (armtol_axis){ARMTOL_PRISMATIC, {0}, {0, -sin(angle), cos(angle)}};
    convert(&arm);
    check_kinds("[npr] ppp ppp", &arm);
    check_link(0, 0, 300, 0, 0, &arm.links[0]);
    check_link(0, 100, 0, angle, 0, &arm.links[1]);
    check_link(0, 0, 0, -angle, 0, &arm.links[2]);
    check_kinematics(&arm, &source, "two slides");
}

/* ---- tables that are known ---- */

/* The axes and the tool of a table, from the frames of its links. */
static void axes_of_table(const armtol_link links[], size_t n_links, arm *arm)
{
    armtol_transform frame = armtol_chain_transform(NULL, 0, &armtol_errata_none);
    arm->n_axes = 0;
    for (size_t i = 0; i < n_links; i++) {
        if (links[i].joint != ARMTOL_FIXED) {
            armtol_axis *const axis = &arm->axes[arm->n_axes++];
            axis->joint = links[i].joint;
            for (int k = 0; k < 3; k++) {
                axis->point[k] = frame.m[k][3];
                axis->direction[k] = frame.m[k][2];
            }
        }
        double next[4][4];
        reference_chain(links, i + 1, next);
        memcpy(frame.m, next, sizeof next);
    }
    arm->tool = frame;
}

static void check_same_arm(const armtol_link links[], size_t n_links, const arm *arm)
{
    random_source source = {9};
    for (int n = 0; n < 20; n++) {
        double q[MOST_AXES], expected[4][4], actual[4][4];
        armtol_link placed[MOST_LINKS];
        draw_joints(&source, arm, q);
        TEST_ASSERT_EQUAL(ARMTOL_OK,
                          armtol_links_place(links, n_links, q, arm->n_axes, &armtol_errata_none, placed));
        reference_chain(placed, n_links, expected);
        TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_links_place(arm->links, arm->n_links, q, arm->n_axes,
                                                        &armtol_errata_none, placed));
        reference_chain(placed, arm->n_links, actual);
        check_tools(expected, actual, 1e-9, "the table's tool");
    }
}

static void test_the_arms_of_1987_come_back(void)
{
    armtol_link links[MOST_LINKS];
    arm arm = {.snap = 0};
    armtol_intelledex_605t.links(&armtol_errata_none, links);
    axes_of_table(links, armtol_intelledex_605t.n_links, &arm);
    convert(&arm);
    check_kinds("npr npr ppr ppr npr npr", &arm); /* 359.7 of the base's link and 100 of the tool's are d */
    check_within(1e-10, 359.7, arm.links[0].d, "height of the shoulder");
    check_within(1e-10, 373.4, arm.links[2].a, "upper arm");
    check_within(1e-10, 279.4, arm.links[3].a, "forearm");
    check_within(1e-10, 100, arm.links[5].d, "tool");
    check_same_arm(links, armtol_intelledex_605t.n_links, &arm);

    armtol_adept_one.links(&armtol_errata_none, links);
    axes_of_table(links, armtol_adept_one.n_links, &arm);
    convert(&arm);
    check_kinds("ppr ppr ppr ppp", &arm);
    check_within(1e-10, 425, arm.links[0].a, "inner link");
    check_within(1e-10, 375, arm.links[1].a, "outer link");
    check_same(0, arm.links[2].a, "the quill is on axis 3");
    check_within(1e-10, 203.2, arm.links[3].d, "height");
    check_same_arm(links, armtol_adept_one.n_links, &arm);
}

/* Whatever their tables' form, with no more links than those have. */
static void test_the_built_in_arms_come_back(void)
{
    TEST_ASSERT_TRUE(armtol_arm_count() > 2);
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        const armtol_arm *const built_in = armtol_arm_at(i);
        arm arm = {.snap = 0};
        axes_of_table(built_in->links, built_in->n_links, &arm);
        convert(&arm);
        check_form(&arm, built_in->name);
        TEST_ASSERT_TRUE_MESSAGE(arm.n_links <= built_in->n_links, built_in->name);
        check_same_arm(built_in->links, built_in->n_links, &arm);
    }
}

/* Hayati's parameters of tables that are in this form already come back as they were. */
static void test_a_table_in_the_same_form_comes_back_to_the_digit(void)
{
    random_source source = {10};
    for (int n = 0; n < 200; n++) {
        armtol_link links[4] = {
            {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = 1.2, .d = 300},
            {ARMTOL_PPR, ARMTOL_REVOLUTE},
            {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = -0.8, .d = -40},
            {ARMTOL_NPR, ARMTOL_REVOLUTE, .d = 120},
        };
        arm arm = {.snap = 0};
        for (int i = 0; i < 4; i++) {
            links[i].theta = random_between(&source, -3, 3);
            links[i].a = i < 3 ? random_between(&source, 50, 500) : 0;
        }
        links[1].alpha = random_between(&source, -0.012, 0.012) + (n % 2 == 0 ? 0 : pi);
        links[1].alpha -= links[1].alpha > pi ? 2 * pi : 0;
        links[1].beta = random_between(&source, -0.012, 0.012);
        axes_of_table(links, 4, &arm);
        convert(&arm);
        TEST_ASSERT_EQUAL(4, arm.n_links);
        for (int i = 0; i < 4; i++) {
            TEST_ASSERT_EQUAL(links[i].kind, arm.links[i].kind);
            check_within(1e-9, links[i].theta, arm.links[i].theta, "theta %d", i);
            check_within(1e-8, links[i].d, arm.links[i].d, "d %d", i);
            check_within(1e-8, links[i].a, arm.links[i].a, "a %d", i);
            check_within(1e-12, links[i].alpha, arm.links[i].alpha, "alpha %d", i);
            check_within(1e-12, links[i].beta, arm.links[i].beta, "beta %d", i);
        }
    }
}

/* ---- what is wrong ---- */

/* It fails so, and nothing is written. */
static void check_refused(armtol_status expected, const armtol_axis axes[], size_t n_axes,
                          const armtol_transform *tool)
{
    armtol_link links[ARMTOL_LINKS_OF_AXES(2)], before[ARMTOL_LINKS_OF_AXES(2)];
    size_t n_links = 77, n_snapped = 77;
    memset(links, 0x5a, sizeof links);
    memset(before, 0x5a, sizeof before);
    TEST_ASSERT_EQUAL_STRING(armtol_status_text(expected),
                             armtol_status_text(armtol_links_of_axes(axes, n_axes, tool, 0, links, &n_links, NULL,
                                                                     &n_snapped)));
    TEST_ASSERT_EQUAL(77, n_links);
    TEST_ASSERT_EQUAL(77, n_snapped);
    TEST_ASSERT_EQUAL_MEMORY(before, links, sizeof links);
}

static void test_wrong_input_is_refused(void)
{
    const armtol_axis right[2] = {{ARMTOL_REVOLUTE, {0}, {0, 0, 1}}, {ARMTOL_PRISMATIC, {0}, {1, 0, 0}}};
    armtol_axis axes[2];
    armtol_transform tool = tool_at_base;
    memcpy(axes, right, sizeof axes);
    check_refused(ARMTOL_WRONG_SIZE, axes, 0, &tool);
    axes[1].joint = ARMTOL_FIXED;
    check_refused(ARMTOL_BAD_AXIS, axes, 2, &tool);
    axes[1].joint = (armtol_joint)ARMTOL_JOINT_COUNT;
    check_refused(ARMTOL_BAD_AXIS, axes, 2, &tool);
    memcpy(axes, right, sizeof axes);
    axes[1].direction[0] = 0;
    check_refused(ARMTOL_BAD_AXIS, axes, 2, &tool);
    axes[1].direction[2] = INFINITY;
    check_refused(ARMTOL_NOT_FINITE, axes, 2, &tool);
    memcpy(axes, right, sizeof axes);
    axes[0].point[1] = NAN;
    check_refused(ARMTOL_NOT_FINITE, axes, 2, &tool);
    memcpy(axes, right, sizeof axes);
    tool.m[2][3] = NAN;
    check_refused(ARMTOL_NOT_FINITE, axes, 2, &tool);
    tool = tool_at_base;
    axes[1] = (armtol_axis){ARMTOL_REVOLUTE, {DBL_MAX, DBL_MAX, 0}, {0.1, -0.1, 1}};
    check_refused(ARMTOL_NOT_FINITE, axes, 2, &tool);
}

static void test_the_length_of_a_direction_is_free(void)
{
    arm arm = {.n_axes = 2,
               .axes = {{ARMTOL_REVOLUTE, {0}, {0, 0, DBL_MIN}},
                        {ARMTOL_REVOLUTE, {5, 0, 0}, {0, -DBL_MAX, DBL_MAX}}},
               .tool = tool_at_base};
    convert(&arm);
    check_link(0, 0, 5, pi / 4, 0, &arm.links[0]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_links_of_revolute_axes_move_as_the_axes_do);
    RUN_TEST(test_links_of_mixed_axes_move_as_the_axes_do);
    RUN_TEST(test_links_of_prismatic_axes_move_as_the_axes_do);
    RUN_TEST(test_two_axes_have_the_kind_length_and_twist_of_their_relation);
    RUN_TEST(test_what_rounding_leaves_is_set_to_zero);
    RUN_TEST(test_rounding_does_not_choose_a_direction);
    RUN_TEST(test_rounding_is_judged_by_the_size_of_the_arm);
    RUN_TEST(test_a_small_tilt_is_no_rounding);
    RUN_TEST(test_axes_that_are_hardly_not_parallel);
    RUN_TEST(test_the_common_perpendicular_is_near_within_the_reach);
    RUN_TEST(test_axes_that_cross_at_small_angles);
    RUN_TEST(test_the_base_has_a_link_unless_axis_1_is_its_z);
    RUN_TEST(test_the_tool_has_a_link_unless_its_z_is_the_last_axis);
    RUN_TEST(test_a_gantry);
    RUN_TEST(test_slides_parallel_to_what_follows_have_no_length);
    RUN_TEST(test_the_arms_of_1987_come_back);
    RUN_TEST(test_the_built_in_arms_come_back);
    RUN_TEST(test_a_table_in_the_same_form_comes_back_to_the_digit);
    RUN_TEST(test_wrong_input_is_refused);
    RUN_TEST(test_the_length_of_a_direction_is_free);
    return UNITY_END();
}
