/* The corners of the box of tolerances, and what A leaves out in it. */

#include "armtol/corners.h"
#include "armtol/error_matrix.h"
#include "armtol/tool_error.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"

#include "unity.h"

#include <math.h>

enum { LINKS = 6, COLUMNS = LINKS * ARMTOL_PARAMETER_COUNT };

static const double pi = 3.14159265358979323846;

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- an arm, its A by central differences, and a box ---- */

typedef struct box {
    armtol_link links[LINKS];
    size_t n_links, n;
    armtol_column columns[COLUMNS];
    armtol_tool_point tool;
    double matrix[6 * COLUMNS];
    double tolerances[COLUMNS];
    double remainder[6];
} box;

/* The vector along the axes of the tool. */
static void express(double chain[4][4], double vector[3])
{
    double expressed[3];
    for (int i = 0; i < 3; i++) {
        expressed[i] = chain[0][i] * vector[0] + chain[1][i] * vector[1] + chain[2][i] * vector[2];
    }
    for (int i = 0; i < 3; i++) {
        vector[i] = expressed[i];
    }
}

static double cross(const double a[3], const double b[3], int i)
{
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return a[j] * b[k] - a[k] * b[j];
}

static void make_column(box *box, size_t k, double chain[4][4])
{
    const double *offset = box->tool.offset;
    double twist[6], lever[3];
    reference_column(box->links, box->n_links, box->columns[k], true, twist);
    for (int i = 0; i < 3; i++) {
        lever[i] = chain[i][0] * offset[0] + chain[i][1] * offset[1] + chain[i][2] * offset[2];
    }
    for (int i = 0; i < 3; i++) {
        twist[i] += cross(twist + 3, lever, i);
    }
    if (box->tool.frame == ARMTOL_TOOL_FRAME) {
        express(chain, twist);
        express(chain, twist + 3);
    }
    for (size_t i = 0; i < 6; i++) {
        const bool none = i >= 3 && armtol_parameter_is_length(box->columns[k].parameter);
        box->matrix[i * box->n + k] = none ? 0 : twist[i];
    }
}

/* With links, tool and n_links set; tolerances are still to come. */
static void box_start(box *box)
{
    double chain[4][4];
    box->n = armtol_column_count(box->links, box->n_links);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_columns(box->links, box->n_links, box->columns, box->n));
    reference_chain(box->links, box->n_links, chain);
    for (size_t k = 0; k < box->n; k++) {
        make_column(box, k, chain);
    }
}

static void box_of(random_source *source, double angle, double length, box *box)
{
    *box = (struct box){.n_links = 1 + (size_t)random_between(source, 0, LINKS)};
    for (size_t i = 0; i < box->n_links; i++) {
        box->links[i] = (armtol_link){
            .kind = (armtol_kind)random_between(source, 0, ARMTOL_KIND_COUNT),
            .joint = ARMTOL_REVOLUTE,
            .a = random_between(source, -300, 300),
            .alpha = random_between(source, -pi, pi),
            .d = random_between(source, -300, 300),
            .theta = random_between(source, -pi, pi),
            .beta = random_between(source, -1, 1),
        };
    }
    for (int i = 0; i < 3; i++) {
        box->tool.offset[i] = random_between(source, -100, 100);
    }
    box->tool.frame = random_between(source, 0, 1) < 0.5 ? ARMTOL_BASE_FRAME : ARMTOL_TOOL_FRAME;
    box_start(box);
    for (size_t k = 0; k < box->n; k++) {
        const double most = armtol_parameter_is_length(box->columns[k].parameter) ? length : angle;
        box->tolerances[k] = random_between(source, 0, most);
    }
    armtol_remainder(box->matrix, box->n, box->tolerances, box->remainder);
}

static double prediction(const box *box, size_t row, const double errors[])
{
    double sum = 0;
    for (size_t k = 0; k < box->n; k++) {
        sum += box->matrix[row * box->n + k] * errors[k];
    }
    return sum;
}

static double exact(const box *box, size_t row, const double errors[])
{
    double error[6];
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                          armtol_tool_error(box->links, box->n_links, errors, box->n, &box->tool, error));
    return error[row];
}

static double left_out(const box *box, size_t row, const double errors[])
{
    return fabs(exact(box, row, errors) - prediction(box, row, errors));
}

/* ---- sums of rows ---- */

static void test_sums_of_rows(void)
{
    const double matrix[12] = {3, -4, 0, 1}; /* 6 x 2 */
    const double tolerances[2] = {2, 1}, one_unbounded[2] = {INFINITY, 1};
    check_same(10, armtol_worst_error(matrix, 2, 0, tolerances), "sum of magnitudes");
    check_within(1e-15, sqrt(52), armtol_rss_error(matrix, 2, 0, tolerances), "root of the sum of squares");
    check_same(1, armtol_worst_error(matrix, 2, 1, one_unbounded), "what does not move it adds nothing");
    check_same(1, armtol_rss_error(matrix, 2, 1, one_unbounded), "nor to the squares");
    check_same(INFINITY, armtol_worst_error(matrix, 2, 0, one_unbounded), "what moves it is not bounded");
    check_same(0, armtol_worst_error(matrix, 2, 5, tolerances), "a row of zeros");
    const double small[12] = {0, 1, 1e-30, 1};
    check_same(1, armtol_worst_error(small, 2, 0, one_unbounded), "nor does a 0");
    check_same(INFINITY, armtol_worst_error(small, 2, 1, one_unbounded), "what is no 0 is not bounded");
    check_same(INFINITY, armtol_rss_error(small, 2, 1, one_unbounded), "nor is its square");
}

/* ---- corners ---- */

/* The largest value that a function of a corner has in all 2^n corners. */
static double largest_of_corners(const box *box, size_t row, int sign,
                                 double (*value)(const struct box *, size_t, const double[]))
{
    double largest = -INFINITY;
    for (unsigned bits = 0; bits < 1u << box->n; bits++) {
        double errors[COLUMNS];
        for (size_t k = 0; k < box->n; k++) {
            errors[k] = (bits >> k & 1) != 0 ? box->tolerances[k] : -box->tolerances[k];
        }
        largest = fmax(largest, sign * value(box, row, errors));
    }
    return largest;
}

static void small_arm(box *box)
{
    *box = (struct box){
        .links = {{ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 30, .d = 120, .alpha = 1.2, .theta = 0.4},
                  {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 250, .theta = -0.9, .beta = 0.01},
                  {ARMTOL_NPP, ARMTOL_PRISMATIC, .d = 90, .alpha = 0.3}},
        .n_links = 3,
        .tool = {{10, -20, 60}, ARMTOL_TOOL_FRAME},
    };
    box_start(box);
    for (size_t k = 0; k < box->n; k++) {
        box->tolerances[k] = armtol_parameter_is_length(box->columns[k].parameter) ? 1e-3 : 1e-5;
    }
}

static void test_a_corner_is_the_largest_of_all(void)
{
    box box;
    small_arm(&box);
    TEST_ASSERT_EQUAL_INT(11, box.n);
    for (size_t row = 0; row < 6; row++) {
        const double worst = armtol_worst_error(box.matrix, box.n, row, box.tolerances);
        for (int sign = -1; sign <= 1; sign += 2) {
            double errors[COLUMNS];
            armtol_corner(box.matrix, box.n, row, sign, box.tolerances, errors);
            check_within(1e-12 * worst, worst, sign * prediction(&box, row, errors), "to first order");
            check_within(1e-12 * worst, worst, largest_of_corners(&box, row, sign, prediction), "of all");
            const double most = largest_of_corners(&box, row, sign, exact);
            check_within(1e-4 * worst, most, sign * exact(&box, row, errors), "row %zu, exact", row);
        }
    }
}

static void test_what_does_not_move_the_component_stays_as_meant(void)
{
    const double matrix[18] = {5, 0, 2e-11}; /* 6 x 3 */
    const double tolerances[3] = {2, 3, 4};
    double errors[3];
    armtol_corner(matrix, 3, 0, -1, tolerances, errors);
    check_same(-2, errors[0], "first");
    check_same(0, errors[1], "zero");
    check_same(-4, errors[2], "small");
    armtol_corner(matrix, 3, 1, 1, tolerances, errors);
    check_same(0, errors[0], "a row of zeros");
}

/* ---- the remainder ---- */

/* From a corner on to where no other sign of one error makes more of what A leaves out. */
static double climb(const box *box, size_t row, double errors[])
{
    double most = left_out(box, row, errors), before;
    do {
        before = most;
        for (size_t k = 0; k < box->n; k++) {
            errors[k] = -errors[k];
            const double changed = left_out(box, row, errors);
            errors[k] = changed > most ? errors[k] : -errors[k];
            most = fmax(most, changed);
        }
    } while (most > before * (1 + 1e-9));
    return most;
}

/* The largest share of the remainder that was found of any row, none of them more than all of it. */
static double check_remainder(const box *box, random_source *source)
{
    double share = 0;
    for (size_t row = 0; row < 6; row++) {
        double errors[COLUMNS];
        for (size_t k = 0; k < box->n; k++) {
            errors[k] = random_between(source, -1, 1) < 0 ? -box->tolerances[k] : box->tolerances[k];
        }
        const double most = climb(box, row, errors);
        const double rounding = row < 3 ? 1e-11 : 1e-14;
        if (!(most <= box->remainder[row] + rounding)) {
            check_within(0, box->remainder[row], most, "row %zu leaves out more than the remainder", row);
        }
        share = box->remainder[row] > 1e3 * rounding ? fmax(share, most / box->remainder[row]) : share;
    }
    return share;
}

static double sum_of_angles(const box *box)
{
    double sum = 0;
    for (size_t k = 0; k < box->n; k++) {
        sum += armtol_parameter_is_length(box->columns[k].parameter) ? 0 : box->tolerances[k];
    }
    return sum;
}

static double check_random_boxes(double angle, double length, int tries)
{
    random_source source = {3};
    double share = 0;
    for (int i = 0; i < tries; i++) {
        box box;
        box_of(&source, angle, length, &box);
        if (sum_of_angles(&box) < pi) {
            share = fmax(share, check_remainder(&box, &source));
        }
    }
    return share;
}

static void test_the_remainder_holds_in_random_boxes(void)
{
    TEST_ASSERT_TRUE(check_random_boxes(1e-5, 1e-3, 40) > 0.9);
    TEST_ASSERT_TRUE(check_random_boxes(1e-3, 1, 40) > 0.9);
    TEST_ASSERT_TRUE(check_random_boxes(0.02, 10, 40) > 0.8);
    TEST_ASSERT_TRUE(check_random_boxes(0.3, 100, 100) > 0.5);
    check_random_boxes(1, 300, 100);
}

/* A link that only turns by t leaves out a (1 - cos t) along itself and a (t - sin t) across. */
static void test_the_remainder_of_one_link(void)
{
    box box = {.links = {{ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 400}}, .n_links = 1, .tolerances = {0.1}};
    box_start(&box);
    armtol_remainder(box.matrix, box.n, box.tolerances, box.remainder);
    check_within(0.002, 400 * (1 - cos(0.1)), box.remainder[0], "along");
    check_within(0.0001, 400 * (0.1 - sin(0.1)), box.remainder[1], "across");
    TEST_ASSERT_TRUE(400 * (1 - cos(0.1)) <= box.remainder[0]);
    TEST_ASSERT_TRUE(400 * (0.1 - sin(0.1)) <= box.remainder[1]);
    for (int i = 3; i < 6; i++) {
        check_same(0, box.remainder[i], "component %d", i);
    }
}

/* Turns by s about z and by t about the x that it turns: the rotation vector is off by s t / 2 about y. */
static void test_the_remainder_of_two_turns(void)
{
    box box = {.links = {{ARMTOL_NPR, ARMTOL_REVOLUTE}}, .n_links = 1, .tolerances = {0.004, 0, 0, 0.003}};
    box_start(&box);
    armtol_remainder(box.matrix, box.n, box.tolerances, box.remainder);
    const double missing = left_out(&box, 4, box.tolerances);
    check_within(1e-9, 0.004 * 0.003 / 2, missing, "what A leaves out");
    TEST_ASSERT_TRUE(missing <= box.remainder[4]);
    check_within(0.01 * missing, missing, box.remainder[4], "remainder");
}

/* About axes that are 0.3 apart A leaves out less. */
static void test_the_remainder_of_turns_about_near_axes(void)
{
    box box = {.links = {{ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = 0.3}, {ARMTOL_NPR, ARMTOL_REVOLUTE}},
               .n_links = 2,
               .tolerances = {[0] = 0.004, [4] = 0.003}};
    box_start(&box);
    armtol_remainder(box.matrix, box.n, box.tolerances, box.remainder);
    const double missing = left_out(&box, 3, box.tolerances);
    check_within(1e-8, 0.004 * 0.003 * sin(0.3) / 2, missing, "what A leaves out");
    TEST_ASSERT_TRUE(missing <= box.remainder[3]);
    check_within(0.02 * missing, missing, box.remainder[3], "remainder");
}

/*
 * Two links of length 400 folded onto each other, the tool on the first axis: p = 400 e^is (1 - e^it). Of its
 * part across the links A leaves out 400 s^2 t / 2 and less, since errors move the tool off that axis.
 */
static void test_the_remainder_of_a_folded_arm(void)
{
    box box = {.links = {{ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 400},
                         {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 400, .theta = pi}},
               .n_links = 2,
               .tolerances = {[0] = 0.1, [4] = 0.01}};
    box_start(&box);
    armtol_remainder(box.matrix, box.n, box.tolerances, box.remainder);
    const double missing = left_out(&box, 1, box.tolerances);
    check_within(0.003, 400 * 0.1 * 0.1 * 0.01 / 2, missing, "what A leaves out");
    TEST_ASSERT_TRUE(missing <= box.remainder[1]);
    check_within(0.2 * missing, missing, box.remainder[1], "remainder");
}

/* An angle before a length takes the length with it; behind it, it does not. */
static void test_the_order_of_parameters_counts(void)
{
    /* npr: theta d a alpha */
    box before = {.links = {{ARMTOL_NPR, ARMTOL_REVOLUTE}}, .n_links = 1, .tolerances = {0.001, 0, 2, 0}};
    box behind = {.links = {{ARMTOL_NPR, ARMTOL_REVOLUTE}}, .n_links = 1, .tolerances = {0, 0, 2, 0.001}};
    box_start(&before);
    box_start(&behind);
    armtol_remainder(before.matrix, before.n, before.tolerances, before.remainder);
    armtol_remainder(behind.matrix, behind.n, behind.tolerances, behind.remainder);
    check_within(1e-5, 2 * sin(0.001), before.remainder[1], "angle before length");
    TEST_ASSERT_TRUE(before.remainder[1] >= 2 * sin(0.001));
    for (int i = 0; i < 6; i++) {
        check_same(0, behind.remainder[i], "length before angle, component %d", i);
    }
}

static void test_without_tolerances_nothing_remains(void)
{
    box box;
    small_arm(&box);
    const double none[COLUMNS] = {0};
    armtol_remainder(box.matrix, box.n, none, box.remainder);
    for (int i = 0; i < 6; i++) {
        check_same(0, box.remainder[i], "component %d", i);
    }
}

static void test_where_it_is_not_bounded(void)
{
    box box = {.links = {{ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 400}}, .n_links = 1};
    const double below[4] = {3.1, 5, 5, 0.04}, above[4] = {3.1, 5, 5, 0.05};
    box_start(&box);
    armtol_remainder(box.matrix, box.n, below, box.remainder);
    for (int i = 0; i < 6; i++) {
        TEST_ASSERT_TRUE(isfinite(box.remainder[i]));
    }
    armtol_remainder(box.matrix, box.n, above, box.remainder);
    for (int i = 0; i < 6; i++) {
        TEST_ASSERT_TRUE(i < 3 ? isfinite(box.remainder[i]) : isinf(box.remainder[i]));
    }
    for (int k = 0; k < 4; k++) {
        double unbounded[4] = {0}, no_number[4] = {0};
        unbounded[k] = INFINITY;
        no_number[k] = NAN;
        for (int i = 0; i < 6; i++) {
            armtol_remainder(box.matrix, box.n, unbounded, box.remainder);
            check_same(INFINITY, box.remainder[i], "an infinite tolerance, %d, %d", k, i);
            armtol_remainder(box.matrix, box.n, no_number, box.remainder);
            check_same(INFINITY, box.remainder[i], "no number, %d, %d", k, i);
        }
    }
}

/* A lever whose square overflows, and tolerances whose product underflows: 0 times infinity bounds nothing. */
static void test_what_is_too_large_is_not_bounded(void)
{
    const double matrix[6 * 2] = {[1] = 1e200, [6] = 1, [7] = 1}, tolerances[2] = {1e-200, 1e-200};
    double remainder[6];
    armtol_remainder(matrix, 2, tolerances, remainder);
    for (int i = 0; i < 3; i++) {
        check_same((double)INFINITY, remainder[i], "component %d", i);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_sums_of_rows);
    RUN_TEST(test_a_corner_is_the_largest_of_all);
    RUN_TEST(test_what_does_not_move_the_component_stays_as_meant);
    RUN_TEST(test_the_remainder_holds_in_random_boxes);
    RUN_TEST(test_the_remainder_of_one_link);
    RUN_TEST(test_the_remainder_of_two_turns);
    RUN_TEST(test_the_remainder_of_turns_about_near_axes);
    RUN_TEST(test_the_remainder_of_a_folded_arm);
    RUN_TEST(test_the_order_of_parameters_counts);
    RUN_TEST(test_without_tolerances_nothing_remains);
    RUN_TEST(test_where_it_is_not_bounded);
    RUN_TEST(test_what_is_too_large_is_not_bounded);
    return UNITY_END();
}
