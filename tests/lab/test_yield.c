/* Arms built to tolerances: closed forms, the bounds, the draws, and the program. */

#include "armtol/sampler.h"
#include "lab/published.h"
#include "lab/recompute.h"
#include "lab/yield/arm_draws.h"
#include "lab/yield/case.h"
#include "lab/yield/column_tolerances.h"
#include "lab/yield/drawn_arm.h"
#include "lab/yield/guarantee.h"
#include "support/check.h"
#include "support/process.h"
#include "support/random.h"

#include "unity.h"

#include <math.h>
#include <string.h>

enum { MOST = 40 }; /* columns */

static published_list published;

void setUp(void)
{
    TEST_ASSERT_TRUE(published_read(TEST_PUBLISHED, &published));
}

void tearDown(void)
{
    published_free(&published);
    process_clean_up();
}

/* ---- the paper's cases ---- */

/* A case of the paper: the arm as drawn, and what the columns may be off in each set. */
typedef struct sample {
    const char *program;
    int number;
    analysis drawn;
    drawn_arm arm;
    double tolerances[SET_COUNT][MOST];
} sample;

static void sample_start(sample *sample, size_t first, length_reading reading)
{
    analysis made;
    sample->program = published.numbers[first].program;
    sample->number = published.numbers[first].case_number;
    TEST_ASSERT_TRUE(recompute(&published, first, &armtol_errata_none, NULL, &sample->drawn));
    TEST_ASSERT_TRUE(sample->drawn.n_columns <= MOST);
    sample->arm = (drawn_arm){sample->drawn.links, sample->drawn.robot->n_links, sample->drawn.columns,
                              sample->drawn.n_columns};
    column_tolerances(&sample->drawn, reading, sample->tolerances[SET_CORRECTED]);
    TEST_ASSERT_TRUE(recompute(&published, first, &armtol_errata_1987, NULL, &made));
    column_tolerances(&made, reading, sample->tolerances[SET_PUBLISHED]);
    analysis_free(&made);
}

static void sample_free(sample *sample)
{
    analysis_free(&sample->drawn);
}

static void for_every_case(void (*test)(const sample *))
{
    size_t cases = 0;
    for (size_t i = 0; i < published.count; i++) {
        if (published_begins_case(&published, i)) {
            sample sample;
            sample_start(&sample, i, LENGTHS_SHARE);
            test(&sample);
            sample_free(&sample);
            cases++;
        }
    }
    TEST_ASSERT_EQUAL_INT(4, cases);
}

/* A single parallel revolute link of length 400. */
static const armtol_link one_link[1] = {{ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 400}};
static const armtol_column one_link_columns[4] = {
    {0, ARMTOL_THETA}, {0, ARMTOL_A}, {0, ARMTOL_ALPHA}, {0, ARMTOL_BETA}};
static const drawn_arm one_link_arm = {one_link, 1, one_link_columns, 4};

/* ---- tolerances ---- */

static double tolerance_of(const analysis *analysis, const double tolerances[], size_t link,
                           armtol_parameter parameter)
{
    for (size_t k = 0; k < analysis->n_columns; k++) {
        if (analysis->columns[k].link == link && analysis->columns[k].parameter == parameter) {
            return tolerances[k];
        }
    }
    TEST_FAIL_MESSAGE("no such column");
    return 0;
}

/* The paper's last case, the Adept's second: rd and td are those that it prints. */
static void test_the_adepts_published_tolerances(void)
{
    size_t first = 0;
    sample sample;
    for (size_t i = 0; i < published.count; i++) {
        first = published_begins_case(&published, i) ? i : first;
    }
    sample_start(&sample, first, LENGTHS_SHARE);
    const double *share = sample.tolerances[SET_PUBLISHED];
    check_printed("0.006081", tolerance_of(&sample.drawn, share, 0, ARMTOL_THETA), "machined angle");
    check_printed("0.006081", tolerance_of(&sample.drawn, share, 2, ARMTOL_THETA), "revolute joint");
    check_printed("0.057224", tolerance_of(&sample.drawn, share, 4, ARMTOL_D), "prismatic joint, no sign");
    check_within(1e-6, sqrt(0.045870 / 14), /* the printed distance bound */
                 tolerance_of(&sample.drawn, share, 1, ARMTOL_A), "share");
    sample_free(&sample);
    sample_start(&sample, first, LENGTHS_RD);
    const double *rd = sample.tolerances[SET_PUBLISHED];
    check_printed("0.080950", tolerance_of(&sample.drawn, rd, 1, ARMTOL_A), "rd[1], one length");
    check_printed("0.057244", tolerance_of(&sample.drawn, rd, 2, ARMTOL_A), "rd[2], one length");
    check_within(1e-6, sqrt(0.045870 / 14), /* the printed distance bound */
                 tolerance_of(&sample.drawn, rd, 5, ARMTOL_A), "two lengths keep the share");
    sample_free(&sample);
}

/* ---- corners ---- */

static void scale(const double tolerances[], size_t n, double factor, double scaled[])
{
    for (size_t k = 0; k < n; k++) {
        scaled[k] = factor * tolerances[k];
    }
}

static void check_first_order(const sample *sample)
{
    const size_t n = sample->drawn.n_columns;
    double tiny[MOST], errors[MOST], error[6];
    scale(sample->tolerances[SET_CORRECTED], n, 1e-4, tiny);
    for (size_t i = 0; i < 6; i++) {
        const double prediction = armtol_worst_error(sample->drawn.matrix, n, i, tiny);
        for (int sign = -1; sign <= 1; sign += 2) {
            armtol_corner(sample->drawn.matrix, n, i, sign, tiny, errors);
            drawn_arm_error(&sample->arm, errors, error);
            check_within(1e-6, 1, sign * error[i] / prediction, "%s %d, component %zu", sample->program,
                         sample->number, i);
        }
    }
}

static void test_tiny_tolerances_are_linear(void)
{
    for_every_case(check_first_order);
}

static void check_parameters_of_a_corner(const sample *sample)
{
    const size_t n = sample->drawn.n_columns;
    const double *tolerances = sample->tolerances[SET_PUBLISHED];
    double errors[MOST];
    for (size_t i = 0; i < 6; i++) {
        const double prediction = armtol_worst_error(sample->drawn.matrix, n, i, tolerances);
        double product = 0;
        armtol_corner(sample->drawn.matrix, n, i, -1, tolerances, errors);
        for (size_t k = 0; k < n; k++) {
            TEST_ASSERT_TRUE(errors[k] == 0 || fabs(errors[k]) == tolerances[k]);
            product += sample->drawn.matrix[i * n + k] * errors[k];
        }
        check_within(1e-9 * prediction, -prediction, product, "%s %d, row %zu", sample->program,
                     sample->number, i);
    }
}

static void test_a_corner_is_where_its_row_is_largest(void)
{
    for_every_case(check_parameters_of_a_corner);
}

/* No corner drawn differs from A by more than the remainder. */
static void check_remainder(const sample *sample)
{
    const size_t n = sample->drawn.n_columns;
    const double *tolerances = sample->tolerances[SET_PUBLISHED];
    const double remainder = guarantee_remainder(&sample->arm, tolerances);
    for (size_t i = 0; i < 2000; i++) {
        double errors[MOST], error[6];
        arm_draws_errors(&sample->arm, tolerances, 5, i, errors);
        for (size_t k = 0; k < n; k++) {
            errors[k] = copysign(tolerances[k], errors[k]);
        }
        drawn_arm_error(&sample->arm, errors, error);
        for (size_t j = 0; j < 3; j++) {
            for (size_t k = 0; k < n; k++) {
                error[j] -= sample->drawn.matrix[j * n + k] * errors[k];
            }
        }
        TEST_ASSERT_TRUE(error_norm(error) <= remainder);
    }
}

static void test_the_remainder_holds(void)
{
    for_every_case(check_remainder);
}

/* A link that only turns by t: what A leaves out is a (1 - cos t), and the remainder hardly more. */
static void test_the_remainder_is_tight_for_one_link(void)
{
    const double tolerances[4] = {0.01};
    const double remainder = guarantee_remainder(&one_link_arm, tolerances);
    const double left_out = 400 * (1 - cos(0.01));
    TEST_ASSERT_TRUE(left_out <= remainder);
    check_within(1e-4 * left_out, left_out, remainder, "remainder");
}

static void check_climb(const sample *sample)
{
    const double *tolerances = sample->tolerances[SET_PUBLISHED];
    double errors[MOST], error[6];
    armtol_corner(sample->drawn.matrix, sample->drawn.n_columns, 0, 1, tolerances, errors);
    drawn_arm_error(&sample->arm, errors, error);
    const double start = error_norm(error);
    const double end = drawn_arm_farthest(&sample->arm, tolerances, errors);
    TEST_ASSERT_TRUE(end >= start);
    drawn_arm_error(&sample->arm, errors, error);
    check_same(end, error_norm(error), "the distance where the climb ends");
    for (size_t k = 0; k < sample->drawn.n_columns; k++) {
        TEST_ASSERT_TRUE(errors[k] == 0 || fabs(errors[k]) == tolerances[k]);
        errors[k] = -errors[k];
        drawn_arm_error(&sample->arm, errors, error);
        TEST_ASSERT_TRUE(error_norm(error) <= end * (1 + 1e-9));
        errors[k] = -errors[k];
    }
}

static void test_a_climb_ends_where_no_sign_takes_farther(void)
{
    for_every_case(check_climb);
}

static void check_guarantee(const sample *sample)
{
    const double *accuracy = sample->drawn.tolerances, *matrix = sample->drawn.matrix;
    double loose[MOST];
    TEST_ASSERT_TRUE(guarantee_holds(&sample->arm, matrix, sample->tolerances[SET_CORRECTED], accuracy));
    TEST_ASSERT_FALSE(guarantee_holds(&sample->arm, matrix, sample->tolerances[SET_PUBLISHED], accuracy));
    scale(sample->tolerances[SET_CORRECTED], sample->drawn.n_columns, 2, loose);
    TEST_ASSERT_FALSE(guarantee_holds(&sample->arm, matrix, loose, accuracy));
}

static void test_the_corrected_tolerances_are_a_guarantee(void)
{
    for_every_case(check_guarantee);
}

/* ---- draws ---- */

static void test_the_generator_is_splitmix64(void)
{
    const double first = (double)(0xe220a8397b1dcdafu >> 11) / 4503599627370496.0 - 1;
    random_source other = {0}; /* seed 0 is mixed to itself */
    check_same(first, armtol_sampler_uniform(0, 0), "the first number of seed 0");
    for (uint64_t i = 0; i < 1000; i++) {
        check_same(random_between(&other, -1, 1), armtol_sampler_uniform(0, i), "number %d of seed 0", (int)i);
    }
}

static void test_draws_are_uniform(void)
{
    enum { DRAWS = 100000 };
    double sum = 0, squares = 0, product = 0;
    for (uint64_t i = 0; i < DRAWS; i++) {
        const double u = armtol_sampler_uniform(7, i);
        TEST_ASSERT_TRUE(u >= -1 && u < 1);
        sum += u;
        squares += u * u;
        product += u * armtol_sampler_uniform(7, i + 1);
    }
    /* five standard deviations */
    check_within(5 * sqrt(1.0 / 3 / DRAWS), 0, sum / DRAWS, "mean");
    check_within(5 * sqrt(4.0 / 45 / DRAWS), 1.0 / 3, squares / DRAWS, "mean of squares");
    check_within(5 * sqrt(1.0 / 9 / DRAWS), 0, product / DRAWS, "product of neighbours");
}

/* Of a link of length a that may only turn, asin(e / a) / t of the arms keep y to e. */
static void test_a_share_in_closed_form(void)
{
    const double tolerances[4] = {0.005}, accuracy[6] = {1, 0.5, 1, 1, 1, 1};
    const double share = asin(0.5 / 400) / 0.005;
    arm_draws draws;
    TEST_ASSERT_TRUE(arm_draws_make(&one_link_arm, tolerances, accuracy, 3, 20000, &draws));
    check_within(5 * sqrt(share * (1 - share) / 20000), share, (double)draws.within / 20000, "share");
    check_within(0.01, 400 * sin(0.5 * 0.005), draws.linear.quantiles[1], "median");
    check_within(0.001, 400 * sin(0.005), draws.linear.worst, "worst");
    check_within(1e-6, 0.005, draws.angular.worst, "worst rotation");
    check_within(0.001, 2 * 400 * sin(0.005 / 2), draws.distance.worst, "farthest");
}

static void check_zero_tolerances(const sample *sample)
{
    const double none[MOST] = {0};
    arm_draws draws;
    TEST_ASSERT_TRUE(arm_draws_make(&sample->arm, none, sample->drawn.tolerances, 1, 100, &draws));
    TEST_ASSERT_EQUAL_INT(100, draws.within);
    check_same(0, draws.distance.worst, "worst distance");
    check_same(0, draws.angular.worst, "worst rotation");
}

static void test_with_tolerances_of_zero_every_arm_is_exact(void)
{
    for_every_case(check_zero_tolerances);
}

static arm_draws draw(const sample *sample, tolerance_set set, uint64_t seed, size_t samples)
{
    arm_draws draws;
    TEST_ASSERT_TRUE(arm_draws_make(&sample->arm, sample->tolerances[set], sample->drawn.tolerances, seed,
                                    samples, &draws));
    return draws;
}

static void check_sets(const sample *sample)
{
    const arm_draws as_published = draw(sample, SET_PUBLISHED, 11, 10000);
    const arm_draws as_corrected = draw(sample, SET_CORRECTED, 11, 10000);
    TEST_ASSERT_TRUE(as_published.within > 50 && as_published.within < 500);
    TEST_ASSERT_EQUAL_INT(10000, as_corrected.within);
    TEST_ASSERT_TRUE(as_corrected.distance.worst < 0.5);
}

static void test_few_arms_of_1987_are_within_and_all_corrected_ones(void)
{
    for_every_case(check_sets);
}

static void check_seeds(const sample *sample)
{
    const arm_draws one = draw(sample, SET_PUBLISHED, 1, 500), again = draw(sample, SET_PUBLISHED, 1, 500);
    const arm_draws other = draw(sample, SET_PUBLISHED, 2, 500), more = draw(sample, SET_PUBLISHED, 1, 501);
    check_same(one.linear.worst, again.linear.worst, "the same seed");
    check_same(one.angular.quantiles[1], again.angular.quantiles[1], "the same seed");
    TEST_ASSERT_TRUE(one.linear.worst != other.linear.worst);
    /* one arm more, and the others as they were */
    TEST_ASSERT_TRUE(more.within - one.within <= 1 && more.linear.worst >= one.linear.worst);
}

static void test_a_seed_says_what_is_drawn(void)
{
    for_every_case(check_seeds);
}

/* ---- the program ---- */

static void run(process *process, const char *const arguments[])
{
    const process_setup setup = {.program = TEST_YIELD, .arguments = arguments};
    process_run(process, &setup, "");
}

static void check_refused(const char *const arguments[], const char *words)
{
    process process;
    run(&process, arguments);
    process_check_status(&process, 2, words);
    const string line = process_last_line(&process);
    const bool ours = strncmp(line.text, "yield: ", 7) == 0 && strstr(line.text, words) != NULL;
    if (!ours || process.output.length > 0) {
        fail_with("expected a message with \"%s\"; it said \"%s\"", words, process.errors.bytes);
    }
}

static void test_wrong_options_are_refused(void)
{
    check_refused((const char *const[]){NULL}, "is missing");
    check_refused((const char *const[]){TEST_PUBLISHED, "more", NULL}, "unexpected argument \"more\"");
    check_refused((const char *const[]){"--colour", TEST_PUBLISHED, NULL}, "unknown option \"--colour\"");
    check_refused((const char *const[]){"--seed", NULL}, "missing after \"--seed\"");
    check_refused((const char *const[]){"--samples=0", TEST_PUBLISHED, NULL}, "--samples: \"0\"");
    check_refused((const char *const[]){"--samples=1e-3", TEST_PUBLISHED, NULL}, "--samples: \"1e-3\"");
    check_refused((const char *const[]){"--samples=10000001", TEST_PUBLISHED, NULL}, "from 1 to 10000000");
    check_refused((const char *const[]){"--seed=-1", TEST_PUBLISHED, NULL}, "--seed: \"-1\"");
    check_refused((const char *const[]){"--seed=18446744073709551616", TEST_PUBLISHED, NULL}, "--seed: ");
    check_refused((const char *const[]){"--lengths=h", TEST_PUBLISHED, NULL}, "share or rd");
    check_refused((const char *const[]){"--format=html", TEST_PUBLISHED, NULL}, "text, markdown or tsv");
}

static void test_help_and_version(void)
{
    process process;
    run(&process, (const char *const[]){"--help", NULL});
    process_check_status(&process, 0, "--help");
    TEST_ASSERT_EQUAL_INT(0, strncmp(process.output.bytes, "Usage: yield [OPTION]... PUBLISHED\n", 35));
    run(&process, (const char *const[]){"-V", NULL});
    process_check_status(&process, 0, "-V");
    TEST_ASSERT_EQUAL_STRING("yield (armtol) " TEST_VERSION "\n", process.output.bytes);
}

static void test_a_table_that_is_not_there_is_refused(void)
{
    process process;
    const string folder = folder_new();
    const string path = string_of("%s/none.tsv", folder.text);
    run(&process, (const char *const[]){path.text, NULL});
    process_check_status(&process, 2, path.text);
    TEST_ASSERT_NOT_NULL(strstr(process.errors.bytes, path.text));
}

static void test_the_same_seed_prints_the_same(void)
{
    static process one, again, other;
    run(&one, (const char *const[]){"-n", "200", "-s", "18446744073709551615", TEST_PUBLISHED, NULL});
    run(&again, (const char *const[]){"-n", "200", "-s", "18446744073709551615", TEST_PUBLISHED, NULL});
    run(&other, (const char *const[]){"-n", "200", "-s", "0", TEST_PUBLISHED, NULL});
    process_check_status(&one, 0, "seed");
    text_check(one.output.bytes, one.output.length, &again.output, "the same seed");
    const char *drawn = strchr(one.output.bytes, ')'), *drawn_other = strchr(other.output.bytes, ')');
    TEST_ASSERT_TRUE(drawn != NULL && drawn_other != NULL && strcmp(drawn, drawn_other) != 0);
}

static void test_formats(void)
{
    static process text, markdown, tsv;
    run(&text, (const char *const[]){"-n", "1", TEST_PUBLISHED, NULL});
    run(&markdown, (const char *const[]){"-n", "1", "-f", "markdown", TEST_PUBLISHED, NULL});
    run(&tsv, (const char *const[]){"-n", "1", "-f", "tsv", "-l", "rd", TEST_PUBLISHED, NULL});
    TEST_ASSERT_NOT_NULL(strstr(text.output.bytes, "Worst corner, mm\n\n  tolerances"));
    TEST_ASSERT_NOT_NULL(strstr(markdown.output.bytes, "### Worst corner, mm\n\n| tolerances"));
    TEST_ASSERT_NOT_NULL(strstr(tsv.output.bytes, "# Worst corner, mm\ntolerances\tcorner of\t"));
    TEST_ASSERT_NOT_NULL(strstr(tsv.output.bytes, "lengths within rd"));
    TEST_ASSERT_NOT_NULL(strstr(tsv.output.bytes, "\nadpta 2, corrected\t0.024789\t0.000214\t1\t100.000\t"));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_adepts_published_tolerances);
    RUN_TEST(test_tiny_tolerances_are_linear);
    RUN_TEST(test_a_corner_is_where_its_row_is_largest);
    RUN_TEST(test_the_remainder_holds);
    RUN_TEST(test_the_remainder_is_tight_for_one_link);
    RUN_TEST(test_a_climb_ends_where_no_sign_takes_farther);
    RUN_TEST(test_the_corrected_tolerances_are_a_guarantee);
    RUN_TEST(test_the_generator_is_splitmix64);
    RUN_TEST(test_draws_are_uniform);
    RUN_TEST(test_a_share_in_closed_form);
    RUN_TEST(test_with_tolerances_of_zero_every_arm_is_exact);
    RUN_TEST(test_few_arms_of_1987_are_within_and_all_corrected_ones);
    RUN_TEST(test_a_seed_says_what_is_drawn);
    RUN_TEST(test_wrong_options_are_refused);
    RUN_TEST(test_help_and_version);
    RUN_TEST(test_a_table_that_is_not_there_is_refused);
    RUN_TEST(test_the_same_seed_prints_the_same);
    RUN_TEST(test_formats);
    return UNITY_END();
}
