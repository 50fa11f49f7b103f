/* Two arms side by side, against the long double reference, which shares nothing with the library. */

#include "armtol/comparison.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"

#include "unity.h"

#include <math.h>
#include <string.h>

enum { LINKS = 5, DIFFERENCES = LINKS * ARMTOL_PARAMETER_COUNT, TRIES = 200 };

static const double pi = 3.14159265358979323846;

void setUp(void)
{
}

void tearDown(void)
{
}

/* An arm of all joints in turn, and the same with each parameter off by up to `off` radians and 100 times that. */
typedef struct pair {
    armtol_link links[2][LINKS];
    armtol_drive drives[LINKS];
    armtol_arm arms[2];
    double q[LINKS];
    size_t n_joints;
    armtol_tool_point tool;
} pair;

static void move_link(armtol_link *link, random_source *source, double off)
{
    for (int p = 0; p < ARMTOL_PARAMETER_COUNT; p++) {
        const armtol_parameter parameter = (armtol_parameter)p;
        const double scale = armtol_parameter_is_length(parameter) ? 100 * off : off;
        *armtol_link_parameter(link, parameter) += random_between(source, -scale, scale);
    }
}

static void make_pair(pair *pair, random_source *source, double off)
{
    for (size_t i = 0; i < LINKS; i++) {
        pair->links[0][i] = (armtol_link){
            .kind = (armtol_kind)random_between(source, 0, ARMTOL_KIND_COUNT),
            .joint = (armtol_joint)(i % ARMTOL_JOINT_COUNT),
            .a = random_between(source, -300, 300),
            .alpha = random_between(source, -pi, pi),
            .d = random_between(source, -300, 300),
            .theta = random_between(source, -pi, pi),
            .beta = random_between(source, -1, 1),
        };
        pair->links[1][i] = pair->links[0][i];
        pair->links[1][i].kind = (armtol_kind)((i + 1) % ARMTOL_KIND_COUNT);
        move_link(&pair->links[1][i], source, off);
        pair->drives[i] = armtol_drive_unknown;
    }
    for (int k = 0; k < 2; k++) {
        pair->arms[k] = (armtol_arm){.name = "arm", .n_links = LINKS, .links = pair->links[k], .drives = pair->drives};
    }
    pair->n_joints = armtol_arm_joint_count(&pair->arms[0]);
    for (size_t i = 0; i < pair->n_joints; i++) {
        pair->q[i] = random_between(source, -2, 2);
    }
    pair->tool = (armtol_tool_point){{10, -20, 30}, ARMTOL_BASE_FRAME};
}

static size_t compare(const pair *pair, armtol_difference differences[], double error[6], double explained[])
{
    armtol_link work[LINKS];
    size_t n;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_arm_differences(&pair->arms[0], &pair->arms[1], differences, &n));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_arm_compare(&pair->arms[0], &pair->arms[1], pair->q, pair->n_joints,
                                                        &pair->tool, differences, n, work, error, explained));
    return n;
}

static void place(const pair *pair, int which, armtol_link placed[])
{
    size_t joint = 0;
    for (size_t i = 0; i < LINKS; i++) {
        placed[i] = pair->links[which][i];
        placed[i].theta += placed[i].joint == ARMTOL_REVOLUTE ? pair->q[joint] : 0;
        placed[i].d += placed[i].joint == ARMTOL_PRISMATIC ? pair->q[joint] : 0;
        joint += placed[i].joint != ARMTOL_FIXED;
    }
}

static void tool_of(const pair *pair, int which, double transform[4][4], double point[3])
{
    armtol_link placed[LINKS];
    place(pair, which, placed);
    reference_chain(placed, LINKS, transform);
    for (int i = 0; i < 3; i++) {
        point[i] = transform[i][3];
        for (int n = 0; n < 3; n++) {
            point[i] += transform[i][n] * pair->tool.offset[n];
        }
    }
}

/* The displacement of the tool point; and the turn, which takes the axes as meant into those as built. */
static void check_error(const pair *pair, const double error[6])
{
    double meant[4][4], built[4][4], from[3], to[3];
    tool_of(pair, 0, meant, from);
    tool_of(pair, 1, built, to);
    const double angle = sqrt(error[3] * error[3] + error[4] * error[4] + error[5] * error[5]);
    for (int i = 0; i < 3; i++) {
        check_within(1e-11, to[i] - from[i], error[i], "component %d", i);
    }
    for (int column = 0; column < 3; column++) {
        /* Rodrigues: v cos + (w x v) sin + w (w.v)(1 - cos) */
        const double w[3] = {error[3] / angle, error[4] / angle, error[5] / angle};
        const double v[3] = {meant[0][column], meant[1][column], meant[2][column]};
        const double along = w[0] * v[0] + w[1] * v[1] + w[2] * v[2];
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            const double turned =
                v[i] * cos(angle) + (w[j] * v[k] - w[k] * v[j]) * sin(angle) + w[i] * along * (1 - cos(angle));
            check_within(1e-12, built[i][column], turned, "axis %d, %d", column, i);
        }
    }
}

static void test_the_error_is_that_of_the_two_chains(void)
{
    random_source source = {161};
    for (int t = 0; t < TRIES; t++) {
        pair pair;
        armtol_difference differences[DIFFERENCES];
        double error[6], explained[6 * DIFFERENCES];
        make_pair(&pair, &source, 0.05);
        TEST_ASSERT_EQUAL_UINT(DIFFERENCES, compare(&pair, differences, error, explained));
        check_error(&pair, error);
    }
}

/* To first order it is the column of A, by central differences, times the difference. */
static void test_each_is_explained_by_its_column(void)
{
    random_source source = {162};
    for (int t = 0; t < TRIES; t++) {
        pair pair;
        armtol_difference differences[DIFFERENCES];
        armtol_link placed[LINKS];
        double error[6], explained[6 * DIFFERENCES];
        make_pair(&pair, &source, 1e-5);
        pair.tool = armtol_tool_origin;
        const size_t n = compare(&pair, differences, error, explained);
        place(&pair, 0, placed);
        for (size_t k = 0; k < n; k++) {
            double twist[6];
            const armtol_column column = {differences[k].link, differences[k].parameter};
            reference_column(placed, LINKS, column, true, twist);
            for (size_t i = 0; i < 6; i++) {
                const double size = i < 3 ? 1e-7 : 1e-9; /* 1e-5^2 of 1,000 mm, or of 1; and the differences' own */
                check_within(size, twist[i] * differences[k].value, explained[6 * k + i], "row %zu", i);
            }
        }
    }
}

static double size_of_rest(const double error[6], const double explained[], size_t n, size_t first)
{
    double square = 0;
    for (size_t i = first; i < first + 3; i++) {
        double rest = error[i];
        for (size_t k = 0; k < n; k++) {
            rest -= explained[6 * k + i];
        }
        square += rest * rest;
    }
    return sqrt(square);
}

/* With differences of a tenth, what they do together is a hundredth. */
static void test_what_is_left_is_of_second_order(void)
{
    random_source source = {163};
    for (int t = 0; t < TRIES; t++) {
        pair pair;
        armtol_difference differences[DIFFERENCES];
        double error[6], explained[6 * DIFFERENCES], rest[2];
        make_pair(&pair, &source, 1e-3);
        for (int step = 0; step < 2; step++) {
            const size_t n = compare(&pair, differences, error, explained);
            rest[step] = size_of_rest(error, explained, n, 0);
            for (size_t k = 0; k < n; k++) {
                armtol_link *const built = &pair.links[1][differences[k].link];
                armtol_link *const meant = &pair.links[0][differences[k].link];
                *armtol_link_parameter(built, differences[k].parameter) =
                    *armtol_link_parameter(meant, differences[k].parameter) + differences[k].value / 10;
            }
        }
        check_within(0.1 * rest[0] / 100 + 1e-10, rest[0] / 100, rest[1], "try %d", t);
    }
}

/* Along the tool's axes the error is the same, turned. */
static void test_the_frame_of_the_tool(void)
{
    random_source source = {164};
    pair pair;
    armtol_difference differences[DIFFERENCES];
    double in_base[6], in_tool[6], explained[6 * DIFFERENCES], meant[4][4], point[3];
    make_pair(&pair, &source, 0.01);
    compare(&pair, differences, in_base, explained);
    pair.tool.frame = ARMTOL_TOOL_FRAME;
    compare(&pair, differences, in_tool, explained);
    tool_of(&pair, 0, meant, point);
    for (size_t i = 0; i < 6; i++) {
        double expected = 0;
        for (size_t n = 0; n < 3; n++) {
            expected += meant[n][i % 3] * in_base[i / 3 * 3 + n];
        }
        check_within(1e-11, expected, in_tool[i], "row %zu", i);
    }
}

static void test_a_whole_turn_is_no_difference(void)
{
    random_source source = {165};
    pair pair;
    armtol_difference differences[DIFFERENCES];
    size_t n;
    make_pair(&pair, &source, 0);
    pair.links[0][1].alpha = -pi;
    pair.links[1][1].alpha = pi;
    pair.links[1][2].a += 0.25;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_arm_differences(&pair.arms[0], &pair.arms[1], differences, &n));
    TEST_ASSERT_EQUAL_UINT(1, n);
    TEST_ASSERT_EQUAL_UINT(2, differences[0].link);
    TEST_ASSERT_EQUAL_INT(ARMTOL_A, differences[0].parameter);
    check_within(1e-12, 0.25, differences[0].value, "a");
}

static armtol_status asked(const pair *pair)
{
    armtol_difference differences[DIFFERENCES];
    size_t n;
    return armtol_arm_differences(&pair->arms[0], &pair->arms[1], differences, &n);
}

static void test_arms_that_are_not_alike_are_refused(void)
{
    random_source source = {166};
    pair pair;
    armtol_motion motions[LINKS];
    make_pair(&pair, &source, 0.01);
    for (size_t i = 0; i < LINKS; i++) {
        motions[i] = (armtol_motion){.follows = i, .multiplier = 7, .offset = 7, .sign = 1};
    }
    pair.arms[1].motions = motions;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, asked(&pair)); /* what follows itself has neither multiplier nor offset */
    motions[1].sign = -1;
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_JOINT, asked(&pair));
    motions[1] = (armtol_motion){.follows = 4, .multiplier = 1, .sign = 1};
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_JOINT, asked(&pair));
    pair.arms[1].motions = NULL;
    pair.links[1][1].joint = ARMTOL_PRISMATIC;
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_JOINT, asked(&pair));
    pair.arms[1].n_links = LINKS - 1;
    TEST_ASSERT_EQUAL_INT(ARMTOL_WRONG_SIZE, asked(&pair));
    pair.links[1][0].a = (double)NAN;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, asked(&pair));
    pair.arms[0].n_links = 0;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NO_LINKS, asked(&pair));
}

static void test_a_pose_that_cannot_be_placed_is_refused(void)
{
    random_source source = {167};
    pair pair;
    armtol_link work[LINKS];
    double error[6];
    make_pair(&pair, &source, 0.01);
    pair.q[0] = (double)NAN;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_arm_compare(&pair.arms[0], &pair.arms[1], pair.q, pair.n_joints,
                                                                &pair.tool, NULL, 0, work, error, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_WRONG_SIZE, armtol_arm_compare(&pair.arms[0], &pair.arms[1], pair.q, 0, &pair.tool,
                                                                NULL, 0, work, error, NULL));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_error_is_that_of_the_two_chains);
    RUN_TEST(test_each_is_explained_by_its_column);
    RUN_TEST(test_what_is_left_is_of_second_order);
    RUN_TEST(test_the_frame_of_the_tool);
    RUN_TEST(test_a_whole_turn_is_no_difference);
    RUN_TEST(test_arms_that_are_not_alike_are_refused);
    RUN_TEST(test_a_pose_that_cannot_be_placed_is_refused);
    return UNITY_END();
}
