/*
 * The largest noise for a wished repeatability: closed forms, a search without an optimum's conditions, and arms that
 * come back with what was allotted.
 */

#include "armtol/arrivals.h"
#include "support/check.h"
#include "support/random.h"

#include "unity.h"

#include <math.h>
#include <string.h>

enum { MOST_LINKS = 16, MOST_POSES = 3 };

static const double pi = 3.14159265358979323846;
static armtol_link links[MOST_LINKS];
static armtol_drive drives[MOST_LINKS];
static double q[MOST_LINKS * MOST_POSES], noise[MOST_LINKS], shares[MOST_LINKS];
static armtol_arm arm;
static armtol_question question;
static armtol_answer *answer;
static armtol_fault fault;

/* Exact parts: what is off is of the drives. */
static const double tolerances[5 * MOST_LINKS];

void setUp(void)
{
    for (size_t i = 0; i < MOST_LINKS; i++) {
        drives[i] = armtol_drive_unknown;
    }
    memset(q, 0, sizeof q);
    arm = (armtol_arm){.name = "drawn", .title = "an arm", .source = "the test", .links = links, .drives = drives};
    question = (armtol_question){.arm = &arm, .q = q, .n_poses = 1, .tolerances = tolerances};
    answer = NULL;
}

void tearDown(void)
{
    armtol_answer_destroy(answer);
}

/* Slides along z, y and x of the base. */
static void take_slides(size_t n)
{
    const armtol_link slide = {ARMTOL_NPP, ARMTOL_PRISMATIC, .alpha = pi / 2, .theta = pi / 2};
    links[0] = links[1] = links[2] = slide;
    arm.n_links = n;
}

/* Booms in a plane, each 0.75 times as long as the one before. */
static void take_booms(size_t n)
{
    for (size_t i = 0; i < n; i++) {
        links[i] = (armtol_link){ARMTOL_PPR, ARMTOL_REVOLUTE, .a = i == 0 ? 400 : 0.75 * links[i - 1].a};
    }
    arm.n_links = n;
}

static armtol_status allot(double wish)
{
    armtol_answer_destroy(answer);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&question, &answer, NULL));
    const armtol_status status = armtol_arrivals_noise(answer, wish, noise, &fault);
    TEST_ASSERT_EQUAL_INT(status, fault.status);
    return status;
}

static void allot_well(double wish)
{
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, allot(wish));
    TEST_ASSERT_EQUAL_INT(ARMTOL_ABOUT_NOTHING, fault.about);
}

/* The median RP of arms whose drives have the noise that was allotted; joints that may have any have none. */
static double median_of_arms(uint64_t samples, size_t cycles)
{
    const armtol_draw draw = {.samples = samples, .seed = 7};
    armtol_arrivals *arrivals;
    for (size_t i = 0; i < arm.n_links; i++) {
        drives[i].noise = isinf(noise[i]) ? 0 : noise[i];
    }
    armtol_answer_destroy(answer);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&question, &answer, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_arrivals_create(answer, &draw, cycles, &arrivals, NULL));
    double largest = 0;
    for (size_t pose = 0; pose < arrivals->n_poses; pose++) {
        largest = fmax(largest, arrivals->poses[pose].repeatability.quantiles[0]);
    }
    armtol_arrivals_destroy(arrivals);
    return largest;
}

/* ---- closed forms ---- */

/* A normal error along a line has the mean sqrt(2/pi) and the mean square 1. */
static double normal_bound(void)
{
    return sqrt(2 / pi) + 3 * sqrt(1 - 2 / pi);
}

static void test_one_slide(void)
{
    take_slides(1);
    allot_well(0.03);
    check_within(1e-15, 0.03 / normal_bound(), noise[0], "noise");
    const double repeatability = median_of_arms(1, 400000);
    check_within(0.01 * 0.03, 0.03, repeatability, "RP");
    check_within(1e-15, 0.03, armtol_arrivals_bound(answer, 0, NULL, shares), "bound");
    check_same(1, shares[0], "its share");
}

/* RP of three alike is sigma (sqrt(8 / pi) + 3 sqrt(3 - 8 / pi)). */
static void test_three_slides(void)
{
    take_slides(3);
    allot_well(0.03);
    const double sigma = 0.03 / normal_bound() / sqrt(3);
    for (size_t i = 0; i < 3; i++) {
        check_within(1e-12 * sigma, sigma, noise[i], "noise of %zu", i);
    }
    const double repeatability = median_of_arms(1, 400000);
    TEST_ASSERT_TRUE(repeatability <= 0.03);
    check_within(4 * 1.7 * sigma / sqrt(400000), sigma * (sqrt(8 / pi) + 3 * sqrt(3 - 8 / pi)), repeatability, "RP");
}

/* Even errors have a third of the square of their half width. */
static void test_steps_and_plays(void)
{
    const double step = 0.006, play = 0.008, wish = 0.03;
    take_slides(3);
    drives[0].resolution = 2 * step;
    drives[1].backlash = 2 * play;
    drives[2].noise = 0.5; /* is not looked at */
    allot_well(wish);
    const double square = wish * wish / (normal_bound() * normal_bound()) - (step * step + play * play) / 3;
    for (size_t i = 0; i < 3; i++) {
        check_within(1e-12, sqrt(square / 3), noise[i], "noise of %zu", i);
    }
    check_within(1e-12, wish, armtol_arrivals_bound(answer, 0, noise, shares), "bound");
    check_within(1e-12, (square / 3 + step * step / 3) / (square + (step * step + play * play) / 3), shares[0],
                 "share of the first");
    check_within(1e-12, 1, shares[0] + shares[1] + shares[2], "all shares");
}

/* A step alone: h (1/2 + sqrt(3)/2), which is 0.908 of the bound. */
static void test_a_step_alone(void)
{
    take_slides(1);
    drives[0].resolution = 0.02;
    allot_well(1);
    const double bound = armtol_arrivals_bound(answer, 0, NULL, shares);
    check_within(1e-15, normal_bound() * 0.01 / sqrt(3), bound, "bound");
    TEST_ASSERT_TRUE(0.01 * (0.5 + sqrt(3) / 2) <= bound);
    noise[0] = 0;
    check_within(0.005 * bound, 0.01 * (0.5 + sqrt(3) / 2), median_of_arms(1, 100000), "RP");
}

/* The last axis goes through the tool point, and a fixed link has no drive. */
static void test_joints_that_move_nothing(void)
{
    take_booms(3);
    links[1].joint = ARMTOL_FIXED;
    links[2].a = 0;
    allot_well(1);
    check_same(0, noise[1], "fixed");
    TEST_ASSERT_TRUE(isinf(noise[2]));
    check_within(1e-15, 1 / normal_bound() / 700, noise[0], "the first");
    check_within(1e-12, 1, armtol_arrivals_bound(answer, 0, noise, shares), "bound");
    check_same(0, shares[2], "share");
    links[0].joint = ARMTOL_FIXED;
    links[2].joint = ARMTOL_FIXED;
    allot_well(1);
    check_same(0, noise[0], "all fixed");
    check_same(0, armtol_arrivals_bound(answer, 0, NULL, shares), "bound of all fixed");
}

/* ---- a search ---- */

/* How far the tool goes for 1 of a boom's joint, by plane trigonometry; squared. */
static double square_of(size_t pose, size_t link)
{
    double x = 0, y = 0, angle = 0;
    for (size_t i = 0; i < arm.n_links; i++) {
        angle += q[pose * arm.n_links + i];
        x += i >= link ? links[i].a * cos(angle) : 0;
        y += i >= link ? links[i].a * sin(angle) : 0;
    }
    return x * x + y * y;
}

/* What is left for the last joint's square by all poses. */
static double rest_of(double limit, double first, double second)
{
    double rest = (double)INFINITY;
    for (size_t pose = 0; pose < question.n_poses; pose++) {
        rest = fmin(rest, (limit - square_of(pose, 0) * first - square_of(pose, 1) * second) / square_of(pose, 2));
    }
    return rest;
}

/*
 * Three booms, one pose in which the first joint has the longer arm and another in which the second has: both hold.
 * No squares of two noises in a net have a larger product with what they leave for the third.
 */
static void test_no_other_noises_have_a_larger_product(void)
{
    enum { STEPS = 400 };
    const double wish = 0.05, limit = wish * wish / (normal_bound() * normal_bound());
    double best = 0;
    take_booms(3);
    question.n_poses = 2;
    q[1] = 0.1;
    q[2] = 3;
    q[4] = 3;
    q[5] = 0.1;
    allot_well(wish);
    const double found = noise[0] * noise[1] * noise[2];
    check_within(1e-9 * limit, noise[2] * noise[2], rest_of(limit, noise[0] * noise[0], noise[1] * noise[1]),
                 "what is left for the third");
    for (int i = 1; i < STEPS; i++) {
        for (int j = 1; j < STEPS; j++) {
            const double first = noise[0] * noise[0] * 3 * i / STEPS, second = noise[1] * noise[1] * 3 * j / STEPS;
            const double rest = rest_of(limit, first, second);
            best = fmax(best, rest > 0 ? sqrt(first * second * rest) : 0);
        }
    }
    TEST_ASSERT_TRUE(best <= found * (1 + 1e-9));
    TEST_ASSERT_TRUE(best >= found * 0.999);
    for (size_t pose = 0; pose < 2; pose++) {
        const double bound = armtol_arrivals_bound(answer, pose, noise, shares);
        check_within(1e-6 * wish, wish, bound, "bound in pose %zu", pose);
    }
}

/* ---- arms that come back ---- */

static void draw_pose(random_source *random)
{
    for (size_t i = 0, joint = 0; i < arm.n_links; i++) {
        if (armtol_arm_is_driven(&arm, i)) {
            const bool slides = links[i].joint == ARMTOL_PRISMATIC;
            q[joint++] = slides ? random_between(random, 100, 300) : random_between(random, -3, 3);
        }
    }
}

/* Every built-in arm with steps, and plays in every other joint, that leave something: RP of many cycles. */
static void test_every_arm_comes_back_within_the_wish(void)
{
    random_source random = {2026};
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        arm = *armtol_arm_at(i);
        TEST_ASSERT_TRUE(arm.n_links <= MOST_LINKS);
        memcpy(links, arm.links, arm.n_links * sizeof *links);
        arm.links = links;
        arm.drives = drives;
        arm.masses = NULL;
        for (size_t k = 0; k < arm.n_links; k++) {
            drives[k] = armtol_drive_unknown;
        }
        draw_pose(&random);
        allot_well(1);
        for (size_t k = 0; k < arm.n_links; k++) { /* of what the joint may have, some goes to its step and its play */
            drives[k].resolution = isinf(noise[k]) ? 1e-3 : noise[k];
            drives[k].backlash = k % 2 == 0 ? drives[k].resolution : (double)NAN;
        }
        allot_well(1);
        const double repeatability = median_of_arms(40, 1000);
        if (!(repeatability <= 1.01 && repeatability >= 0.75)) { /* a median of 40 scatters by 0.5 % */
            TEST_FAIL_MESSAGE(arm.name);
        }
    }
}

/* ---- what is wrong ---- */

static void check_fault(armtol_status status, armtol_subject about, size_t number)
{
    TEST_ASSERT_EQUAL_INT(status, fault.status);
    TEST_ASSERT_EQUAL_INT(about, fault.about);
    TEST_ASSERT_EQUAL_UINT64(number, fault.number);
    for (size_t i = 0; i < arm.n_links; i++) {
        check_same(0, noise[i], "noise of %zu after an error", i);
    }
}

static void test_wishes_that_are_none(void)
{
    const double wishes[] = {0, -1, (double)INFINITY, (double)NAN};
    take_booms(2);
    for (size_t i = 0; i < sizeof wishes / sizeof wishes[0]; i++) {
        allot(wishes[i]);
        check_fault(ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_ACCURACY, 0);
    }
    allot(1e-300);
    check_fault(ARMTOL_NOT_FINITE, ARMTOL_ABOUT_METHOD, 0);
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_TOLERANCE, armtol_arrivals_noise(answer, 0, noise, NULL));
}

/* Folded, the first joint moves the tool by 100; stretched, by 700. */
static void test_a_step_that_leaves_nothing(void)
{
    take_booms(2);
    question.n_poses = 2;
    q[1] = pi;
    drives[0].resolution = 2e-3;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, allot(normal_bound() * 701e-3 / sqrt(3)));
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOTHING_LEFT, allot(normal_bound() * 699e-3 / sqrt(3)));
    check_fault(ARMTOL_NOTHING_LEFT, ARMTOL_ABOUT_POSE, 1);
    armtol_arrivals_bound(answer, 1, noise, shares);
    check_same(1, shares[0], "its share");
}

/* A link of parallel axes does not count d. */
static void test_a_joint_that_its_link_does_not_count(void)
{
    take_booms(2);
    links[1].joint = ARMTOL_PRISMATIC;
    allot(1);
    check_fault(ARMTOL_BAD_LOAD, ARMTOL_ABOUT_DRIVES, 1);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_one_slide);
    RUN_TEST(test_three_slides);
    RUN_TEST(test_steps_and_plays);
    RUN_TEST(test_a_step_alone);
    RUN_TEST(test_joints_that_move_nothing);
    RUN_TEST(test_no_other_noises_have_a_larger_product);
    RUN_TEST(test_every_arm_comes_back_within_the_wish);
    RUN_TEST(test_wishes_that_are_none);
    RUN_TEST(test_a_step_that_leaves_nothing);
    RUN_TEST(test_a_joint_that_its_link_does_not_count);
    return UNITY_END();
}
