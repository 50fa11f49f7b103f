#include "armtol/column_order.h"
#include "armtol/corners.h"
#include "armtol/poses.h"
#include "armtol/robots.h"
#include "armtol/tool_matrix.h"

#include "lib/tool/kernels.h"
#include "lib/tool/negligible.h"
#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST_LINKS = 21, MOST_COLUMNS = MOST_LINKS * ARMTOL_PARAMETER_COUNT, MOST_POSES = 19 };

static const double usual[6] = {0.5, 0.3, 0.4, 0.1, 0.02, 0.3}, delta = 0.1;
static double accuracy[6];

static armtol_link links[MOST_LINKS], placed[MOST_LINKS];
static armtol_pose_link prepared[MOST_LINKS];
static double q[MOST_POSES * MOST_LINKS];
static double blocks[ARMTOL_POSE_BLOCKS(MOST_POSES) * ARMTOL_POSE_BLOCK * 6 * MOST_COLUMNS + 1];
static double expected[6 * MOST_COLUMNS], ordered[6 * MOST_COLUMNS];

void setUp(void)
{
    memcpy(accuracy, usual, sizeof accuracy);
}

void tearDown(void)
{
}

static size_t random_arm(uint64_t seed, size_t n)
{
    random_source source = {seed};
    for (size_t i = 0; i < n; i++) {
        links[i] = (armtol_link){
            .kind = (armtol_kind)((i + seed) % ARMTOL_KIND_COUNT),
            .joint = (armtol_joint)((i + seed / 4) % ARMTOL_JOINT_COUNT),
            .a = i % 3 == 0 ? 0 : random_between(&source, -300, 300),
            .alpha = i % 4 == 0 ? 0 : random_between(&source, -3, 3),
            .d = i % 2 == 0 ? 0 : random_between(&source, -300, 300),
            .theta = i % 5 == 0 ? 0 : random_between(&source, -3, 3),
            .beta = i % 2 == 0 ? 0 : random_between(&source, -1, 1),
        };
    }
    for (size_t i = 0; i < MOST_POSES * n; i++) {
        q[i] = random_between(&source, -4, 4);
    }
    return n;
}

static void start(armtol_poses *poses, size_t n_links, const armtol_tool_point *tool)
{
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_poses_start(poses, prepared, links, n_links, tool, accuracy,
                                                        delta));
}

/* A of the placed links, and the bounds that its rows' norms give. */
static armtol_bounds expect(const armtol_poses *poses, const double joints[], size_t *n_columns)
{
    armtol_column columns[MOST_COLUMNS];
    size_t order[MOST_COLUMNS];
    armtol_bounds bounds;
    const size_t n = armtol_column_count(links, poses->n_links);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(links, poses->n_links, joints, poses->n_joints,
                                                        &armtol_errata_none, placed));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tool_matrix(placed, poses->n_links, &poses->tool, expected, n));
    armtol_columns(links, poses->n_links, columns, n);
    const size_t n_lengths = armtol_column_order(columns, n, order);
    armtol_reorder(expected, n, order, ordered);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_norm_bounds(ordered, n, n_lengths, accuracy, delta,
                                                        &armtol_errata_none, &bounds));
    *n_columns = n;
    return bounds;
}

static void check_bounds(const armtol_bounds *right, const armtol_bounds *found)
{
    check_within(1e-13 * right->distance, right->distance, found->distance, "the distance bound");
    check_within(1e-13 * right->angle, right->angle, found->angle, "the angle bound");
}

static void check_pose(const armtol_poses *poses, const double joints[])
{
    size_t n;
    armtol_bounds found;
    const armtol_bounds right = expect(poses, joints, &n);
    armtol_pose_blocks(poses, joints, 1, blocks, &found);
    for (size_t i = 0; i < 6 * n; i++) {
        check_same(expected[i], blocks[ARMTOL_POSE_ELEMENT(n, i / n, i % n, 0)], "row %zu, column %zu", i / n, i % n);
    }
    check_bounds(&right, &found);
}

/* So small a part of the usual that the component's row sets the bound of the angles. */
static void tighten(size_t component, double part)
{
    const double always = component < 3 ? delta : 0;
    memcpy(accuracy, usual, sizeof accuracy);
    accuracy[component] = always + part * (usual[component] - always);
}

static void test_every_row_can_set_the_bounds(void)
{
    static const armtol_tool_point tool = {{30, -20, 70}, ARMTOL_BASE_FRAME};
    for (size_t i = 0; i < 6; i++) {
        armtol_poses poses;
        size_t n;
        tighten(i, 1e-6);
        start(&poses, random_arm(i, 7), &tool);
        check_pose(&poses, q);
        const armtol_bounds tight = expect(&poses, q, &n);
        tighten(i, 5e-7);
        const armtol_bounds tighter = expect(&poses, q, &n);
        TEST_ASSERT_TRUE(tighter.angle != tight.angle); /* it is that row indeed */
    }
}

static void test_a_pose_is_the_matrix_and_the_bounds_of_the_placed_links(void)
{
    for (uint64_t seed = 0; seed < 24; seed++) {
        const size_t n_links = random_arm(seed, 4 + seed % (MOST_LINKS - 3));
        for (armtol_frame frame = ARMTOL_BASE_FRAME; frame < ARMTOL_FRAME_COUNT; frame++) {
            const armtol_tool_point tool = {{30, -20, 70}, frame};
            armtol_poses poses;
            start(&poses, n_links, &tool);
            for (size_t p = 0; p < 3; p++) {
                check_pose(&poses, q + p * poses.n_joints);
            }
        }
    }
}

/* Bit for bit, and also where there is no pose for a lane: it repeats the last. */
static void check_blocks_of(const kernels *kernels, const armtol_poses *poses, size_t n_poses, double *first)
{
    static double alone_blocks[ARMTOL_POSE_BLOCK * 6 * MOST_COLUMNS];
    armtol_bounds bounds[MOST_POSES + 1];
    bounds[n_poses] = (armtol_bounds){42, 42};
    kernels->pose_blocks(poses, q, n_poses, first, bounds);
    for (size_t p = 0; p < ARMTOL_POSE_BLOCKS(n_poses) * ARMTOL_POSE_BLOCK; p++) {
        armtol_bounds alone;
        size_t n;
        const size_t same = p < n_poses ? p : n_poses - 1;
        expect(poses, q + same * poses->n_joints, &n);
        armtol_pose_blocks(poses, q + same * poses->n_joints, 1, alone_blocks, &alone);
        for (size_t i = 0; i < 6; i++) {
            for (size_t j = 0; j < n; j++) {
                check_same(expected[i * n + j], first[ARMTOL_POSE_ELEMENT(n, i, j, p)],
                           "%zu poses, pose %zu, row %zu, column %zu", n_poses, p, i, j);
            }
        }
        check_same(alone.distance, bounds[same].distance, "pose %zu, the distance bound", p);
        check_same(alone.angle, bounds[same].angle, "pose %zu, the angle bound", p);
    }
    check_same(42, bounds[n_poses].distance, "behind the last bound");
}

/* With every width of vectors that this machine has. */
static void check_blocks(const armtol_poses *poses, size_t n_poses, double *first)
{
    for (int lanes = 2; lanes <= ARMTOL_POSE_BLOCK; lanes *= 2) {
        check_blocks_of(kernels_of_machine(lanes), poses, n_poses, first);
    }
}

static void test_a_pose_has_the_same_bits_in_any_block_and_alone(void)
{
    for (uint64_t seed = 0; seed < 12; seed++) {
        const armtol_tool_point tool = {{3, 4, 5}, (armtol_frame)(seed % 2)};
        const size_t n_links = random_arm(seed, 3 + seed);
        armtol_poses poses;
        start(&poses, n_links, &tool);
        for (size_t n_poses = 1; n_poses <= MOST_POSES; n_poses += 3) {
            check_blocks(&poses, n_poses, blocks);
            check_blocks(&poses, n_poses, blocks + 1); /* aligned to no vector */
        }
    }
}

/* Angles beyond 1e6 are libm's; those of other poses beside them are not. */
/* |A| t by the matrix of the placed links, less what is negligible; of a pose's row, or the length of three. */
static double worst_expected(const armtol_poses *poses, const double joints[], const double tolerances[], size_t row,
                             bool is_length)
{
    double squares = 0;
    size_t n;
    expect(poses, joints, &n);
    armtol_tool_matrix_clear(placed, poses->n_links, &poses->tool, expected, n);
    for (size_t i = row; i < row + 3 && is_length; i++) {
        const double worst = armtol_worst_error(expected, n, i, tolerances);
        squares += worst * worst;
    }
    return is_length ? sqrt(squares) : armtol_worst_error(expected, n, row, tolerances);
}

/* The stretched chain and the tool's offset: what negligible is a part of. */
static double reach_of_placed(const armtol_poses *poses, const double joints[])
{
    const double *offset = poses->tool.offset;
    double reach = sqrt(offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]);
    armtol_links_place(links, poses->n_links, joints, poses->n_joints, &armtol_errata_none, placed);
    for (size_t i = 0; i < poses->n_links; i++) {
        reach += sqrt(placed[i].a * placed[i].a + placed[i].d * placed[i].d);
    }
    return reach;
}

static void check_worst_of(const kernels *kernels, const worst_case *worst, size_t n_poses)
{
    double reach[ARMTOL_POSE_BLOCKS(MOST_POSES) * ARMTOL_POSE_BLOCK] = {0}, found[MOST_POSES + 1];
    const armtol_poses *poses = worst->poses;
    for (size_t p = 0; p < n_poses; p++) {
        reach[p] = reach_of_placed(poses, q + p * poses->n_joints);
    }
    found[n_poses] = 42;
    kernels->worst(worst, q, n_poses, reach, blocks, found);
    for (size_t p = 0; p < n_poses; p++) {
        const double *joints = q + p * poses->n_joints;
        check_same(worst_expected(poses, joints, worst->tolerances, worst->row, worst->is_length), found[p],
                   "pose %zu of %zu, row %zu, %d", p, n_poses, worst->row, worst->is_length);
    }
    check_same(42, found[n_poses], "behind the last pose");
}

/* Arms of links of all kinds and joints; every width of vectors that this machine has. */
static void test_the_worst_case_of_many_poses_is_that_of_each(void)
{
    double tolerances[MOST_COLUMNS];
    for (size_t k = 0; k < MOST_COLUMNS; k++) {
        tolerances[k] = 1e-3 * (double)(k % 7 + 1);
    }
    for (uint64_t seed = 0; seed < 12; seed++) {
        const armtol_tool_point tool = {{3, 4, 5}, (armtol_frame)(seed % 2)};
        armtol_poses poses;
        start(&poses, random_arm(seed, 3 + seed), &tool);
        for (size_t asked = 0; asked < 8; asked++) {
            const bool is_length = asked >= 6;
            const worst_case worst = {&poses, tolerances, is_length ? 3 * (asked - 6) : asked, is_length};
            for (int lanes = 2; lanes <= ARMTOL_POSE_BLOCK; lanes *= 2) {
                check_worst_of(kernels_of_machine(lanes), &worst, 1 + (seed + asked) % MOST_POSES);
            }
        }
    }
}

/* Elements up to the edge are what rounding left of a 0; just above it they count. */
static void test_what_is_negligible_is_left_out_of_the_worst_case(void)
{
    static const double tolerances[2 * 4] = {1, 1, 1, 1, 1, 1, 1, 1};
    const armtol_tool_point tool = armtol_tool_origin;
    links[0] = (armtol_link){.kind = ARMTOL_NPR, .joint = ARMTOL_REVOLUTE};
    links[1] = (armtol_link){.kind = ARMTOL_NPR, .joint = ARMTOL_FIXED};
    for (int more = 0; more < 2; more++) {
        armtol_poses poses;
        const double part = negligible * (more ? 1.5 : 0.5), reach[ARMTOL_POSE_BLOCK] = {0};
        double found;
        links[0].theta = part;
        q[0] = 0;
        start(&poses, 2, &tool);
        const worst_case worst = {&poses, tolerances, 1, false};
        kernels_of_machine(ARMTOL_POSE_BLOCK)->worst(&worst, q, 1, reach, blocks, &found);
        check_same(more ? 2 * part : 0, found, "the y of two x axes that are turned by %g", part);
    }
}

static void test_a_far_angle_leaves_its_neighbours_alone(void)
{
    static const armtol_tool_point tool = {{30, -20, 70}, ARMTOL_BASE_FRAME};
    for (uint64_t seed = 0; seed < 12; seed++) {
        armtol_poses poses;
        start(&poses, random_arm(seed, 7), &tool);
        for (size_t i = 0; i < MOST_POSES * poses.n_joints; i++) {
            q[i] *= 1000;
        }
        for (size_t p = seed % 4; p < MOST_POSES; p += 4) {
            q[p * poses.n_joints + seed % poses.n_joints] = 1e7 + (double)p;
        }
        check_blocks(&poses, MOST_POSES, blocks);
    }
}

static void test_no_poses_are_no_work(void)
{
    armtol_poses poses;
    armtol_bounds bounds = {42, 42};
    start(&poses, random_arm(1, 5), &armtol_tool_origin);
    blocks[0] = 42;
    armtol_pose_blocks(&poses, q, 0, blocks, &bounds);
    check_same(42, blocks[0], "the matrix");
    check_same(42, bounds.angle, "the bound");
}

/*
 * One link of length 1: its theta moves the tool by (-sin, cos), which are held against those of long double.
 */
static void check_sine(const armtol_poses *poses, double angle, double units)
{
    armtol_bounds bounds;
    armtol_pose_blocks(poses, &angle, 1, blocks, &bounds);
    const long double right[2] = {-sinl((long double)angle), cosl((long double)angle)};
    for (int i = 0; i < 2; i++) {
        const double unit = ldexp(1, ilogb((double)right[i]) - 52);
        const double off = (double)((long double)blocks[ARMTOL_POSE_ELEMENT(4, (size_t)i, 0, 0)] - right[i]);
        check_within(units * unit, 0, off, "%s of %.17g", i == 0 ? "sine" : "cosine", angle);
    }
}

/* valgrind computes it in doubles, and then it is no better than what is tested. */
static bool long_double_is_wide(void)
{
    volatile long double sum = 1;
    sum += LDBL_EPSILON;
    return sum > 1 && LDBL_EPSILON < (long double)DBL_EPSILON;
}

static void test_sines_and_cosines_are_within_a_unit_in_the_last_place(void)
{
    armtol_poses poses;
    random_source source = {41};
    if (!long_double_is_wide()) {
        TEST_IGNORE_MESSAGE("long double is no wider than double here");
    }
    links[0] = (armtol_link){.joint = ARMTOL_REVOLUTE, .a = 1};
    start(&poses, 1, &armtol_tool_origin);
    for (int n = 0; n < 20000; n++) {
        check_sine(&poses, random_between(&source, -4, 4), 0.9);
        check_sine(&poses, random_between(&source, -1e5, 1e5), 0.9);
        check_sine(&poses, ldexp(random_between(&source, -1, 1), -n % 60), 0.9);
        /* next to multiples of a quarter turn there is least left */
        check_sine(&poses, floor(random_between(&source, 1, 6e4)) * 1.57079632679489661923, 0.9);
    }
}

static void test_joint_values_of_any_size(void)
{
    armtol_poses poses;
    random_source source = {43};
    links[0] = (armtol_link){.joint = ARMTOL_REVOLUTE, .a = 1};
    start(&poses, 1, &armtol_tool_origin);
    for (int n = 0; n < 1000; n++) {
        check_sine(&poses, random_between(&source, -1e6, 1e6), 1.1);
        check_sine(&poses, random_between(&source, -1e9, 1e9), 1.1);
        q[n % MOST_POSES] = random_between(&source, -4e6, 4e6);
    }
    check_blocks(&poses, MOST_POSES, blocks);
}

static void test_nan_gives_nan_bounds(void)
{
    armtol_poses poses;
    armtol_bounds bounds;
    armtol_intelledex_605t.links(&armtol_errata_none, links);
    start(&poses, armtol_intelledex_605t.n_links, &armtol_tool_origin);
    for (size_t k = 0; k < 6; k++) {
        double joints[6] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
        joints[k] = k % 2 == 0 ? (double)NAN : (double)INFINITY;
        armtol_pose_blocks(&poses, joints, 1, blocks, &bounds);
        TEST_ASSERT_TRUE(isnan(bounds.angle));
        TEST_ASSERT_TRUE(k == 5 || isnan(bounds.distance));
    }
}

static void test_rows_without_entries_set_no_bound(void)
{
    armtol_poses poses;
    armtol_bounds bounds;
    /* no link counts a length but d, along z: rows x and y have none */
    links[0] = (armtol_link){.kind = ARMTOL_NPP, .joint = ARMTOL_PRISMATIC};
    start(&poses, 1, &armtol_tool_origin);
    const double joint = 5;
    armtol_pose_blocks(&poses, &joint, 1, blocks, &bounds);
    check_within(1e-15, accuracy[2], bounds.distance, "the distance bound: no angle moves z");
    /*
     * theta turns about z: 0.3 allowed; alpha about x: 0.1, and moves y by 5 an unit: no, the tool is on its
     * axis
     */
    check_within(1e-15, 0.1, bounds.angle, "the angle bound");
}

static void check_refused(armtol_status status, const armtol_link *link, size_t n,
                          const armtol_tool_point *tool, const double tolerances[6], double share)
{
    armtol_poses poses = {.n_links = 42};
    TEST_ASSERT_EQUAL_INT(status, armtol_poses_start(&poses, prepared, link, n, tool, tolerances, share));
    TEST_ASSERT_EQUAL_INT(42, poses.n_links);
}

static void test_what_cannot_be_prepared_is_refused(void)
{
    const armtol_link good = {.a = 1}, bad = {.kind = ARMTOL_KIND_COUNT};
    const armtol_tool_point *tool = &armtol_tool_origin, nowhere = {{(double)NAN, 0, 0}, ARMTOL_BASE_FRAME};
    const double negative[6] = {1, 1, 1, 1, 1, -1}, wide[6] = {1, 1, 1, 1, 1, 1e200};
    check_refused(ARMTOL_NO_LINKS, &good, 0, tool, accuracy, delta);
    check_refused(ARMTOL_BAD_KIND, &bad, 1, tool, accuracy, delta);
    check_refused(ARMTOL_NOT_FINITE, &good, 1, &nowhere, accuracy, delta);
    check_refused(ARMTOL_BAD_TOLERANCE, &good, 1, tool, negative, delta);
    check_refused(ARMTOL_BAD_TOLERANCE, &good, 1, tool, wide, delta);
    check_refused(ARMTOL_BAD_DELTA, &good, 1, tool, accuracy, 0.3);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_row_can_set_the_bounds);
    RUN_TEST(test_a_pose_is_the_matrix_and_the_bounds_of_the_placed_links);
    RUN_TEST(test_a_pose_has_the_same_bits_in_any_block_and_alone);
    RUN_TEST(test_the_worst_case_of_many_poses_is_that_of_each);
    RUN_TEST(test_what_is_negligible_is_left_out_of_the_worst_case);
    RUN_TEST(test_a_far_angle_leaves_its_neighbours_alone);
    RUN_TEST(test_no_poses_are_no_work);
    RUN_TEST(test_sines_and_cosines_are_within_a_unit_in_the_last_place);
    RUN_TEST(test_joint_values_of_any_size);
    RUN_TEST(test_nan_gives_nan_bounds);
    RUN_TEST(test_rows_without_entries_set_no_bound);
    RUN_TEST(test_what_cannot_be_prepared_is_refused);
    return UNITY_END();
}
