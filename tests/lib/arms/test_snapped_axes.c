/* Axes that are nearly something, and tables that become axes. */

#include "armtol/axes.h"

#include "armtol/arm.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"
#include "unity.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

enum { MOST_AXES = 8, MOST_LINKS = ARMTOL_LINKS_OF_AXES(MOST_AXES) };

static const double pi = 3.14159265358979323846;

typedef struct arm {
    size_t n_axes, n_links, n_snapped;
    armtol_axis axes[MOST_AXES];
    armtol_transform tool;
    armtol_link links[MOST_LINKS];
    armtol_snapped snapped[MOST_LINKS];
} arm;

static void convert(arm *arm, double snap)
{
    TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_links_of_axes(arm->axes, arm->n_axes, &arm->tool, snap, arm->links,
                                                      &arm->n_links, arm->snapped, &arm->n_snapped));
}

/* ---- robots of square turns, and the same with a little noise ---- */

/* A rotation about x, y or z, multiplied out. */
static void turn(double r[3][3], int about, double angle)
{
    const int j = (about + 1) % 3, k = (about + 2) % 3;
    for (int i = 0; i < 3; i++) {
        const double u = r[i][j], v = r[i][k];
        r[i][j] = cos(angle) * u + sin(angle) * v;
        r[i][k] = cos(angle) * v - sin(angle) * u;
    }
}

/* Frames at quarter turns and at lengths of half of which are 0, each `noise` off. */
static void draw_robot(random_source *source, double noise, arm *arm)
{
    double r[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, p[3] = {0};
    arm->n_axes = (size_t)random_between(source, 1, MOST_AXES + 1);
    for (size_t i = 0; i <= arm->n_axes; i++) {
        for (int k = 0; k < 3; k++) {
            const double length = random_between(source, 0, 1) < 0.5 ? 0 : random_between(source, 0.1, 0.5);
            for (int row = 0; row < 3; row++) {
                p[row] += r[row][k] * (length + noise * random_between(source, -1, 1));
            }
        }
        for (int k = 0; k < 3; k++) {
            const double quarters = random_between(source, 0, 1) < 0.6 ? 0 : floor(random_between(source, -1, 3));
            turn(r, k, quarters * pi / 2 + noise * random_between(source, -1, 1));
        }
        for (int row = 0; row < 3 && i < arm->n_axes; row++) {
            arm->axes[i].joint = ARMTOL_REVOLUTE;
            arm->axes[i].point[row] = p[row];
            arm->axes[i].direction[row] = r[row][2];
        }
    }
    for (int row = 0; row < 3; row++) {
        memcpy(arm->tool.m[row], r[row], sizeof r[row]);
        arm->tool.m[row][3] = p[row];
    }
    memcpy(arm->tool.m[3], (const double[]){0, 0, 0, 1}, sizeof arm->tool.m[3]);
}

static void place(const arm *arm, const double q[], double tool[4][4])
{
    armtol_link placed[MOST_LINKS];
    TEST_ASSERT_EQUAL(ARMTOL_OK,
                      armtol_links_place(arm->links, arm->n_links, q, arm->n_axes, &armtol_errata_none, placed));
    reference_chain(placed, arm->n_links, tool);
}

/* What axes.h says snapping may change. */
static void check_moved(const arm *exact, const arm *snapped, random_source *source)
{
    const double reach = armtol_spread_of_axes(exact->axes, exact->n_axes, &exact->tool).reach;
    double angles = 0, distances = 0, q[MOST_AXES] = {0};
    for (size_t i = 0; i < snapped->n_snapped; i++) {
        angles += snapped->snapped[i].angle;
        distances += snapped->snapped[i].distance;
    }
    for (int n = 0; n < 5; n++) {
        double expected[4][4], actual[4][4];
        place(exact, q, expected);
        place(snapped, q, actual);
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                check_within(2 * angles + 1e-11, expected[i][k], actual[i][k], "turn");
            }
            check_within(2 * (angles * reach + distances) + 1e-11, expected[i][3], actual[i][3], "tool");
        }
        for (size_t i = 0; i < exact->n_axes; i++) {
            q[i] = random_between(source, -pi, pi);
        }
    }
}

/* Noise of the sixth digit: the arm that was meant comes out, and what was done is said. */
static void test_noise_decides_nothing(void)
{
    for (uint64_t seed = 1; seed <= 400; seed++) {
        arm meant = {.n_axes = 0}, noisy = {.n_axes = 0}, kept;
        random_source first = {seed}, second = {seed}, third = {seed};
        char what[40];
        snprintf(what, sizeof what, "robot %d", (int)seed);
        draw_robot(&first, 0, &meant);
        draw_robot(&second, 1e-7, &noisy);
        if (armtol_spread_of_axes(meant.axes, meant.n_axes, &meant.tool).reach == 0) {
            continue; /* a point, of which noise is no small share */
        }
        convert(&meant, 0);
        kept = noisy;
        convert(&kept, 0);
        TEST_ASSERT_EQUAL_MESSAGE(0, kept.n_snapped, what);
        convert(&noisy, 1e-5);
        TEST_ASSERT_EQUAL_MESSAGE(meant.n_links, noisy.n_links, what);
        for (size_t i = 0; i < meant.n_links; i++) {
            TEST_ASSERT_EQUAL_MESSAGE(meant.links[i].kind, noisy.links[i].kind, what);
            check_within(1e-5, meant.links[i].a, noisy.links[i].a, "%s: a %zu", what, i);
            check_within(1e-5, meant.links[i].d, noisy.links[i].d, "%s: d %zu", what, i);
        }
        check_moved(&kept, &noisy, &third);
    }
}

static void check_snapped(const armtol_snapped *snapped, size_t axis, armtol_relation relation, double angle,
                          double distance)
{
    TEST_ASSERT_EQUAL(axis, snapped->axis);
    TEST_ASSERT_EQUAL_STRING(armtol_relation_text(relation), armtol_relation_text(snapped->relation));
    check_within(1e-12, angle, snapped->angle, "angle");
    check_within(1e-12, distance, snapped->distance, "distance");
}

/* The base's z and axis 1 coincide, 2 and 3 meet, 3 and 4 are parallel, and so is the tool, in the frame of axis 4. */
static void test_what_is_taken_for_exact_is_said(void)
{
    arm arm = {.n_axes = 4,
               .axes = {{ARMTOL_REVOLUTE, {3e-6, 0, 0}, {0, 2e-6, 1}},
                        {ARMTOL_REVOLUTE, {0, 0, 1}, {1, 0, 0}},
                        {ARMTOL_REVOLUTE, {0, 0, 1 + 4e-6}, {0, 1, 0}},
                        {ARMTOL_REVOLUTE, {2, 0, 1}, {5e-6, 1, 0}}},
               .tool = {{{1, 0, 0, 4}, {0, 0, 1, 3e-6}, {0, -1, 0, 1}, {0, 0, 0, 1}}}};
    convert(&arm, 1e-5);
    TEST_ASSERT_EQUAL(4, arm.n_snapped);
    check_snapped(&arm.snapped[0], 0, ARMTOL_COINCIDENT, 2e-6, hypot(3e-6, 2e-6)); /* at height 1, where the arm is */
    check_snapped(&arm.snapped[1], 2, ARMTOL_MEETING, 0, 4e-6);
    check_snapped(&arm.snapped[2], 3, ARMTOL_PARALLEL, 5e-6, 0);
    check_snapped(&arm.snapped[3], 4, ARMTOL_SAME_FRAME, 0, 3e-6);
    convert(&arm, 1e-7);
    TEST_ASSERT_EQUAL(0, arm.n_snapped);
    convert(&arm, NAN); /* none that is a number: rounding only */
    TEST_ASSERT_EQUAL(0, arm.n_snapped);
    TEST_ASSERT_EQUAL_STRING("?", armtol_relation_text(ARMTOL_RELATION_COUNT));
}

/* The tool's frame is turned by 2e-6 about z, and 3e-6 up: no link for that. */
static void test_what_is_nearly_the_tool_s_frame_is_it(void)
{
    arm arm = {.n_axes = 1,
               .axes = {{ARMTOL_REVOLUTE, {0}, {0, 0, 1}}},
               .tool = {{{1, -2e-6, 0, 1}, {2e-6, 1, 0, 0}, {0, 0, 1, 3e-6}, {0, 0, 0, 1}}}};
    convert(&arm, 1e-5);
    TEST_ASSERT_EQUAL(1, arm.n_links);
    TEST_ASSERT_EQUAL(1, arm.n_snapped);
    check_snapped(&arm.snapped[0], 1, ARMTOL_SAME_FRAME, 2e-6, 3e-6);
    convert(&arm, 0);
    TEST_ASSERT_EQUAL(2, arm.n_links);
}

/* ---- tables ---- */

/* The kinds of the built-in arms are those of their axes. */
static void test_the_built_in_arms_have_the_kinds_of_their_axes(void)
{
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        const armtol_arm *built_in = armtol_arm_at(i);
        armtol_axis rows[16];
        armtol_kind kinds[16];
        TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_kinds_of_links(built_in->links, built_in->n_links, rows, kinds));
        for (size_t k = 0; k < built_in->n_links; k++) {
            TEST_ASSERT_EQUAL_STRING_MESSAGE(armtol_kind_name(built_in->links[k].kind), armtol_kind_name(kinds[k]),
                                             built_in->name);
        }
    }
}

static void test_the_frames_of_the_built_in_arms_are_near(void)
{
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        const armtol_arm *built_in = armtol_arm_at(i);
        armtol_axis axes[16];
        armtol_transform tool;
        size_t n_axes;
        TEST_ASSERT_EQUAL(ARMTOL_OK,
                          armtol_axes_of_links(built_in->links, built_in->n_links, axes, &n_axes, &tool));
        TEST_ASSERT_EQUAL(armtol_joint_count(built_in->links, built_in->n_links), n_axes);
        const armtol_spread spread = armtol_spread_of_axes(axes, n_axes, &tool);
        TEST_ASSERT_TRUE_MESSAGE(spread.farthest <= 2 * spread.reach, built_in->name);
    }
}

static void check_kind(armtol_kind expected, armtol_link link, const armtol_link *next)
{
    const armtol_link links[2] = {link, next != NULL ? *next : link};
    armtol_axis rows[2];
    armtol_kind kinds[2];
    TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_kinds_of_links(links, next != NULL ? 2 : 1, rows, kinds));
    TEST_ASSERT_EQUAL_STRING(armtol_kind_name(expected), armtol_kind_name(kinds[0]));
}

/* A reach of 550, axes 300 apart: near from atan(300 / 550) = 28.61 degrees on. */
static void test_the_kind_of_a_row(void)
{
    const double degree = pi / 180;
    const armtol_link next = {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 250};
    const double parallel[] = {0, degree, -28.5 * degree, pi, -pi, pi - 28.5 * degree, 2 * pi};
    const double other[] = {28.7 * degree, -28.7 * degree, pi / 2, pi - 28.7 * degree, 1, -2.5};
    for (size_t i = 0; i < sizeof parallel / sizeof parallel[0]; i++) {
        const double alpha = parallel[i];
        check_kind(ARMTOL_PPR, (armtol_link){.joint = ARMTOL_REVOLUTE, .a = 300, .alpha = alpha}, &next);
        check_kind(ARMTOL_NPR, (armtol_link){.joint = ARMTOL_FIXED, .a = 300, .alpha = alpha}, &next);
        check_kind(ARMTOL_NPR, (armtol_link){.joint = ARMTOL_REVOLUTE, .d = 9, .a = 300, .alpha = alpha}, NULL);
        check_kind(ARMTOL_NPR, (armtol_link){.joint = ARMTOL_REVOLUTE, .alpha = alpha}, NULL);
        check_kind(ARMTOL_PPR, (armtol_link){.joint = ARMTOL_REVOLUTE, .a = 300, .alpha = alpha}, NULL);
    }
    for (size_t i = 0; i < sizeof other / sizeof other[0]; i++) {
        const double alpha = other[i];
        check_kind(ARMTOL_NPR, (armtol_link){.joint = ARMTOL_REVOLUTE, .a = 300, .alpha = alpha}, &next);
        check_kind(ARMTOL_NPP, (armtol_link){.joint = ARMTOL_PRISMATIC, .alpha = alpha}, &next);
    }
    check_kind(ARMTOL_PPP, (armtol_link){.joint = ARMTOL_PRISMATIC, .alpha = 5.7 * degree}, &next);
    check_kind(ARMTOL_NPP, (armtol_link){.joint = ARMTOL_PRISMATIC, .alpha = 5.8 * degree}, &next);
    check_kind(ARMTOL_PPP, (armtol_link){.joint = ARMTOL_PRISMATIC, .alpha = 0}, NULL);
    check_kind(ARMTOL_PPR, (armtol_link){.joint = ARMTOL_REVOLUTE, .beta = 0.01}, NULL);
    check_kind(ARMTOL_PPR, (armtol_link){.joint = ARMTOL_REVOLUTE, .a = 300, .beta = 0.4}, &next);
}

/* Two axes 300 apart, one tilted by 0.05 degrees to the other: their common perpendicular is 300 / tan below. */
static void test_frames_that_lie_far_off(void)
{
    const double angle = 0.05 * pi / 180, far = 300 / tan(angle);
    const armtol_link links[] = {
        {ARMTOL_PPR, ARMTOL_REVOLUTE, .theta = pi / 2, .d = -far, .alpha = angle},
        {ARMTOL_NPR, ARMTOL_REVOLUTE, .theta = -pi / 2, .d = 300 / sin(angle), .a = 250},
    };
    arm arm = {.n_axes = 0};
    TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_axes_of_links(links, 2, arm.axes, &arm.n_axes, &arm.tool));
    const armtol_spread spread = armtol_spread_of_axes(arm.axes, arm.n_axes, &arm.tool);
    check_within(1, far, spread.farthest, "off the arm");
    check_within(1e-3, 300 + 250, spread.reach, "reach");
    convert(&arm, 1e-11);
    TEST_ASSERT_EQUAL(2, arm.n_links);
    check_within(1e-9, 300, arm.links[0].a, "a");
    check_within(1e-12, angle, arm.links[0].beta, "beta");
    for (int n = 0; n < 9; n++) {
        const double q = -3 + 0.7 * n;
        armtol_link placed[2];
        double expected[4][4], actual[4][4];
        const double joints[2] = {q, 1 - q};
        TEST_ASSERT_EQUAL(ARMTOL_OK, armtol_links_place(links, 2, joints, 2, &armtol_errata_none, placed));
        reference_chain(placed, 2, expected);
        place(&arm, joints, actual);
        for (int i = 0; i < 16; i++) {
            check_within(1e-9, expected[i / 4][i % 4], actual[i / 4][i % 4], "element %d", i);
        }
    }
}

/* Frames that were laid by the rules are near, so that a table of them is not laid anew. */
static void test_frames_that_were_laid_are_near(void)
{
    random_source source = {3};
    for (int n = 0; n < 2000; n++) {
        arm arm = {.n_axes = (size_t)random_between(&source, 1, MOST_AXES + 1)}, back;
        double r[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, p[3] = {0};
        for (size_t i = 0; i <= arm.n_axes; i++) {
            const double tilt = exp(random_between(&source, -12, 0.5));
            for (int k = 0; k < 3; k++) {
                p[k] += random_between(&source, -1, 1);
                turn(r, k, tilt * random_between(&source, -1, 1));
            }
            for (int row = 0; row < 3; row++) {
                if (i < arm.n_axes) {
                    arm.axes[i].joint = ARMTOL_REVOLUTE;
                    arm.axes[i].point[row] = p[row];
                    arm.axes[i].direction[row] = r[row][2];
                }
                memcpy(arm.tool.m[row], r[row], sizeof r[row]);
                arm.tool.m[row][3] = p[row];
            }
        }
        arm.tool.m[3][3] = 1;
        convert(&arm, 0);
        TEST_ASSERT_EQUAL(ARMTOL_OK,
                          armtol_axes_of_links(arm.links, arm.n_links, back.axes, &back.n_axes, &back.tool));
        const armtol_spread spread = armtol_spread_of_axes(back.axes, back.n_axes, &back.tool);
        TEST_ASSERT_TRUE(spread.farthest <= 2.5 * spread.reach);
    }
}

static void test_wrong_tables_are_refused(void)
{
    armtol_link link = {.kind = ARMTOL_KIND_COUNT};
    armtol_axis axes[1];
    armtol_kind kinds[1];
    armtol_transform tool;
    size_t n_axes;
    TEST_ASSERT_EQUAL(ARMTOL_BAD_KIND, armtol_axes_of_links(&link, 1, axes, &n_axes, &tool));
    TEST_ASSERT_EQUAL(ARMTOL_NO_LINKS, armtol_kinds_of_links(&link, 0, axes, kinds));
    const armtol_link long_links[2] = {{.d = DBL_MAX}, {.d = DBL_MAX}};
    armtol_axis two[2];
    TEST_ASSERT_EQUAL(ARMTOL_NOT_FINITE, armtol_axes_of_links(long_links, 2, two, &n_axes, &tool));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_noise_decides_nothing);
    RUN_TEST(test_what_is_taken_for_exact_is_said);
    RUN_TEST(test_what_is_nearly_the_tool_s_frame_is_it);
    RUN_TEST(test_the_built_in_arms_have_the_kinds_of_their_axes);
    RUN_TEST(test_the_frames_of_the_built_in_arms_are_near);
    RUN_TEST(test_the_kind_of_a_row);
    RUN_TEST(test_frames_that_lie_far_off);
    RUN_TEST(test_frames_that_were_laid_are_near);
    RUN_TEST(test_wrong_tables_are_refused);
    return UNITY_END();
}
