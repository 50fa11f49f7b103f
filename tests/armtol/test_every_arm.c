/* What holds for every built-in arm, at poses drawn within its joints' limits. */

#include "armtol/asked.h"
#include "armtol/verification.h"
#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"

#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { POSES = 5 };

void setUp(void)
{
}

void tearDown(void)
{
}

typedef void check(const asked *asked, const char *what);

static void at_drawn_poses(const char *accuracy, check *check)
{
    random_source random = {1987};
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        const armtol_arm *arm = armtol_arm_at(i);
        for (int pose = 0; pose < POSES; pose++) {
            char joints[JOINTS_TEXT], what[JOINTS_TEXT + 64];
            asked asked;
            draw_joints_text(&random, arm, joints);
            snprintf(what, sizeof what, "%s at %s", arm->name, joints);
            const cli_options options = question(arm->name, joints, accuracy);
            asked_make(&asked, &options);
            check(&asked, what);
            asked_free(&asked);
        }
    }
}

static void check_matrix(const asked *asked, const char *what)
{
    const armtol_answer *answer = asked->answer;
    for (size_t k = 0; k < answer->n_columns; k++) {
        double twist[6];
        reference_column(answer->links, answer->n_links, answer->columns[k], true, twist);
        for (size_t i = 0; i < 6; i++) {
            check_within(1e-6, twist[i], answer->matrices[i * answer->n_columns + k], "row %zu, column %zu of %s", i, k,
                         what);
        }
    }
}

static void test_the_matrix_is_that_of_central_differences(void)
{
    at_drawn_poses(".5,.5,.5,.01,.01,.01", check_matrix);
}

/* The first order keeps to the accuracy, and at least one component uses all of it. */
static void check_worst_case(const asked *asked, const char *what)
{
    const armtol_answer *answer = asked->answer;
    double fullest = 0;
    for (size_t i = 0; i < 6; i++) {
        double sum = 0;
        for (size_t k = 0; k < answer->n_columns; k++) {
            const double tolerance = asked->answer->tolerances[k];
            const double element = fabs(answer->matrices[i * answer->n_columns + k]);
            TEST_ASSERT_TRUE_MESSAGE(tolerance > 0, what);
            sum += isinf(tolerance) ? 0 : element * tolerance;
            TEST_ASSERT_TRUE_MESSAGE(!isinf(tolerance) || element < 1e-9, what);
        }
        TEST_ASSERT_TRUE_MESSAGE(sum <= asked->request.accuracy[i] * (1 + 1e-12), what);
        fullest = fmax(fullest, sum / asked->request.accuracy[i]);
    }
    check_within(1e-9, 1, fullest, "%s", what);
}

static void test_worst_case_tolerances_use_the_accuracy_and_no_more(void)
{
    at_drawn_poses(".5,.5,.5,.01,.01,.01", check_worst_case);
}

static void check_verified(const asked *asked, const char *what)
{
    const armtol_draw draw = {.samples = 20000, .seed = 7, .n_threads = 2};
    armtol_verification found;
    TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_OK, armtol_verify(asked->answer, &draw, &found, NULL), what);
    TEST_ASSERT_TRUE_MESSAGE(found.drawn == 20000, what);
    TEST_ASSERT_TRUE_MESSAGE(found.beyond == 0, what);
    for (size_t i = 0; i < 6; i++) {
        const armtol_predicted *predicted = &asked->answer->components[i];
        const armtol_verified *component = &found.components[i];
        const double most = predicted->worst + predicted->remainder;
        TEST_ASSERT_TRUE_MESSAGE(component->worst_drawn <= most, what);
        TEST_ASSERT_TRUE_MESSAGE(component->worst_corner <= most * (1 + 1e-12), what);
        TEST_ASSERT_TRUE_MESSAGE(component->worst_corner >= predicted->worst - predicted->remainder - 1e-12, what);
        TEST_ASSERT_TRUE_MESSAGE(component->worst_drawn > 0.1 * predicted->worst, what);
    }
}

static void test_no_arm_drawn_within_worst_case_tolerances_is_outside_beyond_the_remainder(void)
{
    at_drawn_poses(".5,.5,.5,.01,.01,.01", check_verified);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_matrix_is_that_of_central_differences);
    RUN_TEST(test_worst_case_tolerances_use_the_accuracy_and_no_more);
    RUN_TEST(test_no_arm_drawn_within_worst_case_tolerances_is_outside_beyond_the_remainder);
    return UNITY_END();
}
