/*
 * Arms from axes: whatever the axes, the links bring the tool where turning about, and sliding along, the axes does,
 * but for what was taken for exact; the table keeps to the rules of axes.h, and as a table it has these axes again.
 */

#include "fuzz/bytes.h"
#include "fuzz/harness.h"
#include "fuzz/motion.h"
#include "fuzz/require.h"

#include "armtol/axes.h"
#include "armtol/link_transform.h"
#include "support/random.h"

#include <math.h>

#define PI 3.14159265358979323846

enum { MOST_AXES = 8 };

typedef struct problem {
    size_t n;
    armtol_axis axes[MOST_AXES];
    armtol_transform tool;
    double snap;
    bool wild;
} problem;

typedef struct table {
    armtol_link links[ARMTOL_LINKS_OF_AXES(MOST_AXES)];
    size_t n_links;
    armtol_snapped snapped[ARMTOL_LINKS_OF_AXES(MOST_AXES)];
    size_t n_snapped;
} table;

static void take_numbers(bytes *bytes, double scale, double numbers[3])
{
    for (int i = 0; i < 3; i++) {
        numbers[i] = bytes_number(bytes, scale);
    }
}

/* Along x, y or z, tilted from one of them, or anywhere. */
static void take_direction(bytes *bytes, double direction[3])
{
    static const double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const double origin[3];
    if (bytes_below(bytes, 4) == 0) {
        take_numbers(bytes, 1, direction);
        return;
    }
    const unsigned main = bytes_below(bytes, 3);
    const double rpy[3] = {bytes_angle(bytes), bytes_angle(bytes), bytes_angle(bytes)};
    const armtol_transform turned = motion_of_rpy(origin, rpy);
    for (int i = 0; i < 3; i++) {
        direction[i] = 0;
        for (int k = 0; k < 3; k++) {
            direction[i] += turned.m[i][k] * axes[main][k];
        }
    }
}

static void take_problem(bytes *bytes, problem *problem)
{
    double xyz[3], rpy[3];
    problem->n = bytes_below(bytes, MOST_AXES + 1);
    for (size_t i = 0; i < problem->n; i++) {
        armtol_axis *axis = &problem->axes[i];
        axis->joint = (armtol_joint)(bytes_below(bytes, 40) == 39 ? 0 : 1 + bytes_below(bytes, 5) / 4);
        take_numbers(bytes, 1000, axis->point);
        take_direction(bytes, axis->direction);
    }
    take_numbers(bytes, 1000, xyz);
    for (int i = 0; i < 3; i++) {
        rpy[i] = bytes_angle(bytes);
    }
    problem->tool = motion_of_rpy(xyz, rpy);
    problem->snap = bytes_below(bytes, 2) == 0 ? 0 : ARMTOL_USUAL_SNAP;
    problem->wild = bytes->wild;
}

/* ---- what must not work ---- */

static bool is_finite(const problem *problem)
{
    bool fine = true;
    for (size_t i = 0; i < problem->n; i++) {
        for (int k = 0; k < 3; k++) {
            fine = fine && isfinite(problem->axes[i].direction[k]) && isfinite(problem->axes[i].point[k]);
        }
    }
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 4; k++) {
            fine = fine && isfinite(problem->tool.m[i][k]);
        }
    }
    return fine;
}

static bool has_axes(const problem *problem)
{
    bool fine = true;
    for (size_t i = 0; i < problem->n; i++) {
        const double *direction = problem->axes[i].direction;
        fine = fine && problem->axes[i].joint != ARMTOL_FIXED &&
               (direction[0] != 0 || direction[1] != 0 || direction[2] != 0);
    }
    return fine;
}

static void check_refusal(const problem *problem, armtol_status status)
{
    if (problem->n == 0) {
        REQUIRE(status == ARMTOL_WRONG_SIZE);
    } else if (status == ARMTOL_BAD_AXIS) {
        REQUIRE(!has_axes(problem));
    } else {
        REQUIRE(status == ARMTOL_NOT_FINITE && (problem->wild || !is_finite(problem)));
    }
}

/* ---- the table ---- */

static void check_angle(double angle)
{
    REQUIRE(angle > -PI - 1e-15 && angle <= PI);
    const double quarters = angle / (PI / 2);
    REQUIRE(fabs(quarters - round(quarters)) == 0 || fabs(angle - round(quarters) * (PI / 2)) > 0.9e-13);
}

static void check_kind(const armtol_link *link)
{
    const bool parallel = link->kind == ARMTOL_PPR || link->kind == ARMTOL_PPP;
    const bool prismatic = link->kind == ARMTOL_NPP || link->kind == ARMTOL_PPP;
    REQUIRE(link->joint == ARMTOL_FIXED ? !prismatic : prismatic == (link->joint == ARMTOL_PRISMATIC));
    REQUIRE(parallel || link->beta == 0 || link->joint == ARMTOL_FIXED);
    REQUIRE(link->kind != ARMTOL_NPP || link->a == 0);
    REQUIRE(link->a >= 0);
}

static void check_table(const problem *problem, const armtol_link links[], size_t n_links)
{
    REQUIRE(n_links >= problem->n && n_links <= ARMTOL_LINKS_OF_AXES(problem->n));
    REQUIRE(armtol_links_check(links, n_links) == ARMTOL_OK);
    size_t axis = 0;
    for (size_t i = 0; i < n_links; i++) {
        if (links[i].joint != ARMTOL_FIXED) {
            REQUIRE(axis < problem->n && links[i].joint == problem->axes[axis].joint);
            axis++;
        }
        check_kind(&links[i]);
        check_angle(links[i].alpha);
        check_angle(links[i].theta);
        check_angle(links[i].beta);
    }
    REQUIRE(axis == problem->n);
}

/* ---- kinematics ---- */

static armtol_transform reached(const problem *problem, const double q[])
{
    armtol_transform chain = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    for (size_t i = 0; i < problem->n; i++) {
        const armtol_transform motion = motion_of_axis(&problem->axes[i], q[i]);
        chain = motion_product(&chain, &motion);
    }
    return motion_product(&chain, &problem->tool);
}

/* All lengths that come in, links' own included: rounding is measured by them. */
static double size_of(const problem *problem, const armtol_link links[], size_t n_links)
{
    double size = 1e-300;
    for (size_t i = 0; i < problem->n; i++) {
        for (int k = 0; k < 3; k++) {
            size += problem->axes[i].joint == ARMTOL_REVOLUTE ? fabs(problem->axes[i].point[k]) : 0;
        }
    }
    for (int k = 0; k < 3; k++) {
        size += fabs(problem->tool.m[k][3]);
    }
    for (size_t i = 0; i < n_links; i++) {
        size += fabs(links[i].a) + fabs(links[i].d);
    }
    return size;
}

/* By how much what was taken for exact may turn and move the tool; slides go as far as `size`. */
static motion_difference allowed(const table *table, double size)
{
    motion_difference allowed = {.angle = 1e-11, .length = 1e-11 * (size + 1e-300)};
    for (size_t i = 0; i < table->n_snapped; i++) {
        allowed.angle += 2 * table->snapped[i].angle;
        allowed.length += 2 * (table->snapped[i].angle * (1 + MOST_AXES) * size + table->snapped[i].distance);
    }
    return allowed;
}

static void check_kinematics(const problem *problem, const table *table, uint64_t seed)
{
    random_source random = {seed};
    const armtol_link *const links = table->links;
    const size_t n_links = table->n_links;
    const double size = size_of(problem, links, n_links);
    const motion_difference limit = allowed(table, size);
    for (int i = 0; i < 3; i++) {
        double q[MOST_AXES];
        armtol_link placed[ARMTOL_LINKS_OF_AXES(MOST_AXES)];
        for (size_t k = 0; k < problem->n; k++) {
            const double most = problem->axes[k].joint == ARMTOL_PRISMATIC ? size : PI;
            q[k] = i == 0 ? 0 : random_between(&random, -most, most);
        }
        REQUIRE(armtol_links_place(links, n_links, q, problem->n, &armtol_errata_none, placed) == ARMTOL_OK);
        const armtol_transform expected = reached(problem, q);
        const armtol_transform actual = armtol_chain_transform(placed, n_links, &armtol_errata_none);
        const motion_difference difference = motion_compare(&expected, &actual);
        REQUIRE(difference.angle <= limit.angle);
        REQUIRE(difference.length <= limit.length);
    }
}

/* As many axes and the same tool; and each row has a kind that its joint can be of. */
static void check_as_table(const problem *problem, const table *table)
{
    enum { MOST_ROWS = ARMTOL_LINKS_OF_AXES(MOST_AXES) };
    armtol_axis axes[MOST_ROWS];
    armtol_kind kinds[MOST_ROWS];
    armtol_transform tool;
    size_t n_axes;
    const armtol_status status = armtol_axes_of_links(table->links, table->n_links, axes, &n_axes, &tool);
    if (status == ARMTOL_OK) {
        REQUIRE(n_axes == problem->n);
        REQUIRE(armtol_kinds_of_links(table->links, table->n_links, axes, kinds) == ARMTOL_OK);
        for (size_t i = 0; i < table->n_links; i++) {
            armtol_link link = table->links[i];
            link.kind = kinds[i];
            REQUIRE(link.joint != ARMTOL_FIXED || link.kind == ARMTOL_NPR);
            REQUIRE((link.joint == ARMTOL_PRISMATIC) == (link.kind == ARMTOL_NPP || link.kind == ARMTOL_PPP));
        }
    } else {
        REQUIRE(status == ARMTOL_NOT_FINITE && problem->wild);
    }
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    caught_start("axes");
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    bytes bytes = bytes_start(data, size);
    problem problem;
    table table = {.n_links = 0};
    take_problem(&bytes, &problem);
    const armtol_status status = armtol_links_of_axes(problem.axes, problem.n, &problem.tool, problem.snap, table.links,
                                                      &table.n_links, table.snapped, &table.n_snapped);
    if (status != ARMTOL_OK) {
        check_refusal(&problem, status);
        return 0;
    }
    REQUIRE(is_finite(&problem) && has_axes(&problem) && problem.n > 0);
    check_table(&problem, table.links, table.n_links);
    check_as_table(&problem, &table);
    if (!problem.wild) {
        check_kinematics(&problem, &table, bytes_hash(data, size));
    }
    return 0;
}
