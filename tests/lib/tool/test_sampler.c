#include "armtol/error_matrix.h"
#include "armtol/sampler.h"

#include "lib/tool/kernels.h"
#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"
#include "unity.h"

#include <math.h>
#include <string.h>

enum { MOST_LINKS = 12, MOST_COLUMNS = MOST_LINKS * ARMTOL_PARAMETER_COUNT, ARMS = 100 };

#define PI 3.14159265358979323846

static armtol_link links[MOST_LINKS], built[MOST_LINKS];
static armtol_sampled_link prepared[MOST_LINKS];
static armtol_sampler sampler;
static double tolerances[MOST_COLUMNS], parameters[MOST_COLUMNS];
static double errors[6 * ARMS], others[6 * ARMS];

void setUp(void)
{
}

void tearDown(void)
{
}

static void random_links(uint64_t seed, size_t n)
{
    random_source source = {seed};
    for (size_t i = 0; i < n; i++) {
        links[i] = (armtol_link){
            .kind = (armtol_kind)((i + seed) % ARMTOL_KIND_COUNT),
            .a = random_between(&source, -0.5, 0.5),
            .alpha = i % 4 == 3 ? 0 : random_between(&source, -3, 3),
            .d = random_between(&source, -0.5, 0.5),
            .theta = i % 5 == 4 ? 0 : random_between(&source, -3, 3),
            .beta = i % 2 == 0 ? 0 : random_between(&source, -1, 1),
        };
    }
}

static size_t start(size_t n_links, const armtol_tool_point *tool, uint64_t seed)
{
    const size_t n = armtol_column_count(links, n_links);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                          armtol_sampler_start(&sampler, prepared, links, n_links, tolerances, n, tool,
                                               seed));
    return n;
}

/* Every seventh parameter is exact, so that a link has three to five that are not. */
static void set_tolerances(size_t n, double length, double angle, size_t n_links)
{
    armtol_column columns[MOST_COLUMNS];
    armtol_columns(links, n_links, columns, n);
    for (size_t k = 0; k < n; k++) {
        tolerances[k] = k % 7 == 4 ? 0 : armtol_parameter_is_length(columns[k].parameter) ? length : angle;
    }
}

/* ---- by the plain definition ---- */

static void build(size_t n_links)
{
    size_t k = 0;
    for (size_t i = 0; i < n_links; i++) {
        size_t count;
        const armtol_parameter *of_link = armtol_kind_parameters(links[i].kind, &count);
        double *const fields[ARMTOL_PARAMETER_COUNT] = {
            [ARMTOL_THETA] = &built[i].theta, [ARMTOL_D] = &built[i].d, [ARMTOL_A] = &built[i].a,
            [ARMTOL_ALPHA] = &built[i].alpha, [ARMTOL_BETA] = &built[i].beta,
        };
        built[i] = links[i];
        for (size_t j = 0; j < count; j++) {
            *fields[of_link[j]] += parameters[k++];
        }
    }
}

/* The rotation by a vector: I + sin/angle V + (1 - cos)/angle^2 V^2, V v = vector x v. */
static void rotation_by(const double vector[3], double r[3][3])
{
    const double angle = sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    const double s = angle > 0 ? sin(angle) / angle : 1;
    const double c = angle > 0 ? 2 * pow(sin(angle / 2) / angle, 2) : 0.5;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        r[i][i] = 1 - c * (vector[j] * vector[j] + vector[k] * vector[k]);
        r[i][j] = c * vector[i] * vector[j] - s * vector[k];
        r[j][i] = c * vector[i] * vector[j] + s * vector[k];
    }
}

/* R as meant, turned by the vector along its own or along the base's axes, is R as built. */
static void check_rotation(const double vector[3], armtol_frame frame, double meant[4][4], double is[4][4],
                           double tolerance)
{
    double r[3][3];
    rotation_by(vector, r);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            double turned = 0;
            for (int n = 0; n < 3; n++) {
                turned += frame == ARMTOL_BASE_FRAME ? r[i][n] * meant[n][j] : meant[i][n] * r[n][j];
            }
            check_within(tolerance, is[i][j], turned, "the rotation, element %d %d", i, j);
        }
    }
    const double angle = sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    TEST_ASSERT_TRUE(angle <= PI + 1e-12);
}

static void check_displacement(const double displacement[3], const armtol_tool_point *tool,
                               double meant[4][4], double is[4][4], double tolerance)
{
    double moved[3], along[3];
    for (int i = 0; i < 3; i++) {
        moved[i] = is[i][3] - meant[i][3];
        for (int j = 0; j < 3; j++) {
            moved[i] += (is[i][j] - meant[i][j]) * tool->offset[j];
        }
    }
    for (int i = 0; i < 3; i++) {
        along[i] = meant[0][i] * moved[0] + meant[1][i] * moved[1] + meant[2][i] * moved[2];
        check_within(tolerance, tool->frame == ARMTOL_BASE_FRAME ? moved[i] : along[i], displacement[i],
                     "the displacement, component %d", i);
    }
}

static void check_arms(size_t n_links, const armtol_tool_point *tool, uint64_t first, double tolerance)
{
    double meant[4][4], is[4][4];
    armtol_sampler_draw(&sampler, first, ARMS, errors);
    reference_chain(links, n_links, meant);
    for (size_t j = 0; j < ARMS; j++) {
        double error[6];
        for (size_t i = 0; i < 6; i++) {
            error[i] = errors[i * ARMS + j];
        }
        armtol_sampler_parameters(&sampler, first + j, parameters);
        build(n_links);
        reference_chain(built, n_links, is);
        check_displacement(error, tool, meant, is, tolerance);
        check_rotation(error + 3, tool->frame, meant, is, tolerance);
    }
}

/* Arms of every kind of link, about a metre an arm. */
static void check_tolerances_of(double length, double angle)
{
    for (uint64_t seed = 0; seed < MOST_LINKS; seed++) {
        const armtol_tool_point tool = {{0.1, -0.2, 0.3},
                                        seed % 2 == 0 ? ARMTOL_BASE_FRAME : ARMTOL_TOOL_FRAME};
        const size_t n_links = 1 + seed;
        random_links(seed, n_links);
        set_tolerances(armtol_column_count(links, n_links), length, angle, n_links);
        start(n_links, &tool, seed);
        check_arms(n_links, &tool, seed * 1000, 3e-14);
    }
}

static void test_errors_are_those_of_the_definition_for_small_tolerances(void)
{
    check_tolerances_of(1e-4, 1e-4);
    check_tolerances_of(1e-3, 1e-3);
    check_tolerances_of(1e-3, 1.0 / 128);
}

static void test_errors_are_those_of_the_definition_for_large_tolerances(void)
{
    check_tolerances_of(1e-3, 0.0079);
    check_tolerances_of(0.05, 0.02);
    check_tolerances_of(0.5, 0.5);
    check_tolerances_of(2, 3);
}

static void test_no_tolerance_is_no_error(void)
{
    check_tolerances_of(0, 0);
    for (size_t i = 0; i < 6 * ARMS; i++) {
        check_within(1e-14, 0, errors[i], "component %zu", i / ARMS);
    }
}

/* ---- one link, of which the answer is known ---- */

/* theta off by e: the tool, one length ahead, moves by (cos e - 1, sin e) and turns by e about z. */
static void check_turn(double tolerance, double within, double of_turn)
{
    links[0] = (armtol_link){.a = 1};
    memset(tolerances, 0, sizeof tolerances);
    tolerances[0] = tolerance;
    start(1, &armtol_tool_origin, 3);
    armtol_sampler_draw(&sampler, 0, ARMS, errors);
    double largest = 0;
    for (size_t j = 0; j < ARMS; j++) {
        armtol_sampler_parameters(&sampler, j, parameters);
        const double e = parameters[0], twice_sine = sin(e / 2);
        const double turn = atan2(sin(e), cos(e));
        check_within(within, -2 * twice_sine * twice_sine, errors[0 * ARMS + j], "x for %.17g", e);
        check_within(within, sin(e), errors[1 * ARMS + j], "y for %.17g", e);
        check_within(of_turn, turn, errors[5 * ARMS + j], "the turn for %.17g", e);
        check_same(0, errors[3 * ARMS + j], "the turn about x");
        largest = fmax(largest, fabs(e));
    }
    TEST_ASSERT_TRUE(largest > 0.95 * tolerance);
}

static void test_series_are_good_to_rounding_up_to_where_they_end(void)
{
    check_turn(1e-6, 3e-16, 1e-16);
    check_turn(1.0 / 128, 3e-16, 1e-16);
    check_turn(1.0 / 4, 3e-16, 1e-16);
    check_turn(0.26, 4e-16, 2e-16);
}

/*
 * The largest of the draws becomes almost a half turn, where next to nothing of the turn's sine is left:
 * about z (theta), x (alpha) and y (beta).
 */
static void check_half_turn(size_t column, size_t axis, double less)
{
    double largest = 0;
    for (uint64_t j = 0; j < ARMS; j++) {
        largest = fmax(largest, fabs(armtol_sampler_uniform(3, 4 * j + column)));
    }
    links[0] = (armtol_link){.kind = ARMTOL_PPR};
    memset(tolerances, 0, sizeof tolerances);
    tolerances[column] = (PI - less) / largest;
    start(1, &armtol_tool_origin, 3);
    armtol_sampler_draw(&sampler, 0, ARMS, errors);
    for (size_t j = 0; j < ARMS; j++) {
        armtol_sampler_parameters(&sampler, j, parameters);
        for (size_t i = 0; i < 3; i++) {
            check_within(2e-15, i == axis ? parameters[column] : 0, errors[(i + 3) * ARMS + j],
                         "component %zu for %.17g about axis %zu", i, parameters[column], axis);
        }
    }
}

static void test_almost_half_turns(void)
{
    const double less[] = {1e-3, 1e-6, 1e-9};
    for (int n = 0; n < 3; n++) {
        check_half_turn(0, 2, less[n]);
        check_half_turn(2, 0, less[n]);
        check_half_turn(3, 1, less[n]);
    }
}

static void test_turns_of_any_size(void)
{
    check_turn(0.8, 5e-16, 5e-16);
    check_turn(1.6, 5e-16, 5e-16);
    check_turn(PI, 5e-16, 1e-15);
    check_turn(7, 1e-15, 2e-15);
    check_turn(1e5, 1e-15, 2e-15);
    check_turn(3e6, 1e-15, 2e-15);
}

/* ---- draws ---- */

/* A state that is mixed once more than the generator's own, to which it goes back by a step. */
static double draw_of(uint64_t seed, uint64_t number)
{
    static const uint64_t step = 0x9e3779b97f4a7c15u;
    random_source mixed = {seed - step};
    random_source source = {random_bits(&mixed) + number * step};
    return random_between(&source, -1, 1);
}

static void test_draws_are_splitmix64_from_a_mixed_seed(void)
{
    for (uint64_t n = 0; n < 2000; n++) {
        check_same(draw_of(n / 100, n * n), armtol_sampler_uniform(n / 100, n * n), "draw %d", (int)n);
    }
    check_same(draw_of(1, UINT64_MAX), armtol_sampler_uniform(1, UINT64_MAX), "the last draw");
}

static void test_parameters_are_shares_of_their_tolerances(void)
{
    random_links(2, 5);
    set_tolerances(armtol_column_count(links, 5), 0.25, 2, 5);
    const size_t n = start(5, &armtol_tool_origin, 17);
    for (uint64_t arm = 0; arm < 50; arm++) {
        armtol_sampler_parameters(&sampler, arm, parameters);
        for (size_t k = 0; k < n; k++) {
            check_same(tolerances[k] * draw_of(17, arm * n + k), parameters[k], "column %zu", k);
        }
    }
}

/*
 * However the arms are divided, wherever a part begins, and with every width of vectors of this machine: the same bits.
 */
static void check_split(const kernels *kernels, uint64_t first, size_t part)
{
    for (size_t done = 0; done < ARMS; done += part) {
        const size_t count = part < ARMS - done ? part : ARMS - done;
        double some[6 * ARMS + 1];
        some[6 * count] = 42;
        kernels->draw(&sampler, first + done, count, some);
        for (size_t i = 0; i < 6; i++) {
            TEST_ASSERT_EQUAL_MEMORY(errors + i * ARMS + done, some + i * count, count * sizeof some[0]);
        }
        check_same(42, some[6 * count], "behind the errors");
    }
}

static void test_the_same_bits_for_any_split(void)
{
    for (int large = 0; large < 2; large++) {
        random_links(7, 6);
        set_tolerances(armtol_column_count(links, 6), 0.01, large ? 0.4 : 0.001, 6);
        start(6, &armtol_tool_origin, 5);
        const uint64_t firsts[] = {0, 3, 1000000007, UINT64_MAX - 50};
        for (size_t n = 0; n < sizeof firsts / sizeof firsts[0]; n++) {
            armtol_sampler_draw(&sampler, firsts[n], ARMS, errors);
            for (size_t part = 1; part <= ARMS; part += part < 20 ? 1 : 13) {
                check_split(kernels_of_machine(2 << part % 3), firsts[n], part);
            }
        }
    }
}

/* Discs of all links that can have one; their draws are as wide vectors make them. */
static void test_discs_have_the_same_bits_for_any_width(void)
{
    bool discs[MOST_COLUMNS] = {false};
    armtol_column columns[MOST_COLUMNS];
    random_links(7, 6);
    const size_t n = armtol_column_count(links, 6);
    armtol_columns(links, 6, columns, n);
    for (size_t k = 0; k < n; k++) {
        tolerances[k] = 0.01;
        discs[k] = k + 1 < n && columns[k].parameter == ARMTOL_ALPHA && columns[k + 1].parameter == ARMTOL_BETA;
    }
    start(6, &armtol_tool_origin, 5);
    armtol_sampler_draw(&sampler, 3, ARMS, others);
    armtol_sampler_discs(&sampler, prepared, discs);
    armtol_sampler_draw(&sampler, 3, ARMS, errors);
    for (size_t i = 0; i < 6 * ARMS; i++) {
        TEST_ASSERT_TRUE(errors[i] != others[i]);
    }
    for (size_t part = 1; part <= ARMS; part += part < 20 ? 1 : 13) {
        check_split(kernels_of_machine(2 << part % 3), 3, part);
    }
}

/* Every distribution, and groups across links. */
static void spread_out(size_t n)
{
    static armtol_error_spread spreads[MOST_COLUMNS];
    for (size_t k = 0; k < n; k++) {
        spreads[k] = (armtol_error_spread){(armtol_distribution)(k % ARMTOL_DISTRIBUTION_COUNT), 2, 5, k % 8 == 1};
    }
    armtol_sampler_spread(&sampler, prepared, spreads);
}

static void test_spread_errors_are_those_of_the_definition(void)
{
    const armtol_tool_point tool = {{0.1, -0.2, 0.3}, ARMTOL_BASE_FRAME};
    for (int large = 0; large < 2; large++) {
        random_links(11, 8);
        set_tolerances(armtol_column_count(links, 8), 0.01, large ? 0.4 : 0.001, 8);
        spread_out(start(8, &tool, 4));
        check_arms(8, &tool, 1000, 3e-14);
    }
}

static void test_the_same_bits_for_any_split_of_spread_errors(void)
{
    random_links(7, 6);
    set_tolerances(armtol_column_count(links, 6), 0.01, 0.001, 6);
    spread_out(start(6, &armtol_tool_origin, 5));
    armtol_sampler_draw(&sampler, 3, ARMS, errors);
    for (size_t part = 1; part <= ARMS; part += part < 20 ? 1 : 13) {
        check_split(kernels_of_machine(2 << part % 3), 3, part);
    }
}

/* A column's part of its tolerance is the distribution's of its own draw, or of that of its group's first. */
static void test_parameters_are_spread(void)
{
    random_links(2, 5);
    set_tolerances(armtol_column_count(links, 5), 0.25, 2, 5);
    const size_t n = start(5, &armtol_tool_origin, 17);
    spread_out(n);
    for (uint64_t arm = 0; arm < 50; arm++) {
        armtol_sampler_parameters(&sampler, arm, parameters);
        for (size_t k = 0; k < n; k++) {
            const armtol_error_spread of = {(armtol_distribution)(k % ARMTOL_DISTRIBUTION_COUNT), 2, 0, 0};
            const armtol_shape shape = armtol_shape_of(&of);
            const double draw = draw_of(17, arm * n + (k % 8 == 1 ? 1 : k));
            check_same(tolerances[k] * armtol_shape_value(&shape, draw), parameters[k], "column %zu", k);
        }
    }
}

static void test_other_seeds_are_other_arms(void)
{
    random_links(7, 6);
    set_tolerances(armtol_column_count(links, 6), 0.01, 0.01, 6);
    start(6, &armtol_tool_origin, 5);
    armtol_sampler_draw(&sampler, 0, ARMS, errors);
    start(6, &armtol_tool_origin, 6);
    armtol_sampler_draw(&sampler, 0, ARMS, others);
    for (size_t i = 0; i < 6 * ARMS; i++) {
        TEST_ASSERT_TRUE(errors[i] != others[i]);
    }
}

/* ---- what is refused ---- */

static void check_refused(armtol_status status, size_t n_links, size_t n_columns,
                          const armtol_tool_point *tool)
{
    sampler.n_links = 42;
    TEST_ASSERT_EQUAL_INT(status, armtol_sampler_start(&sampler, prepared, links, n_links, tolerances,
                                                       n_columns, tool, 1));
    TEST_ASSERT_EQUAL_INT(42, sampler.n_links);
}

static void test_what_cannot_be_drawn_is_refused(void)
{
    const armtol_tool_point nowhere = {{0, 0, (double)INFINITY}, ARMTOL_BASE_FRAME};
    memset(tolerances, 0, sizeof tolerances);
    random_links(0, 1);
    check_refused(ARMTOL_NO_LINKS, 0, 0, &armtol_tool_origin);
    check_refused(ARMTOL_WRONG_SIZE, 1, 3, &armtol_tool_origin);
    check_refused(ARMTOL_NOT_FINITE, 1, 4, &nowhere);
    tolerances[3] = -1e-300;
    check_refused(ARMTOL_BAD_TOLERANCE, 1, 4, &armtol_tool_origin);
    tolerances[3] = (double)NAN;
    check_refused(ARMTOL_NOT_FINITE, 1, 4, &armtol_tool_origin);
    tolerances[3] = 0;
    links[0].theta = (double)NAN;
    check_refused(ARMTOL_NOT_FINITE, 1, 4, &armtol_tool_origin);
    links[0].kind = ARMTOL_KIND_COUNT;
    check_refused(ARMTOL_BAD_KIND, 1, 4, &armtol_tool_origin);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_errors_are_those_of_the_definition_for_small_tolerances);
    RUN_TEST(test_errors_are_those_of_the_definition_for_large_tolerances);
    RUN_TEST(test_no_tolerance_is_no_error);
    RUN_TEST(test_series_are_good_to_rounding_up_to_where_they_end);
    RUN_TEST(test_almost_half_turns);
    RUN_TEST(test_turns_of_any_size);
    RUN_TEST(test_draws_are_splitmix64_from_a_mixed_seed);
    RUN_TEST(test_parameters_are_shares_of_their_tolerances);
    RUN_TEST(test_the_same_bits_for_any_split);
    RUN_TEST(test_discs_have_the_same_bits_for_any_width);
    RUN_TEST(test_spread_errors_are_those_of_the_definition);
    RUN_TEST(test_the_same_bits_for_any_split_of_spread_errors);
    RUN_TEST(test_parameters_are_spread);
    RUN_TEST(test_other_seeds_are_other_arms);
    RUN_TEST(test_what_cannot_be_drawn_is_refused);
    return UNITY_END();
}
