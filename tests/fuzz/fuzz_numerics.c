/*
 * The numerics behind armtol, on arms, poses, accuracies and weights that are made of the bytes: A, the optima, the
 * spheres, the remainder, the sampler, inverse kinematics. Every promise of the headers that can be looked at is.
 */

#include "fuzz/bytes.h"
#include "fuzz/harness.h"
#include "fuzz/require.h"

#include "armtol/armtol.h"
#include "armtol/poses.h"
#include "support/random.h"

#include <math.h>
#include <string.h>

enum { MOST_LINKS = 7, MOST_POSES = 3, MOST_COLUMNS = 5 * MOST_LINKS, MOST_ROWS = 6 * MOST_POSES };
enum { WORKSPACE = 20000 };

typedef struct problem {
    size_t n_links, n_joints, n_columns, n_poses;
    armtol_link links[MOST_LINKS], placed[MOST_POSES][MOST_LINKS];
    double q[MOST_POSES * MOST_LINKS];
    armtol_column columns[MOST_COLUMNS];
    double matrices[MOST_ROWS * MOST_COLUMNS];
    armtol_tool_point tool;
    double limits[MOST_ROWS], weights[MOST_COLUMNS], delta;
    double size; /* of the arm */
    bool wild;
} problem;

/* ---- from bytes ---- */

static void take_links(bytes *bytes, problem *problem)
{
    problem->n_links = 1 + bytes_below(bytes, MOST_LINKS);
    for (size_t i = 0; i < problem->n_links; i++) {
        const unsigned what = bytes_below(bytes, ARMTOL_KIND_COUNT * ARMTOL_JOINT_COUNT);
        problem->links[i] = (armtol_link){
            .kind = (armtol_kind)(what % ARMTOL_KIND_COUNT),
            .joint = (armtol_joint)(what / ARMTOL_KIND_COUNT),
            .a = bytes_number(bytes, 500),
            .alpha = bytes_angle(bytes),
            .d = bytes_number(bytes, 500),
            .theta = bytes_angle(bytes),
        };
        problem->links[i].beta = bytes_below(bytes, 4) == 0 ? bytes_angle(bytes) : 0;
    }
    problem->n_joints = armtol_joint_count(problem->links, problem->n_links);
    problem->n_columns = armtol_column_count(problem->links, problem->n_links);
}

static double take_limit(bytes *bytes)
{
    const unsigned kind = bytes_below(bytes, 8);
    const double value = bytes_number(bytes, 1);
    return kind == 0 ? (double)INFINITY : kind == 1 ? value : fabs(value) + 1e-6;
}

static void take_problem(bytes *bytes, problem *problem)
{
    take_links(bytes, problem);
    problem->n_poses = 1 + bytes_below(bytes, MOST_POSES);
    for (size_t i = 0; i < problem->n_poses * problem->n_joints; i++) {
        problem->q[i] = bytes_angle(bytes);
    }
    problem->tool.frame = (armtol_frame)bytes_below(bytes, ARMTOL_FRAME_COUNT);
    for (int i = 0; i < 3; i++) {
        problem->tool.offset[i] = bytes_number(bytes, 100);
    }
    for (size_t i = 0; i < 6 * problem->n_poses; i++) {
        problem->limits[i] = i < 6 ? take_limit(bytes) : problem->limits[i - 6];
    }
    const bool even = bytes_below(bytes, 2) == 0;
    for (size_t k = 0; k < problem->n_columns; k++) {
        problem->weights[k] = even ? 1 : fabs(bytes_number(bytes, 10)) + (bytes_below(bytes, 16) == 0 ? 0 : 1e-3);
    }
    problem->delta = bytes_number(bytes, 1);
    problem->wild = bytes->wild;
    problem->size = 1;
    for (size_t i = 0; i < problem->n_links; i++) {
        problem->size += fabs(problem->links[i].a) + fabs(problem->links[i].d);
    }
    for (int i = 0; i < 3; i++) {
        problem->size += fabs(problem->tool.offset[i]) + 8; /* joint values may be lengths */
    }
}

/* ---- A ---- */

/* The way of 1987, corrected, says the same as the axes of the links. */
static void check_same_matrix(const problem *problem, size_t pose)
{
    double other[6 * MOST_COLUMNS];
    const double *matrix = problem->matrices + pose * 6 * problem->n_columns;
    armtol_tool_point origin = armtol_tool_origin;
    if (memcmp(&origin, &problem->tool, sizeof origin) != 0) {
        return;
    }
    REQUIRE(armtol_error_matrix(problem->placed[pose], problem->n_links, &armtol_errata_none, other,
                                problem->n_columns) == ARMTOL_OK);
    for (size_t i = 0; i < 6 * problem->n_columns; i++) {
        REQUIRE(fabs(other[i] - matrix[i]) <= 1e-11 * problem->size);
    }
}

static bool make_matrices(problem *problem)
{
    const size_t n = problem->n_columns;
    armtol_status status = armtol_columns(problem->links, problem->n_links, problem->columns, n);
    for (size_t p = 0; p < problem->n_poses && status == ARMTOL_OK; p++) {
        status = armtol_links_place(problem->links, problem->n_links, problem->q + p * problem->n_joints,
                                    problem->n_joints, &armtol_errata_none, problem->placed[p]);
        if (status == ARMTOL_OK) {
            status = armtol_tool_matrix(problem->placed[p], problem->n_links, &problem->tool,
                                        problem->matrices + p * 6 * n, n);
        }
        for (size_t i = 0; i < 6 * n && status == ARMTOL_OK; i++) {
            REQUIRE(isfinite(problem->matrices[p * 6 * n + i]));
        }
        if (status == ARMTOL_OK && !problem->wild) {
            check_same_matrix(problem, p);
        }
    }
    REQUIRE(status == ARMTOL_OK || (status == ARMTOL_NOT_FINITE && problem->wild));
    return status == ARMTOL_OK;
}

/* What is rounding in A counts for nothing, as in the engine. */
static void clear_matrices(problem *problem)
{
    const size_t n = problem->n_columns;
    for (size_t p = 0; p < problem->n_poses; p++) {
        armtol_tool_matrix_clear(problem->placed[p], problem->n_links, &problem->tool, problem->matrices + p * 6 * n,
                                 n);
    }
}

/* ---- the optimum ---- */

static double product(const problem *problem, size_t row, size_t k, const double tolerances[])
{
    const double t = tolerances[k];
    return isinf(t) ? 0 : fabs(problem->matrices[row * problem->n_columns + k]) * t;
}

/* |A| t, summed from the left and from the right. */
static void check_worst_row(const problem *problem, size_t row, const double tolerances[])
{
    const size_t n = problem->n_columns;
    double up = 0, down = 0;
    for (size_t k = 0; k < n; k++) {
        up += product(problem, row, k, tolerances);
        down += product(problem, row, n - 1 - k, tolerances);
    }
    REQUIRE(up <= problem->limits[row] && down <= problem->limits[row]);
}

/* The root of the summed squares, as parts of the limit, whose own square may overflow. */
static void check_rss_row(const problem *problem, size_t row, const double tolerances[])
{
    double sum = 0;
    for (size_t k = 0; k < problem->n_columns; k++) {
        const double part = product(problem, row, k, tolerances) / problem->limits[row];
        sum += part * part;
    }
    REQUIRE(isinf(problem->limits[row]) || sqrt(sum) <= 1);
}

static double share(const problem *problem, armtol_sum sum, size_t row, size_t k, const double tolerances[])
{
    const double part = product(problem, row, k, tolerances) / problem->limits[row];
    return sum == ARMTOL_WORST_CASE ? part : part * part;
}

/* The multipliers prove that there is no better. */
static void check_certificate(const problem *problem, armtol_sum sum, const double tolerances[],
                              const double multipliers[])
{
    double whole = 0, total = 0;
    for (size_t k = 0; k < problem->n_columns; k++) {
        whole += isinf(tolerances[k]) ? 0 : problem->weights[k];
    }
    for (size_t i = 0; i < 6 * problem->n_poses; i++) {
        REQUIRE(multipliers[i] >= 0);
        total += multipliers[i];
    }
    REQUIRE(whole > 0 ? fabs(total - 1) <= 1e-9 : total == 0);
    for (size_t k = 0; k < problem->n_columns; k++) {
        double sum_of_shares = 0;
        for (size_t i = 0; i < 6 * problem->n_poses; i++) {
            sum_of_shares += multipliers[i] > 0 ? multipliers[i] * share(problem, sum, i, k, tolerances) : 0;
        }
        REQUIRE(isinf(tolerances[k]) || fabs(sum_of_shares - problem->weights[k] / whole) <= 1e-8);
    }
}

static armtol_status find_optimum(const problem *problem, armtol_sum sum, double tolerances[], double multipliers[])
{
    static double workspace[WORKSPACE];
    const size_t n_rows = 6 * problem->n_poses;
    REQUIRE(armtol_optimum_workspace(n_rows, problem->n_columns) <= WORKSPACE);
    return armtol_optimum(sum, problem->matrices, n_rows, problem->n_columns, problem->limits, problem->weights,
                           tolerances, multipliers, workspace);
}

/* What is wrong among limits and weights; ARMTOL_OK where nothing is. */
static bool is_wrong(const problem *problem)
{
    bool wrong = false;
    for (size_t i = 0; i < 6; i++) {
        wrong = wrong || !(problem->limits[i] > 0);
    }
    for (size_t k = 0; k < problem->n_columns; k++) {
        wrong = wrong || !(problem->weights[k] > 0) || !isfinite(problem->weights[k]);
    }
    return wrong;
}

static bool check_optimum(const problem *problem, armtol_sum sum, double tolerances[])
{
    double multipliers[MOST_ROWS];
    const armtol_status status = find_optimum(problem, sum, tolerances, multipliers);
    if (is_wrong(problem)) {
        REQUIRE(status == ARMTOL_NOT_FINITE || status == ARMTOL_BAD_TOLERANCE || status == ARMTOL_BAD_WEIGHT);
        return false;
    }
    REQUIRE(status == ARMTOL_OK || problem->wild);
    if (status != ARMTOL_OK) {
        return false;
    }
    for (size_t k = 0; k < problem->n_columns; k++) {
        REQUIRE(tolerances[k] > 0);
    }
    for (size_t i = 0; i < 6 * problem->n_poses; i++) {
        if (sum == ARMTOL_WORST_CASE) {
            check_worst_row(problem, i, tolerances);
        } else {
            check_rss_row(problem, i, tolerances);
        }
    }
    if (!problem->wild) {
        check_certificate(problem, sum, tolerances, multipliers);
    }
    return true;
}

/* ---- spheres ---- */

static void check_sphere_tolerances(const problem *problem, const armtol_bounds *bounds)
{
    double tolerances[MOST_COLUMNS];
    REQUIRE(bounds->distance >= 0 && bounds->angle >= 0);
    armtol_sphere_tolerances(problem->columns, problem->n_columns, bounds, tolerances);
    for (size_t k = 0; k < problem->n_columns; k++) {
        REQUIRE(tolerances[k] >= 0);
    }
    for (size_t i = 0; i < 6 * problem->n_poses; i++) {
        double sum = 0;
        for (size_t k = 0; k < problem->n_columns; k++) {
            const double element = fabs(problem->matrices[i * problem->n_columns + k]);
            sum += element > 0 ? element * tolerances[k] : 0;
        }
        REQUIRE(problem->wild || sum <= problem->limits[i] * (1 + 1e-12));
    }
}

static void check_sphere(const problem *problem)
{
    const size_t n = problem->n_columns;
    armtol_bounds bounds;
    double delta;
    armtol_status status = armtol_sphere_delta(problem->matrices, problem->n_poses, n, problem->columns,
                                               problem->limits, problem->size, &delta);
    if (status == ARMTOL_OK) {
        REQUIRE(armtol_sphere_bounds(problem->matrices, problem->n_poses, n, problem->columns, problem->limits, delta,
                                     &bounds) == ARMTOL_OK);
        REQUIRE(problem->wild || (bounds.distance > 0 && bounds.angle > 0));
        check_sphere_tolerances(problem, &bounds);
    } else {
        REQUIRE(problem->wild || is_wrong(problem));
    }
    status = armtol_sphere_bounds(problem->matrices, problem->n_poses, n, problem->columns, problem->limits,
                                  problem->delta, &bounds);
    if (status == ARMTOL_OK) {
        check_sphere_tolerances(problem, &bounds);
    }
}

/* ---- norms ---- */

/* What tolerances come to along a direction, by the sum of magnitudes or of squares. */
static double along(const problem *problem, const double direction[6], const double tolerances[], bool rss)
{
    double row[MOST_COLUMNS], sum = 0;
    armtol_norm_row(problem->matrices, problem->n_columns, direction, row);
    for (size_t k = 0; k < problem->n_columns; k++) {
        const double part = row[k] == 0 ? 0 : fabs(row[k]) * tolerances[k];
        sum += rss ? part * part : part;
    }
    return rss ? sqrt(sum) : sum;
}

/* It is reached, and neither along an axis nor along a direction between is there more. */
static void check_norm(const problem *problem, unsigned components, const double tolerances[], uint64_t seed, bool rss)
{
    double workspace[6 * (MOST_COLUMNS + 1)], direction[6], other[6], length = 0;
    random_source source = {seed};
    const double *matrix = problem->matrices;
    const size_t n = problem->n_columns;
    const double norm = rss ? armtol_rss_norm(matrix, n, components, NULL, tolerances, 1, direction)
                            : armtol_worst_norm(matrix, n, components, NULL, tolerances, direction, workspace);
    REQUIRE(isfinite(norm) && fabs(along(problem, direction, tolerances, rss) - norm) <= 1e-12 * norm);
    for (size_t i = 0; i < 6; i++) {
        const double axis[6] = {i == 0, i == 1, i == 2, i == 3, i == 4, i == 5};
        const bool counts = (components >> i & 1) != 0;
        REQUIRE(!counts || along(problem, axis, tolerances, rss) <= norm * (1 + 1e-12));
        other[i] = counts ? random_between(&source, -1, 1) : 0;
        length += other[i] * other[i];
    }
    REQUIRE(along(problem, other, tolerances, rss) <= norm * sqrt(length) * (1 + 1e-12));
}

static void check_norms(const problem *problem, const double tolerances[], uint64_t seed)
{
    static const unsigned norms[] = {007, 003, 005, 006, 070, 030, 050, 060};
    for (size_t i = 0; i < sizeof norms / sizeof norms[0]; i++) {
        check_norm(problem, norms[i], tolerances, seed, false);
        check_norm(problem, norms[i], tolerances, seed, true);
    }
}

/* The largest tolerances for a ball: no norm is beyond its limit, and one is used up. */
static void check_ball(const problem *problem, bool rss)
{
    armtol_drive drives[MOST_LINKS];
    const armtol_norm norms[2] = {{007, 1}, {060, 0.01}};
    const armtol_arm arm = {.name = "", .title = "", .source = "", .links = problem->links, .n_links = problem->n_links,
                            .drives = drives};
    const armtol_question question = {.arm = &arm, .q = problem->q, .n_poses = problem->n_poses, .tool = problem->tool,
                                      .norms = norms, .n_norms = 2, .sigma = 3,
                                      .method = rss ? ARMTOL_METHOD_RSS : ARMTOL_METHOD_WORST};
    armtol_answer *answer;
    double held = 0;
    bool bounded = false;
    for (size_t i = 0; i < problem->n_links; i++) {
        drives[i] = armtol_drive_unknown;
    }
    REQUIRE(armtol_answer_create(&question, &answer, NULL) == ARMTOL_OK);
    for (size_t k = 0; k < answer->n_columns; k++) {
        bounded = bounded || isfinite(answer->tolerances[k]);
    }
    for (size_t i = 0; i < 2; i++) {
        REQUIRE((rss ? answer->norms[i].spread : answer->norms[i].of.worst) <= norms[i].limit);
        held += answer->norms[i].of.binds;
    }
    REQUIRE(!bounded || fabs(held - 1) <= 1e-9);
    armtol_answer_destroy(answer);
}

/* ---- arms drawn ---- */

/* Tolerances that an arm could have: none of an angle so large that nothing is said of it. */
static void make_small(const problem *problem, double tolerances[])
{
    for (size_t k = 0; k < problem->n_columns; k++) {
        const double most = armtol_parameter_is_length(problem->columns[k].parameter) ? 20 : 0.05;
        tolerances[k] = isinf(tolerances[k]) ? 0 : fmin(tolerances[k], most);
    }
}

/* Exact errors are no farther from what A says than the remainder is. */
static void check_error(const problem *problem, const double parameters[], const double remainder[6],
                        const double error[6])
{
    for (size_t i = 0; i < 6; i++) {
        double linear = 0;
        for (size_t k = 0; k < problem->n_columns; k++) {
            linear += problem->matrices[i * problem->n_columns + k] * parameters[k];
        }
        REQUIRE(isfinite(error[i]));
        REQUIRE(fabs(error[i] - linear) <= remainder[i] * (1 + 1e-9) + 1e-12 * (i < 3 ? problem->size : 1));
    }
}

static void check_arm(const problem *problem, const armtol_sampler *sampler, uint64_t arm, const double remainder[6],
                      const double drawn[6])
{
    double parameters[MOST_COLUMNS], error[6];
    armtol_sampler_parameters(sampler, arm, parameters);
    REQUIRE(armtol_tool_error(problem->placed[0], problem->n_links, parameters, problem->n_columns, &problem->tool,
                              error) == ARMTOL_OK);
    for (size_t i = 0; i < 6; i++) {
        REQUIRE(fabs(error[i] - drawn[i]) <= 1e-11 * (i < 3 ? problem->size : 1));
    }
    check_error(problem, parameters, remainder, error);
}

static void check_corners(const problem *problem, const double tolerances[], const double remainder[6])
{
    for (size_t row = 0; row < 6; row++) {
        double corner[MOST_COLUMNS], error[6];
        armtol_corner(problem->matrices, problem->n_columns, row, 1, tolerances, corner);
        REQUIRE(armtol_tool_error(problem->placed[0], problem->n_links, corner, problem->n_columns, &problem->tool,
                                  error) == ARMTOL_OK);
        check_error(problem, corner, remainder, error);
    }
}

static void check_draws(const problem *problem, const double tolerances[], uint64_t seed)
{
    enum { ARMS = 11 };
    armtol_sampler sampler;
    armtol_sampled_link prepared[MOST_LINKS];
    double remainder[6], errors[6 * ARMS];
    armtol_remainder(problem->matrices, problem->n_columns, tolerances, remainder);
    REQUIRE(armtol_sampler_start(&sampler, prepared, problem->placed[0], problem->n_links, tolerances,
                                 problem->n_columns, &problem->tool, seed) == ARMTOL_OK);
    armtol_sampler_draw(&sampler, seed % 1000, ARMS, errors);
    for (size_t j = 0; j < ARMS; j++) {
        double alone[6], drawn[6];
        armtol_sampler_draw(&sampler, seed % 1000 + j, 1, alone);
        for (size_t i = 0; i < 6; i++) {
            drawn[i] = errors[i * ARMS + j];
        }
        REQUIRE(memcmp(alone, drawn, sizeof alone) == 0);
        check_arm(problem, &sampler, seed % 1000 + j, remainder, drawn);
    }
    check_corners(problem, tolerances, remainder);
}

/* Whatever the tolerances: a remainder that is no number bounds nothing. */
static void check_remainder(const problem *problem, const double tolerances[])
{
    double remainder[6];
    armtol_remainder(problem->matrices, problem->n_columns, tolerances, remainder);
    for (int i = 0; i < 6; i++) {
        REQUIRE(remainder[i] >= 0);
    }
}

/* ---- many poses at once ---- */

static void check_poses(const problem *problem)
{
    static double blocks[ARMTOL_POSE_BLOCK * 6 * MOST_COLUMNS], alone_blocks[ARMTOL_POSE_BLOCK * 6 * MOST_COLUMNS];
    const size_t n = problem->n_columns;
    armtol_poses poses;
    armtol_pose_link prepared[MOST_LINKS];
    armtol_bounds bounds[MOST_POSES], alone;
    if (armtol_poses_start(&poses, prepared, problem->links, problem->n_links, &problem->tool, problem->limits,
                           problem->delta) != ARMTOL_OK) {
        return;
    }
    armtol_pose_blocks(&poses, problem->q, problem->n_poses, blocks, bounds);
    for (size_t p = 0; p < problem->n_poses; p++) {
        for (size_t i = 0; i < 6 * n; i++) {
            const double *const expected = &problem->matrices[p * 6 * n + i];
            REQUIRE(memcmp(expected, &blocks[ARMTOL_POSE_ELEMENT(n, i / n, i % n, p)], sizeof *expected) == 0);
        }
        armtol_pose_blocks(&poses, problem->q + p * problem->n_joints, 1, alone_blocks, &alone);
        REQUIRE(memcmp(&alone, &bounds[p], sizeof alone) == 0);
    }
}

/* Where the first pose brings the tool is asked for near that pose: the first start is there. */
static void check_inverse(const problem *problem)
{
    armtol_drive drives[MOST_LINKS];
    for (size_t i = 0; i < problem->n_links; i++) {
        drives[i] = armtol_drive_unknown;
    }
    const armtol_arm arm = {.name = "arm", .n_links = problem->n_links, .links = problem->links, .drives = drives};
    const armtol_inverse_setup setup = {.arm = &arm, .near = problem->q, .enough = 1};
    armtol_wish wish = {armtol_chain_transform(problem->placed[0], problem->n_links, &armtol_errata_none), false};
    armtol_inverse *inverse;
    armtol_branches branches;
    const armtol_status made = armtol_inverse_create(&setup, &inverse);
    REQUIRE(made == ARMTOL_OK || (made == ARMTOL_NOT_FINITE && problem->wild));
    if (made != ARMTOL_OK) {
        return;
    }
    const armtol_status status = armtol_inverse_find(inverse, &wish, &branches);
    REQUIRE(problem->wild || status == ARMTOL_OK);
    if (status == ARMTOL_OK) {
        REQUIRE(branches.count == 1 && branches.branch[0].angle <= 1e-10);
        REQUIRE(branches.branch[0].distance <= 1e-10 * armtol_inverse_size(inverse));
    }
    armtol_inverse_destroy(inverse);
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    caught_start("numerics");
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    bytes bytes = bytes_start(data, size);
    static problem problem;
    double tolerances[MOST_COLUMNS];
    take_problem(&bytes, &problem);
    if (!make_matrices(&problem)) {
        return 0;
    }
    check_poses(&problem);
    check_inverse(&problem);
    clear_matrices(&problem);
    check_sphere(&problem);
    if (check_optimum(&problem, ARMTOL_ROOT_SUM_SQUARES, tolerances)) {
        check_remainder(&problem, tolerances);
    }
    if (check_optimum(&problem, ARMTOL_WORST_CASE, tolerances)) {
        check_remainder(&problem, tolerances);
        make_small(&problem, tolerances);
        if (!problem.wild) {
            const uint64_t seed = bytes_hash(data, size);
            check_draws(&problem, tolerances, seed);
            check_norms(&problem, tolerances, seed);
            if (seed % 16 == 0) { /* it takes as long as all the rest */
                check_ball(&problem, seed / 16 % 2 == 0);
            }
        }
    }
    return 0;
}
