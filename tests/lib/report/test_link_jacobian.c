#include "armtol/link_jacobian.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/*
 * The reference gives twists of the tool point in coordinates of the frame before the link; G is in those of the
 * frame behind it.
 */
static void reference_jacobian_column(const armtol_link *link, armtol_parameter parameter, double twist[6])
{
    double before[6], t[4][4];
    reference_column(link, 1, (armtol_column){0, parameter}, true, before);
    reference_link(link, t);
    for (int i = 0; i < 3; i++) {
        twist[i] = twist[i + 3] = 0;
        for (int j = 0; j < 3; j++) {
            twist[i] += t[j][i] * before[j];
            twist[i + 3] += t[j][i] * before[j + 3];
        }
    }
}

static void check_against_reference(const armtol_link *link)
{
    double g[6][ARMTOL_PARAMETER_COUNT];
    size_t count, n;
    const armtol_parameter *parameters = armtol_kind_parameters(link->kind, &n);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_link_jacobian(link, &armtol_errata_none, g, &count));
    TEST_ASSERT_EQUAL_INT(n, count);
    for (size_t k = 0; k < count; k++) {
        double expected[6];
        reference_jacobian_column(link, parameters[k], expected);
        for (int i = 0; i < 6; i++) {
            check_within(1e-7 * (1 + fabs(link->a)), expected[i], g[i][k], "%s, %s, row %d",
                         armtol_kind_name(link->kind), armtol_parameter_name(parameters[k]), i);
        }
    }
}

static void test_corrected_it_agrees_with_central_differences_for_every_kind(void)
{
    random_source source = {1};
    for (int n = 0; n < 200; n++) {
        check_against_reference(&(armtol_link){
            .kind = (armtol_kind)(n % ARMTOL_KIND_COUNT),
            .a = random_between(&source, -400, 400),
            .alpha = random_between(&source, -3, 3),
            .d = random_between(&source, -400, 400),
            .theta = random_between(&source, -3, 3),
            .beta = random_between(&source, -3, 3),
        });
    }
}

/* One element of G with one erratum kept. */
static double element(const armtol_link *link, const char *erratum, int row, int column)
{
    armtol_errata errata = armtol_errata_none;
    double g[6][ARMTOL_PARAMETER_COUNT];
    size_t count;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_erratum_keep(&errata, erratum, true));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_link_jacobian(link, &errata, g, &count));
    return g[row][column];
}

static void test_parallel_arm_takes_d_for_a(void)
{
    const armtol_link link = {.kind = ARMTOL_PPR, .a = 100, .d = 7, .alpha = 0.3, .beta = 0.2};
    check_within(1e-14, 7 * cos(0.3), element(&link, "parallel-arm", 1, 0), "vy of theta");
    check_within(1e-14, 7 * sin(0.3) * sin(0.2), element(&link, "parallel-arm", 0, 0), "vx of theta");
    check_within(1e-14, -7 * sin(0.3) * cos(0.2), element(&link, "parallel-arm", 2, 0), "vz of theta");
}

static void test_parallel_arm_leaves_the_other_kinds(void)
{
    const armtol_link link = {.kind = ARMTOL_PPP, .a = 100, .d = 7, .alpha = 0.3};
    check_within(1e-12, 100 * cos(0.3), element(&link, "parallel-arm", 1, 1), "vy of theta");
}

static void test_prismatic_alpha_takes_alpha_for_a(void)
{
    const armtol_link link = {.kind = ARMTOL_PPP, .a = 100, .d = 7, .alpha = 0.3, .beta = 0.2};
    check_within(1e-14, 0.3 * cos(0.3), element(&link, "prismatic-alpha", 1, 1), "vy of theta");
    check_within(1e-14, 0.3 * sin(0.3) * sin(0.2), element(&link, "prismatic-alpha", 0, 1), "vx of theta");
}

static void test_prismatic_alpha_leaves_the_other_kinds(void)
{
    const armtol_link link = {.kind = ARMTOL_NPR, .a = 100, .d = 7, .alpha = 0.3};
    check_within(1e-12, 100 * cos(0.3), element(&link, "prismatic-alpha", 1, 0), "vy of theta");
}

/* The elements with sin beta or a rotation about y as gppr and gppp print them. */
static void test_beta_sign_is_written_for_minus_beta(void)
{
    const armtol_link ppr = {.kind = ARMTOL_PPR, .a = 100, .alpha = 0.3, .beta = 0.2};
    const armtol_link ppp = {.kind = ARMTOL_PPP, .a = 100, .alpha = 0.3, .beta = 0.2};
    check_within(1e-12, -100 * sin(0.3) * sin(0.2), element(&ppr, "beta-sign", 0, 0), "ppr: vx of theta");
    check_within(1e-15, -sin(0.2), element(&ppr, "beta-sign", 2, 1), "ppr: vz of a");
    check_within(1e-15, cos(0.3) * sin(0.2), element(&ppr, "beta-sign", 3, 0), "ppr: wx of theta");
    check_within(1e-15, -sin(0.2), element(&ppr, "beta-sign", 5, 2), "ppr: wz of alpha");
    check_same(-1, element(&ppr, "beta-sign", 4, 3), "ppr: wy of beta");
    check_within(1e-15, cos(0.3) * sin(0.2), element(&ppp, "beta-sign", 0, 0), "ppp: vx of d");
    check_same(-1, element(&ppp, "beta-sign", 4, 4), "ppp: wy of beta");
}

static void test_what_is_no_kind_is_refused(void)
{
    const armtol_link link = {.kind = ARMTOL_KIND_COUNT};
    double g[6][ARMTOL_PARAMETER_COUNT] = {{5}};
    size_t count = 9;
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_KIND, armtol_link_jacobian(&link, &armtol_errata_1987, g, &count));
    TEST_ASSERT_EQUAL_INT(9, count);
    check_same(5, g[0][0], "the output after an error");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_corrected_it_agrees_with_central_differences_for_every_kind);
    RUN_TEST(test_parallel_arm_takes_d_for_a);
    RUN_TEST(test_parallel_arm_leaves_the_other_kinds);
    RUN_TEST(test_prismatic_alpha_takes_alpha_for_a);
    RUN_TEST(test_prismatic_alpha_leaves_the_other_kinds);
    RUN_TEST(test_beta_sign_is_written_for_minus_beta);
    RUN_TEST(test_what_is_no_kind_is_refused);
    return UNITY_END();
}
