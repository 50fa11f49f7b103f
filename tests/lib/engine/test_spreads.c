/*
 * Distributions, means and groups: what verification counts against closed forms (Irwin-Hall and others), predictions
 * against true variances, and what is refused. The arm is a chain of links whose axes are parallel: the rotation about
 * z is the sum of the errors of theta, exactly.
 */

#include "armtol/budget.h"
#include "armtol/map.h"
#include "armtol/region.h"
#include "armtol/tally.h"
#include "lib/engine/answers.h"
#include "support/check.h"

#include "unity.h"

#include <math.h>
#include <string.h>

enum { MOST_LINKS = 6, COLUMNS = 4 * MOST_LINKS, DRAWS = 100000, WZ = 5 };

static const double t = 0.002;

typedef struct parallel {
    armtol_link links[MOST_LINKS];
    armtol_drive drives[MOST_LINKS];
    armtol_arm arm;
    double q[MOST_LINKS], tolerances[COLUMNS], accuracy[6];
    armtol_error_spread spreads[COLUMNS];
    armtol_question question;
} parallel;

static parallel chain;
static double least[COLUMNS], largest[COLUMNS]; /* of its tolerances, where they are asked for */

void tearDown(void)
{
}

/* So many links with the tolerance t of theta, spread as it is said. */
static void make(size_t n_links, armtol_error_spread spread)
{
    chain = (parallel){.arm = {.name = "chain", .title = "parallel axes", .source = "the test", .n_links = n_links}};
    for (size_t i = 0; i < n_links; i++) {
        chain.links[i] = (armtol_link){ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 1};
        chain.drives[i] = armtol_drive_unknown;
        chain.tolerances[4 * i] = t;
        chain.spreads[4 * i] = spread;
    }
    for (int i = 0; i < 6; i++) {
        chain.accuracy[i] = INFINITY;
    }
    memset(least, 0, sizeof least);
    memset(largest, 0, sizeof largest);
    chain.arm.links = chain.links;
    chain.arm.drives = chain.drives;
    chain.question = (armtol_question){.arm = &chain.arm, .q = chain.q, .n_poses = 1, .sigma = 3};
    chain.question.tolerances = chain.tolerances;
    chain.question.spreads = chain.spreads;
}

void setUp(void)
{
    make(1, (armtol_error_spread){ARMTOL_UNIFORM, 0, 0, 0});
}

/* ---- what is drawn ---- */

static armtol_verification verified(size_t n_threads)
{
    const armtol_draw draw = {.samples = DRAWS, .seed = 5, .n_threads = n_threads};
    armtol_verification found;
    chain.question.accuracy = chain.accuracy;
    armtol_answer *answer = answer_of(&chain.question);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_verify(answer, &draw, &found, NULL));
    armtol_answer_destroy(answer);
    return found;
}

static void check_share(double limit, double expected, const char *what)
{
    chain.accuracy[WZ] = limit;
    const armtol_verification found = verified(1);
    const double deviation = sqrt(expected * (1 - expected) / DRAWS);
    TEST_ASSERT_EQUAL_UINT64(DRAWS, found.drawn);
    check_within(5 * deviation, expected, (double)found.within / DRAWS, "%s within %g", what, limit);
}

/* Irwin and Hall: the share of sums of n draws of [0, 1] below x. */
static double irwin_hall(int n, double x)
{
    double sum = 0, choose = 1, factorial = 1;
    for (int k = 0; k <= n && k < x; k++) {
        sum += (k % 2 == 0 ? 1 : -1) * choose * pow(x - k, n);
        choose *= (double)(n - k) / (k + 1);
    }
    for (int k = 2; k <= n; k++) {
        factorial *= k;
    }
    return sum / factorial;
}

/* That of sums of n errors, even within 1, which are no further than x from 0. */
static double even_within(int n, double x)
{
    return 1 - 2 * irwin_hall(n, (n - x) / 2);
}

static void test_sums_of_even_errors(void)
{
    for (int n = 1; n <= MOST_LINKS; n++) {
        make((size_t)n, (armtol_error_spread){ARMTOL_UNIFORM, 0, 0, 0});
        check_share(0.3 * n * t, even_within(n, 0.3 * n), "even errors");
        check_share(0.8 * t, even_within(n, 0.8), "even errors");
    }
}

/* A triangular error is half the sum of two even ones. */
static void test_sums_of_triangular_errors(void)
{
    for (int n = 1; n <= MOST_LINKS; n++) {
        make((size_t)n, (armtol_error_spread){ARMTOL_TRIANGULAR, 0, 0, 0});
        check_share(0.3 * n * t, even_within(2 * n, 2 * 0.3 * n), "triangular errors");
        check_share(0.5 * t, even_within(2 * n, 2 * 0.5), "triangular errors");
    }
}

/* The binomial distribution: n = 5 has sums of 1, 3 and 5. */
static void test_sums_of_ends(void)
{
    make(5, (armtol_error_spread){ARMTOL_ENDS, 0, 0, 0});
    check_share(2 * t, 20.0 / 32, "ends");
    check_share(4 * t, 30.0 / 32, "ends");
}

static double cut_normal(double k, double x)
{
    return (1 + erf(k * fmax(-1, fmin(x, 1)) / sqrt(2)) / erf(k / sqrt(2))) / 2;
}

/* Of two, by the midpoint rule over the quantile of the one: its probability is even. */
static double two_cut_normal(double k, double x)
{
    enum { PARTS = 4000 };
    double sum = 0, mass = 0;
    for (int i = 0; i < PARTS; i++) {
        const double one = (2 * i + 1.0) / PARTS - 1, weight = exp(-k * k * one * one / 2);
        sum += weight * (cut_normal(k, x - one) - cut_normal(k, -x - one));
        mass += weight;
    }
    return sum / mass;
}

static void test_sums_of_cut_normal_errors(void)
{
    static const double sigmas[] = {0.5, 1, 2, 3, 6};
    for (size_t i = 0; i < sizeof sigmas / sizeof sigmas[0]; i++) {
        const double k = sigmas[i];
        make(1, (armtol_error_spread){ARMTOL_NORMAL, k, 0, 0});
        check_share(0.4 * t, 2 * cut_normal(k, 0.4) - 1, "one normal error");
        make(2, (armtol_error_spread){ARMTOL_NORMAL, k, 0, 0});
        check_share(0.5 * t, two_cut_normal(k, 0.5), "two normal errors");
    }
}

/* From s - t to s + t. */
static void test_a_mean_that_is_shifted(void)
{
    make(1, (armtol_error_spread){ARMTOL_UNIFORM, 0, 0.3 * t, 0});
    check_share(t, (1 + 0.7) / 2, "a shifted error");
    make(1, (armtol_error_spread){ARMTOL_NORMAL, 2, -0.5 * t, 0});
    check_share(0.5 * t, cut_normal(2, 1) - cut_normal(2, 0), "a shifted normal error");
    armtol_answer *answer = answer_of(&chain.question);
    check_within(1e-17, 1.5 * t, answer->components[WZ].worst, "worst case");
    check_within(1e-17, 0.5 * t, answer->components[WZ].shift, "shift");
    TEST_ASSERT_TRUE(answer->shifted && !answer->loaded);
    armtol_answer_destroy(answer);
}

/* A group of three is one draw, three times. */
static void test_a_group_is_one_draw(void)
{
    make(4, (armtol_error_spread){ARMTOL_UNIFORM, 0, 0, 0});
    chain.spreads[0].group = chain.spreads[8].group = chain.spreads[12].group = 4;
    chain.tolerances[4] = 0;
    check_share(1.2 * t, 1.2 / 3, "a group");
    chain.tolerances[4] = t; /* and one by itself: 3 u + v */
    check_share(t, 1.0 / 3, "a group and one more");
}

/* Two links that point in opposite directions, whose lengths are off alike: the tool stays where it is. */
static void test_a_group_whose_errors_undo_each_other(void)
{
    make(2, (armtol_error_spread){ARMTOL_UNIFORM, 0, 0, 0});
    chain.q[1] = 3.14159265358979323846;
    chain.tolerances[0] = chain.tolerances[4] = 0;
    chain.tolerances[1] = chain.tolerances[5] = t;
    chain.spreads[1] = chain.spreads[5] = (armtol_error_spread){ARMTOL_NORMAL, 2, 0, 9};
    const armtol_verification found = verified(1);
    check_within(1e-15, 0, found.components[0].worst_drawn, "dx");
    check_within(1e-9, 2 * t, found.components[0].worst_corner, "corners know nothing of groups");
    armtol_answer *answer = answer_of(&chain.question);
    check_within(1e-18, 0, answer->components[0].deviation, "standard deviation");
    check_within(1e-17, 2 * t, answer->components[0].worst, "worst case");
    armtol_answer_destroy(answer);
}

static void check_alike(const armtol_verification *one, const armtol_verification *other)
{
    TEST_ASSERT_EQUAL_UINT64(one->within, other->within);
    for (int i = 0; i < 6; i++) {
        TEST_ASSERT_EQUAL_MEMORY(&one->components[i], &other->components[i], sizeof one->components[i]);
    }
}

static void test_threads_do_not_matter(void)
{
    make(3, (armtol_error_spread){ARMTOL_NORMAL, 2, 1e-4, 0});
    chain.spreads[0].group = chain.spreads[4].group = 1;
    chain.spreads[8].distribution = ARMTOL_TRIANGULAR;
    chain.accuracy[WZ] = t;
    const armtol_verification one = verified(1), three = verified(3);
    check_alike(&one, &three);
}

/* ---- what is predicted ---- */

/* The variance for a tolerance of 1. */
static double variance_of(const armtol_error_spread *spread)
{
    const double k = spread->sigmas, pi = 3.14159265358979323846;
    switch (spread->distribution) {
    case ARMTOL_NORMAL:
        return (1 - 2 * k * exp(-k * k / 2) / sqrt(2 * pi) / erf(k / sqrt(2))) / (k * k);
    case ARMTOL_TRIANGULAR:
        return 1.0 / 6;
    case ARMTOL_ENDS:
        return 1;
    default:
        return 1.0 / 3;
    }
}

static const armtol_error_spread kinds[] = {
    {ARMTOL_UNIFORM, 0, 0, 0}, {ARMTOL_NORMAL, 3, 0, 0}, {ARMTOL_TRIANGULAR, 0, 0, 0}, {ARMTOL_ENDS, 0, 0, 0}};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

static void test_deviations_are_the_true_ones(void)
{
    make(KINDS, kinds[0]);
    double sum = 0;
    for (size_t i = 0; i < KINDS; i++) {
        chain.spreads[4 * i] = kinds[i];
        sum += variance_of(&kinds[i]);
    }
    armtol_answer *answer = answer_of(&chain.question);
    check_within(1e-17, t * sqrt(sum), answer->components[WZ].deviation, "standard deviation");
    check_within(1e-17, KINDS * t, answer->components[WZ].worst, "worst case");
    armtol_answer_destroy(answer);
}

/* Of one column there is one tolerance that K standard deviations and the shift allow. */
static void test_the_optimum_by_rss(void)
{
    const double shift = 3e-4;
    for (size_t i = 0; i < KINDS; i++) {
        make(1, kinds[i]);
        chain.spreads[0].shift = -shift;
        chain.accuracy[WZ] = t;
        chain.question.tolerances = NULL;
        chain.question.accuracy = chain.accuracy;
        chain.question.method = ARMTOL_METHOD_RSS;
        armtol_answer *answer = answer_of(&chain.question);
        check_within(1e-15, (t - shift) / 3 / sqrt(variance_of(&kinds[i])), answer->tolerances[0], "kind %zu", i);
        armtol_answer_destroy(answer);
        chain.question.method = ARMTOL_METHOD_WORST;
        answer = answer_of(&chain.question);
        check_within(1e-15, t - shift, answer->tolerances[0], "worst case, kind %zu", i);
        armtol_answer_destroy(answer);
    }
}

/* Two columns, A = (1, 1): the weights' halves of the variance, and beside one that is held at its least. */
static void test_the_optimum_by_rss_of_unlike_errors(void)
{
    make(2, kinds[1]);
    chain.spreads[4] = kinds[3];
    chain.accuracy[WZ] = t;
    chain.question.tolerances = NULL;
    chain.question.accuracy = chain.accuracy;
    chain.question.method = ARMTOL_METHOD_RSS;
    chain.question.least = least;
    chain.question.largest = largest;
    for (int k = 0; k < COLUMNS; k++) {
        largest[k] = k % 4 == 0 ? (double)INFINITY : 0;
    }
    armtol_answer *answer = answer_of(&chain.question);
    const double all = t / 3, half = all / sqrt(2), normal = sqrt(variance_of(&kinds[1]));
    check_within(1e-15, half / normal, answer->tolerances[0], "normal");
    check_within(1e-15, half, answer->tolerances[4], "ends");
    armtol_answer_destroy(answer);
    least[4] = 0.9 * all;
    answer = answer_of(&chain.question);
    check_within(1e-15, 0.9 * all, answer->tolerances[4], "at its least");
    check_within(1e-12, all * sqrt(1 - 0.81) / normal, answer->tolerances[0], "what that leaves");
    check_within(1e-9, 0.81 / 0.19 - 1, -answer->held[4], "what the least holds");
    armtol_answer_destroy(answer);
}

/* Lengths along x and along y: a group moves the tool along one line, without it each goes its way. */
static void test_norms_know_groups(void)
{
    const armtol_norm norm = {3, INFINITY};
    make(2, kinds[2]);
    chain.q[1] = 3.14159265358979323846 / 2;
    chain.tolerances[0] = chain.tolerances[4] = 0;
    chain.tolerances[1] = 3 * t;
    chain.tolerances[5] = 4 * t;
    chain.question.norms = &norm;
    chain.question.n_norms = 1;
    chain.spreads[1] = chain.spreads[5] = kinds[2];
    armtol_answer *answer = answer_of(&chain.question);
    check_within(1e-15, 4 * t / sqrt(6), answer->norms[0].of.deviation, "apart");
    check_within(1e-15, 3 * 4 * t / sqrt(6), answer->norms[0].spread, "3 sigma");
    armtol_answer_destroy(answer);
    chain.spreads[1].group = chain.spreads[5].group = 1;
    answer = answer_of(&chain.question);
    check_within(1e-15, 5 * t / sqrt(6), answer->norms[0].of.deviation, "together");
    check_within(1e-15, 0.6, answer->norms[0].spread_direction[0], "along x");
    armtol_answer_destroy(answer);
}

/* ---- budgets ---- */

static double row_of(const armtol_budget *budget, size_t link, armtol_role role)
{
    double share = 0;
    for (size_t r = 0; r < budget->n_rows; r++) {
        share += budget->rows[r].link == link && budget->rows[r].role == role ? budget->rows[r].shares[WZ] : 0;
    }
    return share;
}

static double sum_of(const armtol_budget *budget)
{
    double sum = 0;
    for (size_t r = 0; r < budget->n_rows; r++) {
        sum += budget->rows[r].shares[WZ];
    }
    return sum;
}

/* Shift and three standard deviations, those by their squares; of a group of two twice two of four parts. */
static void test_a_budget_by_rss(void)
{
    armtol_budget *budget;
    make(4, kinds[0]);
    chain.spreads[4].group = chain.spreads[8].group = 2;
    chain.spreads[12] = kinds[3];
    chain.spreads[12].shift = t;
    chain.question.method = ARMTOL_METHOD_RSS;
    armtol_answer *answer = answer_of(&chain.question);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_budget_create(answer, &budget));
    const double squares = 1.0 / 3 + 4.0 / 3 + 1, spread = 3 * sqrt(squares), part = spread / (1 + spread);
    check_within(1e-15, t * sqrt(squares), answer->components[WZ].deviation, "standard deviation");
    check_within(1e-14, 1.0 / 3 / squares * part, row_of(budget, 0, ARMTOL_MOTOR), "by itself");
    check_within(1e-14, 2.0 / 3 / squares * part, row_of(budget, 1, ARMTOL_MOTOR), "in a group");
    check_within(1e-14, 2.0 / 3 / squares * part, row_of(budget, 2, ARMTOL_MOTOR), "in the same");
    check_within(1e-14, 1 / squares * part, row_of(budget, 3, ARMTOL_MOTOR), "ends");
    check_within(1e-14, 1 / (1 + spread), row_of(budget, 3, ARMTOL_SHIFT), "its mean");
    check_within(1e-14, 1 / (1 + spread), budget->shifts[WZ], "all means");
    check_within(0, 0, budget->loads[WZ], "no load");
    check_within(1e-14, 1, sum_of(budget), "all");
    armtol_budget_destroy(budget);
    armtol_answer_destroy(answer);
}

/* ---- refused ---- */

static void test_what_is_refused(void)
{
    make(2, kinds[1]);
    chain.spreads[4].sigmas = 31;
    check_refused(&chain.question, ARMTOL_BAD_SPREAD, ARMTOL_ABOUT_SPREADS, 4);
    chain.spreads[4].sigmas = 2;
    chain.spreads[0].group = chain.spreads[4].group = 3; /* unlike ones in a group */
    check_refused(&chain.question, ARMTOL_BAD_SPREAD, ARMTOL_ABOUT_SPREADS, 4);
    chain.spreads[4].distribution = ARMTOL_ENDS;
    check_refused(&chain.question, ARMTOL_BAD_SPREAD, ARMTOL_ABOUT_SPREADS, 4);
}

/* A group's sum of signed errors is no sum of squares: by rss nothing is shared out among them. */
static void test_groups_by_rss(void)
{
    make(3, kinds[0]);
    chain.spreads[0].group = chain.spreads[4].group = 3;
    chain.accuracy[WZ] = t;
    chain.question.accuracy = chain.accuracy;
    chain.question.tolerances = NULL;
    armtol_answer *answer = answer_of(&chain.question);
    check_within(1e-15, t / 3, answer->tolerances[0], "worst case");
    armtol_answer_destroy(answer);
    chain.question.method = ARMTOL_METHOD_RSS;
    check_refused(&chain.question, ARMTOL_BAD_SPREAD, ARMTOL_ABOUT_SPREADS, 0);
    least[0] = least[4] = largest[0] = largest[4] = t / 10;
    largest[8] = INFINITY;
    chain.question.least = least;
    chain.question.largest = largest;
    answer = answer_of(&chain.question);
    check_within(1e-15, sqrt(t * t / 3 - 4 * t * t / 100), answer->tolerances[8], "beside a group that is given");
    armtol_answer_destroy(answer);
}

static void test_regions_and_maps_know_no_spreads(void)
{
    const double low[] = {-1}, high[] = {1};
    const armtol_region region = {.low = low, .high = high};
    const armtol_map map = {.value = ARMTOL_MAP_WORST};
    double values[1];
    armtol_region_answer *answer;
    armtol_fault fault;
    armtol_region_fault why;
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_SPREAD,
                          armtol_region_answer_create(&chain.question, &region, NULL, &answer, &fault, &why));
    TEST_ASSERT_EQUAL_INT(ARMTOL_ABOUT_SPREADS, fault.about);
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_SPREAD, armtol_map_values(&chain.question, &map, values, &fault));
    TEST_ASSERT_EQUAL_INT(ARMTOL_ABOUT_SPREADS, fault.about);
}

/* ---- tallies ---- */

static uint64_t fingerprint(armtol_tally_subject subject)
{
    armtol_answer *answer = answer_of(&chain.question);
    const uint64_t bits = armtol_tally_fingerprint(answer, subject);
    armtol_answer_destroy(answer);
    return bits;
}

static void test_tallies_of_other_distributions_differ(void)
{
    make(2, kinds[0]);
    const uint64_t even = fingerprint(ARMTOL_TALLY_SPREADS), loads = fingerprint(ARMTOL_TALLY_LOADS);
    chain.spreads[0] = kinds[1];
    const uint64_t normal = fingerprint(ARMTOL_TALLY_SPREADS);
    chain.spreads[0].sigmas = 2;
    const uint64_t wider = fingerprint(ARMTOL_TALLY_SPREADS);
    chain.spreads[0] = kinds[0];
    chain.spreads[0].group = chain.spreads[4].group = 8;
    const uint64_t grouped = fingerprint(ARMTOL_TALLY_SPREADS);
    TEST_ASSERT_TRUE(even != normal && normal != wider && even != grouped);
    chain.spreads[0].shift = t;
    TEST_ASSERT_TRUE(loads != fingerprint(ARMTOL_TALLY_LOADS));
    chain.question.spreads = NULL;
    TEST_ASSERT_TRUE(even == fingerprint(ARMTOL_TALLY_SPREADS));
    TEST_ASSERT_EQUAL_STRING("distributions", armtol_tally_subject_name(ARMTOL_TALLY_SPREADS));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_sums_of_even_errors);
    RUN_TEST(test_sums_of_triangular_errors);
    RUN_TEST(test_sums_of_ends);
    RUN_TEST(test_sums_of_cut_normal_errors);
    RUN_TEST(test_a_mean_that_is_shifted);
    RUN_TEST(test_a_group_is_one_draw);
    RUN_TEST(test_a_group_whose_errors_undo_each_other);
    RUN_TEST(test_threads_do_not_matter);
    RUN_TEST(test_deviations_are_the_true_ones);
    RUN_TEST(test_the_optimum_by_rss);
    RUN_TEST(test_the_optimum_by_rss_of_unlike_errors);
    RUN_TEST(test_norms_know_groups);
    RUN_TEST(test_a_budget_by_rss);
    RUN_TEST(test_what_is_refused);
    RUN_TEST(test_groups_by_rss);
    RUN_TEST(test_regions_and_maps_know_no_spreads);
    RUN_TEST(test_tallies_of_other_distributions_differ);
    return UNITY_END();
}
