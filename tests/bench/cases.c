#include "bench/cases.h"

#include "armtol/armtol.h"
#include "armtol/poses.h"
#include "bench/textbook.h"

#include <math.h>
#include <string.h>

enum { LINKS = 8, JOINTS = 6, COLUMNS = 32, POSES = 256, ARMS = 1024, MAP_POSES = 1000000, SLICE = 4000 };

#define SEED 605

static const double accuracy[6] = {0.5, 0.5, 0.5, 0.1, 0.1, 0.1}, delta = 0.1;
static const double pose[JOINTS] = {1.571237, 1.063532, -0.944167, 1.754183, -0.810926, -0.507265};

static double q[POSES * JOINTS];
static armtol_link links[LINKS], placed[POSES][LINKS];
static armtol_pose_link pose_links[LINKS];
static armtol_poses poses;
static armtol_sampled_link sampled_links[LINKS], far_sampled_links[LINKS];
static armtol_sampler sampler, far_sampler;
static double tolerances[COLUMNS], far_tolerances[COLUMNS];
static textbook_arm arm;

static double matrices[POSES][6][COLUMNS];
static double blocks[POSES * 6 * COLUMNS] __attribute__((aligned(64)));
static armtol_bounds bounds[POSES];
static double errors[6 * ARMS];

static double map_q[MAP_POSES * JOINTS], map_values[SLICE];
static armtol_drive no_drives[LINKS];
static armtol_arm map_arm;

/* Whatever is computed is read, so that no compiler leaves it out. */
static volatile double sink;
static uint64_t next_arm;

static void consume_matrices(void)
{
    sink = matrices[POSES / 2][3][5] + bounds[POSES - 1].angle;
}

static void run_textbook_poses(void)
{
    for (size_t p = 0; p < POSES; p++) {
        textbook_pose(q + p * JOINTS, accuracy, delta, matrices[p], &bounds[p]);
    }
    consume_matrices();
}

static void run_pose_blocks(void)
{
    armtol_pose_blocks(&poses, q, POSES, blocks, bounds);
    sink = blocks[7] + bounds[POSES - 1].angle;
}

static void run_tool_matrices(void)
{
    for (size_t p = 0; p < POSES; p++) {
        armtol_tool_matrix(placed[p], LINKS, &armtol_tool_origin, &matrices[p][0][0], COLUMNS);
    }
    consume_matrices();
}

static void run_error_matrices(void)
{
    for (size_t p = 0; p < POSES; p++) {
        armtol_error_matrix(placed[p], LINKS, &armtol_errata_none, &matrices[p][0][0], COLUMNS);
    }
    consume_matrices();
}

static void run_textbook_samples(void)
{
    for (size_t i = 0; i < ARMS; i++) {
        textbook_sample(&arm, next_arm++, errors + 6 * i);
    }
    sink = errors[17];
}

static void run_samples(void)
{
    armtol_sampler_draw(&sampler, next_arm, ARMS, errors);
    next_arm += ARMS;
    sink = errors[17];
}

static void run_far_samples(void)
{
    armtol_sampler_draw(&far_sampler, next_arm, ARMS, errors);
    next_arm += ARMS;
    sink = errors[17];
}

/* A map is gone through slice by slice, one after the other, all of it over and over. */
static size_t next_slice(void)
{
    static size_t at;
    at = at + SLICE < MAP_POSES ? at + SLICE : 0;
    return at;
}

/* A in all poses of a map, in blocks that stay in a near cache, and nothing done with it. */
static void run_map_blocks(void)
{
    const size_t first = next_slice();
    for (size_t p = 0; p < SLICE; p += POSES) {
        const size_t n = SLICE - p < POSES ? SLICE - p : POSES;
        armtol_pose_blocks(&poses, map_q + (first + p) * JOINTS, n, blocks, bounds);
        sink = blocks[7] + bounds[n - 1].angle;
    }
}

static void run_map(size_t first, size_t component)
{
    const armtol_question question = {.arm = &map_arm, .q = map_q + first * JOINTS, .n_poses = SLICE, .tolerances =
        tolerances};
    const armtol_map map = {.value = ARMTOL_MAP_WORST, .component = component};
    sink = armtol_map_values(&question, &map, map_values, NULL) == ARMTOL_OK ? map_values[SLICE - 1] : -1;
}

static void run_map_of_dx(void)
{
    run_map(next_slice(), 0);
}

static void run_map_of_position(void)
{
    run_map(next_slice(), ARMTOL_MAP_POSITION);
}

const bench_case map_cases[] = {
    {"armtol_pose_blocks, 256 poses at a time", run_map_blocks, SLICE},
    {"armtol_map_values: the worst case of dx", run_map_of_dx, SLICE},
    {"armtol_map_values: the worst case of the position", run_map_of_position, SLICE},
};
const size_t map_case_count = sizeof map_cases / sizeof map_cases[0];

const bench_case pose_cases[] = {
    {"by hand for this arm, scalar, libm's sines", run_textbook_poses, POSES},
    {"armtol_pose_blocks, 256 poses at a time", run_pose_blocks, POSES},
    {"armtol_tool_matrix: nothing prepared, no bounds", run_tool_matrices, POSES},
    {"armtol_error_matrix: by adjoints, no bounds", run_error_matrices, POSES},
};
const size_t pose_case_count = sizeof pose_cases / sizeof pose_cases[0];

const bench_case sample_cases[] = {
    {"by hand for this arm, scalar, short series, libm's atan2", run_textbook_samples, ARMS},
    {"armtol_sampler_draw, 1024 arms at a time", run_samples, ARMS},
    {"armtol_sampler_draw, angles off by up to 0.1: no short series", run_far_samples, ARMS},
};
const size_t sample_case_count = sizeof sample_cases / sizeof sample_cases[0];

const char *cases_compiled_for(void)
{
#ifdef BENCH_NATIVE
    return "this machine";
#else
    return "any machine";
#endif
}

const armtol_sampler *cases_sampler(void)
{
    return &sampler;
}

/* ---- preparing ---- */

static bool near(double one, double other, double size)
{
    return fabs(one - other) <= 1e-12 * size;
}

static bool poses_agree(void)
{
    const double reach = 1000;
    run_textbook_poses();
    armtol_pose_blocks(&poses, q, POSES, blocks, bounds);
    for (size_t p = 0; p < POSES; p++) {
        double matrix[6][COLUMNS];
        armtol_bounds by_hand;
        textbook_pose(q + p * JOINTS, accuracy, delta, matrix, &by_hand);
        if (!near(by_hand.angle, bounds[p].angle, 1) || !near(by_hand.distance, bounds[p].distance, 1)) {
            return false;
        }
        for (size_t i = 0; i < 6; i++) {
            for (size_t k = 0; k < COLUMNS; k++) {
                if (!near(matrix[i][k], blocks[ARMTOL_POSE_ELEMENT(COLUMNS, i, k, p)], reach)) {
                    return false;
                }
            }
        }
    }
    return true;
}

static bool samples_agree(void)
{
    armtol_sampler_draw(&sampler, 0, ARMS, errors);
    for (size_t j = 0; j < ARMS; j++) {
        double error[6];
        textbook_sample(&arm, j, error);
        for (size_t i = 0; i < 6; i++) {
            if (!near(error[i], errors[i * ARMS + j], i < 3 ? 1000 : 1)) {
                return false;
            }
        }
    }
    return true;
}

static bool start_poses(void)
{
    armtol_intelledex_605t.links(&armtol_errata_none, links);
    for (size_t i = 0; i < POSES * JOINTS; i++) {
        q[i] = 3 * armtol_sampler_uniform(SEED, i);
    }
    for (size_t p = 0; p < POSES; p++) {
        armtol_links_place(links, LINKS, q + p * JOINTS, JOINTS, &armtol_errata_none, placed[p]);
    }
    return armtol_poses_start(&poses, pose_links, links, LINKS, &armtol_tool_origin, accuracy, delta) ==
           ARMTOL_OK;
}

static bool start_samplers(void)
{
    armtol_column columns[COLUMNS];
    armtol_link here[LINKS];
    armtol_columns(links, LINKS, columns, COLUMNS);
    armtol_links_place(links, LINKS, pose, JOINTS, &armtol_errata_none, here);
    for (size_t k = 0; k < COLUMNS; k++) {
        const bool length = armtol_parameter_is_length(columns[k].parameter);
        tolerances[k] = length ? 0.05 : 0.001;
        far_tolerances[k] = length ? 0.05 : 0.1;
    }
    textbook_arm_start(&arm, pose, tolerances, SEED);
    return armtol_sampler_start(&sampler, sampled_links, here, LINKS, tolerances, COLUMNS,
                                &armtol_tool_origin, SEED) == ARMTOL_OK &&
           armtol_sampler_start(&far_sampler, far_sampled_links, here, LINKS, far_tolerances, COLUMNS,
                                &armtol_tool_origin, SEED) == ARMTOL_OK;
}

static void start_map(void)
{
    for (size_t i = 0; i < LINKS; i++) {
        no_drives[i] = armtol_drive_unknown;
    }
    map_arm = (armtol_arm){.name = "bench", .title = "bench", .source = "bench", .n_links = LINKS, .links = links,
                           .drives = no_drives};
    for (size_t i = 0; i < MAP_POSES * JOINTS; i++) {
        map_q[i] = 3 * armtol_sampler_uniform(SEED, i);
    }
}

/* |A| t of the first poses, which are those of the other cases, added up here. */
static bool map_agrees(void)
{
    run_map(0, 0);
    bool agrees = sink >= 0;
    for (size_t p = 0; p < POSES && agrees; p++) {
        double worst = 0;
        for (size_t k = 0; k < COLUMNS; k++) {
            worst += fabs(blocks[ARMTOL_POSE_ELEMENT(COLUMNS, 0, k, p)]) * tolerances[k];
        }
        agrees = near(worst, map_values[p], 1000);
    }
    return agrees;
}

bool cases_start(void)
{
    if (!start_poses() || !start_samplers() || !poses_agree() || !samples_agree()) {
        return false;
    }
    start_map();
    armtol_pose_blocks(&poses, q, POSES, blocks, bounds);
    return map_agrees();
}
