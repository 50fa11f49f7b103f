/* What rounding does: to a 0 of A, and to the errors of the tool. The judge computes in long double. */

#include "armtol/corners.h"
#include "armtol/sampler.h"
#include "armtol/tool_error.h"
#include "armtol/tool_matrix.h"
#include "support/check.h"
#include "support/random.h"

#include "unity.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { LINKS = 12, COLUMNS = 4 * LINKS + LINKS };

static const double pi = 3.14159265358979323846;

typedef struct sample {
    armtol_link links[LINKS];
    size_t n_links, n;
    armtol_tool_point tool;
    double matrix[6 * COLUMNS], tolerances[COLUMNS];
} sample;

void setUp(void)
{
}

void tearDown(void)
{
}

static void sample_make(random_source *source, double size, double tolerance, sample *sample)
{
    *sample = (struct sample){.n_links = 1 + (size_t)random_between(source, 0, LINKS)};
    for (size_t i = 0; i < sample->n_links; i++) {
        sample->links[i] = (armtol_link){
            .kind = (armtol_kind)random_between(source, 0, ARMTOL_KIND_COUNT),
            .joint = ARMTOL_REVOLUTE,
            .a = random_between(source, -size, size),
            .alpha = random_between(source, -pi, pi),
            .d = random_between(source, -size, size),
            .theta = random_between(source, -pi, pi),
        };
    }
    for (int i = 0; i < 3; i++) {
        sample->tool.offset[i] = random_between(source, -size, size);
    }
    sample->n = armtol_column_count(sample->links, sample->n_links);
    for (size_t k = 0; k < sample->n; k++) {
        sample->tolerances[k] = tolerance;
    }
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tool_matrix(sample->links, sample->n_links, &sample->tool, sample->matrix,
                                                        sample->n));
    armtol_tool_matrix_clear(sample->links, sample->n_links, &sample->tool, sample->matrix, sample->n);
}

/* ---- the judge: Eq. (4.1) in long double ---- */

typedef long double matrix4[4][4];

static void multiply(matrix4 a, matrix4 b)
{
    matrix4 product = {{0}};
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            for (int n = 0; n < 4; n++) {
                product[i][j] += a[i][n] * b[n][j];
            }
        }
    }
    memcpy(a, product, sizeof product);
}

/* A turn about z or x or y, and a way along z and x. */
static void turn_about(matrix4 frame, int axis, long double angle)
{
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    matrix4 turn = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    turn[j][j] = turn[k][k] = cosl(angle);
    turn[k][j] = sinl(angle);
    turn[j][k] = -sinl(angle);
    multiply(frame, turn);
}

static void move(matrix4 frame, long double a, long double d)
{
    matrix4 way = {{1, 0, 0, a}, {0, 1, 0, 0}, {0, 0, 1, d}, {0, 0, 0, 1}};
    multiply(frame, way);
}

static void chain_of(const sample *sample, const double errors[], matrix4 frame)
{
    static const matrix4 identity = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    size_t column = 0;
    memcpy(frame, identity, sizeof identity);
    for (size_t i = 0; i < sample->n_links; i++) {
        const armtol_link *link = &sample->links[i];
        long double of[ARMTOL_PARAMETER_COUNT] = {link->theta, link->d, link->a, link->alpha, link->beta};
        size_t count;
        const armtol_parameter *parameters = armtol_kind_parameters(link->kind, &count);
        for (size_t k = 0; k < count; k++, column++) {
            of[parameters[k]] += errors != NULL ? errors[column] : 0;
        }
        turn_about(frame, 2, of[ARMTOL_THETA]);
        move(frame, of[ARMTOL_A], of[ARMTOL_D]);
        turn_about(frame, 0, of[ARMTOL_ALPHA]);
        turn_about(frame, 1, of[ARMTOL_BETA]);
    }
}

/* The rotation vector of a turn so small that the sine is the angle. */
static void error_of(const sample *sample, const double errors[], long double error[6])
{
    matrix4 meant, built, turn = {{0}};
    chain_of(sample, NULL, meant);
    chain_of(sample, errors, built);
    for (int i = 0; i < 3; i++) {
        error[i] = built[i][3] - meant[i][3];
        for (int j = 0; j < 3; j++) {
            error[i] += (built[i][j] - meant[i][j]) * (long double)sample->tool.offset[j];
            for (int n = 0; n < 3; n++) {
                turn[i][j] += built[i][n] * meant[j][n];
            }
        }
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        error[3 + i] = (turn[k][j] - turn[j][k]) / 2;
    }
}

/* ---- */

/* Both ways to the exact error, and A, of arms off by less than rounding: what they differ by is rounding. */
static void test_the_bound_holds_for_all_three_computations(void)
{
    random_source source = {1};
    double closest = 0;
    if (LDBL_MANT_DIG <= DBL_MANT_DIG) {
        TEST_IGNORE_MESSAGE("long double is no judge here");
    }
    for (int t = 0; t < 2000; t++) {
        sample sample;
        armtol_sampled_link prepared[LINKS];
        armtol_sampler sampler;
        double errors[COLUMNS], drawn[6], exact[6], rounding[6];
        long double judged[6];
        sample_make(&source, pow(10, random_between(&source, -6, 6)), 1e-12, &sample);
        armtol_rounding(sample.links, sample.n_links, &sample.tool, sample.tolerances, rounding);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_sampler_start(&sampler, prepared, sample.links, sample.n_links,
                                                              sample.tolerances, sample.n, &sample.tool, 7));
        armtol_sampler_draw(&sampler, (uint64_t)t, 1, drawn);
        armtol_sampler_parameters(&sampler, (uint64_t)t, errors);
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tool_error(sample.links, sample.n_links, errors, sample.n, &sample.tool,
                                                           exact));
        error_of(&sample, errors, judged);
        for (size_t i = 0; i < 6; i++) {
            double by_matrix = 0;
            for (size_t k = 0; k < sample.n; k++) {
                by_matrix += sample.matrix[i * sample.n + k] * errors[k];
            }
            check_within(rounding[i], (double)judged[i], drawn[i], "the sampler, arm %d, %zu", t, i);
            check_within(rounding[i], (double)judged[i], exact[i], "armtol_tool_error, arm %d, %zu", t, i);
            check_within(rounding[i], by_matrix, drawn[i], "A and the sampler, arm %d, %zu", t, i);
            closest = fmax(closest, fabs(drawn[i] - by_matrix) / rounding[i]);
        }
    }
    TEST_ASSERT_TRUE_MESSAGE(closest > 1e-4, "the bound is of no use");
}

/* z through the tool: in one pose an exact 0, in another what sin(pi) leaves; and no unit of length changes that. */
static void test_what_rounding_left_of_a_zero_is_cleared(void)
{
    for (int exponent = -9; exponent <= 9; exponent++) {
        const double unit = pow(10, exponent);
        const armtol_link link = {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = unit, .d = 3 * unit, .theta = pi};
        double matrix[24];
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tool_matrix(&link, 1, &armtol_tool_origin, matrix, 4));
        TEST_ASSERT_TRUE(matrix[0] != 0 && matrix[6] != 0); /* dx by theta, dy by a */
        armtol_tool_matrix_clear(&link, 1, &armtol_tool_origin, matrix, 4);
        TEST_ASSERT_TRUE(matrix[0] == 0 && matrix[6] == 0);
        check_within(1e-15 * unit, -unit, matrix[4], "dy by theta");
        check_within(1e-15, -1, matrix[2], "dx by a");
        check_within(1e-15, -1, matrix[15], "wx by alpha");
    }
}

static void test_what_is_small_and_no_rounding_stays(void)
{
    const armtol_link link = {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 1000, .theta = 1e-10};
    double matrix[24];
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tool_matrix(&link, 1, &armtol_tool_origin, matrix, 4));
    armtol_tool_matrix_clear(&link, 1, &armtol_tool_origin, matrix, 4);
    check_within(1e-20, 1e-10, matrix[6], "dy by a");
    check_within(1e-17, -1e-7, matrix[0], "dx by theta");
}

static void test_no_number_is_no_bound(void)
{
    const armtol_link link = {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 1e308, .d = 1e308};
    const double tolerances[4] = {1, 1, 1, 1};
    double rounding[6];
    armtol_rounding(&link, 1, &armtol_tool_origin, tolerances, rounding);
    TEST_ASSERT_TRUE(isinf(rounding[0]) && rounding[3] < 1e-11);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_bound_holds_for_all_three_computations);
    RUN_TEST(test_what_rounding_left_of_a_zero_is_cleared);
    RUN_TEST(test_what_is_small_and_no_rounding_stays);
    RUN_TEST(test_no_number_is_no_bound);
    return UNITY_END();
}
