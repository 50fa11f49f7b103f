/*
 * Inverse kinematics of any arm. Branches are held against closed forms, against the published joint values of 1987,
 * and, brought forward by Eq. (4.1) in long double, against the wish.
 */

#include "armtol/inverse.h"

#include "armtol/euler.h"
#include "armtol/robots.h"
#include "armtol/transform.h"
#include "inverse/drawn.h"
#include "support/check.h"
#include "unity.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

static armtol_inverse *inverse;
static armtol_branches branches;

void setUp(void)
{
    inverse = NULL;
}

void tearDown(void)
{
    armtol_inverse_destroy(inverse);
}

static void make(const armtol_inverse_setup *setup)
{
    armtol_inverse_destroy(inverse);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_inverse_create(setup, &inverse));
}

static armtol_wish wish_at(const armtol_arm *arm, const double q[])
{
    return (armtol_wish){tool_at(arm, q), false};
}

static armtol_wish point_at(double x, double y, double z)
{
    return (armtol_wish){{{{1, 0, 0, x}, {0, 1, 0, y}, {0, 0, 1, z}, {0, 0, 0, 1}}}, true};
}

/* Every branch leads to the wish, and they are told apart and in order. */
static void check_branches(const armtol_arm *arm, const armtol_wish *wish)
{
    for (size_t i = 0; i < branches.count; i++) {
        const armtol_branch *branch = &branches.branch[i];
        const armtol_transform tool = tool_at(arm, branch->q);
        check_within(1e-9 * armtol_inverse_size(inverse), 0, distance_between(&tool, &wish->tool), "%s", arm->name);
        check_within(1e-9, 0, wish->point_only ? 0 : turn_between(&tool, &wish->tool), "%s", arm->name);
        TEST_ASSERT_TRUE(i == 0 || branches.branch[0].own || branch->from_near >= branch[-1].from_near - 1e-8);
        for (size_t k = 0; k < i; k++) {
            double apart = 0;
            for (size_t j = 0; j < armtol_arm_joint_count(arm); j++) {
                apart = fmax(apart, fabs(branch->q[j] - branches.branch[k].q[j]));
            }
            TEST_ASSERT_TRUE(apart > ARMTOL_BRANCH_APART);
        }
    }
    TEST_ASSERT_EQUAL_PTR(branches.branch[0].q, branches.best.q);
}

static void find(const armtol_arm *arm, const armtol_wish *wish)
{
    TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_OK, armtol_inverse_find(inverse, wish, &branches), arm->name);
    check_branches(arm, wish);
}

#define FREE {-INFINITY, INFINITY, NAN, 0, 0, 0, 0}

static const armtol_drive free_drives[6] = {FREE, FREE, FREE, FREE, FREE, FREE};

/* ---- closed forms ---- */

static const armtol_link two_links[] = {{ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 3}, {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 2}};
static const armtol_arm planar = {.name = "planar", .n_links = 2, .links = two_links, .drives = free_drives};

/* q2 = +-acos((r^2 - 9 - 4) / 12), q1 = atan2(y, x) - atan2(2 sin q2, 3 + 2 cos q2). */
static void test_a_planar_arm_has_both_elbows(void)
{
    random_source random = {5};
    make(&(armtol_inverse_setup){.arm = &planar});
    for (int i = 0; i < 200; i++) {
        const double r = random_between(&random, 1.01, 4.99), turn = random_between(&random, -pi, pi);
        const double x = r * cos(turn), y = r * sin(turn), elbow = acos((r * r - 13) / 12);
        const armtol_wish wish = point_at(x, y, 0);
        find(&planar, &wish);
        TEST_ASSERT_EQUAL_UINT(2, branches.count);
        for (size_t k = 0; k < 2; k++) {
            const double *q = branches.branch[k].q, q2 = copysign(elbow, q[1]);
            const double q1 = atan2(y, x) - atan2(2 * sin(q2), 3 + 2 * cos(q2));
            check_within(1e-9, q2, q[1], "elbow");
            check_within(1e-9, 0, remainder(q[0] - q1, 2 * pi), "shoulder");
        }
        TEST_ASSERT_TRUE(branches.branch[0].q[1] * branches.branch[1].q[1] < 0);
    }
}

/* Beyond reach by as much as the wish is beyond 5, or within 1. */
static void test_what_is_out_of_reach_has_its_distance(void)
{
    static const double asked[][2] = {{5.5, 0.5}, {0.25, 0.75}, {100, 95}};
    make(&(armtol_inverse_setup){.arm = &planar});
    for (size_t i = 0; i < 3; i++) {
        const armtol_wish wish = point_at(0, asked[i][0], 0);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OUT_OF_REACH, armtol_inverse_find(inverse, &wish, &branches));
        TEST_ASSERT_EQUAL_UINT(0, branches.count);
        check_within(1e-5, asked[i][1], branches.best.distance, "distance");
        check_same(0, branches.best.angle, "the axes are free");
    }
}

/* Its tool only turns about the upright: a tilt stays, whatever the joints do. */
static void test_a_tilt_that_an_arm_cannot_take_is_its_angle(void)
{
    const double pose[6] = {300, 200, 50, 0.3, 0, 0.7};
    const armtol_wish wish = {armtol_pose_to_transform(pose, &armtol_errata_none), false};
    make(&(armtol_inverse_setup){.arm = armtol_arm_named("adeptone")});
    TEST_ASSERT_EQUAL_INT(ARMTOL_OUT_OF_REACH, armtol_inverse_find(inverse, &wish, &branches));
    check_within(1e-6, 0.3, branches.best.angle, "angle");
    check_within(1e-3, 0, branches.best.distance, "distance");
}

/* A wrist of three meeting axes: with (q4, q5, q6) comes (q4 + pi, -q5, q6 + pi); two shoulders, two elbows. */
static void test_a_puma_without_limits_has_eight_branches(void)
{
    const armtol_arm *puma = armtol_arm_named("puma560");
    random_source random = {560};
    make(&(armtol_inverse_setup){.arm = puma, .ignore_limits = true});
    for (int i = 0; i < 100; i++) {
        double q[MOST_JOINTS];
        draw_posture(&random, puma, q);
        const armtol_wish wish = wish_at(puma, q);
        find(puma, &wish);
        TEST_ASSERT_EQUAL_UINT(8, branches.count);
        for (size_t k = 0; k < 8; k++) {
            const double *one = branches.branch[k].q;
            size_t flipped = 0;
            for (size_t l = 0; l < 8; l++) {
                const double *other = branches.branch[l].q;
                double apart = fabs(one[4] + other[4]);
                for (size_t j = 0; j < 6; j++) {
                    const double turned = one[j] - other[j] - (j == 3 || j == 5 ? pi : 0);
                    apart = j == 4 ? apart : fmax(apart, fabs(remainder(turned, 2 * pi)));
                }
                flipped += apart < 1e-7;
            }
            TEST_ASSERT_EQUAL_UINT(1, flipped);
        }
    }
}

/* ---- the arms of 1987 ---- */

/* golden/published.tsv. The frame of intella's positions is a quarter turn about the tool's axis from the table's. */
static const double intella[][12] = {
    {200, 200, 0, 0, 1.57, 0, 1.571237, 1.063532, -0.944167, 1.754183, -0.810926, -0.507265},
    {-200, 200, 100, 0, 1.57, 0, 1.571408, 0.914246, 1.416886, -1.666827, 0.248936, -0.656550}};
static const double adpta[][8] = {{200, 200, 0, 0, -0.262798, 2.429293, -2.166495, -203.199997}};

static void check_own(const armtol_arm *arm, const armtol_wish *wish, const double published[])
{
    make(&(armtol_inverse_setup){.arm = arm});
    find(arm, wish);
    TEST_ASSERT_TRUE(branches.branch[0].own);
    for (size_t j = 0; j < armtol_arm_joint_count(arm); j++) {
        check_within(5e-6, published[j], branches.branch[0].q[j], "%s, joint %zu", arm->name, j + 1);
    }
}

static void test_the_arms_of_1987_take_their_own_way(void)
{
    const double turn[6] = {0, 0, 0, 0, 0, pi / 2};
    const armtol_transform quarter = armtol_pose_to_transform(turn, &armtol_errata_none);
    for (size_t i = 0; i < 2; i++) {
        armtol_wish wish = {armtol_pose_to_transform(intella[i], &armtol_errata_none), false};
        wish.tool = armtol_transform_product(&wish.tool, &quarter, &armtol_errata_none);
        check_own(armtol_arm_named("intelledex605t"), &wish, intella[i] + 6);
    }
    const double pose[6] = {adpta[0][0], adpta[0][1], adpta[0][2], 0, 0, adpta[0][3]};
    const armtol_wish wish = {armtol_pose_to_transform(pose, &armtol_errata_none), false};
    check_own(armtol_arm_named("adeptone"), &wish, adpta[0] + 4);
}

/* 425 + 375 is its reach. */
static void test_their_own_way_has_an_end(void)
{
    const double pose[6] = {600, 800, 203.2, 0, 0, 0};
    const armtol_wish wish = {armtol_pose_to_transform(pose, &armtol_errata_none), false};
    make(&(armtol_inverse_setup){.arm = armtol_arm_named("adeptone")});
    TEST_ASSERT_EQUAL_INT(ARMTOL_OUT_OF_REACH, armtol_inverse_find(inverse, &wish, &branches));
    check_within(1e-3, 200, branches.best.distance, "distance");
}

static void test_who_names_a_posture_has_the_branch_nearest_to_it(void)
{
    const double pose[6] = {200, 200, 0, 0, 0, 0}, near[4] = {2, -2, 0, -200};
    const armtol_wish wish = {armtol_pose_to_transform(pose, &armtol_errata_none), false};
    make(&(armtol_inverse_setup){.arm = armtol_arm_named("adeptone"), .near = near});
    find(armtol_arm_named("adeptone"), &wish);
    TEST_ASSERT_EQUAL_UINT(2, branches.count);
    TEST_ASSERT_FALSE(branches.branch[0].own || branches.branch[1].own);
    check_within(1e-5, -2.429293, branches.branch[0].q[1], "the other elbow");
}

/* An arm whose table has limits that its own way exceeds goes another. */
static void test_its_own_way_keeps_to_limits(void)
{
    const armtol_arm *adept = armtol_arm_named("adeptone");
    armtol_arm arm = *adept;
    armtol_drive drives[6];
    memcpy(drives, adept->drives, sizeof drives);
    drives[2].low = -3;
    drives[2].high = 0;
    arm.drives = drives;
    const double pose[6] = {200, 200, 0, 0, 0, 0};
    const armtol_wish wish = {armtol_pose_to_transform(pose, &armtol_errata_none), false};
    make(&(armtol_inverse_setup){.arm = &arm});
    find(&arm, &wish);
    TEST_ASSERT_EQUAL_UINT(1, branches.count);
    check_within(1e-5, -2.429293, branches.branch[0].q[1], "the other elbow");
}

/* ---- every arm ---- */

/* Near the posture that was drawn, or at it: of an arm with a joint more it may be another one, but none is nearer. */
static void check_found_again(const armtol_arm *arm, random_source *random, bool point_only)
{
    double q[MOST_JOINTS];
    draw_posture(random, arm, q);
    armtol_wish wish = wish_at(arm, q);
    wish.point_only = point_only;
    make(&(armtol_inverse_setup){.arm = arm, .near = q, .enough = 3});
    find(arm, &wish);
    check_within(1e-9, 0, branches.branch[0].from_near, "%s", arm->name);
}

static void test_the_posture_that_is_near_is_found(void)
{
    random_source random = {42};
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        for (int k = 0; k < 10; k++) {
            check_found_again(armtol_arm_at(i), &random, k % 2 != 0);
        }
    }
}

/* Branches keep to limits; some postures that are drawn without them cannot be had within. */
static void test_limits_hold(void)
{
    const armtol_arm *puma = armtol_arm_named("puma560");
    random_source random = {17};
    int refused = 0;
    for (int k = 0; k < 20; k++) {
        double q[6];
        for (size_t j = 0; j < 6; j++) {
            q[j] = random_between(&random, -pi, pi);
        }
        const armtol_wish wish = wish_at(puma, q);
        make(&(armtol_inverse_setup){.arm = puma});
        const armtol_status status = armtol_inverse_find(inverse, &wish, &branches);
        for (size_t i = 0; i < branches.count; i++) {
            for (size_t j = 0; j < 6; j++) {
                TEST_ASSERT_TRUE(branches.branch[i].q[j] >= puma->drives[j].low);
                TEST_ASSERT_TRUE(branches.branch[i].q[j] <= puma->drives[j].high);
            }
        }
        refused += status == ARMTOL_OUT_OF_REACH;
        TEST_ASSERT_TRUE(status == ARMTOL_OK || branches.best.distance + branches.best.angle > 1e-6);
        make(&(armtol_inverse_setup){.arm = puma, .ignore_limits = true});
        find(puma, &wish);
    }
    TEST_ASSERT_TRUE(refused > 0 && refused < 20);
}

/* An arm of seven joints: of all ways to hold the tool there, none nearby is nearer to `near` than the one found. */
static void test_a_branch_of_a_redundant_arm_is_nearest_to_the_posture(void)
{
    const armtol_arm *panda = armtol_arm_named("panda");
    random_source random = {7};
    for (int k = 0; k < 10; k++) {
        double q[MOST_JOINTS], aside[MOST_JOINTS];
        draw_posture(&random, panda, q);
        const armtol_wish wish = wish_at(panda, q);
        make(&(armtol_inverse_setup){.arm = panda});
        find(panda, &wish);
        const double nearest = branches.branch[0].from_near;
        double first[7];
        memcpy(first, branches.branch[0].q, sizeof first);
        for (int way = 0; way < 14; way++) { /* postures beside it, with the tool there */
            memcpy(aside, first, sizeof first);
            aside[way / 2] += way % 2 != 0 ? 0.02 : -0.02;
            make(&(armtol_inverse_setup){.arm = panda, .near = aside, .enough = 1});
            find(panda, &wish);
            double square = 0;
            for (size_t j = 0; j < 7; j++) {
                const double middle = (panda->drives[j].low + panda->drives[j].high) / 2;
                square += (branches.branch[0].q[j] - middle) * (branches.branch[0].q[j] - middle);
            }
            TEST_ASSERT_TRUE(sqrt(square) >= nearest - 1e-8);
        }
    }
}

/* More than there is room for: the nearest are kept. An arm of seven joints within limits has many. */
static void test_the_nearest_of_many_branches_are_kept(void)
{
    const armtol_arm *iiwa = armtol_arm_named("iiwa14");
    random_source random = {162};
    double q[MOST_JOINTS];
    draw_posture(&random, iiwa, q);
    const armtol_wish wish = wish_at(iiwa, q);
    make(&(armtol_inverse_setup){.arm = iiwa});
    find(iiwa, &wish);
    TEST_ASSERT_EQUAL_UINT(ARMTOL_MOST_BRANCHES, branches.count);
    /* near its last one, that one is the first */
    double last[7];
    memcpy(last, branches.branch[ARMTOL_MOST_BRANCHES - 1].q, sizeof last);
    make(&(armtol_inverse_setup){.arm = iiwa, .near = last, .enough = 1});
    find(iiwa, &wish);
    check_within(1e-6, 0, branches.branch[0].from_near, "near the last");
}

static void test_an_offset_is_the_tool_point(void)
{
    const armtol_arm *puma = armtol_arm_named("puma560");
    const double near[6] = {0.3, 0.8, -2.5, 0.4, 0.8, -1}, offset[3] = {10, -20, 100};
    armtol_wish wish = wish_at(puma, near);
    for (int i = 0; i < 3; i++) {
        wish.tool.m[i][3] += wish.tool.m[i][0] * 10 - wish.tool.m[i][1] * 20 + wish.tool.m[i][2] * 100;
    }
    make(&(armtol_inverse_setup){.arm = puma, .near = near, .offset = {offset[0], offset[1], offset[2]}, .enough = 1});
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_inverse_find(inverse, &wish, &branches));
    for (size_t j = 0; j < 6; j++) {
        check_within(1e-9, near[j], branches.branch[0].q[j], "joint %zu", j + 1);
    }
    /* the arms of 1987 too */
    const armtol_arm *adept = armtol_arm_named("adeptone");
    const double pose[6] = {200 + 30, 200, -5, 0, 0, 0};
    const armtol_wish other = {armtol_pose_to_transform(pose, &armtol_errata_none), false};
    make(&(armtol_inverse_setup){.arm = adept, .offset = {30, 0, -5}});
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_inverse_find(inverse, &other, &branches));
    TEST_ASSERT_TRUE(branches.branch[0].own);
    check_within(5e-6, adpta[0][5], branches.branch[0].q[1], "elbow");
}

/* ---- joints that follow, slides ---- */

/* Joint 3 turns half as far back as joint 2: a whole turn of that is another posture. Link 4 slides with joint 1. */
static void test_joints_that_follow_others(void)
{
    static const armtol_link links[] = {{ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 300, .d = 100},
                                        {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 200, .alpha = 1},
                                        {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 150, .alpha = -0.5},
                                        {ARMTOL_NPP, ARMTOL_PRISMATIC, .alpha = 0.3, .beta = 0.1},
                                        {ARMTOL_NPR, ARMTOL_FIXED, .a = 50}};
    static const armtol_motion motions[] = {
        {0, 1, 0, 1}, {1, 1, 0, -1}, {1, -0.5, 0.2, 1}, {0, 40, 10, 1}, {4, 1, 0, 1}};
    armtol_drive drives[5] = {free_drives[0], free_drives[0], {-1, 1, NAN, 0, 0, 0, 0}, free_drives[0], free_drives[0]};
    const armtol_arm arm = {
        .name = "follows", .n_links = 5, .links = links, .drives = drives, .motions = motions};
    random_source random = {99};
    for (int k = 0; k < 50; k++) {
        const double q[2] = {random_between(&random, -2, 2), random_between(&random, -1.6, 2.3)};
        const armtol_wish wish = wish_at(&arm, q);
        make(&(armtol_inverse_setup){.arm = &arm});
        find(&arm, &wish);
        bool again = false;
        for (size_t i = 0; i < branches.count; i++) {
            const double follower = 0.2 - 0.5 * branches.branch[i].q[1];
            TEST_ASSERT_TRUE(follower >= -1 - 1e-9 && follower <= 1 + 1e-9);
            again = again ||
                    (fabs(branches.branch[i].q[0] - q[0]) < 1e-6 && fabs(branches.branch[i].q[1] - q[1]) < 1e-6);
        }
        TEST_ASSERT_TRUE(again);
    }
}

static void test_slides_with_limits_on_one_side(void)
{
    static const armtol_link links[] = {{ARMTOL_NPP, ARMTOL_PRISMATIC, .alpha = 1.5}, {ARMTOL_NPP, ARMTOL_PRISMATIC}};
    const armtol_drive drives[2] = {{0, INFINITY, NAN, 0, 0, 0, 0}, {-INFINITY, -1, NAN, 0, 0, 0, 0}};
    const armtol_arm arm = {.name = "slides", .n_links = 2, .links = links, .drives = drives};
    const double q[2] = {0.5, -70}, beyond[2] = {-0.5, -70};
    const armtol_wish wish = wish_at(&arm, q), refused = wish_at(&arm, beyond);
    make(&(armtol_inverse_setup){.arm = &arm});
    find(&arm, &wish);
    TEST_ASSERT_EQUAL_UINT(1, branches.count);
    check_within(1e-7, 0.5, branches.branch[0].q[0], "the first");
    check_within(1e-7, -70, branches.branch[0].q[1], "the second");
    check_within(1e-12, sqrt(0.5 * 0.5 + 69 * 69), branches.branch[0].from_near, "near is 0 and -1, the size 1");
    TEST_ASSERT_EQUAL_INT(ARMTOL_OUT_OF_REACH, armtol_inverse_find(inverse, &refused, &branches));
}

/* A slide to 1 is near enough to 1.05 for who takes a tenth of its size for there. */
static void test_near_enough_at_a_limit(void)
{
    static const armtol_link link = {ARMTOL_NPP, ARMTOL_PRISMATIC};
    const armtol_drive drive = {0, 1, NAN, 0, 0, 0, 0};
    const armtol_arm arm = {.name = "slide", .n_links = 1, .links = &link, .drives = &drive};
    const armtol_wish wish = point_at(0, 0, 1.05);
    make(&(armtol_inverse_setup){.arm = &arm, .within = 0.1});
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_inverse_find(inverse, &wish, &branches));
    TEST_ASSERT_EQUAL_UINT(1, branches.count);
    check_within(1e-12, 1, branches.branch[0].q[0], "the slide");
    check_within(1e-12, 0.05, branches.branch[0].distance, "distance");
    make(&(armtol_inverse_setup){.arm = &arm, .within = 0.01});
    TEST_ASSERT_EQUAL_INT(ARMTOL_OUT_OF_REACH, armtol_inverse_find(inverse, &wish, &branches));
}

/* A gantry without any length of its own: its size is 1, whatever is asked of it. */
static void test_a_far_wish_of_slides(void)
{
    static const armtol_link links[] = {{ARMTOL_NPP, ARMTOL_PRISMATIC, .alpha = 1.57079632679489661923},
                                        {ARMTOL_NPP, ARMTOL_PRISMATIC, .theta = 1, .alpha = 1.57079632679489661923},
                                        {ARMTOL_NPP, ARMTOL_PRISMATIC}};
    const armtol_arm arm = {.name = "gantry", .n_links = 3, .links = links, .drives = free_drives};
    const double q[3] = {-3e7, 2e7, 5e7};
    const armtol_wish wish = wish_at(&arm, q);
    make(&(armtol_inverse_setup){.arm = &arm});
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_inverse_find(inverse, &wish, &branches));
    for (size_t j = 0; j < 3; j++) {
        check_within(0.01, q[j], branches.branch[0].q[j], "joint %zu", j + 1);
    }
}

static void test_an_arm_without_joints_is_there_or_is_not(void)
{
    static const armtol_link link = {ARMTOL_NPR, ARMTOL_FIXED, .a = 2};
    const armtol_arm arm = {.name = "post", .n_links = 1, .links = &link, .drives = free_drives};
    const armtol_wish there = point_at(2, 0, 0), away = point_at(2, 0, 3);
    make(&(armtol_inverse_setup){.arm = &arm});
    find(&arm, &there);
    TEST_ASSERT_EQUAL_UINT(1, branches.count);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OUT_OF_REACH, armtol_inverse_find(inverse, &away, &branches));
    check_within(1e-12, 3, branches.best.distance, "distance");
}

/* ---- what does not matter, and what is wrong ---- */

static void test_a_unit_of_length_changes_no_angle(void)
{
    const armtol_arm *puma = armtol_arm_named("puma560");
    armtol_link links[6];
    armtol_arm small = *puma;
    const double q[6] = {0.3, 0.8, -2.5, 0.4, 0.8, -1};
    memcpy(links, puma->links, sizeof links);
    for (size_t i = 0; i < 6; i++) {
        links[i].a /= 1024;
        links[i].d /= 1024;
    }
    small.links = links;
    armtol_wish wish = wish_at(puma, q);
    make(&(armtol_inverse_setup){.arm = puma});
    find(puma, &wish);
    const size_t count = branches.count;
    double first[6];
    memcpy(first, branches.branch[0].q, sizeof first);
    for (int i = 0; i < 3; i++) {
        wish.tool.m[i][3] /= 1024;
    }
    make(&(armtol_inverse_setup){.arm = &small});
    find(&small, &wish);
    TEST_ASSERT_EQUAL_UINT(count, branches.count);
    TEST_ASSERT_EQUAL_MEMORY(first, branches.branch[0].q, sizeof first);
}

static void test_what_was_asked_before_does_not_matter(void)
{
    const armtol_arm *ur5e = armtol_arm_named("ur5e");
    const double one[6] = {0.1, -1, 1.2, -1, 0.9, 0.7}, other[6] = {2, 1, -1.2, 0.3, -0.9, 0.1};
    const armtol_wish first = wish_at(ur5e, one), second = wish_at(ur5e, other);
    double q[ARMTOL_MOST_BRANCHES * 6];
    make(&(armtol_inverse_setup){.arm = ur5e});
    find(ur5e, &first);
    const size_t count = branches.count;
    for (size_t i = 0; i < count; i++) {
        memcpy(q + 6 * i, branches.branch[i].q, 6 * sizeof *q);
    }
    find(ur5e, &second);
    find(ur5e, &first);
    TEST_ASSERT_EQUAL_UINT(count, branches.count);
    for (size_t i = 0; i < count; i++) {
        TEST_ASSERT_EQUAL_MEMORY(q + 6 * i, branches.branch[i].q, 6 * sizeof *q);
    }
}

static void test_wrong_input(void)
{
    const double nowhere[2] = {0, NAN};
    armtol_link links[2] = {two_links[0], two_links[1]};
    armtol_arm arm = planar;
    armtol_wish wish = point_at(1, 1, NAN);
    arm.links = links;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE,
                          armtol_inverse_create(&(armtol_inverse_setup){.arm = &planar, .near = nowhere}, &inverse));
    TEST_ASSERT_NULL(inverse);
    const armtol_inverse_setup far_off = {.arm = &planar, .offset = {INFINITY}};
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_inverse_create(&far_off, &inverse));
    links[0].a = links[1].a = 1e308;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_inverse_create(&(armtol_inverse_setup){.arm = &arm}, &inverse));
    arm.n_links = 0;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NO_LINKS, armtol_inverse_create(&(armtol_inverse_setup){.arm = &arm}, &inverse));
    TEST_ASSERT_NULL(inverse);
    make(&(armtol_inverse_setup){.arm = &planar});
    branches.count = 77;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_inverse_find(inverse, &wish, &branches));
    wish = point_at(1, 1, 0);
    wish.tool.m[0][0] = NAN; /* not looked at, but where the axes count */
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_inverse_find(inverse, &wish, &branches));
    wish.point_only = false;
    branches.count = 77;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_inverse_find(inverse, &wish, &branches));
    wish = point_at(1e300, 1, 1);
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_inverse_find(inverse, &wish, &branches));
    TEST_ASSERT_EQUAL_UINT(77, branches.count);
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_inverse_follow(inverse, &wish, NULL, &branches.best));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_planar_arm_has_both_elbows);
    RUN_TEST(test_what_is_out_of_reach_has_its_distance);
    RUN_TEST(test_a_tilt_that_an_arm_cannot_take_is_its_angle);
    RUN_TEST(test_a_puma_without_limits_has_eight_branches);
    RUN_TEST(test_the_arms_of_1987_take_their_own_way);
    RUN_TEST(test_their_own_way_has_an_end);
    RUN_TEST(test_who_names_a_posture_has_the_branch_nearest_to_it);
    RUN_TEST(test_its_own_way_keeps_to_limits);
    RUN_TEST(test_the_posture_that_is_near_is_found);
    RUN_TEST(test_limits_hold);
    RUN_TEST(test_a_branch_of_a_redundant_arm_is_nearest_to_the_posture);
    RUN_TEST(test_the_nearest_of_many_branches_are_kept);
    RUN_TEST(test_an_offset_is_the_tool_point);
    RUN_TEST(test_joints_that_follow_others);
    RUN_TEST(test_slides_with_limits_on_one_side);
    RUN_TEST(test_near_enough_at_a_limit);
    RUN_TEST(test_a_far_wish_of_slides);
    RUN_TEST(test_an_arm_without_joints_is_there_or_is_not);
    RUN_TEST(test_a_unit_of_length_changes_no_angle);
    RUN_TEST(test_what_was_asked_before_does_not_matter);
    RUN_TEST(test_wrong_input);
    return UNITY_END();
}
