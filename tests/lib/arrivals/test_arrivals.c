/*
 * Arms that come to a pose again and again: closed forms, of normal and of even arrivals, and a second computation of
 * an arm of two joints by plane trigonometry, another generator and Box and Muller's normal numbers.
 */

#include "armtol/arrivals.h"
#include "armtol/sampler.h"
#include "support/check.h"

#include "unity.h"

#include <math.h>
#include <string.h>

enum { MOST_LINKS = 3, MOST_COLUMNS = 15, MOST_POSES = 2 };

static armtol_link links[MOST_LINKS];
static armtol_drive drives[MOST_LINKS];
static armtol_mass masses[MOST_LINKS];
static double q[MOST_LINKS * MOST_POSES], tolerances[MOST_COLUMNS];
static armtol_arm arm;
static armtol_question question;
static armtol_draw draw;

void setUp(void)
{
    for (size_t i = 0; i < MOST_LINKS; i++) {
        drives[i] = armtol_drive_unknown;
    }
    memset(q, 0, sizeof q);
    memset(tolerances, 0, sizeof tolerances);
    arm = (armtol_arm){.name = "drawn", .title = "an arm", .source = "the test", .links = links, .drives = drives};
    question = (armtol_question){.arm = &arm, .q = q, .n_poses = 1, .tolerances = tolerances};
    draw = (armtol_draw){.seed = 7};
}

void tearDown(void)
{
}

/* ---- arms ---- */

static const armtol_link boom = {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 400}; /* theta a alpha beta */

static void take_boom(void)
{
    links[0] = boom;
    arm.n_links = 1;
}

/* Two booms in a plane. */
static void take_elbow(void)
{
    links[0] = boom;
    links[1] = boom;
    links[1].a = 300;
    arm.n_links = 2;
}

/* Slides along z, y and x of the base. */
static void take_slides(void)
{
    const double quarter = 1.57079632679489661923;
    const armtol_link slide = {ARMTOL_NPP, ARMTOL_PRISMATIC, .alpha = quarter, .theta = quarter};
    links[0] = links[1] = links[2] = slide;
    arm.n_links = 3;
}

static armtol_arrivals *repeat(uint64_t samples, size_t cycles)
{
    armtol_answer *answer;
    armtol_arrivals *arrivals;
    armtol_fault fault;
    draw.samples = samples;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&question, &answer, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_arrivals_create(answer, &draw, cycles, &arrivals, &fault));
    TEST_ASSERT_TRUE(fault.status == ARMTOL_OK && fault.about == ARMTOL_ABOUT_NOTHING);
    TEST_ASSERT_EQUAL_UINT64(cycles, arrivals->cycles);
    TEST_ASSERT_EQUAL_UINT64(answer->n_poses, arrivals->n_poses);
    armtol_answer_destroy(answer);
    return arrivals;
}

static void check_all_zero(const armtol_over_arms *over, const char *what)
{
    for (size_t i = 0; i < ARMTOL_ARRIVAL_QUANTILES; i++) {
        check_same(0, over->quantiles[i], "%s, quantile %zu", what, i);
    }
    check_same(0, over->largest, "%s, largest", what);
}

/* ---- closed forms ---- */

/* sigma (sqrt(8 / pi) + 3 sqrt(3 - 8 / pi)); of n cycles RP scatters by some 1.7 sigma / sqrt n. */
static void test_isotropic_normal_arrivals(void)
{
    enum { CYCLES = 400000 };
    const double sigma = 0.02, pi = 3.14159265358979323846;
    take_slides();
    drives[0].noise = drives[1].noise = drives[2].noise = sigma;
    armtol_arrivals *arrivals = repeat(1, CYCLES);
    const double expected = sigma * (sqrt(8 / pi) + 3 * sqrt(3 - 8 / pi));
    check_within(4 * 1.7 * sigma / sqrt(CYCLES), expected, arrivals->poses[0].repeatability.largest, "RP");
    check_within(6 * sigma / sqrt(CYCLES), 0, arrivals->poses[0].accuracy.largest, "AP");
    armtol_arrivals_destroy(arrivals);
}

/*
 * Of 30 normal arrivals the mean is normal, with sigma / sqrt 30, and its length that times chi of 3 degrees of
 * freedom, whose quantiles are the roots of tabled ones of chi squared (Abramowitz and Stegun, table 26.8; the median
 * 2.36597). A share of n arms scatters by sqrt(p (1 - p) / n).
 */
static void test_the_accuracy_of_normal_arrivals(void)
{
    enum { ARMS = 20000 };
    static const double squares[ARMTOL_ARRIVAL_QUANTILES] = {2.36597, 6.25139, 7.81473, 11.3449};
    const double sigma = 0.02;
    take_slides();
    drives[0].noise = drives[1].noise = drives[2].noise = sigma;
    armtol_arrivals *arrivals = repeat(ARMS, ARMTOL_ARRIVAL_CYCLES);
    for (size_t i = 0; i < ARMTOL_ARRIVAL_QUANTILES; i++) {
        const double p = arrivals->probabilities[i], x = sqrt(squares[i]);
        const double density = sqrt(2 / 3.14159265358979323846) * x * x * exp(-x * x / 2);
        const double unit = sigma / sqrt(ARMTOL_ARRIVAL_CYCLES);
        check_within(4 * unit * sqrt(p * (1 - p) / ARMS) / density, unit * x,
                     arrivals->poses[0].accuracy.quantiles[i], "AP, quantile %zu", i);
    }
    armtol_arrivals_destroy(arrivals);
}

static void test_arms_that_differ_in_making_come_back_exactly(void)
{
    enum { ARMS = 20000 };
    take_boom();
    tolerances[0] = 0.004;
    armtol_arrivals *arrivals = repeat(ARMS, ARMTOL_ARRIVAL_CYCLES);
    const armtol_over_arms *accuracy = &arrivals->poses[0].accuracy;
    TEST_ASSERT_EQUAL_UINT64(ARMS, arrivals->drawn);
    check_all_zero(&arrivals->poses[0].repeatability, "RP");
    for (size_t i = 0; i < ARMTOL_ARRIVAL_QUANTILES; i++) { /* the chord of an angle that is even up to 0.004 */
        const double p = arrivals->probabilities[i];
        check_within(800 * 0.002 * 4 * sqrt(p * (1 - p) / ARMS), 800 * sin(0.002 * p), accuracy->quantiles[i],
                     "AP, quantile %zu", i);
    }
    TEST_ASSERT_TRUE(accuracy->largest <= 800 * sin(0.002) && accuracy->largest > 800 * sin(0.001999));
    armtol_arrivals_destroy(arrivals);
}

/* The arm that is told is the one that armtol_verify draws: its chord from its own parameter. */
static void test_the_arm_that_is_farthest_off(void)
{
    take_boom();
    tolerances[0] = 0.004;
    armtol_arrivals *arrivals = repeat(1000, 2);
    const armtol_over_arms *accuracy = &arrivals->poses[0].accuracy;
    const double turn = 0.004 * armtol_sampler_uniform(draw.seed, 4 * accuracy->largest_arm);
    check_within(1e-12, 800 * sin(fabs(turn) / 2), accuracy->largest, "AP of arm %d", (int)accuracy->largest_arm);
    armtol_arrivals_destroy(arrivals);
}

/* Evenly to h on either side: the mean distance h / 2, its deviation h / sqrt 12. */
static void check_even_arrivals(double h)
{
    enum { CYCLES = 400000 };
    armtol_arrivals *arrivals = repeat(1, CYCLES);
    check_within(4 * 1.1 * h / sqrt(CYCLES), h * (0.5 + 3 / sqrt(12)), arrivals->poses[0].repeatability.largest,
                 "RP of %g", h);
    armtol_arrivals_destroy(arrivals);
}

static void test_an_encoder_alone(void)
{
    take_boom();
    drives[0].resolution = 0.001;
    check_even_arrivals(400 * 0.0005);
}

static void test_a_play_that_nothing_holds(void)
{
    take_boom();
    drives[0].backlash = 0.001;
    check_even_arrivals(400 * 0.0005);
}

/* The middle of the play is off by half of it at the most, in every arm otherwise: AP is even up to that. */
static void test_where_the_middle_of_a_play_is(void)
{
    enum { ARMS = 400 };
    const double half = 0.0005;
    take_boom();
    drives[0].backlash = 2 * half;
    armtol_arrivals *arrivals = repeat(ARMS, 4000);
    const double scatter = half / sqrt(3 * 4000);
    for (size_t i = 0; i < ARMTOL_ARRIVAL_QUANTILES; i++) {
        const double p = arrivals->probabilities[i];
        check_within(400 * (4 * half * sqrt(p * (1 - p) / ARMS) + 3 * scatter), 400 * half * p,
                     arrivals->poses[0].accuracy.quantiles[i], "AP, quantile %zu", i);
    }
    armtol_arrivals_destroy(arrivals);
}

/* The same at each arrival: the tool turns by compliance and play and comes back exactly. */
static void test_a_load_is_no_matter_of_arrivals(void)
{
    const armtol_loading down = {.gravity = {0, -9.80665, 0}};
    take_boom();
    drives[0].backlash = 0.001;
    drives[0].compliance = 1e-4;
    masses[0] = (armtol_mass){2, {-100, 0, 0}};
    arm.masses = masses;
    question.loading = &down;
    armtol_arrivals *arrivals = repeat(100, ARMTOL_ARRIVAL_CYCLES);
    const double turn = 0.001 + 1e-4 * 2 * 9.80665 * 0.3;
    check_all_zero(&arrivals->poses[0].repeatability, "RP");
    check_within(1e-12, 800 * sin(turn / 2), arrivals->poses[0].accuracy.quantiles[0], "AP");
    check_within(1e-12, 800 * sin(turn / 2), arrivals->poses[0].accuracy.largest, "AP, largest");
    armtol_arrivals_destroy(arrivals);
}

/* A typed moment is somewhere between its ends in each arm, and stays there. */
static void test_a_moment_in_doubt_is_of_the_arm(void)
{
    take_boom();
    drives[0].compliance = 1e-4;
    drives[0].moment = 10;
    armtol_arrivals *arrivals = repeat(2000, ARMTOL_ARRIVAL_CYCLES);
    const double largest = arrivals->poses[0].accuracy.largest;
    check_all_zero(&arrivals->poses[0].repeatability, "RP");
    TEST_ASSERT_TRUE(largest <= 800 * sin(0.0005) && largest > 0.99 * 800 * sin(0.0005));
    armtol_arrivals_destroy(arrivals);
}

/* ---- the second computation ---- */

static uint64_t congruential_state; /* Knuth's MMIX, of which the upper half is taken */

static double even(double half)
{
    congruential_state = congruential_state * 6364136223846793005u + 1442695040888963407u;
    return half * ((double)(congruential_state >> 32) / 2147483648.0 - 1);
}

static double normal(double sigma)
{
    const double u = (even(1) + 1) / 2 + 0x1p-34, angle = even(3.14159265358979323846);
    return sigma * sqrt(-2 * log(u)) * cos(angle);
}

typedef struct by_hand {
    double accuracy, repeatability;
} by_hand;

static const double turn_tolerance = 0.002, length_tolerance = 0.05;
static const double play = 2e-4, step = 3e-4, noise = 1e-4;

/* What joints and links are off by in an arm, and then in each arrival, all of it by sines and cosines. */
static by_hand arm_by_hand(size_t cycles, double xs[], double ys[])
{
    const double arrival = play / 2 + step / 2 + 3 * noise;
    const double turns[2] = {even(turn_tolerance - arrival), even(play / 2)}, length = even(length_tolerance);
    double x = 0, y = 0, sum = 0, squares = 0;
    for (size_t j = 0; j < cycles; j++) {
        const double first = q[0] + turns[0] + even(play / 2) + even(step / 2) + normal(noise);
        const double second = first + q[1] + turns[1] + even(play / 2) + even(step / 2) + normal(noise);
        xs[j] = (400 + length) * cos(first) + 300 * cos(second);
        ys[j] = (400 + length) * sin(first) + 300 * sin(second);
        x += xs[j] / (double)cycles;
        y += ys[j] / (double)cycles;
    }
    for (size_t j = 0; j < cycles; j++) {
        const double l = hypot(xs[j] - x, ys[j] - y);
        sum += l;
        squares += l * l;
    }
    const double mean = sum / (double)cycles;
    return (by_hand){
        hypot(x - 400 * cos(q[0]) - 300 * cos(q[0] + q[1]), y - 400 * sin(q[0]) - 300 * sin(q[0] + q[1])),
        mean + 3 * sqrt((squares - (double)cycles * mean * mean) / (double)(cycles - 1)),
    };
}

/* Two samples of n: a share below a number scatters by sqrt(2 p (1 - p) / n). */
static void check_share(size_t below, size_t n, double p, const char *what)
{
    check_within(4 * sqrt(2 * p * (1 - p) / (double)n), p, (double)below / (double)n, "%s: share of %g", what, p);
}

static void test_an_elbow_by_hand(void)
{
    enum { ARMS = 20000, CYCLES = ARMTOL_ARRIVAL_CYCLES };
    static by_hand arms[ARMS];
    double xs[CYCLES], ys[CYCLES];
    take_elbow();
    q[0] = 0.4;
    q[1] = 1.1;
    tolerances[0] = turn_tolerance; /* theta a alpha beta of the first link; more than its drive is off by */
    tolerances[1] = length_tolerance;
    drives[0].backlash = drives[1].backlash = play;
    drives[0].resolution = drives[1].resolution = step;
    drives[0].noise = drives[1].noise = noise;
    armtol_arrivals *arrivals = repeat(ARMS, CYCLES);
    congruential_state = 20261129;
    for (size_t i = 0; i < ARMS; i++) {
        arms[i] = arm_by_hand(CYCLES, xs, ys);
    }
    for (size_t k = 0; k < ARMTOL_ARRIVAL_QUANTILES; k++) {
        size_t accurate = 0, repeatable = 0;
        for (size_t i = 0; i < ARMS; i++) {
            accurate += arms[i].accuracy <= arrivals->poses[0].accuracy.quantiles[k];
            repeatable += arms[i].repeatability <= arrivals->poses[0].repeatability.quantiles[k];
        }
        check_share(accurate, ARMS, arrivals->probabilities[k], "AP");
        check_share(repeatable, ARMS, arrivals->probabilities[k], "RP");
    }
    armtol_arrivals_destroy(arrivals);
}

/* ---- poses, seeds and ends ---- */

static void take_noisy_elbow(void)
{
    take_elbow();
    question.n_poses = 2;
    q[1] = 1.1;
    q[3] = 0.2; /* nearly stretched: the first joint moves the tool farther */
    tolerances[0] = 0.002;
    drives[0].noise = drives[1].noise = 1e-4;
}

static void test_of_all_poses_the_largest(void)
{
    take_noisy_elbow();
    armtol_arrivals *arrivals = repeat(1000, ARMTOL_ARRIVAL_CYCLES);
    const armtol_repeated *poses = arrivals->poses, *all = &arrivals->all;
    check_same(fmax(poses[0].accuracy.largest, poses[1].accuracy.largest), all->accuracy.largest, "AP");
    check_same(fmax(poses[0].repeatability.largest, poses[1].repeatability.largest), all->repeatability.largest, "RP");
    for (size_t i = 0; i < ARMTOL_ARRIVAL_QUANTILES; i++) {
        TEST_ASSERT_TRUE(all->repeatability.quantiles[i] >= poses[0].repeatability.quantiles[i]);
        TEST_ASSERT_TRUE(all->repeatability.quantiles[i] >= poses[1].repeatability.quantiles[i]);
        TEST_ASSERT_TRUE(all->repeatability.quantiles[i] <= all->repeatability.largest);
    }
    /* the tool is 1.2 times as far from the first joint in the second pose, and as far from the other one */
    TEST_ASSERT_TRUE(poses[1].repeatability.quantiles[0] > poses[0].repeatability.quantiles[0]);
    armtol_arrivals_destroy(arrivals);
}

static void test_draws_depend_on_the_seed_alone(void)
{
    take_noisy_elbow();
    armtol_arrivals *one = repeat(500, 10);
    draw.n_threads = 4;
    armtol_arrivals *same = repeat(500, 10);
    TEST_ASSERT_EQUAL_MEMORY(one->poses, same->poses, 2 * sizeof *one->poses);
    TEST_ASSERT_EQUAL_MEMORY(&one->all, &same->all, sizeof one->all);
    draw.seed++;
    armtol_arrivals *other = repeat(500, 10);
    TEST_ASSERT_TRUE(other->all.accuracy.quantiles[0] != one->all.accuracy.quantiles[0]);
    TEST_ASSERT_TRUE(other->all.repeatability.quantiles[0] != one->all.repeatability.quantiles[0]);
    armtol_arrivals_destroy(one);
    armtol_arrivals_destroy(same);
    armtol_arrivals_destroy(other);
}

static bool end_after_two_looks(void *context, uint64_t done, uint64_t total)
{
    int *looks = context;
    TEST_ASSERT_TRUE(done > 0 && done <= total);
    return ++*looks < 2;
}

/* What there is then is what so many arms give. */
static void test_an_early_end(void)
{
    int looks = 0;
    take_noisy_elbow();
    draw.progress = end_after_two_looks;
    draw.context = &looks;
    armtol_arrivals *ended = repeat(5000, 5);
    TEST_ASSERT_TRUE(ended->drawn > 0 && ended->drawn < 5000);
    draw.progress = NULL;
    armtol_arrivals *whole = repeat(ended->drawn, 5);
    TEST_ASSERT_EQUAL_UINT64(ended->drawn, whole->drawn);
    TEST_ASSERT_EQUAL_MEMORY(whole->poses, ended->poses, 2 * sizeof *whole->poses);
    armtol_arrivals_destroy(ended);
    armtol_arrivals_destroy(whole);
}

static void test_no_arms(void)
{
    take_noisy_elbow();
    armtol_arrivals *arrivals = repeat(0, 5);
    TEST_ASSERT_EQUAL_UINT64(0, arrivals->drawn);
    TEST_ASSERT_TRUE(isnan(arrivals->all.accuracy.largest) && isnan(arrivals->poses[1].repeatability.quantiles[3]));
    armtol_arrivals_destroy(arrivals);
}

/* Of one whose length nothing bounds nothing is said of where it is; that it comes back is sure all the same. */
static void test_a_tolerance_without_a_bound(void)
{
    take_noisy_elbow();
    tolerances[0] = tolerances[1] = (double)INFINITY;
    armtol_arrivals *arrivals = repeat(100, 5);
    TEST_ASSERT_TRUE(isnan(arrivals->poses[0].accuracy.quantiles[0]) && isnan(arrivals->all.accuracy.largest));
    TEST_ASSERT_TRUE(arrivals->poses[0].repeatability.quantiles[0] > 0);
    armtol_arrivals_destroy(arrivals);
}

static void test_drives_that_are_apart_do_nothing(void)
{
    take_noisy_elbow();
    question.drives_apart = true;
    armtol_arrivals *arrivals = repeat(100, 5);
    check_all_zero(&arrivals->all.repeatability, "RP");
    armtol_arrivals_destroy(arrivals);
}

static void test_one_cycle_is_too_few(void)
{
    armtol_answer *answer;
    armtol_arrivals *arrivals;
    armtol_fault fault;
    take_noisy_elbow();
    draw.samples = 10;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&question, &answer, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_QUESTION, armtol_arrivals_create(answer, &draw, 1, &arrivals, &fault));
    TEST_ASSERT_TRUE(fault.status == ARMTOL_BAD_QUESTION && fault.about == ARMTOL_ABOUT_QUESTION);
    TEST_ASSERT_NULL(arrivals);
    draw.samples = UINT64_MAX; /* more than can be counted in bytes */
    TEST_ASSERT_EQUAL_INT(ARMTOL_NO_MEMORY, armtol_arrivals_create(answer, &draw, 2, &arrivals, NULL));
    TEST_ASSERT_NULL(arrivals);
    armtol_arrivals_destroy(NULL);
    armtol_answer_destroy(answer);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_isotropic_normal_arrivals);
    RUN_TEST(test_the_accuracy_of_normal_arrivals);
    RUN_TEST(test_arms_that_differ_in_making_come_back_exactly);
    RUN_TEST(test_the_arm_that_is_farthest_off);
    RUN_TEST(test_an_encoder_alone);
    RUN_TEST(test_a_play_that_nothing_holds);
    RUN_TEST(test_where_the_middle_of_a_play_is);
    RUN_TEST(test_a_load_is_no_matter_of_arrivals);
    RUN_TEST(test_a_moment_in_doubt_is_of_the_arm);
    RUN_TEST(test_an_elbow_by_hand);
    RUN_TEST(test_of_all_poses_the_largest);
    RUN_TEST(test_draws_depend_on_the_seed_alone);
    RUN_TEST(test_an_early_end);
    RUN_TEST(test_no_arms);
    RUN_TEST(test_a_tolerance_without_a_bound);
    RUN_TEST(test_drives_that_are_apart_do_nothing);
    RUN_TEST(test_one_cycle_is_too_few);
    return UNITY_END();
}
