/*
 * Drives, loads and given tolerances in an answer: an arm of one link, of which everything is known in closed form; and
 * the conditions of Karush, Kuhn and Tucker, which prove an optimum, on random arms.
 */

#include "armtol/budget.h"
#include "armtol/tool_error.h"
#include "armtol/verification.h"
#include "lib/engine/answers.h"
#include "lib/engine/one_link.h"

#include "support/check.h"
#include "support/random.h"

#include "unity.h"

#include <math.h>

static one_link one;
static const double g = 9.80665;

void setUp(void)
{
    one_link_make(&one, 20000);
}

void tearDown(void)
{
}

/* Gravity to -y turns the link, which lies along x, to -y. */
static const armtol_loading down = {.gravity = {0, -9.80665, 0}};
static const armtol_mass mass = {2, {-100, 0, 0}};

static void load(void)
{
    one.drive.backlash = 0.001;
    one.drive.compliance = 1e-4;
    one.drive.resolution = 2e-4;
    one.arm.masses = &mass;
    one.question.loading = &down;
    one.tolerances[0] = 0;
}

/* m g l: 2 kg at 0.3 m. */
#define SHIFT (-(0.001 + 1e-4 * 2 * g * 0.3))

static void test_a_loaded_link(void)
{
    load();
    armtol_answer *answer = answer_of(&one.question);
    check_within(1e-13, -2 * g * 0.3, answer->moments[0], "moment");
    check_within(1e-15, SHIFT, answer->shifts[0], "shift");
    check_within(1e-15, 1e-4, answer->bounded[0], "half a step");
    TEST_ASSERT_TRUE(answer->given[0] && answer->loaded);
    check_within(1e-12, 400 * -SHIFT, answer->components[1].shift, "|A s|");
    check_within(1e-12, 400 * (1e-4 - SHIFT), answer->components[1].worst, "|A s| + |A| t");
    check_within(1e-12, 400 * 1e-4 / sqrt(3), answer->components[1].deviation, "deviation");
    check_within(1e-12, 400 * sin(SHIFT), answer->droops[1], "droop, dy");
    check_within(1e-12, 400 * (cos(SHIFT) - 1), answer->droops[0], "droop, dx");
    check_within(1e-15, SHIFT, answer->droops[5], "droop, wz");
    check_within(1e-15, 1e-4 - SHIFT, answer->parts[0].drive, "drive");
    armtol_answer_destroy(answer);
}

static void test_the_exact_error_is_within_prediction_and_remainder(void)
{
    load();
    const double accuracy[6] = {1, 400 * (1e-4 - SHIFT), 1, 1, 1, 1};
    one.question.accuracy = accuracy;
    one.draw.samples = 20000;
    armtol_answer *answer = answer_of(&one.question);
    armtol_verification found;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_verify(answer, &one.draw, &found, NULL));
    TEST_ASSERT_EQUAL_INT(0, found.beyond);
    check_within(1e-10, 400 * sin(1e-4 - SHIFT), found.components[1].worst_corner, "worst corner");
    check_within(400 * 1e-6, 400 * sin(1e-4 - SHIFT), found.components[1].worst_drawn, "worst drawn");
    check_within(400 * 2e-6, 400 * sin(-SHIFT), found.components[1].quantiles[0], "median");
    TEST_ASSERT_TRUE(found.components[1].worst_corner <= answer->components[1].worst + answer->components[1].remainder);
    TEST_ASSERT_TRUE(found.components[0].worst_corner <= answer->components[0].worst + answer->components[0].remainder);
    TEST_ASSERT_TRUE(found.components[0].worst_corner > 0.9 * 400 * (1 - cos(1e-4 - SHIFT)));
    armtol_answer_destroy(answer);
}

static void test_load_cases_stand_one_behind_the_other(void)
{
    const armtol_mass payloads[2] = {{0}, {5, {50, 0, 0}}};
    const armtol_loading loading = {.gravity = {0, -9.80665, 0}, .n_payloads = 2, .payloads = payloads};
    load();
    one.question.loading = &loading;
    one.question.n_poses = 2;
    one.q[1] = 1;
    armtol_answer *answer = answer_of(&one.question);
    TEST_ASSERT_EQUAL_INT(4, answer->n_poses);
    TEST_ASSERT_EQUAL_INT(2, answer->n_loads);
    for (size_t pose = 0; pose < 2; pose++) {
        check_within(1e-12, -2 * g * 0.3 * cos(one.q[pose]), answer->moments[2 * pose], "empty");
        check_within(1e-12, -(2 * 0.3 + 5 * 0.45) * g * cos(one.q[pose]), answer->moments[2 * pose + 1], "loaded");
    }
    armtol_answer_destroy(answer);
}

static void test_drives_that_are_apart_are_in_no_error(void)
{
    load();
    one.question.drives_apart = true;
    armtol_answer *answer = answer_of(&one.question);
    TEST_ASSERT_FALSE(answer->given[0] || answer->loaded);
    check_same(0, answer->components[1].worst, "worst");
    check_within(1e-15, 1e-4 - SHIFT, answer->parts[0].drive, "drive");
    armtol_answer_destroy(answer);
}

static void test_a_typed_moment_serves_where_masses_are_not_known(void)
{
    load();
    one.arm.masses = NULL;
    one.drive.moment = 12;
    armtol_answer *answer = answer_of(&one.question);
    check_same(0, answer->shifts[0], "shift");
    check_within(1e-15, 0.001 + 1e-4 * 12 + 1e-4, answer->bounded[0], "both sides");
    armtol_answer_destroy(answer);
    one.drive.moment = 0;
    check_refused(&one.question, ARMTOL_BAD_LOAD, ARMTOL_ABOUT_DRIVES, 0);
}

static void test_the_budget_tells_loads_apart(void)
{
    load();
    one.tolerances[1] = 0.01;
    armtol_answer *answer = answer_of(&one.question);
    armtol_budget *budget;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_budget_create(answer, &budget));
    TEST_ASSERT_EQUAL_INT(3, budget->n_rows);
    TEST_ASSERT_EQUAL_INT(ARMTOL_LOAD, budget->rows[2].role);
    TEST_ASSERT_EQUAL_STRING("load", armtol_role_name(ARMTOL_LOAD));
    check_within(1e-12, -SHIFT / (1e-4 - SHIFT), budget->rows[2].shares[1], "load in dy");
    check_within(1e-12, 1e-4 / (1e-4 - SHIFT), budget->rows[1].shares[1], "motor in dy");
    check_within(1e-12, 1, budget->rows[0].shares[0], "making in dx");
    check_within(1e-12, -SHIFT / (1e-4 - SHIFT), budget->loads[1], "all loads");
    armtol_budget_destroy(budget);
    one.question.method = ARMTOL_METHOD_RSS;
    one.question.sigma = 3;
    armtol_answer_destroy(answer);
    answer = answer_of(&one.question);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_budget_create(answer, &budget));
    check_within(1e-12, -SHIFT / (1e-4 * sqrt(3) - SHIFT), budget->rows[2].shares[1], "load in dy, rss");
    check_within(1e-12, 1, budget->loads[1] + budget->motors[1], "all of dy, rss");
    armtol_budget_destroy(budget);
    armtol_answer_destroy(answer);
}

/* ---- what is given ---- */

static const double tight[6] = {0.1, 0.5, 1, 1, 1, 1};

static void test_what_is_given_takes_its_part(void)
{
    double least[4] = {0.001, 0, 0, 0}, largest[4] = {0.001, INFINITY, 0, 0};
    one.question.accuracy = tight;
    one.question.tolerances = NULL;
    one.question.least = least;
    one.question.largest = largest;
    armtol_answer *answer = answer_of(&one.question);
    check_same(0.001, answer->tolerances[0], "given");
    check_within(1e-13, 0.1, answer->tolerances[1], "a");
    check_same(0, answer->tolerances[2], "exact");
    check_within(1e-12, 1, answer->components[0].binds, "dx binds");
    check_within(1e-12, 0.4, answer->components[1].worst, "dy");
    armtol_answer_destroy(answer);
    largest[1] = 0.07;
    answer = answer_of(&one.question);
    check_within(1e-14, 0.07, answer->tolerances[1], "its largest");
    check_within(1e-12, 1, answer->held[1], "held by it");
    armtol_answer_destroy(answer);
}

static void test_a_given_tolerance_larger_than_the_drive_counts(void)
{
    const double least[4] = {0.0012, 0, 0, 0}, largest[4] = {0.0012, INFINITY, INFINITY, INFINITY};
    one.drive.backlash = 0.001;
    one.question.accuracy = tight;
    one.question.tolerances = NULL;
    armtol_answer *answer = answer_of(&one.question);
    check_same(0.001, answer->bounded[0], "the drive");
    armtol_answer_destroy(answer);
    one.question.least = least;
    one.question.largest = largest;
    answer = answer_of(&one.question);
    check_same(0.0012, answer->bounded[0], "the larger");
    armtol_answer_destroy(answer);
    one.question.least = one.question.largest = NULL;
    one.question.tolerances = one.tolerances;
    one.tolerances[0] = 0.0005;
    answer = answer_of(&one.question);
    check_same(0.001, answer->bounded[0], "the drive again");
    armtol_answer_destroy(answer);
}

/* The play of 0.001 is held in the first pose and not in the second, where the link hangs. */
static void test_a_given_tolerance_counts_where_the_drive_has_less(void)
{
    load();
    one.drive.friction = 0.1;
    one.question.n_poses = 2;
    one.q[1] = -1.5707963267948966;
    one.tolerances[0] = 0.0008;
    armtol_answer *answer = answer_of(&one.question);
    check_same(0.0008, answer->bounded[0], "half a step is less");
    check_within(1e-15, 0.001 + 1e-4, answer->bounded[answer->n_columns], "play and half a step are more");
    check_within(1e-15, 0.001 + 1e-4, answer->tolerances[0], "the larger");
    armtol_answer_destroy(answer);
}

static void test_nothing_is_left(void)
{
    one.drive.backlash = 0.002;
    one.question.accuracy = tight;
    one.question.tolerances = NULL;
    one.question.n_poses = 2;
    one.q[1] = 0.0001;
    for (armtol_method method = 0; method < ARMTOL_METHOD_COUNT; method++) {
        one.question.method = method;
        one.question.sigma = 3;
        one.drive.backlash = 0.002;
        check_refused(&one.question, ARMTOL_NOTHING_LEFT, ARMTOL_ABOUT_ROW, 1);
        one.drive.backlash = 0.0005;
        armtol_answer_destroy(answer_of(&one.question));
    }
}

/* All is given, and uses the accuracy up: nothing is asked for that could not be had. */
static void test_all_is_given(void)
{
    const double given[4] = {0.5 / 400, 0.1, 0, 0};
    one.question.accuracy = tight;
    one.question.tolerances = NULL;
    one.question.least = one.question.largest = given;
    armtol_answer *answer = answer_of(&one.question);
    check_within(1e-15, 0.5, answer->components[1].worst, "dy");
    armtol_answer_destroy(answer);
}

static void test_ranges_and_loads_that_are_none(void)
{
    const double below[4] = {0, -1, 0, 0}, two[4] = {0, 2, 0, 0}, one_each[4] = {1, 1, 1, 1};
    const armtol_mass negative = {-1, {0}}, huge = {1e308, {0}};
    const armtol_loading too_much = {.compensated = 1.5}, below_zero = {.n_payloads = 1, .payloads = &negative},
                         too_heavy = {.n_payloads = 1, .payloads = &huge, .gravity = {0, -9.80665, 0}};
    one.question.least = below;
    check_refused(&one.question, ARMTOL_BAD_RANGE, ARMTOL_ABOUT_RANGES, 1);
    one.question.least = two;
    one.question.largest = one_each;
    check_refused(&one.question, ARMTOL_BAD_RANGE, ARMTOL_ABOUT_RANGES, 1);
    one.question.least = NULL;
    one.question.accuracy = tight;
    one.question.tolerances = NULL;
    one.question.method = ARMTOL_METHOD_SPHERE;
    check_refused(&one.question, ARMTOL_BAD_RANGE, ARMTOL_ABOUT_METHOD, 0);
    one.question.largest = NULL;
    one.question.loading = &too_much;
    check_refused(&one.question, ARMTOL_BAD_LOAD, ARMTOL_ABOUT_LOADING, 0);
    one.question.loading = &below_zero;
    check_refused(&one.question, ARMTOL_BAD_LOAD, ARMTOL_ABOUT_LOADING, 0);
    one.question.loading = &too_heavy;
    check_refused(&one.question, ARMTOL_NOT_FINITE, ARMTOL_ABOUT_LOADING, 0);
    one.question.loading = NULL;
    one.arm.masses = &negative;
    check_refused(&one.question, ARMTOL_BAD_LOAD, ARMTOL_ABOUT_ARM, 0);
    one.arm.masses = NULL;
    one.drive.backlash = -1;
    check_refused(&one.question, ARMTOL_BAD_LOAD, ARMTOL_ABOUT_DRIVES, 0);
    one.drive.backlash = 0;
    one.drive.noise = (double)INFINITY;
    check_refused(&one.question, ARMTOL_BAD_LOAD, ARMTOL_ABOUT_DRIVES, 0);
    one.drive.noise = 0;
    one.link.kind = ARMTOL_PPR;
    one.link.joint = ARMTOL_PRISMATIC;
    check_refused(&one.question, ARMTOL_BAD_LOAD, ARMTOL_ABOUT_DRIVES, 0);
}

/* ---- the optimum between bounds ---- */

enum { COLUMNS = 40, ARMS = 400 };

/*
 * A question to a built-in arm, one pose, all components bounded, some tolerances in ranges about the optimum without.
 */
typedef struct wish {
    armtol_question question;
    double q[8], accuracy[6], weights[COLUMNS], least[COLUMNS], largest[COLUMNS];
} wish;

static void draw_wish(random_source *source, int i, wish *wish)
{
    const armtol_arm *arm = armtol_arm_at((size_t)i % armtol_arm_count());
    *wish = (struct wish){.question = {.arm = arm, .q = wish->q, .n_poses = 1, .accuracy = wish->accuracy, .sigma = 3}};
    wish->question.method = i % 2 ? ARMTOL_METHOD_RSS : ARMTOL_METHOD_WORST;
    wish->question.weights = wish->weights;
    for (int j = 0; j < 8; j++) {
        wish->q[j] = random_between(source, -1.5, 1.5);
    }
    for (int c = 0; c < 6; c++) {
        wish->accuracy[c] = random_between(source, 0.5, 2) * (c < 3 ? 1 : 0.003);
    }
    for (int k = 0; k < COLUMNS; k++) {
        wish->weights[k] = random_between(source, 0.2, 3);
    }
}

static void draw_ranges(random_source *source, wish *wish, size_t n)
{
    armtol_answer *answer = answer_of(&wish->question);
    for (size_t k = 0; k < n; k++) {
        const double without = answer->tolerances[k], choice = random_between(source, 0, 1);
        wish->largest[k] = choice < 0.4 ? without * random_between(source, 0.7, 2) : (double)INFINITY;
        wish->least[k] =
            choice > 0.25 && choice < 0.7 && isfinite(without) ? without * random_between(source, 0.2, 1.3) : 0;
        wish->least[k] = fmin(wish->least[k], wish->largest[k]);
    }
    armtol_answer_destroy(answer);
    wish->question.least = wish->least;
    wish->question.largest = wish->largest;
}

/* Whether the column is held at its least: it takes its part of the limits as if it were given. */
static bool is_held_low(const armtol_answer *answer, size_t k)
{
    return answer->given[k] || answer->held[k] < 0;
}

/* What of row i a column's tolerance uses: of the limit, or of its square. */
static double use_of(const armtol_answer *answer, size_t i, size_t k)
{
    const double part = fabs(answer->matrices[i * answer->n_columns + k]) * answer->bounded[k];
    return answer->method == ARMTOL_METHOD_RSS ? part * part : part;
}

static double limit_of(const armtol_answer *answer, size_t i)
{
    const bool rss = answer->method == ARMTOL_METHOD_RSS;
    const double limit = rss ? answer->accuracy[i] * sqrt(3) / answer->sigma : answer->accuracy[i];
    return rss ? limit * limit : limit;
}

static void check_conditions(const wish *wish, const armtol_answer *answer)
{
    double left[6], whole = 0;
    for (size_t i = 0; i < 6; i++) {
        double used = 0;
        left[i] = limit_of(answer, i);
        for (size_t k = 0; k < answer->n_columns; k++) {
            used += use_of(answer, i, k);
            left[i] -= is_held_low(answer, k) ? use_of(answer, i, k) : 0;
        }
        TEST_ASSERT_TRUE(used <= limit_of(answer, i) * (1 + 1e-10));
        TEST_ASSERT_TRUE(answer->components[i].binds < 1e-9 || used >= limit_of(answer, i) * (1 - 1e-10));
    }
    for (size_t k = 0; k < answer->n_columns; k++) {
        whole += is_held_low(answer, k) || isinf(answer->tolerances[k]) ? 0 : wish->weights[k];
    }
    for (size_t k = 0; k < answer->n_columns; k++) {
        const double t = answer->tolerances[k];
        double sum = answer->held[k], doubt = 1e-10;
        TEST_ASSERT_TRUE(t >= wish->least[k] && t <= wish->largest[k] * (1 + 1e-10));
        for (size_t i = 0; i < 6; i++) {
            if (answer->components[i].binds > 0) { /* what is left is a difference, rounded as its terms are */
                const double part = answer->components[i].binds * use_of(answer, i, k) / left[i];
                sum += part;
                doubt += part * 1e-14 * limit_of(answer, i) / left[i];
            }
        }
        if (!answer->given[k] && isfinite(t)) {
            check_within(doubt, wish->weights[k] / whole, sum, "%s, column %zu", wish->question.arm->name, k);
        }
        if (answer->held[k] < 0) {
            check_same(wish->least[k], t, "held by its least");
        }
        if (answer->held[k] > 1e-9) {
            check_within(1e-10 * t, wish->largest[k], t, "held by its largest");
        }
    }
}

static void test_an_optimum_between_bounds_fulfils_the_conditions(void)
{
    random_source source = {3};
    int solved = 0, low = 0, high = 0;
    for (int i = 0; i < ARMS; i++) {
        wish wish;
        armtol_answer *answer;
        armtol_fault fault;
        draw_wish(&source, i, &wish);
        const size_t n = armtol_column_count(wish.question.arm->links, wish.question.arm->n_links);
        TEST_ASSERT_TRUE(n <= COLUMNS);
        draw_ranges(&source, &wish, n);
        const armtol_status status = armtol_answer_create(&wish.question, &answer, &fault);
        TEST_ASSERT_TRUE(status == ARMTOL_OK || status == ARMTOL_NOTHING_LEFT);
        if (status == ARMTOL_OK) {
            check_conditions(&wish, answer);
            for (size_t k = 0; k < n; k++) {
                low += answer->held[k] < 0;
                high += answer->held[k] > 0;
            }
            armtol_answer_destroy(answer);
            solved++;
        }
    }
    TEST_ASSERT_TRUE(solved > ARMS / 2 && low > ARMS && high > ARMS);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_loaded_link);
    RUN_TEST(test_the_exact_error_is_within_prediction_and_remainder);
    RUN_TEST(test_load_cases_stand_one_behind_the_other);
    RUN_TEST(test_drives_that_are_apart_are_in_no_error);
    RUN_TEST(test_a_typed_moment_serves_where_masses_are_not_known);
    RUN_TEST(test_the_budget_tells_loads_apart);
    RUN_TEST(test_what_is_given_takes_its_part);
    RUN_TEST(test_a_given_tolerance_larger_than_the_drive_counts);
    RUN_TEST(test_a_given_tolerance_counts_where_the_drive_has_less);
    RUN_TEST(test_nothing_is_left);
    RUN_TEST(test_all_is_given);
    RUN_TEST(test_ranges_and_loads_that_are_none);
    RUN_TEST(test_an_optimum_between_bounds_fulfils_the_conditions);
    return UNITY_END();
}
