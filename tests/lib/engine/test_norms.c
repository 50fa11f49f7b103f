/*
 * Norms in a question and its answer: a link of which everything is known in closed form; on random arms the conditions
 * of Karush, Kuhn and Tucker, which prove an optimum, and boxes within a ball and around it.
 */

#include "armtol/budget.h"
#include "armtol/sampler.h"
#include "armtol/tool_error.h"
#include "armtol/verification.h"
#include "lib/engine/answers.h"
#include "lib/engine/one_link.h"

#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>
#include <string.h>

enum { COLUMNS = 40, POSES = 3, ARMS = 48 };

#define NONE (double)INFINITY
static const double free_six[6] = {NONE, NONE, NONE, NONE, NONE, NONE};

static one_link one;

void setUp(void)
{
    one_link_make(&one, 20000);
}

void tearDown(void)
{
}

/* ---- one link: theta moves the tool by 400 along y, a along x, and nothing else moves it ---- */

static void ask_for_a_disc(armtol_norm *norm)
{
    *norm = (armtol_norm){003, 1};
    one.question.tolerances = NULL;
    one.question.norms = norm;
    one.question.n_norms = 1;
}

static void test_the_largest_rectangle_in_a_disc(void)
{
    armtol_norm norm;
    ask_for_a_disc(&norm);
    armtol_answer *answer = answer_of(&one.question);
    check_within(1e-9 / 400, sqrt(0.5) / 400, answer->tolerances[0], "theta");
    check_within(1e-9, sqrt(0.5), answer->tolerances[1], "a");
    TEST_ASSERT_TRUE(isinf(answer->tolerances[2]) && isinf(answer->tolerances[3]));
    const armtol_predicted_norm *disc = &answer->norms[0];
    TEST_ASSERT_TRUE(answer->n_norms == 1 && disc->components == 003 && disc->limit == 1);
    TEST_ASSERT_TRUE(disc->of.worst <= 1);
    check_within(1e-10, 1, disc->of.worst, "worst");
    check_within(1e-9, 1, disc->of.binds, "it holds all");
    check_within(1e-9, sqrt(1 / 6.0), disc->of.deviation, "of each direction");
    check_within(1e-9, sqrt(0.5), fabs(disc->worst_direction[0]), "along a diagonal");
    TEST_ASSERT_TRUE(answer->n_held >= 1 && answer->n_held <= 2); /* either diagonal serves */
    check_within(1e-5, sqrt(0.5), fabs(answer->held_directions[0].direction[1]), "along a diagonal");
    check_within(1e-9, answer->components[0].remainder * answer->components[0].remainder +
                           answer->components[1].remainder * answer->components[1].remainder,
                 disc->of.remainder * disc->of.remainder, "the remainder's length");
    TEST_ASSERT_TRUE(disc->of.rounding > answer->components[0].rounding && disc->of.rounding < 1e-9);
    armtol_answer_destroy(answer);
}

static void test_deviations_on_a_disc(void)
{
    armtol_norm norm;
    ask_for_a_disc(&norm);
    one.question.method = ARMTOL_METHOD_RSS;
    one.question.sigma = 2;
    armtol_answer *answer = answer_of(&one.question);
    check_within(1e-9 / 400, sqrt(3) / 2 / 400, answer->tolerances[0], "theta, as if it were alone");
    check_within(1e-9, sqrt(3) / 2, answer->tolerances[1], "a");
    TEST_ASSERT_TRUE(answer->norms[0].spread <= 1);
    check_within(1e-10, 1, answer->norms[0].spread, "2 sigma");
    check_within(1e-9, 0.5, answer->norms[0].of.deviation, "sigma");
    armtol_answer_destroy(answer);
}

static void test_what_is_given_takes_its_part_of_a_disc(void)
{
    armtol_norm norm;
    double least[4] = {0.002, 0, 0, 0}, largest[4] = {0.002, NONE, NONE, NONE};
    ask_for_a_disc(&norm);
    one.question.least = least;
    one.question.largest = largest;
    armtol_answer *answer = answer_of(&one.question);
    check_within(1e-9, 0.6, answer->tolerances[1], "a beside 0.8");
    armtol_answer_destroy(answer);
    largest[0] = 0.01; /* more than it takes: held by its least */
    answer = answer_of(&one.question);
    check_within(1e-9, 0.6, answer->tolerances[1], "a");
    check_same(0.002, answer->tolerances[0], "theta");
    TEST_ASSERT_TRUE(answer->held[0] < 0);
    armtol_answer_destroy(answer);
    least[0] = 0;
    largest[0] = 0.0015;
    answer = answer_of(&one.question);
    check_within(1e-9, 0.8, answer->tolerances[1], "a beside the largest");
    check_within(1e-9, 1, answer->held[0] + answer->norms[0].of.binds, "the range and the disc");
    armtol_answer_destroy(answer);
}

static void test_a_load_shifts_on_the_disc(void)
{
    static const armtol_loading down = {.gravity = {0, -9.80665, 0}};
    static const armtol_mass mass = {2, {-100, 0, 0}};
    armtol_norm norm;
    double least[4] = {0.001, 0, 0, 0}, largest[4] = {0.001, NONE, NONE, NONE};
    ask_for_a_disc(&norm);
    one.drive.compliance = 1e-4;
    one.arm.masses = &mass;
    one.question.loading = &down;
    one.question.least = least;
    one.question.largest = largest;
    armtol_answer *answer = answer_of(&one.question);
    const double across = 400 * (1e-4 * 2 * 9.80665 * 0.3) + 0.4; /* metres of the lever: 400 - 100 mm */
    check_within(1e-9, 400 * 1e-4 * 2 * 9.80665 * 0.3, answer->norms[0].of.shift, "the shift");
    check_within(1e-9, sqrt(1 - across * across), answer->tolerances[1], "a beside shift and motor");
    armtol_answer_destroy(answer);
}

static void test_nothing_is_left_of_a_disc(void)
{
    armtol_norm norms[2] = {{007, 10}, {003, 1}};
    double least[4] = {0.004, 0, 0, 0}, largest[4] = {0.004, NONE, NONE, NONE};
    const double q[3] = {0, 1, 2};
    one.question.tolerances = NULL;
    one.question.norms = norms;
    one.question.n_norms = 2;
    one.question.least = least;
    one.question.largest = largest;
    check_refused(&one.question, ARMTOL_NOTHING_LEFT, ARMTOL_ABOUT_NORM_PLACE, 1);
    one.question.method = ARMTOL_METHOD_RSS;
    one.question.sigma = 3;
    check_refused(&one.question, ARMTOL_NOTHING_LEFT, ARMTOL_ABOUT_NORM_PLACE, 1);
    one.question.method = ARMTOL_METHOD_WORST;
    one.question.q = q;
    one.question.n_poses = 3;
    norms[0] = (armtol_norm){006, 0.1}; /* y, z: least is left of it in the first pose, along x */
    check_refused(&one.question, ARMTOL_NOTHING_LEFT, ARMTOL_ABOUT_NORM_PLACE, 0);
    const double accuracy[6] = {NONE, 0.05, NONE, NONE, NONE, NONE};
    one.question.accuracy = accuracy; /* less is left of dy */
    check_refused(&one.question, ARMTOL_NOTHING_LEFT, ARMTOL_ABOUT_ROW, 1);
    norms[1].limit = 1.6;
    norms[0].limit = 2;
    one.question.accuracy = NULL; /* to the last digit, and a is asked for along another direction */
    check_refused(&one.question, ARMTOL_NOTHING_LEFT, ARMTOL_ABOUT_NORM_PLACE, 1);
    largest[1] = 0; /* now it is not */
    armtol_answer *answer = answer_of(&one.question);
    check_within(1e-12, 1.6, answer->norms[1].of.worst, "used up, and that is fine");
    armtol_answer_destroy(answer);
}

static void test_norms_that_are_none(void)
{
    static const double wrong[] = {0, -1, (double)NAN};
    armtol_norm norms[ARMTOL_MOST_NORMS + 1];
    for (int i = 0; i <= ARMTOL_MOST_NORMS; i++) {
        norms[i] = (armtol_norm){003, 1};
    }
    one.question.tolerances = NULL;
    one.question.norms = norms;
    one.question.n_norms = ARMTOL_MOST_NORMS + 1;
    check_refused(&one.question, ARMTOL_BAD_NORM, ARMTOL_ABOUT_NORM, ARMTOL_MOST_NORMS);
    one.question.n_norms = ARMTOL_MOST_NORMS;
    armtol_answer_destroy(answer_of(&one.question));
    norms[2].components = 011;
    check_refused(&one.question, ARMTOL_BAD_NORM, ARMTOL_ABOUT_NORM, 2);
    norms[2].components = 003;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        norms[1].limit = wrong[i];
        check_refused(&one.question, ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_NORM, 1);
    }
    norms[1].limit = 1;
    one.question.method = ARMTOL_METHOD_SPHERE;
    check_refused(&one.question, ARMTOL_BAD_NORM, ARMTOL_ABOUT_METHOD, 0);
    one.question.tolerances = one.tolerances; /* held against them by any method */
    armtol_answer *answer = answer_of(&one.question);
    check_within(1e-12, 1.6, answer->norms[0].of.worst, "0.004 rad at 400");
    armtol_answer_destroy(answer);
    one.question.n_norms = 0;
    one.question.tolerances = NULL;
    check_refused(&one.question, ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0);
}

/* ---- what is told of given tolerances ---- */

static void test_a_norm_that_depends_on_what_has_no_bound(void)
{
    const armtol_norm norms[2] = {{003, 1}, {070, 1}};
    armtol_verification found;
    armtol_fault fault;
    armtol_budget *budget;
    one.tolerances[3] = NONE;
    one.question.norms = norms;
    one.question.n_norms = 2;
    armtol_answer *answer = answer_of(&one.question);
    TEST_ASSERT_TRUE(isinf(answer->norms[1].of.worst) && isinf(answer->norms[1].of.remainder));
    TEST_ASSERT_TRUE(isinf(answer->norms[1].spread));
    TEST_ASSERT_TRUE(isfinite(answer->norms[0].of.worst) && isfinite(answer->norms[1].of.rounding));
    TEST_ASSERT_EQUAL_INT(ARMTOL_UNBOUNDED, armtol_verify(answer, &one.draw, &found, &fault));
    TEST_ASSERT_TRUE(fault.about == ARMTOL_ABOUT_NORM && fault.number == 1);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_budget_create(answer, &budget));
    TEST_ASSERT_TRUE(isnan(budget->norm_motors[1]) && budget->norm_motors[0] == 1);
    armtol_budget_destroy(budget);
    armtol_answer_destroy(answer);
    const armtol_norm told[2] = {{003, 1}, {070, NONE}}; /* it asks for nothing, and is told of */
    one.question.norms = told;
    answer = answer_of(&one.question);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_verify(answer, &one.draw, &found, &fault));
    TEST_ASSERT_TRUE(isnan(found.norms[1].worst_drawn) && isnan(found.norms[1].worst_corner));
    TEST_ASSERT_TRUE(found.norms[0].worst_drawn > 1.59);
    armtol_answer_destroy(answer);
}

/* An arm of six joints, all tolerances given, in two poses. */
typedef struct six {
    armtol_question question;
    double q[12], tolerances[COLUMNS];
    armtol_norm norms[3];
} six;

static void make_six(six *six)
{
    const armtol_arm *arm = armtol_arm_named("puma560");
    *six = (struct six){.q = {0.1, 0.7, -1.5, 0.2, 0.8, 0.3, -1, 0.2, 0.5, 0.9, -0.7, 0.1},
                        .norms = {{007, 0.25}, {070, 1e-3}, {005, NONE}}};
    for (size_t k = 0; k < COLUMNS; k++) {
        six->tolerances[k] = 2e-4 + 1e-5 * (double)k;
    }
    six->question = (armtol_question){.arm = arm, .q = six->q, .n_poses = 2, .tolerances = six->tolerances,
                                      .norms = six->norms, .n_norms = 3, .sigma = 3};
}

/* Drawn again one by one, by the public sampler; the tally knows only bins. */
static void test_arms_are_counted_by_norms(void)
{
    enum { DRAWN = 20000 };
    static double largest[3][DRAWN];
    const armtol_draw draw = {.samples = DRAWN, .seed = 5, .n_threads = 2};
    six six;
    armtol_verification found;
    uint64_t within = 0;
    make_six(&six);
    armtol_answer *answer = answer_of(&six.question);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_verify(answer, &draw, &found, NULL));
    for (size_t pose = 0; pose < 2; pose++) {
        armtol_sampler sampler;
        armtol_sampled_link links[16];
        const armtol_link *meant = armtol_answer_links(answer, pose);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sampler_start(&sampler, links, meant, answer->n_links, six.tolerances,
                                                              answer->n_columns, &answer->tool, 5));
        for (uint64_t arm = 0; arm < DRAWN; arm++) {
            double parameters[COLUMNS], error[6];
            armtol_sampler_parameters(&sampler, arm, parameters);
            armtol_tool_error(armtol_answer_links(answer, pose), answer->n_links, parameters, answer->n_columns,
                              &answer->tool, error);
            for (size_t i = 0; i < 3; i++) {
                const double norm = armtol_norm_of(error, six.norms[i].components);
                largest[i][arm] = pose == 0 ? norm : fmax(largest[i][arm], norm);
            }
        }
    }
    for (size_t arm = 0; arm < DRAWN; arm++) {
        within += largest[0][arm] <= 0.25 && largest[1][arm] <= 1e-3;
    }
    TEST_ASSERT_TRUE(within == found.within && within > DRAWN / 4 && within < DRAWN);
    for (size_t i = 0; i < 3; i++) {
        double worst = 0;
        size_t below = 0;
        for (size_t arm = 0; arm < DRAWN; arm++) {
            worst = fmax(worst, largest[i][arm]);
            below += largest[i][arm] <= found.norms[i].quantiles[1];
        }
        check_within(1e-9 * worst, worst, found.norms[i].worst_drawn, "worst of norm %zu", i);
        check_within(1e-9 * worst, worst, largest[i][found.norms[i].worst_arm], "its arm");
        TEST_ASSERT_TRUE(below >= DRAWN * 9 / 10 && below < DRAWN * 91 / 100);
        const armtol_predicted *of = &answer->norms[i].of;
        TEST_ASSERT_TRUE(worst < of->worst && found.norms[i].worst_corner <= of->worst + of->remainder);
        TEST_ASSERT_TRUE(found.norms[i].worst_corner >= of->worst - of->remainder);
    }
    armtol_answer_destroy(answer);
}

static bool end_at_once(void *context, uint64_t done, uint64_t total)
{
    (void)done;
    (void)total;
    return --*(int *)context > 0;
}

static void test_a_search_for_corners_can_be_ended(void)
{
    six six;
    armtol_verification found;
    make_six(&six);
    armtol_answer *answer = answer_of(&six.question);
    int calls = 13; /* six components in two poses are searched, and of the norms none */
    const armtol_draw draw = {.samples = 1000, .n_threads = 1, .progress = end_at_once, .context = &calls};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_verify(answer, &draw, &found, NULL));
    TEST_ASSERT_TRUE(found.drawn == 0 && found.norms[2].worst_corner == 0 && found.components[5].worst_corner > 0);
    armtol_answer_destroy(answer);
}

/* The shares of a norm are those of a component along its direction. */
static void test_the_budget_of_a_norm(void)
{
    six six;
    armtol_budget *budget;
    make_six(&six);
    for (int rss = 0; rss < 2; rss++) {
        six.question.method = rss ? ARMTOL_METHOD_RSS : ARMTOL_METHOD_WORST;
        armtol_answer *answer = answer_of(&six.question);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_budget_create(answer, &budget));
        for (size_t i = 0; i < 3; i++) {
            const armtol_predicted_norm *norm = &answer->norms[i];
            const double *direction = rss ? norm->spread_direction : norm->worst_direction;
            const double *matrix = armtol_answer_matrix(answer, rss ? norm->of.deviation_pose : norm->of.worst_pose);
            double whole = 0, of_link_2 = 0, sum = 0, told = 0;
            for (size_t k = 0; k < answer->n_columns; k++) {
                double element = 0;
                for (size_t c = 0; c < 6; c++) {
                    element += direction[c] * matrix[c * answer->n_columns + k];
                }
                const double part = pow(fabs(element) * six.tolerances[k], rss ? 2 : 1);
                whole += part;
                of_link_2 += answer->columns[k].link == 2 ? part : 0;
            }
            for (size_t r = 0; r < budget->n_rows; r++) {
                sum += budget->rows[r].norm_shares[i];
                told += budget->rows[r].link == 2 ? budget->rows[r].norm_shares[i] : 0;
            }
            check_within(1e-12, 1, sum, "all shares of norm %zu", i);
            check_within(1e-12, of_link_2 / whole, told, "link 2's of norm %zu", i);
            const double expected = rss ? pow(norm->spread / 3, 2) * 3 : norm->of.worst;
            check_within(1e-9 * whole, expected, whole, "the whole of norm %zu", i);
        }
        armtol_budget_destroy(budget);
        armtol_answer_destroy(answer);
    }
}

/* ---- random arms ---- */

typedef struct wish {
    armtol_question question;
    double q[POSES * 8], weights[COLUMNS], least[COLUMNS], largest[COLUMNS];
    armtol_norm norms[3];
} wish;

static void draw_wish(random_source *source, int i, wish *wish)
{
    const armtol_arm *arm = armtol_arm_at((size_t)i % armtol_arm_count());
    *wish = (struct wish){.norms = {{007, 1}, {070, 3e-3}, {003, 0.8}}};
    wish->question = (armtol_question){.arm = arm, .q = wish->q, .n_poses = 1 + (size_t)i % POSES, .norms = wish->norms,
                                       .n_norms = 1 + random_bits(source) % 3, .sigma = 3, .weights = wish->weights};
    wish->question.method = i % 2 ? ARMTOL_METHOD_RSS : ARMTOL_METHOD_WORST;
    for (int j = 0; j < POSES * 8; j++) {
        wish->q[j] = random_between(source, -1.5, 1.5);
    }
    for (int n = 0; n < 3; n++) {
        wish->norms[n].limit *= random_between(source, 0.5, 2);
    }
    for (int k = 0; k < COLUMNS; k++) {
        wish->weights[k] = random_between(source, 0.2, 3);
        wish->least[k] = 0;
        wish->largest[k] = NONE;
    }
}

/* Some are given, some in a range about the optimum without. */
static void draw_ranges(random_source *source, wish *wish)
{
    armtol_answer *answer = answer_of(&wish->question);
    for (size_t k = 0; k < answer->n_columns; k++) {
        const double without = answer->tolerances[k], choice = random_between(source, 0, 1);
        if (choice < 0.2 && isfinite(without)) {
            wish->least[k] = wish->largest[k] = without * random_between(source, 0, 0.8);
        } else if (choice < 0.4) {
            wish->largest[k] = without * random_between(source, 0.5, 1.5);
        } else if (choice < 0.6 && isfinite(without)) {
            wish->least[k] = without * random_between(source, 0.5, 1.2);
        }
    }
    armtol_answer_destroy(answer);
    wish->question.least = wish->least;
    wish->question.largest = wish->largest;
}

static bool is_fixed(const armtol_answer *answer, size_t k)
{
    return answer->given[k] || answer->held[k] < 0;
}

/* What a column's tolerance uses along a direction: of the limit, or of its square. */
static double use_along(const armtol_answer *answer, const armtol_held_direction *held, size_t k)
{
    const double *matrix = armtol_answer_matrix(answer, held->pose);
    double element = 0;
    for (size_t i = 0; i < 6; i++) {
        element += held->direction[i] * matrix[i * answer->n_columns + k];
    }
    const double part = fabs(element) * armtol_answer_bounded(answer, held->pose)[k];
    return answer->method == ARMTOL_METHOD_RSS ? part * part : part;
}

/* weights[k] / W = held[k] + sum over directions of their share times f(k), a part of what is left of the limit. */
static void check_conditions(const wish *wish, const armtol_answer *answer)
{
    double sums[COLUMNS] = {0}, whole = 0, shares = 0;
    for (size_t k = 0; k < answer->n_columns; k++) {
        whole += is_fixed(answer, k) || isinf(answer->tolerances[k]) ? 0 : wish->weights[k];
    }
    for (size_t h = 0; h < answer->n_held; h++) {
        const armtol_held_direction *held = &answer->held_directions[h];
        const double limit = answer->norms[held->norm].limit;
        double left = answer->method == ARMTOL_METHOD_RSS ? 3 * pow(limit / answer->sigma, 2) : limit, used = 0;
        for (size_t k = 0; k < answer->n_columns; k++) {
            left -= is_fixed(answer, k) ? use_along(answer, held, k) : 0;
            used += is_fixed(answer, k) ? 0 : use_along(answer, held, k);
        }
        check_within(1e-7 * left, left, used, "a direction that holds is used up");
        for (size_t k = 0; k < answer->n_columns; k++) {
            sums[k] += held->share * use_along(answer, held, k) / left;
        }
        shares += held->share;
    }
    for (size_t k = 0; k < answer->n_columns; k++) {
        if (!answer->given[k] && isfinite(answer->tolerances[k])) {
            check_within(1e-8, wish->weights[k] / whole, sums[k] + answer->held[k], "%s, column %zu",
                         wish->question.arm->name, k);
        }
        shares += answer->held[k] > 0 ? answer->held[k] : 0;
    }
    check_within(1e-9, 1, shares, "all that holds");
}

/* No norm is beyond its limit in any pose, and what it comes to is told. */
static void check_norms(const wish *wish, const armtol_answer *answer)
{
    double workspace[6 * (COLUMNS + 1)], direction[6];
    for (size_t i = 0; i < answer->n_norms; i++) {
        const armtol_predicted_norm *norm = &answer->norms[i];
        double worst = 0, spread = 0;
        for (size_t pose = 0; pose < answer->n_poses; pose++) {
            const double *matrix = armtol_answer_matrix(answer, pose), *t = armtol_answer_bounded(answer, pose);
            const size_t n = answer->n_columns;
            worst = fmax(worst, armtol_worst_norm(matrix, n, norm->components, NULL, t, direction, workspace));
            spread = fmax(spread, armtol_rss_norm(matrix, n, norm->components, NULL, t, sqrt(3), direction));
        }
        check_same(worst, norm->of.worst, "worst of %s", armtol_norm_name(norm->components));
        check_within(1e-14 * spread, spread, norm->spread, "3 sigma of %s", armtol_norm_name(norm->components));
        TEST_ASSERT_TRUE((answer->method == ARMTOL_METHOD_RSS ? spread : worst) <= wish->norms[i].limit);
    }
}

static void test_an_optimum_with_norms_fulfils_the_conditions(void)
{
    random_source source = {8};
    int given = 0, low = 0, high = 0;
    for (int i = 0; i < 2 * ARMS; i++) {
        wish wish;
        draw_wish(&source, i, &wish);
        if (i >= ARMS) {
            draw_ranges(&source, &wish);
        }
        armtol_answer *answer;
        armtol_fault fault;
        const armtol_status status = armtol_answer_create(&wish.question, &answer, &fault);
        if (i >= ARMS && status == ARMTOL_NOTHING_LEFT) { /* the least ones alone are too much */
            continue;
        }
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, status);
        check_norms(&wish, answer);
        check_conditions(&wish, answer);
        for (size_t k = 0; k < answer->n_columns; k++) {
            given += answer->given[k];
            low += answer->held[k] < 0;
            high += answer->held[k] > 0;
        }
        armtol_answer_destroy(answer);
    }
    TEST_ASSERT_TRUE(given > ARMS && low > ARMS / 4 && high > ARMS);
}

/* The sum of weights[k] log t[k] over those that have a bound. */
static double log_product(const wish *wish, const double accuracy[6], size_t n_norms)
{
    armtol_question question = wish->question;
    double sum = 0;
    question.accuracy = accuracy;
    question.n_norms = n_norms;
    armtol_answer *answer = answer_of(&question);
    for (size_t k = 0; k < answer->n_columns; k++) {
        sum += isfinite(answer->tolerances[k]) ? wish->weights[k] * log(answer->tolerances[k]) : 0;
    }
    armtol_answer_destroy(answer);
    return sum;
}

/* The box within a ball asks for more than the ball, and the box around it for less: products of tolerances show it. */
static void test_a_ball_lies_between_two_boxes(void)
{
    random_source source = {9};
    for (int i = 0; i < ARMS; i++) {
        wish wish;
        double inner[6], outer[6];
        draw_wish(&source, i, &wish);
        const double r = wish.norms[0].limit, w = wish.norms[1].limit;
        for (int c = 0; c < 6; c++) {
            outer[c] = c < 3 ? r : w;
            inner[c] = outer[c] / sqrt(3);
        }
        const double within = log_product(&wish, inner, 0), ball = log_product(&wish, free_six, 2);
        const double around = log_product(&wish, outer, 0);
        TEST_ASSERT_TRUE(within < ball && ball < around + 1e-9);
    }
}

/* A component beside a norm: whichever is stricter holds. */
static void test_components_and_norms_hold_together(void)
{
    random_source source = {10};
    for (int i = 0; i < ARMS; i++) {
        wish wish;
        double accuracy[6];
        draw_wish(&source, i, &wish);
        memcpy(accuracy, free_six, sizeof accuracy);
        accuracy[2] = wish.norms[0].limit * (i % 3 == 0 ? 2 : 0.3);
        wish.question.accuracy = accuracy;
        armtol_answer *answer = answer_of(&wish.question);
        const armtol_predicted *dz = &answer->components[2];
        double shares = dz->binds;
        for (size_t n = 0; n < answer->n_norms; n++) {
            shares += answer->norms[n].of.binds;
        }
        check_within(1e-9, 1, shares, "what holds");
        const double most = answer->method == ARMTOL_METHOD_RSS ? 3 * dz->deviation : dz->worst;
        TEST_ASSERT_TRUE(most <= accuracy[2] * (1 + 1e-15));
        TEST_ASSERT_TRUE(i % 3 != 0 || dz->binds < 1e-9);
        check_norms(&wish, answer);
        armtol_answer_destroy(answer);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_largest_rectangle_in_a_disc);
    RUN_TEST(test_deviations_on_a_disc);
    RUN_TEST(test_what_is_given_takes_its_part_of_a_disc);
    RUN_TEST(test_a_load_shifts_on_the_disc);
    RUN_TEST(test_nothing_is_left_of_a_disc);
    RUN_TEST(test_norms_that_are_none);
    RUN_TEST(test_a_norm_that_depends_on_what_has_no_bound);
    RUN_TEST(test_arms_are_counted_by_norms);
    RUN_TEST(test_a_search_for_corners_can_be_ended);
    RUN_TEST(test_the_budget_of_a_norm);
    RUN_TEST(test_an_optimum_with_norms_fulfils_the_conditions);
    RUN_TEST(test_a_ball_lies_between_two_boxes);
    RUN_TEST(test_components_and_norms_hold_together);
    return UNITY_END();
}
