/*
 * The experiment with orders of steps and precisions: that its default is the library, that every option does
 * something, that it counts right, and what the paper's numbers say of some configurations.
 */

#include "console/message.h"
#include "lab/joint_orders/elsewhere.h"
#include "lab/joint_orders/survey.h"

#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WISHES = 1000, FEW_WISHES = 50 };

static published_list list;
static double wishes[WISHES][MOST_WISH];

void setUp(void)
{
    message_start("test_joint_orders");
    TEST_ASSERT_TRUE(published_read(PUBLISHED, &list));
}

void tearDown(void)
{
    published_free(&list);
}

static survey survey_of(const family *family)
{
    survey survey;
    TEST_ASSERT_TRUE(survey_start(&survey, &list, family));
    return survey;
}

static void draw_wishes(const family *family, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        elsewhere_wish(family, i, wishes[i]);
    }
}

/* The default with the options "choice=option" given, up to a NULL. */
static configuration with(const family *family, const char *const options[])
{
    configuration configuration = family_default();
    for (; *options != NULL; options++) {
        restriction given = {{false}, {0}};
        TEST_ASSERT_TRUE_MESSAGE(family_restrict(family, *options, &given), *options);
        for (size_t i = 0; i < family->n_choices; i++) {
            if (given.restricted[i]) {
                configuration.option[i] = given.option[i];
            }
        }
    }
    return configuration;
}

/* ---- the default is the library ---- */

static void test_the_default_is_the_library_to_the_bit(void)
{
    for (int f = 0; f < FAMILIES; f++) {
        const family *family = families[f];
        const configuration how = family_default();
        draw_wishes(family, WISHES);
        for (int i = 0; i < WISHES; i++) {
            double expected[MOST_JOINTS], actual[MOST_JOINTS];
            armtol_reach reach;
            TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                                  family->robot->inverse(wishes[i], &armtol_errata_1987, expected, &reach));
            family->solve(&how, wishes[i], actual);
            for (size_t j = 0; j < family->robot->n_joints; j++) {
                check_same(expected[j], actual[j], "%s, wish %d, joint %zu", family->program, i, j + 1);
            }
        }
    }
}

/* ---- every option does something ---- */

static bool differ(const family *family, const configuration *one, const configuration *other)
{
    for (int i = 0; i < FEW_WISHES; i++) {
        double q[MOST_JOINTS] = {0}, r[MOST_JOINTS] = {0};
        family->solve(one, wishes[i], q);
        family->solve(other, wishes[i], r);
        if (memcmp(q, r, sizeof q) != 0) {
            return true;
        }
    }
    return false;
}

/* Whether it makes a difference in the default, or in the default with one other change. */
static bool is_live(const family *family, size_t choice, unsigned char option)
{
    for (size_t i = 0; i < family->n_choices; i++) {
        for (size_t j = 0; j < choice_count(&family->choices[i]) && i != choice; j++) {
            configuration without = family_default();
            without.option[i] = (unsigned char)j;
            configuration changed = without;
            changed.option[choice] = option;
            if (family->matters(&without, choice) && family->matters(&changed, choice) &&
                differ(family, &without, &changed)) {
                return true;
            }
        }
    }
    return false;
}

static void test_every_option_is_live(void)
{
    for (int f = 0; f < FAMILIES; f++) {
        const family *family = families[f];
        draw_wishes(family, FEW_WISHES);
        for (size_t i = 0; i < family->n_choices; i++) {
            for (size_t j = 1; j < choice_count(&family->choices[i]); j++) {
                TEST_ASSERT_TRUE_MESSAGE(is_live(family, i, (unsigned char)j),
                                         family->choices[i].options[j].name);
            }
        }
    }
}

/* Of configurations that differ in such a choice one alone is counted. */
static void check_idle_choices(const family *family, const configuration *how)
{
    for (size_t i = 0; i < family->n_choices; i++) {
        if (!family->matters(how, i)) {
            configuration other = *how;
            other.option[i] = 1;
            TEST_ASSERT_FALSE_MESSAGE(differ(family, how, &other), family->choices[i].name);
        }
    }
}

static void draw_option(const family *family, random_source *source, size_t choice,
                        configuration *configuration)
{
    const double n = (double)choice_count(&family->choices[choice]);
    configuration->option[choice] = (unsigned char)random_between(source, 0, n);
}

static void draw_configuration(const family *family, random_source *source, configuration *configuration)
{
    for (size_t i = 0; i < family->n_choices; i++) {
        draw_option(family, source, i, configuration);
    }
}

static void test_a_choice_that_does_not_matter_does_nothing(void)
{
    random_source source = {605};
    for (int f = 0; f < FAMILIES; f++) {
        draw_wishes(families[f], FEW_WISHES);
        for (int n = 0; n < 60; n++) {
            configuration how = family_default();
            draw_configuration(families[f], &source, &how);
            check_idle_choices(families[f], &how);
        }
    }
}

/* ---- what the paper says of single configurations ---- */

/* The values that are wrong, "case.joint=as printed" with a blank between. */
static void check_wrong(const family *family, const char *const options[], const char *expected)
{
    const evidence evidence = survey_of(family).evidence;
    const configuration how = with(family, options);
    char actual[256] = "";
    double q[MOST_VALUES];
    const unsigned long misses = evidence_misses(&evidence, family, &how, q);
    for (size_t i = 0; i < evidence_count(&evidence); i++) {
        const size_t length = strlen(actual);
        if (misses >> i & 1) {
            snprintf(actual + length, sizeof actual - length, "%s%zu.%zu=%.6f", length > 0 ? " " : "",
                     i / evidence.n_joints + 1, i % evidence.n_joints + 1, q[i]);
        }
    }
    TEST_ASSERT_EQUAL_STRING_MESSAGE(expected, actual, options[0]);
}

#define WITH(...) ((const char *const[]){__VA_ARGS__, NULL})

static void test_the_library_gives_all_twenty(void)
{
    check_wrong(&family_intelledex, WITH("base=inverse"), "");
    check_wrong(&family_adept, WITH("turns=kept"), "");
}

/* Then the short pi does not come into it. */
static void test_an_exact_right_angle_loses_four(void)
{
    check_wrong(&family_intelledex, WITH("last-link=written"),
                "1.1=1.571239 2.1=1.571410 2.3=1.416885 2.4=-1.666826");
}

static void test_a_sine_in_a_variable_loses_joint_4_of_case_2(void)
{
    check_wrong(&family_intelledex, WITH("sines=float"), "2.4=-1.666826");
    check_wrong(&family_intelledex, WITH("last=difference"), "2.4=-1.666826");
}

static void test_the_wrist_may_come_from_anywhere(void)
{
    check_wrong(&family_intelledex, WITH("wrist=t05"), "");
    check_wrong(&family_intelledex, WITH("wrist=axis"), "");
    check_wrong(&family_intelledex, WITH("wrist=mpyn1", "q345=z6"), "");
}

static void test_the_other_elbow_is_far_off(void)
{
    check_wrong(&family_intelledex, WITH("elbow=q4-acos"), "2.3=0.064507 2.4=1.666826 2.5=-1.732338");
    check_wrong(&family_intelledex, WITH("elbow=q4-acos", "branch=q5"), "2.4=-1.666826");
}

static void test_without_a_pi_to_subtract_from_the_adept_loses_six(void)
{
    check_wrong(&family_adept, WITH("elbow=acos"),
                "1.1=-0.262799 1.2=2.429296 1.3=-2.166497 2.1=1.307997 2.2=2.429296 2.3=-3.737293");
}

static void test_a_wrapped_q3_is_a_turn_off(void)
{
    check_wrong(&family_adept, WITH("turns=wrapped"), "2.3=2.545889");
}

/* ---- counting ---- */

static void test_the_adept_s_family_counted_by_hand(void)
{
    /*
     * elbow pi-acos:  cosine 2, shoulder with sines 2*2 + 1, sum 2, turns 2, constants 2: 80
     * elbow acos:     the same
     * elbow pi-atan2: a root, in a variable or not: 160
     * elbow atan2:    the same
     * elbow solve:    no root of its own and no shoulder, but sines 2: 32
     */
    enum { ALL = 2 * 80 + 2 * 160 + 32 };
    const restriction none = {{false}, {0}};
    survey survey = survey_of(&family_adept);
    TEST_ASSERT_TRUE(survey_run(&survey, &none));
    TEST_ASSERT_EQUAL_INT(ALL, (int)survey.configurations);
    uint64_t sum = 0;
    for (size_t score = 0; score <= 8; score++) {
        sum += survey.by_score[score];
    }
    TEST_ASSERT_EQUAL_INT(ALL, (int)sum);
    /*
     * All eight: q3 as it is; pi-acos, or pi-atan2 with either root; either cosine; shoulder by either atan2 with
     * either sines; either sum; either constants.
     */
    TEST_ASSERT_EQUAL_INT(3 * 2 * 4 * 2 * 2, (int)survey.n_all);
    TEST_ASSERT_EQUAL_INT((int)survey.n_all, (int)survey.by_score[8]);
    /* and as many have all but q3 of the second case, because they wrap it */
    TEST_ASSERT_EQUAL_INT(1, (int)survey.n_misses);
    TEST_ASSERT_EQUAL_INT(4 + 2, (int)survey.misses[0].value);
    check_same(2545889, survey.misses[0].printed, "the wrapped q3");
    TEST_ASSERT_EQUAL_INT((int)survey.n_all, (int)survey.misses[0].configurations);
    TEST_ASSERT_EQUAL_INT(1, (int)family_changes(&family_adept, &survey.misses[0].nearest));
    survey_free(&survey);
}

static void test_a_restriction_leaves_out_what_contradicts_it(void)
{
    restriction given = {{false}, {0}};
    survey survey = survey_of(&family_adept);
    TEST_ASSERT_TRUE(family_restrict(&family_adept, "root=double", &given));
    TEST_ASSERT_TRUE(survey_run(&survey, &given));
    /* half of those that have a root; those that have none stay */
    TEST_ASSERT_EQUAL_INT(2 * 80 + 2 * 160 / 2 + 32, (int)survey.configurations);
    survey_free(&survey);
    TEST_ASSERT_FALSE(family_restrict(&family_adept, "root=single", &given));
    TEST_ASSERT_FALSE(family_restrict(&family_adept, "root", &given));
    TEST_ASSERT_FALSE(family_restrict(&family_adept, "root=doubles", &given));
}

/* 3 with 12 values and 5 with 11, against 2 with 8 and 4 with 7. */
static void test_pairs_add_their_scores(void)
{
    survey one = {0}, other = {0};
    uint64_t pairs[2 * MOST_VALUES + 1];
    one.by_score[12] = 3;
    one.by_score[11] = 5;
    other.by_score[8] = 2;
    other.by_score[7] = 4;
    survey_pairs(&one, &other, pairs);
    TEST_ASSERT_EQUAL_INT(3 * 2, (int)pairs[20]);
    TEST_ASSERT_EQUAL_INT(3 * 4 + 5 * 2, (int)pairs[19]);
    TEST_ASSERT_EQUAL_INT(5 * 4, (int)pairs[18]);
    TEST_ASSERT_EQUAL_INT(0, (int)pairs[0]);
}

/* ---- elsewhere ---- */

static void test_the_default_does_not_differ_from_itself(void)
{
    const configuration two[2] = {family_default(), with(&family_intelledex, WITH("wrist=t05"))};
    elsewhere_spread spread;
    TEST_ASSERT_EQUAL_INT(0, (int)elsewhere_compare_one(&family_intelledex, &two[0], 100).n_other);
    const elsewhere_difference difference = elsewhere_compare_one(&family_intelledex, &two[1], 100);
    TEST_ASSERT_TRUE(difference.n_other > 0);
    TEST_ASSERT_TRUE(elsewhere_compare_all(&family_intelledex, two, 2, 100, &spread));
    TEST_ASSERT_EQUAL_INT(2, (int)spread.n_answers);
    TEST_ASSERT_EQUAL_INT(1, (int)spread.n_same);
    TEST_ASSERT_EQUAL_INT(0, (int)spread.least);
    TEST_ASSERT_EQUAL_INT((int)difference.n_other, (int)spread.most);
    TEST_ASSERT_TRUE(elsewhere_compare_all(&family_intelledex, two, 0, 100, &spread));
    TEST_ASSERT_EQUAL_INT(0, (int)spread.n_answers);
}

static void test_printed_is_what_printf_prints(void)
{
    random_source source = {6};
    for (int i = 0; i < 5000; i++) {
        char printed[40], expected[40];
        const double q = armtol_stored(&armtol_errata_1987, random_between(&source, -4, 4));
        snprintf(printed, sizeof printed, "%.6f", printed_of(q) * 1e-6);
        snprintf(expected, sizeof expected, "%.6f", q);
        const bool minus_zero = strcmp(expected, "-0.000000") == 0;
        TEST_ASSERT_EQUAL_STRING(minus_zero ? expected + 1 : expected, printed);
    }
    /* a float right between two prints: to even, as printf does */
    check_same(0, printed_of(0), "0");
    check_same(15258789062, printed_of(15258.7890625), "a tie, down to even");
    check_same(45776367188, printed_of(45776.3671875), "a tie, up to even");
}

/* ---- the evidence ---- */

static void test_the_evidence_has_to_be_complete(void)
{
    evidence evidence;
    const size_t count = list.count;
    list.count = 3;
    TEST_ASSERT_FALSE(evidence_find(&list, &family_intelledex, &evidence));
    TEST_ASSERT_FALSE(evidence_find(&list, &family_adept, &evidence));
    list.count = count;
    TEST_ASSERT_TRUE(evidence_find(&list, &family_adept, &evidence));
    TEST_ASSERT_EQUAL_INT(8, (int)evidence_count(&evidence));
    TEST_ASSERT_EQUAL_STRING("d[4]", evidence.numbers[7]->quantity);
    check_same(-103199997, evidence.printed[7], "the last of them");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_default_is_the_library_to_the_bit);
    RUN_TEST(test_every_option_is_live);
    RUN_TEST(test_a_choice_that_does_not_matter_does_nothing);
    RUN_TEST(test_the_library_gives_all_twenty);
    RUN_TEST(test_an_exact_right_angle_loses_four);
    RUN_TEST(test_a_sine_in_a_variable_loses_joint_4_of_case_2);
    RUN_TEST(test_the_wrist_may_come_from_anywhere);
    RUN_TEST(test_the_other_elbow_is_far_off);
    RUN_TEST(test_without_a_pi_to_subtract_from_the_adept_loses_six);
    RUN_TEST(test_a_wrapped_q3_is_a_turn_off);
    RUN_TEST(test_the_adept_s_family_counted_by_hand);
    RUN_TEST(test_a_restriction_leaves_out_what_contradicts_it);
    RUN_TEST(test_pairs_add_their_scores);
    RUN_TEST(test_the_default_does_not_differ_from_itself);
    RUN_TEST(test_printed_is_what_printf_prints);
    RUN_TEST(test_the_evidence_has_to_be_complete);
    return UNITY_END();
}
