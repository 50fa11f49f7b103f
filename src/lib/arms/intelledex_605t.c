#include "armtol/robots.h"

#include "armtol/euler.h"
#include "armtol/solve.h"
#include "armtol/transform.h"
#include "lib/arms/arms.h"
#include "lib/report/arithmetic.h"
#include "lib/report/finite.h"
#include "lib/report/trigonometry.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { LINKS = 8, JOINTS = 6, WISH = 6 };

#define BASE_HEIGHT 359.7
#define UPPER_ARM 373.4
#define FOREARM 279.4
#define TOOL_LENGTH 100.0

/*
 * Closer than this (mm) to the tool's axis the shoulder counts as on it: products stored as floats are off by
 * up to some 2e-4 over the arm's length, so that nothing but rounding would choose joint 6.
 */
#define SINGULAR_OFFSET 1e-3

static const armtol_link table[LINKS] = {
    {ARMTOL_NPR, ARMTOL_FIXED, .d = BASE_HEIGHT},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = -QUARTER},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER},
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = UPPER_ARM},
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = FOREARM},
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = QUARTER},
    {ARMTOL_NPR, ARMTOL_REVOLUTE},
    {ARMTOL_NPR, ARMTOL_FIXED, .d = TOOL_LENGTH, .theta = QUARTER},
};

static void links_of(const armtol_errata *errata, armtol_link links[])
{
    /* Erratum `short-pi`: the table's quarter turns are made of it. */
    const double quarter = pi_of(errata) / 2;
    for (int i = 0; i < LINKS; i++) {
        links[i] = table[i];
        links[i].alpha = table[i].alpha / QUARTER * quarter;
        links[i].theta = table[i].theta / QUARTER * quarter;
    }
}

enum { CRAIG_BASE, CRAIG_TOOL = 6, CRAIG_LINKS };

static void craig_links_of(const armtol_errata *errata, armtol_craig_link links[CRAIG_LINKS])
{
    const double quarter = pi_of(errata) / 2;
    const armtol_craig_link rows[CRAIG_LINKS] = {
        {ARMTOL_FIXED, .d = BASE_HEIGHT},
        {ARMTOL_REVOLUTE},
        {ARMTOL_REVOLUTE, .alpha = -quarter},
        {ARMTOL_REVOLUTE, .alpha = quarter},
        {ARMTOL_REVOLUTE, .a = UPPER_ARM},
        {ARMTOL_REVOLUTE, .a = FOREARM},
        {ARMTOL_REVOLUTE, .alpha = quarter, .d = TOOL_LENGTH},
    };
    memcpy(links, rows, sizeof rows);
}

static void forward(const double q[], const armtol_errata *errata, double wish[])
{
    armtol_craig_link links[CRAIG_LINKS];
    craig_links_of(errata, links);
    const armtol_transform tool = armtol_craig_chain(links, CRAIG_LINKS, q, errata);
    armtol_transform_to_pose(&tool, errata, wish);
}

/* How far the wrist, TOOL_LENGTH behind the tool point along the tool's axis, is from the shoulder. */
static armtol_reach reach_of(const double wish[])
{
    const armtol_transform tool = armtol_pose_to_transform(wish, &armtol_errata_none);
    const double x = tool.m[0][3] - TOOL_LENGTH * tool.m[0][2];
    const double y = tool.m[1][3] - TOOL_LENGTH * tool.m[1][2];
    const double z = tool.m[2][3] - TOOL_LENGTH * tool.m[2][2] - BASE_HEIGHT;
    return (armtol_reach){length_of(length_of(x, y), z), fabs(UPPER_ARM - FOREARM), UPPER_ARM + FOREARM};
}

/* Joint 6 turns the tool about its axis until the axis of joint 5 is square to the shoulder's direction. */
static armtol_status solve_q6(const armtol_transform *t06, const armtol_errata *errata, double *q6)
{
    const armtol_transform t60 = armtol_transform_inverse(t06, errata);
    if (length_of(t60.m[0][3], t60.m[1][3]) < SINGULAR_OFFSET) {
        return ARMTOL_SINGULAR;
    }
    return armtol_solve(t60.m[1][3], t60.m[0][3], 0, 0, errata, q6);
}

/*
 * Joints 1 and 2 bring the common axis of joints 3, 4 and 5 to the z axis of frame 5. Where that is upright joint 1
 * turns about it too, and any q1 will do.
 */
static void solve_q1_q2(const armtol_transform *t05, const armtol_errata *errata, double q[])
{
    if (armtol_solve(t05->m[1][2], -t05->m[0][2], 0, 0, errata, &q[0]) != ARMTOL_OK) {
        q[0] = 0;
    }
    const double horizontal = cosine_of(errata, q[0]) * t05->m[0][2] + sine_of(errata, q[0]) * t05->m[1][2];
    q[1] = store(errata, angle_of(errata, horizontal, t05->m[2][2]));
}

/* Joints 3 to 5, a planar arm square to their common axis; frame 2's x and y axes span the plane. */
static armtol_status solve_q3_q4_q5(const armtol_transform *t06, const armtol_transform *t05,
                                    const armtol_errata *errata, double q[])
{
    const double c1 = cosine_of(errata, q[0]), s1 = sine_of(errata, q[0]);
    const double c2 = cosine_of(errata, q[1]), s2 = sine_of(errata, q[1]);
    const double(*x5)[4] = t05->m;
    const double x = t06->m[0][3], y = t06->m[1][3], z = t06->m[2][3];

    const double q345 = store(errata, angle_of(errata, -s1 * x5[0][0] + c1 * x5[1][0],
                                               c1 * c2 * x5[0][0] + s1 * c2 * x5[1][0] - s2 * x5[2][0]));
    const double c345 = cosine_of(errata, q345), s345 = sine_of(errata, q345);
    /* the wrist from the shoulder */
    const double px = store(errata, c1 * c2 * x + s1 * c2 * y - s2 * z - TOOL_LENGTH * s345);
    const double py = store(errata, -s1 * x + c1 * y + TOOL_LENGTH * c345);
    /* the shoulder from the wrist, in frame 5 */
    const double qx = store(errata, -(c345 * px + s345 * py));
    const double qy = store(errata, s345 * px - c345 * py);
    const double d = (UPPER_ARM * UPPER_ARM - FOREARM * FOREARM - qx * qx - qy * qy) / (2 * FOREARM);
    const armtol_status status = armtol_solve(qx, -qy, d, 0, errata, &q[4]);
    if (status != ARMTOL_OK) {
        return status;
    }
    const double q34 = store(errata, q345 - q[4]);
    const double x4 = FOREARM * cosine_of(errata, q34), y4 = FOREARM * sine_of(errata, q34);
    q[2] = store(errata, angle_of(errata, py - y4, px - x4));
    q[3] = store(errata, q345 - q[2] - q[4]);
    return ARMTOL_OK;
}

static armtol_status solve_all(const double wish[], const armtol_errata *errata, double q[])
{
    armtol_craig_link links[CRAIG_LINKS];
    craig_links_of(errata, links);
    const armtol_transform tool = armtol_pose_to_transform(wish, errata);
    const armtol_transform base = armtol_craig_transform(&links[CRAIG_BASE], 0, errata);
    const armtol_transform to_shoulder = armtol_transform_inverse(&base, errata);
    const armtol_transform t06 = armtol_transform_product(&to_shoulder, &tool, errata);

    const armtol_status status = solve_q6(&t06, errata, &q[5]);
    if (status != ARMTOL_OK) {
        return status;
    }
    const armtol_transform link6 = armtol_craig_transform(&links[CRAIG_TOOL], q[5], errata);
    const armtol_transform back = armtol_transform_inverse(&link6, errata);
    const armtol_transform t05 = armtol_transform_product(&t06, &back, errata);
    solve_q1_q2(&t05, errata, q);
    return solve_q3_q4_q5(&t06, &t05, errata, q);
}

/*
 * The report prints no inverse kinematics. This order of steps is a reconstruction that gives every published
 * joint value to its last digit; legacy/README.md says what the numbers decide and what they leave open.
 *
 * Method
 *    Joint 6 by solve, where the axis of joint 5 is square to the shoulder; that axis gives joints 1 and 2; joints 3 to
 *    5 are a planar arm, q5 by solve and the others by arc tangents.
 *
 * Special cases
 *    Out of reach, also where squares overflow; singular with the shoulder on the tool's axis; an upright elbow has any
 *    q1 (test_an_upright_elbow_is_no_error).
 *
 * Accuracy
 *    Without errata the tool gets to the wish to 1e-7 mm and 1e-10 rad (test_the_intelledex_gets_where_it_should).
 */
static armtol_status inverse(const double wish[], const armtol_errata *errata, double q[],
                             armtol_reach *reach)
{
    double solved[JOINTS];
    if (!all_finite(wish, WISH)) {
        return ARMTOL_NOT_FINITE;
    }
    *reach = reach_of(wish);
    const armtol_status status = solve_all(wish, errata, solved);
    if (status == ARMTOL_OK) {
        memcpy(q, solved, sizeof solved);
        return ARMTOL_OK;
    }
    /* a far wish may overflow, or have the shoulder on its tool's axis: it is out of reach all the same */
    const bool within = reach->nearest <= reach->distance && reach->distance <= reach->farthest;
    return status == ARMTOL_SINGULAR && within ? ARMTOL_SINGULAR : ARMTOL_OUT_OF_REACH;
}

const armtol_robot armtol_intelledex_605t = {
    .name = "Intelledex 605T",
    .n_links = LINKS,
    .n_joints = JOINTS,
    .n_wish = WISH,
    .links = links_of,
    .inverse = inverse,
    .forward = forward,
};

static const armtol_drive drives[LINKS] = {
    UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN,
};

const armtol_arm arm_intelledex_605t = {
    .name = "intelledex605t",
    .title = "Intelledex 605T",
    .source = "Hahn 1987, appendix, program intella",
    .unit = ARMTOL_MILLIMETRE,
    .n_links = LINKS,
    .links = table,
    .drives = drives,
};
