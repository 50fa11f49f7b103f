/* Arms drawn and corners searched: closed forms, poses, threads, those who look on. */

#include "armtol/verification.h"
#include "armtol/corners.h"
#include "armtol/robots.h"
#include "armtol/sampler.h"
#include "armtol/share_interval.h"
#include "armtol/tool_error.h"
#include "lib/engine/one_link.h"
#include "support/check.h"
#include "support/random.h"

#include "unity.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

void setUp(void)
{
}

void tearDown(void)
{
}

/* What A says, and what comes of the arms. */
typedef struct outcome {
    armtol_predicted predicted[6];
    armtol_verification found;
} outcome;

static outcome verify(const armtol_question *question, const armtol_draw *draw)
{
    outcome outcome;
    armtol_answer *answer;
    armtol_fault fault;
    memset(&outcome, 0, sizeof outcome);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(question, &answer, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_verify(answer, draw, &outcome.found, &fault));
    TEST_ASSERT_TRUE(fault.status == ARMTOL_OK && fault.about == ARMTOL_ABOUT_NOTHING && fault.number == 0);
    memcpy(outcome.predicted, answer->components, sizeof outcome.predicted);
    armtol_answer_destroy(answer);
    return outcome;
}

static outcome run(const one_link *one)
{
    return verify(&one->question, &one->draw);
}

/* ---- closed forms ---- */

enum { DRAWS = 200000 };

static void check_share(double expected, const armtol_verification *found, const char *what)
{
    const double deviation = sqrt(expected * (1 - expected) / (double)found->drawn);
    check_within(5 * deviation, expected, (double)found->within / (double)found->drawn, "%s", what);
    const double width = found->share_high - found->share_low;
    TEST_ASSERT_TRUE(found->share_low <= expected + 5 * deviation);
    TEST_ASSERT_TRUE(found->share_high >= expected - 5 * deviation);
    TEST_ASSERT_TRUE(width > 0 && width < 5 * deviation);
}

/* The rotation about z is the error of theta, uniform within 0.004. */
static void test_one_uniform_error(void)
{
    const double accuracy[6] = {INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, 0.001};
    one_link one;
    one_link_make(&one, DRAWS);
    one.question.accuracy = accuracy;
    const outcome outcome = run(&one);
    const armtol_verified *turn = &outcome.found.components[5];
    TEST_ASSERT_TRUE(outcome.found.drawn == DRAWS);
    check_share(0.25, &outcome.found, "a quarter of the tolerance");
    TEST_ASSERT_TRUE(outcome.found.beyond == DRAWS - outcome.found.within); /* a single turn has no remainder */
    check_same(0.004, outcome.predicted[5].worst, "prediction");
    check_within(1e-18, 0.004 / sqrt(3), outcome.predicted[5].deviation, "standard deviation");
    check_same(outcome.predicted[5].rounding, outcome.predicted[5].remainder, "remainder: nothing but rounding");
    TEST_ASSERT_TRUE(outcome.predicted[5].rounding > 0 && outcome.predicted[5].rounding < 1e-12);
    check_within(1e-16, 0.004, turn->worst_corner, "worst corner");
    TEST_ASSERT_TRUE(turn->worst_drawn < 0.004 && turn->worst_drawn > 0.004 * (1 - 20.0 / DRAWS));
    for (int i = 0; i < ARMTOL_QUANTILES; i++) {
        const double q = (const double[]){0.5, 0.9, 0.99, 0.999}[i];
        const double deviation = 0.004 * sqrt(q * (1 - q) / DRAWS);
        check_same(q, outcome.found.probabilities[i], "probability %d", i);
        check_within(5 * deviation + 0.004 / 4096, 0.004 * q, turn->quantiles[i], "quantile %d", i);
    }
}

static double turn_of_arm(const one_link *one, uint64_t arm)
{
    armtol_sampled_link prepared[1];
    armtol_sampler sampler;
    double errors[4];
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sampler_start(&sampler, prepared, &one->link, 1, one->tolerances, 4,
                                                          &armtol_tool_origin, one->draw.seed));
    armtol_sampler_parameters(&sampler, arm, errors);
    return errors[0];
}

static void test_the_worst_arm_can_be_had_again(void)
{
    one_link one;
    one_link_make(&one, 10000);
    const outcome outcome = run(&one);
    const armtol_verified *turn = &outcome.found.components[5];
    TEST_ASSERT_TRUE(turn->worst_arm < 10000);
    check_within(1e-15, turn->worst_drawn, fabs(turn_of_arm(&one, turn->worst_arm)), "worst arm");
    for (uint64_t arm = 0; arm < turn->worst_arm; arm++) {
        TEST_ASSERT_TRUE(fabs(turn_of_arm(&one, arm)) < turn->worst_drawn);
    }
}

/* The sum of two uniform errors is within x of their 2 t with 1 - (1 - x)^2. */
static void test_two_uniform_errors(void)
{
    const armtol_link links[2] = {{ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 300},
                                  {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 200}};
    const armtol_drive drives[2] = {armtol_drive_unknown, armtol_drive_unknown};
    const double tolerances[8] = {[0] = 0.002, [4] = 0.002};
    const double accuracy[6] = {INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, 0.001};
    one_link one;
    one_link_make(&one, DRAWS);
    one.arm.n_links = 2;
    one.arm.links = links;
    one.arm.drives = drives;
    one.question.tolerances = tolerances;
    one.question.accuracy = accuracy;
    const outcome outcome = run(&one);
    check_share(1 - 0.75 * 0.75, &outcome.found, "of a triangle");
    for (int i = 0; i < 2; i++) {
        const double q = outcome.found.probabilities[i], x = 1 - sqrt(1 - q), slope = 2 * (1 - x) / 0.004;
        const double deviation = sqrt(q * (1 - q) / DRAWS) / slope;
        const double tolerance = 5 * deviation + 0.004 / 4096;
        check_within(tolerance, 0.004 * x, outcome.found.components[5].quantiles[i], "quantile %d", i);
    }
}

/* Along the link the tool moves to first order not at all: that corner is climbed to. */
static void test_a_climb_leaves_the_first_order(void)
{
    one_link one;
    one_link_make(&one, 1);
    const outcome outcome = run(&one);
    check_same(0, outcome.predicted[0].worst, "prediction along the link");
    check_within(1e-13, 400 * (1 - cos(0.004)), outcome.found.components[0].worst_corner, "along the link");
    check_within(1e-12, 400 * sin(0.004), outcome.found.components[1].worst_corner, "across");
}

/* The tool is on the axis: only a tilt and a turn together bring it to the side. */
static void test_a_climb_takes_two_errors_at_once(void)
{
    const double tolerances[4] = {0.002, 0, 0, 0.003}; /* theta d a alpha */
    one_link one;
    one_link_make(&one, 1);
    one.link = (armtol_link){ARMTOL_NPR, ARMTOL_REVOLUTE};
    one.question.tolerances = tolerances;
    one.question.tool.offset[2] = 400;
    const outcome outcome = run(&one);
    check_within(1e-12, 400 * sin(0.002) * sin(0.003), outcome.found.components[0].worst_corner, "to the side");
}

/* What A leaves out may take an arm outside the accuracy, but not beyond the remainder. */
static void test_outside_is_not_yet_beyond(void)
{
    const double accuracy[6] = {0.001, 1.7, 1, 1, 1, 1};
    one_link one;
    one_link_make(&one, DRAWS);
    one.question.accuracy = accuracy;
    const outcome outcome = run(&one);
    check_share(acos(1 - 0.001 / 400) / 0.004, &outcome.found, "along the link");
    TEST_ASSERT_TRUE(outcome.found.beyond == 0);
}

/* ---- poses, and what is not asked ---- */

/* The link along x and along y: what is across in one pose is along in the other. */
static void test_an_arm_is_within_when_it_is_in_every_pose(void)
{
    const double accuracy[6] = {0.4, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY};
    one_link one;
    one_link_make(&one, DRAWS);
    one.q[1] = pi / 2;
    one.question.n_poses = 2;
    one.question.accuracy = accuracy;
    const outcome both = run(&one);
    check_share(asin(0.4 / 400) / 0.004, &both.found, "both poses");
    check_within(0.001, 400 * 0.004, both.found.components[0].worst_drawn, "x, the worse of the poses");
    check_within(0.001, 400 * 0.004, both.found.components[1].worst_drawn, "y, the worse of the poses");
    check_within(1e-12, 400 * 0.004, both.predicted[0].worst, "prediction");
    TEST_ASSERT_TRUE(both.predicted[0].worst_pose == 1 && both.predicted[1].worst_pose == 0);
    check_within(1e-12, 400 * sin(0.004), both.found.components[0].worst_corner, "worst corner");
    one.question.n_poses = 1;
    const outcome along = run(&one);
    TEST_ASSERT_TRUE(along.found.within == DRAWS && along.found.beyond == 0);
    check_within(1e-5, 400 * (1 - cos(0.004)), along.found.components[0].worst_drawn, "x in the first pose");
}

static void test_where_nothing_is_asked_all_are_within(void)
{
    one_link one;
    one_link_make(&one, 5000);
    const outcome outcome = run(&one);
    TEST_ASSERT_TRUE(outcome.found.within == 5000 && outcome.found.beyond == 0);
    check_same(1, outcome.found.share_high, "share");
}

static void check_unbounded(const outcome *outcome, size_t i)
{
    const armtol_verified *found = &outcome->found.components[i];
    check_same(INFINITY, outcome->predicted[i].worst, "prediction");
    check_same(INFINITY, outcome->predicted[i].deviation, "deviation");
    check_same(INFINITY, outcome->predicted[i].remainder, "remainder");
    for (int n = 0; n < ARMTOL_QUANTILES; n++) {
        TEST_ASSERT_TRUE(isnan(found->quantiles[n]));
    }
    TEST_ASSERT_TRUE(isnan(found->worst_drawn) && isnan(found->worst_corner));
}

/* A link along x: alpha turns the tool about x, beta about y, and neither moves the end of the link. */
static void test_infinite_tolerances_are_not_drawn(void)
{
    static const bool depends[6] = {[3] = true, [4] = true};
    one_link one, wide;
    one_link_make(&one, 5000);
    one_link_make(&wide, 5000);
    wide.tolerances[2] = wide.tolerances[3] = INFINITY;
    const outcome bounded = run(&one), without = run(&wide);
    TEST_ASSERT_TRUE(without.found.drawn == 5000 && without.found.within == 5000);
    for (size_t i = 0; i < 6; i++) {
        if (depends[i]) {
            check_unbounded(&without, i);
        } else {
            TEST_ASSERT_EQUAL_MEMORY(&bounded.found.components[i], &without.found.components[i],
                                     sizeof without.found.components[i]);
        }
    }
}

static void test_a_component_without_a_bound_has_no_accuracy_to_keep_to(void)
{
    const double accuracy[6] = {1, 1, 1, INFINITY, 0.01, 1}, without[6] = {1, 1, 1, INFINITY, INFINITY, 1};
    one_link one;
    armtol_answer *answer;
    armtol_verification found;
    armtol_fault fault;
    one_link_make(&one, 5000);
    one.tolerances[3] = INFINITY; /* beta turns the tool about y */
    one.question.accuracy = accuracy;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&one.question, &answer, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_UNBOUNDED, armtol_verify(answer, &one.draw, &found, &fault));
    TEST_ASSERT_TRUE(fault.status == ARMTOL_UNBOUNDED && fault.about == ARMTOL_ABOUT_ACCURACY && fault.number == 4);
    TEST_ASSERT_EQUAL_INT(ARMTOL_UNBOUNDED, armtol_verify(answer, &one.draw, &found, NULL));
    armtol_answer_destroy(answer);
    one.question.accuracy = without;
    const outcome free_row = run(&one);
    TEST_ASSERT_TRUE(free_row.found.drawn == 5000);
}

static void test_without_tolerances_nothing_moves(void)
{
    one_link one;
    one_link_make(&one, 5000);
    one.tolerances[0] = 0;
    const outcome outcome = run(&one);
    for (int i = 0; i < 6; i++) {
        const armtol_verified *component = &outcome.found.components[i];
        check_same(0, component->worst_drawn, "worst drawn %d", i);
        check_same(0, component->worst_corner, "worst corner %d", i);
        check_same(0, component->quantiles[3], "quantile %d", i);
        TEST_ASSERT_TRUE(component->worst_arm == 0);
    }
}

/* Turns of up to 4 about z: of the rest of a turn beyond pi the vector is the shorter way. */
static void test_where_the_remainder_is_not_bounded(void)
{
    one_link one;
    one_link_make(&one, DRAWS);
    one.tolerances[0] = 4;
    const outcome outcome = run(&one);
    const armtol_verified *turn = &outcome.found.components[5];
    check_same(INFINITY, outcome.predicted[5].remainder, "remainder");
    check_within(0.001, pi, turn->worst_drawn, "half a turn");
    /* of |e| the parts above pi come back: up to 2 pi - 4 a magnitude is as likely as its share of 4 */
    check_within(0.02, 2, turn->quantiles[0], "median");
}

static void test_no_samples(void)
{
    one_link one;
    one_link_make(&one, 0);
    const outcome outcome = run(&one);
    TEST_ASSERT_TRUE(outcome.found.drawn == 0 && outcome.found.within == 0);
    TEST_ASSERT_TRUE(outcome.found.share_low == 0 && outcome.found.share_high == 1);
    check_within(1e-12, 400 * sin(0.004), outcome.found.components[1].worst_corner, "worst corner");
}

/* ---- threads ---- */

enum { LINKS = 10, COLUMNS = 50 };

/* The Intelledex in two poses. */
typedef struct six_axes {
    armtol_link links[LINKS];
    armtol_drive drives[LINKS];
    armtol_arm arm;
    double tolerances[COLUMNS];
    armtol_question question;
} six_axes;

static void six_axes_make(six_axes *six)
{
    static const double q[2 * 6] = {0.3, -0.4, 1.1, 0.2, 0.7, -0.9, -1, 0.5, -0.6, 1.3, -0.2, 0.4};
    static const double accuracy[6] = {3, 3, 3, 0.01, 0.01, 0.01};
    const size_t n_links = armtol_intelledex_605t.n_links;
    TEST_ASSERT_TRUE(n_links <= LINKS);
    armtol_intelledex_605t.links(&armtol_errata_none, six->links);
    TEST_ASSERT_TRUE(armtol_column_count(six->links, n_links) <= COLUMNS);
    for (size_t k = 0; k < COLUMNS; k++) {
        six->tolerances[k] = 1e-3 * (double)(1 + k % 3);
    }
    for (size_t i = 0; i < LINKS; i++) {
        six->drives[i] = armtol_drive_unknown;
    }
    six->arm = (armtol_arm){.name = "six", .n_links = n_links, .links = six->links, .drives = six->drives};
    six->question = (armtol_question){.arm = &six->arm, .q = q, .n_poses = 2, .tool = {{10, 20, 30}, ARMTOL_BASE_FRAME},
                                      .accuracy = accuracy, .tolerances = six->tolerances};
}

static void test_the_number_of_threads_changes_nothing(void)
{
    static const uint64_t samples[] = {1, 255, 4096, 4097, 30011};
    static const size_t threads[] = {0, 2, 3, 7, 1000};
    six_axes six;
    six_axes_make(&six);
    for (size_t i = 0; i < sizeof samples / sizeof samples[0]; i++) {
        armtol_draw draw = {.samples = samples[i], .seed = 5, .n_threads = 1};
        const outcome alone = verify(&six.question, &draw);
        TEST_ASSERT_TRUE(alone.found.drawn == samples[i]);
        for (size_t j = 0; j < sizeof threads / sizeof threads[0]; j++) {
            draw.n_threads = threads[j];
            const outcome together = verify(&six.question, &draw);
            TEST_ASSERT_EQUAL_MEMORY(&alone.found, &together.found, sizeof alone.found);
        }
    }
}

/* ---- those who look on ---- */

typedef struct onlooker {
    uint64_t corners, blocks; /* calls before an arm was drawn, and after */
    uint64_t most, total;     /* arms done at the last of them, of so many */
    uint64_t patience;        /* calls of either kind after which it ends the work */
} onlooker;

static bool look_on(void *context, uint64_t done, uint64_t total)
{
    onlooker *onlooker = context;
    onlooker->corners += done == 0;
    onlooker->blocks += done > 0;
    TEST_ASSERT_TRUE(done > onlooker->most || done == 0);
    onlooker->most = done;
    onlooker->total = total;
    return onlooker->corners + onlooker->blocks <= onlooker->patience;
}

static void test_progress_is_told(void)
{
    static const size_t threads[] = {1, 2, 3};
    for (size_t j = 0; j < 3; j++) {
        six_axes six;
        six_axes_make(&six);
        onlooker onlooker = {.patience = UINT64_MAX};
        const armtol_draw quiet = {.samples = 100000, .seed = 5, .n_threads = threads[j]};
        armtol_draw draw = quiet;
        draw.progress = look_on;
        draw.context = &onlooker;
        const outcome unseen = verify(&six.question, &quiet), seen = verify(&six.question, &draw);
        TEST_ASSERT_EQUAL_MEMORY(&unseen, &seen, sizeof seen);
        TEST_ASSERT_TRUE(onlooker.corners >= 6 && onlooker.corners <= 12 && onlooker.total == 100000);
        TEST_ASSERT_TRUE(threads[j] > 1 || (onlooker.blocks > 10 && onlooker.most == 100000));
    }
}

/* After so many calls; the arms until then are the same arms. */
static outcome interrupted(uint64_t patience, size_t n_threads)
{
    six_axes six;
    six_axes_make(&six);
    onlooker onlooker = {.patience = patience};
    const armtol_draw draw = {.samples = UINT64_MAX, .seed = 5, .n_threads = n_threads, .progress = look_on,
                              .context = &onlooker};
    return verify(&six.question, &draw);
}

static void test_an_onlooker_ends_the_drawing(void)
{
    for (size_t n_threads = 1; n_threads <= 3; n_threads++) {
        six_axes six;
        six_axes_make(&six);
        const outcome cut = interrupted(15, n_threads);
        TEST_ASSERT_TRUE(cut.found.drawn > 0 && cut.found.drawn < 1000000);
        const armtol_draw same = {.samples = cut.found.drawn, .seed = 5, .n_threads = 1};
        const outcome whole = verify(&six.question, &same);
        TEST_ASSERT_EQUAL_MEMORY(&whole.found, &cut.found, sizeof cut.found);
    }
}

/* None is drawn then, and the corners searched so far are there. */
static void test_an_onlooker_ends_the_search_of_corners(void)
{
    const outcome none = interrupted(0, 2), two = interrupted(2, 2);
    TEST_ASSERT_TRUE(none.found.drawn == 0 && two.found.drawn == 0);
    for (int i = 0; i < 6; i++) {
        check_same(0, none.found.components[i].worst_corner, "component %d, no search", i);
        check_same(0, two.found.components[i].worst_drawn, "component %d, drawn", i);
        TEST_ASSERT_TRUE((two.found.components[i].worst_corner > 0) == (i < 2));
    }
}

/* ---- corners ---- */

/* The largest magnitudes where each error is all that it may be, either way, or nothing. */
static void largest_of_all(const armtol_link links[2], const double tolerances[8], double largest[6])
{
    const unsigned all = (unsigned)lround(pow(3, 8));
    for (unsigned i = 0; i < all; i++) {
        double errors[8], error[6];
        unsigned rest = i;
        for (size_t k = 0; k < 8; k++) {
            errors[k] = ((int)(rest % 3) - 1) * tolerances[k];
            rest /= 3;
        }
        armtol_tool_error(links, 2, errors, 8, &armtol_tool_origin, error);
        for (size_t component = 0; component < 6; component++) {
            largest[component] = fmax(largest[component], fabs(error[component]));
        }
    }
}

static void check_worst_corner(const armtol_link links[2], const double tolerances[8])
{
    double largest[6] = {0};
    one_link one;
    one_link_make(&one, 0);
    const armtol_drive drives[2] = {armtol_drive_unknown, armtol_drive_unknown};
    one.arm.n_links = 2;
    one.arm.links = links;
    one.arm.drives = drives;
    one.question.tolerances = tolerances;
    const outcome outcome = run(&one);
    largest_of_all(links, tolerances, largest);
    for (size_t i = 0; i < 6; i++) {
        check_within(1e-6 * largest[i], largest[i], outcome.found.components[i].worst_corner, "component %zu", i);
    }
}

static void test_the_worst_corner_is_the_worst_of_all(void)
{
    static const double tolerances[8] = {0.01, 1, 1, 0.01, 0.01, 1, 0.01, 0.01};
    random_source source = {9};
    for (int i = 0; i < 60; i++) {
        const armtol_link links[2] = {{ARMTOL_NPR, ARMTOL_REVOLUTE, .a = random_between(&source, 0, 300),
                                       .alpha = random_between(&source, -2, 2),
                                       .theta = random_between(&source, -3, 3)},
                                      {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 200,
                                       .theta = random_between(&source, -3, 3)}};
        check_worst_corner(links, tolerances);
    }
}

static double first_component(const double error[6], const void *context)
{
    (void)context;
    return fabs(error[0]);
}

static void test_a_climb_of_a_chain_that_is_none(void)
{
    one_link one;
    double errors[4] = {0.004, 0, 0, 0};
    one_link_make(&one, 0);
    TEST_ASSERT_TRUE(
        isnan(armtol_climb(&one.link, 1, &armtol_tool_origin, NULL, one.tolerances, 3, first_component, NULL, errors)));
    one.link.kind = ARMTOL_KIND_COUNT;
    TEST_ASSERT_TRUE(
        isnan(armtol_climb(&one.link, 1, &armtol_tool_origin, NULL, one.tolerances, 4, first_component, NULL, errors)));
    check_same(0.004, errors[0], "as it was");
    check_same(0, errors[1], "as it was");
}

/* ---- the interval of a share ---- */

static void test_the_interval_of_a_share(void)
{
    const armtol_share_interval half = armtol_share_interval_95(50, 100), none = armtol_share_interval_95(0, 100),
                                all = armtol_share_interval_95(100, 100), nothing = armtol_share_interval_95(0, 0);
    check_within(5e-5, 0.4038, half.low, "50 of 100, low");
    check_within(5e-5, 0.5962, half.high, "50 of 100, high");
    check_same(0, none.low, "0 of 100, low");
    check_within(5e-5, 0.0370, none.high, "0 of 100, high");
    check_within(1e-15, 1 - none.high, all.low, "100 of 100, low");
    check_same(1, all.high, "100 of 100, high");
    check_same(0, nothing.low, "of none, low");
    check_same(1, nothing.high, "of none, high");
}

/* Less than rounding leaves of an error: no arm may count as outside by more than the remainder for that. */
static void test_at_the_finest_accuracies_rounding_is_in_the_remainder(void)
{
    static const double q[12] = {0.1, -0.7, 0.5, 1.2, -0.9, 0.8, 0.3, 0.9, -1.1, 0.2, 0.4, -2};
    uint64_t outside = 0;
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        const armtol_arm *arm = armtol_arm_at(i);
        static const double accuracy[6] = {1e-15, 1e-15, 1e-15, 1e-18, 1e-18, 1e-18};
        const armtol_question fine = {.arm = arm, .q = q, .n_poses = 1, .accuracy = accuracy};
        const armtol_draw draw = {.samples = 5000, .seed = 3};
        const outcome outcome = verify(&fine, &draw);
        outside += outcome.found.drawn - outcome.found.within;
        TEST_ASSERT_TRUE_MESSAGE(outcome.found.beyond == 0, arm->name);
        TEST_ASSERT_TRUE(outcome.predicted[0].rounding > accuracy[0] && outcome.predicted[3].rounding > accuracy[3]);
    }
    TEST_ASSERT_TRUE(outside > 1000); /* by rounding, which is what the test is about */
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_one_uniform_error);
    RUN_TEST(test_the_worst_arm_can_be_had_again);
    RUN_TEST(test_two_uniform_errors);
    RUN_TEST(test_a_climb_leaves_the_first_order);
    RUN_TEST(test_a_climb_takes_two_errors_at_once);
    RUN_TEST(test_outside_is_not_yet_beyond);
    RUN_TEST(test_an_arm_is_within_when_it_is_in_every_pose);
    RUN_TEST(test_where_nothing_is_asked_all_are_within);
    RUN_TEST(test_infinite_tolerances_are_not_drawn);
    RUN_TEST(test_a_component_without_a_bound_has_no_accuracy_to_keep_to);
    RUN_TEST(test_without_tolerances_nothing_moves);
    RUN_TEST(test_at_the_finest_accuracies_rounding_is_in_the_remainder);
    RUN_TEST(test_where_the_remainder_is_not_bounded);
    RUN_TEST(test_no_samples);
    RUN_TEST(test_the_number_of_threads_changes_nothing);
    RUN_TEST(test_progress_is_told);
    RUN_TEST(test_an_onlooker_ends_the_drawing);
    RUN_TEST(test_an_onlooker_ends_the_search_of_corners);
    RUN_TEST(test_the_worst_corner_is_the_worst_of_all);
    RUN_TEST(test_a_climb_of_a_chain_that_is_none);
    RUN_TEST(test_the_interval_of_a_share);
    return UNITY_END();
}
