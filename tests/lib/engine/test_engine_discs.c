/*
 * Questions of which alpha and beta of some links move in discs: against the exact error along the rim, arms drawn, and
 * the conditions of an optimum.
 */

#include "armtol/budget.h"
#include "armtol/map.h"
#include "armtol/region.h"
#include "armtol/sampler.h"
#include "armtol/tally.h"
#include "armtol/tool_error.h"
#include "armtol/verification.h"
#include "lib/engine/answers.h"

#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>
#include <string.h>

enum { LINKS = 3, COLUMNS = 13, ALPHA = 2, SLIDE_ALPHA = 11, ARMS = 20000 };

#define PI 3.14159265358979323846

/* theta a alpha beta; theta d a alpha; d theta a alpha beta: discs of the first and of the last. */
static const armtol_link links[LINKS] = {
    {.kind = ARMTOL_PPR, .joint = ARMTOL_REVOLUTE, .a = 300, .d = 50},
    {.kind = ARMTOL_NPR, .joint = ARMTOL_REVOLUTE, .a = 200, .d = 40, .alpha = 1.2},
    {.kind = ARMTOL_PPP, .joint = ARMTOL_PRISMATIC, .a = 30, .d = 100},
};

static armtol_drive drives[LINKS];
static armtol_arm arm;
static double q[2 * LINKS], tolerances[COLUMNS], least[COLUMNS], largest[COLUMNS], accuracy[6];
static bool discs[COLUMNS];
static armtol_question question;

void setUp(void)
{
    for (size_t i = 0; i < LINKS; i++) {
        drives[i] = armtol_drive_unknown;
    }
    arm = (armtol_arm){.name = "three", .title = "three links", .source = "the test", .links = links,
                       .drives = drives, .n_links = LINKS};
    const double pose[2 * LINKS] = {0.3, -0.8, 20, -1.1, 0.4, 60};
    memcpy(q, pose, sizeof q);
    for (size_t k = 0; k < COLUMNS; k++) {
        tolerances[k] = k == ALPHA || k == ALPHA + 1 ? 2e-4 : k > 9 ? 1e-4 : 0;
        least[k] = 0;
        largest[k] = (double)INFINITY;
        discs[k] = k == ALPHA || k == SLIDE_ALPHA;
    }
    for (int i = 0; i < 6; i++) {
        accuracy[i] = i < 3 ? 0.5 : 0.01;
    }
    question = (armtol_question){.arm = &arm, .q = q, .n_poses = 2, .tolerances = tolerances, .discs = discs,
                                 .tool = {.offset = {10, 20, 80}}, .sigma = 3};
    tolerances[10] = 0;
}

void tearDown(void)
{
}

/* ---- the worst case ---- */

/* The largest exact error of a component with both discs on their rims: they add up to first order. */
static double worst_on_rims(const armtol_answer *answer, size_t pose, size_t component)
{
    enum { STEPS = 720 };
    double worst = 0;
    for (size_t disc = ALPHA; disc < COLUMNS; disc += SLIDE_ALPHA - ALPHA) {
        double most = 0;
        for (int i = 0; i < STEPS; i++) {
            double errors[COLUMNS] = {0}, error[6];
            errors[disc] = tolerances[disc] * cos(2 * PI * i / STEPS);
            errors[disc + 1] = tolerances[disc] * sin(2 * PI * i / STEPS);
            TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tool_error(armtol_answer_links(answer, pose), LINKS, errors,
                                                               COLUMNS, &answer->tool, error));
            most = fmax(most, fabs(error[component]));
        }
        worst += most;
    }
    return worst;
}

static void test_the_worst_case_is_that_of_the_rims(void)
{
    armtol_answer *answer = answer_of(&question);
    for (size_t i = 0; i < 6; i++) {
        const double worst = fmax(worst_on_rims(answer, 0, i), worst_on_rims(answer, 1, i));
        check_within(1e-5 * worst + 2 * answer->components[i].remainder, worst, answer->components[i].worst, "row %zu",
                     i);
        TEST_ASSERT_TRUE(answer->components[i].remainder < 1e-3 * worst);
    }
    armtol_answer_destroy(answer);
}

/* A square about the disc allows more, and the disc more than the square within it. */
static void test_a_disc_is_between_two_squares(void)
{
    armtol_answer *disc = answer_of(&question);
    question.discs = NULL;
    armtol_answer *about = answer_of(&question);
    for (size_t i = 0; i < 6; i++) {
        TEST_ASSERT_TRUE(disc->components[i].worst <= about->components[i].worst);
        TEST_ASSERT_TRUE(disc->components[i].worst * (1 + 1e-12) >= about->components[i].worst / sqrt(2));
        check_within(1e-15, about->components[i].deviation * sqrt(3) / 2, disc->components[i].deviation,
                     "r^2 / 4 an axis");
        check_same(about->components[i].remainder, disc->components[i].remainder, "that of the square");
    }
    TEST_ASSERT_TRUE(disc->components[0].worst < about->components[0].worst * 0.99);
    armtol_answer_destroy(disc);
    armtol_answer_destroy(about);
}

/* ---- arms drawn ---- */

static void test_draws_are_even_in_the_disc(void)
{
    armtol_answer *answer = answer_of(&question);
    armtol_sampled_link prepared[LINKS];
    armtol_sampler sampler;
    const double radius = tolerances[ALPHA];
    size_t sectors[8] = {0}, rings[8] = {0};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sampler_start(&sampler, prepared, armtol_answer_links(answer, 0), LINKS,
                                                          tolerances, COLUMNS, &answer->tool, 11));
    armtol_sampler_discs(&sampler, prepared, discs);
    for (uint64_t arm_number = 0; arm_number < ARMS; arm_number++) {
        double errors[COLUMNS];
        armtol_sampler_parameters(&sampler, arm_number, errors);
        const double square = errors[ALPHA] * errors[ALPHA] + errors[ALPHA + 1] * errors[ALPHA + 1];
        TEST_ASSERT_TRUE(square <= radius * radius * (1 + 1e-15));
        rings[(size_t)fmin(7, 8 * square / (radius * radius))]++; /* rings of the same area */
        sectors[(size_t)fmin(7, (atan2(errors[ALPHA + 1], errors[ALPHA]) / PI + 1) * 4)]++;
        check_same(0, errors[0], "what is exact");
    }
    for (int i = 0; i < 8; i++) { /* five standard deviations of a count of 2500 */
        TEST_ASSERT_TRUE(fabs((double)rings[i] - ARMS / 8.0) < 5 * sqrt(ARMS * 7 / 64.0));
        TEST_ASSERT_TRUE(fabs((double)sectors[i] - ARMS / 8.0) < 5 * sqrt(ARMS * 7 / 64.0));
    }
    armtol_answer_destroy(answer);
}

/* The errors of the tool are those of the parameters that are told of the arm, also in blocks of any size. */
static void test_the_drawn_tool_is_that_of_the_drawn_parameters(void)
{
    enum { SOME = 37 };
    armtol_answer *answer = answer_of(&question);
    armtol_sampled_link prepared[LINKS];
    armtol_sampler sampler;
    double drawn[6 * SOME], alone[6];
    const armtol_link *placed = armtol_answer_links(answer, 1);
    armtol_sampler_start(&sampler, prepared, placed, LINKS, tolerances, COLUMNS, &answer->tool, 12);
    armtol_sampler_discs(&sampler, prepared, discs);
    armtol_sampler_draw(&sampler, 5, SOME, drawn);
    for (uint64_t j = 0; j < SOME; j++) {
        double errors[COLUMNS], error[6];
        armtol_sampler_parameters(&sampler, 5 + j, errors);
        armtol_sampler_draw(&sampler, 5 + j, 1, alone);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                              armtol_tool_error(placed, LINKS, errors, COLUMNS, &answer->tool, error));
        for (size_t i = 0; i < 6; i++) {
            check_within(1e-12, error[i], drawn[i * SOME + j], "component %zu", i);
            check_same(alone[i], drawn[i * SOME + j], "component %zu, alone", i);
        }
    }
    armtol_answer_destroy(answer);
}

static void test_verification(void)
{
    const armtol_draw one = {.samples = ARMS, .seed = 3, .n_threads = 1}, two = {ARMS, 3, 2, NULL, NULL};
    armtol_answer *answer = answer_of(&question);
    armtol_verification found, other;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_verify(answer, &one, &found, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_verify(answer, &two, &other, NULL));
    for (size_t i = 0; i < 6; i++) {
        const armtol_predicted *of = &answer->components[i];
        const armtol_verified *verified = &found.components[i];
        check_same(verified->worst_drawn, other.components[i].worst_drawn, "with two threads");
        TEST_ASSERT_TRUE(verified->worst_drawn <= of->worst + of->remainder);
        TEST_ASSERT_TRUE(verified->worst_drawn > 0.9 * of->worst);
        check_within(of->remainder, of->worst, verified->worst_corner, "the corner, component %zu", i);
    }
    armtol_answer_destroy(answer);
}

static void test_tallies_with_discs_are_of_another_question(void)
{
    armtol_answer *disc = answer_of(&question);
    question.discs = NULL;
    armtol_answer *square = answer_of(&question);
    TEST_ASSERT_TRUE(armtol_tally_fingerprint(disc, ARMTOL_TALLY_TOLERANCES) !=
                     armtol_tally_fingerprint(square, ARMTOL_TALLY_TOLERANCES));
    armtol_answer_destroy(disc);
    armtol_answer_destroy(square);
}

/* ---- the budget ---- */

static void check_budget(armtol_method method)
{
    armtol_budget *budget;
    question.method = method;
    tolerances[0] = 1e-4;
    tolerances[4] = 2e-4;
    armtol_answer *answer = answer_of(&question);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_budget_create(answer, &budget));
    for (size_t i = 0; i < 6; i++) {
        double sum = 0;
        for (size_t r = 0; r < budget->n_rows; r++) {
            sum += budget->rows[r].shares[i];
        }
        check_within(1e-12, 1, sum, "shares of component %zu", i);
    }
    armtol_budget_destroy(budget);
    armtol_answer_destroy(answer);
}

static void test_budgets_sum_up(void)
{
    check_budget(ARMTOL_METHOD_WORST);
    check_budget(ARMTOL_METHOD_RSS);
}

/* ---- what is left beside them ---- */

static const armtol_norm both[] = {{007, 0.4}, {070, 0.004}};

static void ask_for_the_rest(void)
{
    for (size_t k = 0; k < COLUMNS; k++) {
        if (discs[k]) {
            least[k] = largest[k] = least[k + 1] = largest[k + 1] = tolerances[k];
        }
    }
    question.tolerances = NULL;
    question.least = least;
    question.largest = largest;
    question.accuracy = accuracy;
}

/* Forward again, the rest given too: all is within the accuracy, and something is at it. */
static void check_rest(double allowed)
{
    double fullest = 0;
    armtol_answer *answer = answer_of(&question);
    const bool rss = question.method == ARMTOL_METHOD_RSS;
    armtol_question forward = question;
    forward.tolerances = answer->tolerances;
    forward.least = forward.largest = NULL;
    armtol_answer *again = answer_of(&forward);
    for (size_t i = 0; i < 6 + question.n_norms; i++) {
        const bool norm = i >= 6;
        const double limit = norm ? question.norms[i - 6].limit : accuracy[i];
        const double used = norm ? (rss ? again->norms[i - 6].spread : again->norms[i - 6].of.worst)
                                 : (rss ? 3 * again->components[i].deviation : again->components[i].worst);
        TEST_ASSERT_TRUE(used <= limit * (1 + 1e-12));
        fullest = fmax(fullest, used / limit);
    }
    check_within(allowed, 1, fullest, "nothing more is left");
    armtol_answer_destroy(again);
    armtol_answer_destroy(answer);
}

static void test_the_rest_keeps_to_the_accuracy(void)
{
    ask_for_the_rest();
    check_rest(1e-9);
    question.method = ARMTOL_METHOD_RSS;
    check_rest(1e-9);
    question.norms = both;
    question.n_norms = 2;
    check_rest(1e-9);
    question.method = ARMTOL_METHOD_WORST;
    check_rest(1e-9);
    question.n_norms = 0;
    question.method = ARMTOL_METHOD_SPHERE;
    armtol_answer *answer = answer_of(&question);
    for (size_t i = 0; i < 6; i++) {
        TEST_ASSERT_TRUE(answer->components[i].worst <= accuracy[i]);
    }
    armtol_answer_destroy(answer);
}

/* With a disc more is left than with the square about it. */
static void test_more_is_left_than_beside_a_square(void)
{
    ask_for_the_rest();
    armtol_answer *disc = answer_of(&question);
    question.discs = NULL;
    armtol_answer *square = answer_of(&question);
    double product = 1;
    for (size_t k = 0; k < COLUMNS; k++) {
        product *= disc->given[k] ? 1 : disc->tolerances[k] / square->tolerances[k];
    }
    TEST_ASSERT_TRUE(product > 1.01);
    armtol_answer_destroy(disc);
    armtol_answer_destroy(square);
}

/* ---- maps ---- */

static void test_a_map_has_the_worst_of_each_pose(void)
{
    const armtol_map map = {.value = ARMTOL_MAP_WORST, .component = 2}, droop = {.value = ARMTOL_MAP_DROOP};
    double values[2], none[2];
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_map_values(&question, &map, values, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_map_values(&question, &droop, none, NULL));
    armtol_answer *answer = answer_of(&question);
    check_same(answer->components[2].worst, fmax(values[0], values[1]), "of both poses");
    check_same(0, none[0], "no load");
    armtol_answer_destroy(answer);
}

/* ---- what is refused ---- */

static void test_what_is_no_disc(void)
{
    discs[0] = true; /* theta */
    check_refused(&question, ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_DISCS, 0);
    discs[0] = false;
    discs[7] = true; /* the alpha of a link without beta */
    check_refused(&question, ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_DISCS, 7);
    discs[7] = false;
    discs[COLUMNS - 1] = true; /* the last beta */
    check_refused(&question, ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_DISCS, COLUMNS - 1);
    discs[COLUMNS - 1] = false;
    tolerances[ALPHA] *= 2; /* an ellipse */
    check_refused(&question, ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_DISCS, ALPHA);
    tolerances[ALPHA] = tolerances[ALPHA + 1] = (double)INFINITY;
    check_refused(&question, ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_DISCS, ALPHA);
}

static void test_a_disc_is_given(void)
{
    ask_for_the_rest();
    largest[ALPHA + 1] *= 2;
    check_refused(&question, ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_DISCS, ALPHA);
    largest[ALPHA] *= 2;
    check_refused(&question, ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_DISCS, ALPHA);
    least[ALPHA] = largest[ALPHA];
    largest[ALPHA + 1] = least[ALPHA + 1];
    check_refused(&question, ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_DISCS, ALPHA);
}

static void test_a_region_has_no_discs(void)
{
    const double low[LINKS] = {0, 0, 0}, high[LINKS] = {0.1, 0.1, 1};
    const armtol_region region = {.low = low, .high = high};
    armtol_region_answer *answer;
    armtol_fault fault;
    armtol_region_fault why;
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_QUESTION,
                          armtol_region_answer_create(&question, &region, NULL, &answer, &fault, &why));
    TEST_ASSERT_EQUAL_INT(ARMTOL_REGION_DISCS, why);
    TEST_ASSERT_EQUAL_INT(ARMTOL_ABOUT_DISCS, fault.about);
    TEST_ASSERT_NULL(answer);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_worst_case_is_that_of_the_rims);
    RUN_TEST(test_a_disc_is_between_two_squares);
    RUN_TEST(test_draws_are_even_in_the_disc);
    RUN_TEST(test_the_drawn_tool_is_that_of_the_drawn_parameters);
    RUN_TEST(test_verification);
    RUN_TEST(test_tallies_with_discs_are_of_another_question);
    RUN_TEST(test_budgets_sum_up);
    RUN_TEST(test_the_rest_keeps_to_the_accuracy);
    RUN_TEST(test_more_is_left_than_beside_a_square);
    RUN_TEST(test_a_map_has_the_worst_of_each_pose);
    RUN_TEST(test_what_is_no_disc);
    RUN_TEST(test_a_disc_is_given);
    RUN_TEST(test_a_region_has_no_discs);
    return UNITY_END();
}
