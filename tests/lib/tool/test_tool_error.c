/* The exact error of the tool, against the long double reference and rotations that are known. */

#include "armtol/error_matrix.h"
#include "armtol/tool_error.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"

#include "unity.h"

#include <math.h>

enum { LINKS = 6, COLUMNS = LINKS * ARMTOL_PARAMETER_COUNT, TRIES = 300 };

static const double pi = 3.14159265358979323846;

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- random chains against the reference ---- */

typedef struct sample {
    armtol_link links[LINKS];
    size_t n_links, n_columns;
    armtol_column columns[COLUMNS];
    double errors[COLUMNS];
    armtol_tool_point tool;
} sample;

static sample sample_of(random_source *source, double size)
{
    sample sample;
    sample.n_links = 1 + (size_t)random_between(source, 0, LINKS);
    for (size_t i = 0; i < sample.n_links; i++) {
        sample.links[i] = (armtol_link){
            .kind = (armtol_kind)random_between(source, 0, ARMTOL_KIND_COUNT),
            .joint = (armtol_joint)random_between(source, 0, ARMTOL_JOINT_COUNT),
            .a = random_between(source, -300, 300),
            .alpha = random_between(source, -pi, pi),
            .d = random_between(source, -300, 300),
            .theta = random_between(source, -pi, pi),
            .beta = random_between(source, -1, 1),
        };
    }
    sample.n_columns = armtol_column_count(sample.links, sample.n_links);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                          armtol_columns(sample.links, sample.n_links, sample.columns, sample.n_columns));
    for (size_t k = 0; k < sample.n_columns; k++) {
        sample.errors[k] = random_between(source, -size, size);
    }
    for (int i = 0; i < 3; i++) {
        sample.tool.offset[i] = random_between(source, -100, 100);
    }
    sample.tool.frame = random_between(source, 0, 1) < 0.5 ? ARMTOL_BASE_FRAME : ARMTOL_TOOL_FRAME;
    return sample;
}

static void add_error(armtol_link *link, armtol_parameter parameter, double error)
{
    link->theta += parameter == ARMTOL_THETA ? error : 0;
    link->d += parameter == ARMTOL_D ? error : 0;
    link->a += parameter == ARMTOL_A ? error : 0;
    link->alpha += parameter == ARMTOL_ALPHA ? error : 0;
    link->beta += parameter == ARMTOL_BETA ? error : 0;
}

static void chains_of(const sample *sample, double meant[4][4], double built[4][4])
{
    armtol_link links[LINKS];
    for (size_t i = 0; i < sample->n_links; i++) {
        links[i] = sample->links[i];
    }
    for (size_t k = 0; k < sample->n_columns; k++) {
        add_error(&links[sample->columns[k].link], sample->columns[k].parameter, sample->errors[k]);
    }
    reference_chain(sample->links, sample->n_links, meant);
    reference_chain(links, sample->n_links, built);
}

/* A vector as counted along the base's axes. */
static void to_base(const sample *sample, double meant[4][4], const double counted[3], double vector[3])
{
    for (int i = 0; i < 3; i++) {
        const double *row = meant[i];
        vector[i] = sample->tool.frame == ARMTOL_BASE_FRAME
                        ? counted[i]
                        : row[0] * counted[0] + row[1] * counted[1] + row[2] * counted[2];
    }
}

static double point_of(double chain[4][4], const double offset[3], int i)
{
    return chain[i][3] + chain[i][0] * offset[0] + chain[i][1] * offset[1] + chain[i][2] * offset[2];
}

static double cross(const double a[3], const double b[3], int i)
{
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return a[j] * b[k] - a[k] * b[j];
}

/* Turn x by a rotation vector: Rodrigues' formula. */
static void rotate(const double vector[3], const double x[3], double rotated[3])
{
    const double angle = sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    const double axis[3] = {vector[0] / angle, vector[1] / angle, vector[2] / angle};
    const double along = axis[0] * x[0] + axis[1] * x[1] + axis[2] * x[2];
    for (int i = 0; i < 3; i++) {
        rotated[i] = x[i] * cos(angle) + cross(axis, x, i) * sin(angle) + axis[i] * along * (1 - cos(angle));
    }
}

static void check_against_reference(const sample *sample)
{
    double meant[4][4], built[4][4], error[6], displacement[3], rotation[3];
    chains_of(sample, meant, built);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tool_error(sample->links, sample->n_links, sample->errors,
                                                       sample->n_columns, &sample->tool, error));
    to_base(sample, meant, error, displacement);
    to_base(sample, meant, error + 3, rotation);
    for (int i = 0; i < 3; i++) {
        const double moved =
            point_of(built, sample->tool.offset, i) - point_of(meant, sample->tool.offset, i);
        check_within(1e-10, moved, displacement[i], "displacement %d", i);
    }
    for (int n = 0; n < 3; n++) {
        const double axis[3] = {meant[0][n], meant[1][n], meant[2][n]};
        double turned[3];
        rotate(rotation, axis, turned);
        for (int i = 0; i < 3; i++) {
            check_within(1e-13, built[i][n], turned[i], "axis %d, component %d", n, i);
        }
    }
}

static void test_random_chains(void)
{
    random_source source = {1};
    for (int i = 0; i < TRIES; i++) {
        const double sizes[] = {1e-5, 1e-2, 3};
        const sample sample = sample_of(&source, sizes[i % 3]);
        check_against_reference(&sample);
    }
}

static void test_no_errors_give_exactly_nothing(void)
{
    random_source source = {2};
    for (int i = 0; i < TRIES; i++) {
        const sample sample = sample_of(&source, 0);
        double error[6];
        armtol_tool_error(sample.links, sample.n_links, sample.errors, sample.n_columns, &sample.tool, error);
        for (int j = 0; j < 6; j++) {
            check_same(0, error[j], "component %d", j);
        }
    }
}

/* ---- rotations that are known ---- */

/* A link that turns by `angle` behind one that holds its axis at any direction; its length bends nothing. */
static void check_turn(double theta, double alpha, double angle)
{
    const armtol_link links[2] = {{ARMTOL_NPR, ARMTOL_FIXED, .alpha = alpha, .theta = theta},
                                  {ARMTOL_NPR, ARMTOL_REVOLUTE, .theta = 0.7, .alpha = -0.4}};
    const double errors[8] = {[4] = angle};
    const double axis[3] = {sin(theta) * sin(alpha), -cos(theta) * sin(alpha), cos(alpha)};
    double error[6];
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tool_error(links, 2, errors, 8, &armtol_tool_origin, error));
    /* half a turn about an axis is half a turn about its opposite */
    const double along = error[3] * axis[0] + error[4] * axis[1] + error[5] * axis[2];
    const double sense = pi - fabs(angle) < 1e-15 && along * angle < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++) {
        check_within(3e-15, sense * angle * axis[i], error[i + 3], "turn by %.17g, component %d", angle, i);
    }
}

static void check_turns(double theta, double alpha, double angle)
{
    check_turn(theta, alpha, angle);
    check_turn(theta, alpha, -angle);
}

static void test_known_rotations(void)
{
    static const double angles[] = {1e-15, 1e-9, 1e-4, 0.1,       1,         2,          2.09,
                                    2.1,   3,    3.14, pi - 1e-6, pi - 1e-9, pi - 1e-13, pi};
    for (size_t i = 0; i < sizeof angles / sizeof angles[0]; i++) {
        check_turns(pi / 2, pi / 2, angles[i]); /* about x */
        check_turns(0, pi / 2, angles[i]);      /* about y */
        for (int n = 0; n < 40; n++) {
            check_turns(0.37 * n, 0.91 * n, angles[i]);
        }
    }
}

static void test_one_link_in_closed_form(void)
{
    static const armtol_link link[1] = {{ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 400, .theta = 0.3}};
    /* theta a alpha beta: turns by 0.1 and is 2 longer; then it tilts by 0.2 about its own x axis */
    const double errors[4] = {0.1, 2, 0.2, 0};
    /* Rot(z, 0.4) Rot(x, 0.2) Rot(z, -0.3) as a quaternion (w; v) */
    const double half_turn = 0.1 / 2, half_tilt = 0.2 / 2, middle = 0.3 + half_turn;
    const double w = cos(half_tilt) * cos(half_turn);
    const double v[3] = {sin(half_tilt) * cos(middle), sin(half_tilt) * sin(middle),
                         cos(half_tilt) * sin(half_turn)};
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    double error[6];
    armtol_tool_error(link, 1, errors, 4, &armtol_tool_origin, error);
    check_within(1e-12, 402 * cos(0.4) - 400 * cos(0.3), error[0], "x");
    check_within(1e-12, 402 * sin(0.4) - 400 * sin(0.3), error[1], "y");
    check_same(0, error[2], "z");
    for (int i = 0; i < 3; i++) {
        check_within(1e-14, 2 * atan2(length, w) * v[i] / length, error[i + 3], "rotation %d", i);
    }
}

/* So small that its square is 0. */
static void test_the_smallest_turn(void)
{
    const armtol_link link[1] = {{ARMTOL_NPR, ARMTOL_REVOLUTE}};
    const double errors[4] = {1e-300};
    double error[6];
    armtol_tool_error(link, 1, errors, 4, &armtol_tool_origin, error);
    check_within(1e-315, 1e-300, error[5], "about z");
}

/* Beyond half a turn the other way round is shorter. */
static void test_more_than_half_a_turn(void)
{
    const armtol_link link[1] = {{ARMTOL_NPR, ARMTOL_REVOLUTE}};
    const double errors[4] = {4};
    double error[6];
    armtol_tool_error(link, 1, errors, 4, &armtol_tool_origin, error);
    check_within(1e-15, 4 - 2 * pi, error[5], "about z");
}

/* The tool stands across the base: its x is the base's y. */
static void test_frames_and_offset(void)
{
    const armtol_link link[1] = {{ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 400, .theta = pi / 2}};
    const double turn[4] = {0.01}, longer[4] = {[2] = 3};
    const armtol_tool_point in_base = {{100, 0, 0}, ARMTOL_BASE_FRAME};
    const armtol_tool_point in_tool = {{100, 0, 0}, ARMTOL_TOOL_FRAME};
    double error[6];
    armtol_tool_error(link, 1, turn, 4, &in_base, error);
    check_within(1e-12, -500 * sin(0.01), error[0], "base, x");
    check_within(1e-12, 500 * (cos(0.01) - 1), error[1], "base, y");
    armtol_tool_error(link, 1, turn, 4, &in_tool, error);
    check_within(1e-12, 500 * (cos(0.01) - 1), error[0], "tool, x");
    check_within(1e-12, 500 * sin(0.01), error[1], "tool, y");
    check_within(1e-15, 0.01, error[5], "tool, about z");
    armtol_tool_error(link, 1, longer, 4, &in_tool, error);
    check_within(1e-12, 3, error[0], "tool, longer");
}

/* ---- what is no arm, and no number ---- */

static void test_statuses(void)
{
    armtol_link links[2] = {{ARMTOL_NPR, ARMTOL_REVOLUTE}, {ARMTOL_PPP, ARMTOL_PRISMATIC}};
    const double errors[9] = {0};
    double error[6] = {7};
    const armtol_tool_point *tool = &armtol_tool_origin;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tool_error(links, 2, errors, 9, tool, error));
    error[0] = 7;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NO_LINKS, armtol_tool_error(links, 0, errors, 0, tool, error));
    TEST_ASSERT_EQUAL_INT(ARMTOL_WRONG_SIZE, armtol_tool_error(links, 2, errors, 8, tool, error));
    links[1].a = NAN;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, armtol_tool_error(links, 2, errors, 9, tool, error));
    links[1].kind = ARMTOL_KIND_COUNT;
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_KIND, armtol_tool_error(links, 2, errors, 9, tool, error));
    links[0].joint = ARMTOL_JOINT_COUNT;
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_JOINT, armtol_tool_error(links, 2, errors, 9, tool, error));
    check_same(7, error[0], "the error, untouched");
}

static void test_what_is_no_number_goes_through(void)
{
    const armtol_link link[1] = {{ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 400, .theta = 0.3}};
    const double no_angle[4] = {NAN}, endless_angle[4] = {INFINITY}, endless_length[4] = {[2] = INFINITY};
    double error[6];
    armtol_tool_error(link, 1, no_angle, 4, &armtol_tool_origin, error);
    TEST_ASSERT_TRUE(isnan(error[0]) && isnan(error[5]));
    armtol_tool_error(link, 1, endless_angle, 4, &armtol_tool_origin, error);
    TEST_ASSERT_TRUE(isnan(error[0]) && isnan(error[5]));
    armtol_tool_error(link, 1, endless_length, 4, &armtol_tool_origin, error);
    TEST_ASSERT_TRUE(!isfinite(error[0]) && error[5] == 0);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_random_chains);
    RUN_TEST(test_no_errors_give_exactly_nothing);
    RUN_TEST(test_known_rotations);
    RUN_TEST(test_one_link_in_closed_form);
    RUN_TEST(test_the_smallest_turn);
    RUN_TEST(test_more_than_half_a_turn);
    RUN_TEST(test_frames_and_offset);
    RUN_TEST(test_statuses);
    RUN_TEST(test_what_is_no_number_goes_through);
    return UNITY_END();
}
