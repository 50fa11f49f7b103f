/* Rows and norms of which some tolerances are radii of discs: along every direction, and over all of them. */

#include "lib/norms/discs.h"
#include "lib/norms/norm_discs.h"
#include "lib/norms/spread_norm.h"
#include "lib/spread/answer_spread.h"

#include "lib/norms/cover.h"
#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 20 };

static const unsigned all_norms[ARMTOL_MOST_NORMS] = {007, 003, 005, 006, 070, 030, 050, 060};

void setUp(void)
{
}

void tearDown(void)
{
}

typedef struct sums {
    size_t n;
    unsigned components;
    double matrix[6 * COLUMNS], shifts[COLUMNS], tolerances[COLUMNS];
    bool discs[COLUMNS];
} sums;

/* Every third column or so begins a disc; some columns are along the one before, and some see nothing. */
static void draw_sums(random_source *source, size_t n, sums *sums)
{
    *sums = (struct sums){.n = n, .components = all_norms[random_bits(source) % ARMTOL_MOST_NORMS]};
    for (size_t k = 0; k < n; k++) {
        const double kind = random_between(source, 0, 1), factor = random_between(source, -2, 2);
        for (size_t i = 0; i < 6; i++) {
            double *element = &sums->matrix[i * n + k];
            *element = kind < 0.1 ? 0 : kind < 0.2 && k > 0 ? factor * element[-1] : random_between(source, -1, 1);
        }
        sums->shifts[k] = random_bits(source) % 4 == 0 ? random_between(source, -1, 1) : 0;
        sums->tolerances[k] = pow(10, random_between(source, -3, 1));
        if (k > 0 && !discs_have(sums->discs, k - 1) && random_bits(source) % 3 == 0) {
            sums->discs[k - 1] = true;
            sums->tolerances[k] = sums->tolerances[k - 1];
        }
    }
}

/* A disc's share along a direction is the radius times the length of what the direction sees of its two columns. */
static double along(const double wide[6], const sums *sums)
{
    double shift = 0, sum = 0, elements[COLUMNS + 1] = {0};
    for (size_t k = 0; k < sums->n; k++) {
        for (size_t i = 0; i < 6; i++) {
            elements[k] += wide[i] * sums->matrix[i * sums->n + k];
        }
        shift += elements[k] * sums->shifts[k];
    }
    for (size_t k = 0; k < sums->n; k++) {
        const bool second = k > 0 && sums->discs[k - 1];
        const double length = sums->discs[k] ? hypot(elements[k], elements[k + 1]) : fabs(elements[k]);
        sum += second ? 0 : sums->tolerances[k] * length;
    }
    return fabs(shift) + sum;
}

/* Three components of a direction, those that are not the norm's left out. */
static double support_of(const double direction[3], const void *context)
{
    const sums *sums = context;
    double wide[6];
    for (size_t i = 0; i < 6; i++) {
        wide[i] = (sums->components >> i & 1) != 0 ? direction[i % 3] : 0;
    }
    return along(wide, sums);
}

static double worst_of(const sums *sums, double direction[6])
{
    double *workspace = calloc(norm_discs_workspace(sums->n, discs_count(sums->discs, sums->n)), sizeof *workspace);
    TEST_ASSERT_NOT_NULL(workspace);
    const double worst = norm_discs_worst(sums->matrix, sums->n, sums->components, sums->shifts, sums->tolerances,
                                          sums->discs, direction, workspace);
    free(workspace);
    return worst;
}

/*
 * Branch and bound over directions, which knows nothing of polygons, finds no more; and along the direction that is
 * told nearly all of it is reached.
 */
static void test_the_farthest_point_of_discs(void)
{
    enum { CASES = 60 };
    random_source source = {4171};
    size_t with_discs = 0;
    for (int i = 0; i < CASES; i++) {
        sums sums;
        double direction[6], squares = 0;
        draw_sums(&source, 2 + random_bits(&source) % (COLUMNS - 1), &sums);
        with_discs += discs_count(sums.discs, sums.n) > 0;
        const double worst = worst_of(&sums, direction), reached = along(direction, &sums);
        const double bound = cover_of_sphere(support_of, &sums, 1e-4);
        for (size_t j = 0; j < 6; j++) {
            squares += direction[j] * direction[j];
            TEST_ASSERT_TRUE((sums.components >> j & 1) != 0 || direction[j] == 0);
        }
        check_within(1e-14, 1, squares, "a unit vector");
        TEST_ASSERT_TRUE(worst >= reached * (1 - 1e-14) && worst <= reached * (1 + 1.1e-12));
        TEST_ASSERT_TRUE(bound >= worst * (1 - 1e-12) && bound <= worst * (1 + 1.01e-4));
    }
    TEST_ASSERT_TRUE(with_discs > CASES / 2);
}

/* Two columns alone: the longer half axis of an ellipse, by the eigenvalues of its two rows. */
static void test_a_disc_alone_is_an_ellipse(void)
{
    random_source source = {4172};
    for (int i = 0; i < 200; i++) {
        sums sums = {.n = 2, .components = 003, .tolerances = {0.7, 0.7}, .discs = {true, false}};
        double direction[6];
        for (int k = 0; k < 4; k++) {
            sums.matrix[k] = random_between(&source, -1, 1);
        }
        const double a = sums.matrix[0], b = sums.matrix[1], c = sums.matrix[2], d = sums.matrix[3];
        const double xx = a * a + b * b, yy = c * c + d * d, xy = a * c + b * d;
        const double longest = sqrt((xx + yy) / 2 + hypot((xx - yy) / 2, xy));
        check_within(2e-12, 0.7 * longest, worst_of(&sums, direction), "half axis");
    }
}

/* Of a disc that a norm sees as a line, from the side: a segment as any other. */
static void test_a_disc_from_the_side_is_a_segment(void)
{
    sums sums = {.n = 3, .components = 007, .tolerances = {2, 2, 1}, .discs = {true, false, false},
                 .matrix = {3, 4, 0, 0, 0, 1}};
    double direction[6];
    check_within(1e-11, sqrt(101), worst_of(&sums, direction), "10 along x, 1 along y");
    sums.matrix[0] = sums.matrix[1] = 0;
    check_within(1e-15, 1, worst_of(&sums, direction), "of a disc that is not seen nothing");
}

/* Every direction is as far. */
static void test_discs_that_lie_in_all_directions(void)
{
    sums sums = {.n = 2, .components = 003, .tolerances = {1, 1}, .discs = {true, false}, .matrix = {1, 0, 0, 1}};
    double direction[6];
    check_within(1e-11, 1, worst_of(&sums, direction), "a round disc");
    sums.shifts[0] = 3;
    check_within(1e-11, 4, worst_of(&sums, direction), "about a point");
    check_within(1e-6, 1, direction[0], "away from it");
}

/* Discs of one shape are one, whatever the directions of their own two axes; so a circle of them stays exact. */
static void test_discs_of_one_shape_add_up(void)
{
    const double c = 0.6, s = 0.8;
    sums sums = {.n = 5, .components = 003, .tolerances = {1, 1, 2, 2, 0.5}, .discs = {true, false, true, false, false},
                 .matrix = {1, 0, c, -s, 0, 0, 1, s, c, 1}};
    double direction[6];
    check_within(1e-14, 3.5, worst_of(&sums, direction), "two round discs and a segment along y");
    check_within(1e-6, 1, direction[1], "along y");
}

/* All directions are as far, of two shapes: the tangents run out, and what is told is too much by no more than said. */
static void test_two_shapes_in_a_circle(void)
{
    sums sums = {.n = 4, .components = 003, .tolerances = {1, 1, 1, 1}, .discs = {true, false, true, false},
                 .matrix = {1, 1e-9, 1, 0, 0, 1, 0, 1}};
    double direction[6];
    const double worst = worst_of(&sums, direction);
    TEST_ASSERT_TRUE(worst > 2 + 1e-9 / 2 && worst < 2 + 3.1e-4);
    TEST_ASSERT_TRUE(along(direction, &sums) > 2 - 1e-8);
}

/* ---- rows ---- */

static const double row[] = {2, 3, -4, 5, 0, 0}, tolerances[] = {0.1, 0.2, 0.2, 0.3, 7, 7};
static const bool discs[] = {false, true, false, false, true, false};

static void test_a_row_s_worst_case(void)
{
    check_within(1e-15, 0.2 + 0.2 * 5 + 1.5, discs_worst(row, 6, tolerances, discs), "a disc counts by its length");
    check_within(1e-15, 0.2 + 0.2 * 7 + 1.5, discs_worst(row, 6, tolerances, NULL), "each by itself");
    check_within(1e-15, 1, discs_worst_part(row, 1, tolerances, discs), "the disc's part is in its first column");
    check_same(0, discs_worst_part(row, 2, tolerances, discs), "the other");
    check_same(0, discs_worst_part(row, 4, tolerances, discs), "of what is not seen");
    TEST_ASSERT_EQUAL_UINT(2, discs_count(discs, 6));
    TEST_ASSERT_EQUAL_UINT(0, discs_count(NULL, 6));
}

/* An axis of a disc of radius r has the variance r^2 / 4: of r^2 / 3 three quarters. */
static void test_a_row_s_squares(void)
{
    const double of_disc = 3 * (0.2 * 0.2 / 4) * (9 + 16);
    double factors[6] = {1, DISC_FACTOR, DISC_FACTOR, 1, DISC_FACTOR, DISC_FACTOR};
    size_t leaders[6] = {0, 1, 2, 3, 4, 5};
    const armtol_answer answer = {.n_columns = 6, .factors = factors, .leaders = leaders};
    check_within(1e-15, sqrt(0.04 + of_disc + 2.25), spread_rss(&answer, row, tolerances), "with a disc");
    factors[1] = factors[2] = 1;
    check_within(1e-15, sqrt(0.04 + 1 + 2.25), spread_rss(&answer, row, tolerances), "without");
}

static void test_the_corner_is_on_the_rim(void)
{
    double errors[6];
    for (int sign = -1; sign <= 1; sign += 2) {
        double sum = 0;
        discs_corner(row, 6, sign, tolerances, discs, errors);
        for (int k = 0; k < 6; k++) {
            sum += row[k] * errors[k];
        }
        check_within(1e-15, 0.2, hypot(errors[1], errors[2]), "the radius");
        check_within(1e-15, sign * 2.7, sum, "the row's worst case");
        check_same(0, errors[4], "what does nothing");
    }
    discs_corner(row, 6, 1, tolerances, NULL, errors);
    check_same(-0.2, errors[2], "without discs");
}

/* ---- standard deviations of norms ---- */

/* The mean of squares over the disc itself, in rings and sectors. */
static double squares_over_disc(const double at[2])
{
    enum { RINGS = 200, SECTORS = 64 };
    double sum = 0, area = 0;
    for (int i = 0; i < RINGS; i++) {
        const double r = (i + 0.5) / RINGS;
        for (int j = 0; j < SECTORS; j++) {
            const double phi = j * 2 * acos(-1) / SECTORS, value = r * (at[0] * cos(phi) + at[1] * sin(phi));
            sum += r * value * value;
            area += r;
        }
    }
    return sum / area;
}

static void test_the_deviation_of_a_disc(void)
{
    sums sums = {.n = 3, .components = 003, .tolerances = {2, 2, 0}, .discs = {true, false, false},
                 .matrix = {3, 4, 0, 0, 0, 0}};
    double direction[6];
    const double at[2] = {6, 8};
    double factors[3] = {DISC_FACTOR, DISC_FACTOR, 1};
    size_t leaders[3] = {0, 1, 2};
    const armtol_answer answer = {.n_columns = 3, .matrices = sums.matrix, .factors = factors, .leaders = leaders};
    const double deviation = spread_norm(&answer, 0, 003, NULL, sums.tolerances, 1 / sqrt(3), direction);
    check_within(1e-3, sqrt(squares_over_disc(at)), deviation, "along x");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_farthest_point_of_discs);
    RUN_TEST(test_a_disc_alone_is_an_ellipse);
    RUN_TEST(test_a_disc_from_the_side_is_a_segment);
    RUN_TEST(test_discs_that_lie_in_all_directions);
    RUN_TEST(test_discs_of_one_shape_add_up);
    RUN_TEST(test_two_shapes_in_a_circle);
    RUN_TEST(test_a_row_s_worst_case);
    RUN_TEST(test_a_row_s_squares);
    RUN_TEST(test_the_corner_is_on_the_rim);
    RUN_TEST(test_the_deviation_of_a_disc);
    return UNITY_END();
}
