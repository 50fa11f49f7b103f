/*
 * One number for each of many poses. Its judges: closed forms of planar arms worked out here; the answer of the engine
 * to the same question about one pose, which goes another way; equations of the report.
 */

#include "armtol/answer.h"
#include "armtol/corners.h"
#include "armtol/link_transform.h"
#include "armtol/map.h"
#include "armtol/robots.h"
#include "support/check.h"

#include "unity.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846
#define G 9.80665

void setUp(void)
{
}

void tearDown(void)
{
}

enum { LINKS = 2, JOINTS = 2, SIDE = 21, GRID = SIDE * SIDE, MOST_COLUMNS = 64 };

/* Two links of 300 and 200 mm that turn about z, flat; parallel axes: theta, a, alpha, beta of each are errors. */
static const armtol_link flat[LINKS] = {
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 300},
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 200},
};

typedef struct flat_arm {
    armtol_drive drives[LINKS];
    armtol_arm arm;
    double q[GRID * JOINTS];
    double tolerances[MOST_COLUMNS];
    armtol_question question;
} flat_arm;

static flat_arm two;

static void make_flat(void)
{
    two = (flat_arm){
        .drives = {armtol_drive_unknown, armtol_drive_unknown},
        .arm = {.name = "flat", .title = "two links", .source = "the test", .n_links = LINKS, .links = flat},
        .question = {.arm = &two.arm, .q = two.q, .n_poses = GRID, .tolerances = two.tolerances},
    };
    two.arm.drives = two.drives;
    for (size_t i = 0; i < GRID; i++) {
        const size_t column = i % SIDE, row = i / SIDE;
        two.q[2 * i] = -PI + 2 * PI * (double)column / SIDE;
        two.q[2 * i + 1] = -PI + 2 * PI * (double)row / SIDE; /* 0 is in it: stretched */
    }
}

static void map_well(const armtol_question *question, armtol_map_value value, size_t component, double values[])
{
    armtol_fault fault;
    const armtol_map map = {.value = value, .component = component};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_map_values(question, &map, values, &fault));
    TEST_ASSERT_EQUAL_INT(ARMTOL_ABOUT_NOTHING, fault.about);
}

/*
 * With x = l1 c1 + l2 c12, y = l1 s1 + l2 s12: theta 1 moves the tool by (-y, x), theta 2 by (-l2 s12, l2 c12), a 1 by
 * (c1, s1), a 2 by (c12, s12); alpha and beta turn about lines in the plane and move it by z alone. A turn about the x
 * axis of frame 1 moves what is behind by l2 s2, about its y axis by -l2 c2; the last two are at the tool, and turn it.
 */
static void closed_form(const double q[2], const double t[8], double worst[3])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), c12 = cos(q[0] + q[1]), s12 = sin(q[0] + q[1]);
    const double x = 300 * c1 + 200 * c12, y = 300 * s1 + 200 * s12;
    worst[0] = fabs(y) * t[0] + fabs(c1) * t[1] + fabs(200 * s12) * t[4] + fabs(c12) * t[5];
    worst[1] = fabs(x) * t[0] + fabs(s1) * t[1] + fabs(200 * c12) * t[4] + fabs(s12) * t[5];
    worst[2] = fabs(200 * sin(q[1])) * t[2] + fabs(200 * cos(q[1])) * t[3];
}

static void test_the_worst_case_of_two_flat_links_in_closed_form(void)
{
    static double values[9][GRID];
    static const double t[8] = {1e-4, 0.02, 3e-4, 5e-4, 2e-4, 0.03, 1e-4, 1e-4};
    make_flat();
    memcpy(two.tolerances, t, sizeof t);
    for (size_t i = 0; i < ARMTOL_MAP_COMPONENT_COUNT; i++) {
        map_well(&two.question, ARMTOL_MAP_WORST, i, values[i]);
    }
    for (size_t p = 0; p < GRID; p++) {
        double worst[3];
        closed_form(two.q + 2 * p, t, worst);
        for (size_t i = 0; i < 3; i++) {
            check_within(1e-13, worst[i], values[i][p], "component %zu of pose %zu", i, p);
        }
        const double whole = sqrt(worst[0] * worst[0] + worst[1] * worst[1] + worst[2] * worst[2]);
        check_within(1e-13, whole, values[ARMTOL_MAP_POSITION][p], "position of pose %zu", p);
        check_within(1e-16, t[0] + t[4], values[5][p], "wz of pose %zu", p);
    }
}

/* ---- every built-in arm, against the engine's answer to each pose by itself ---- */

static double next_random(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (double)(*state >> 8) / (1 << 24);
}

enum { DRAWN = 77 };

typedef struct drawn {
    double q[DRAWN * 8], tolerances[MOST_COLUMNS], accuracy[6];
    armtol_question question;
    size_t n_joints, n_columns;
} drawn;

static void draw_poses(drawn *drawn, const armtol_arm *arm, uint32_t seed)
{
    static const double accuracy[6] = {0.5, 0.4, 0.3, 0.02, 0.03, 0.01};
    drawn->n_joints = armtol_arm_joint_count(arm);
    drawn->n_columns = armtol_column_count(arm->links, arm->n_links);
    for (size_t i = 0; i < DRAWN * drawn->n_joints; i++) {
        drawn->q[i] = 6 * next_random(&seed) - 3;
    }
    for (size_t k = 0; k < drawn->n_columns; k++) {
        drawn->tolerances[k] = 1e-3 * next_random(&seed);
    }
    memcpy(drawn->accuracy, accuracy, sizeof accuracy);
    drawn->question =
        (armtol_question){.arm = arm, .q = drawn->q, .n_poses = DRAWN, .tolerances = drawn->tolerances};
}

static armtol_answer *answer_of(const drawn *drawn, size_t pose)
{
    armtol_answer *answer;
    armtol_question one = drawn->question;
    one.q = drawn->q + pose * drawn->n_joints;
    one.n_poses = 1;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&one, &answer, NULL));
    return answer;
}

static void test_the_worst_case_is_the_answers_to_the_bit(void)
{
    static drawn drawn;
    static double values[ARMTOL_MAP_COMPONENT_COUNT][DRAWN];
    for (size_t a = 0; a < armtol_arm_count(); a++) {
        draw_poses(&drawn, armtol_arm_at(a), 7 + (uint32_t)a);
        drawn.question.tool = (armtol_tool_point){{10, -20, 50}, a % 2 == 0 ? ARMTOL_BASE_FRAME : ARMTOL_TOOL_FRAME};
        for (size_t i = 0; i < ARMTOL_MAP_COMPONENT_COUNT; i++) {
            map_well(&drawn.question, ARMTOL_MAP_WORST, i, values[i]);
        }
        for (size_t p = 0; p < DRAWN; p++) {
            armtol_answer *answer = answer_of(&drawn, p);
            for (size_t i = 0; i < 6; i++) {
                check_same(answer->components[i].worst, values[i][p], "%s, pose %zu, component %zu",
                           armtol_arm_at(a)->name, p, i);
            }
            const armtol_predicted *of = answer->components;
            check_within(1e-15, sqrt(of[3].worst * of[3].worst + of[4].worst * of[4].worst + of[5].worst * of[5].worst),
                         values[ARMTOL_MAP_ROTATION][p], "rotation");
            armtol_answer_destroy(answer);
        }
    }
}

/* A tolerance without a bound goes the other way, and so do drives: what no drive changes is the same. */
static void test_both_ways_to_the_worst_case_agree(void)
{
    static drawn drawn;
    static double fast[DRAWN], slow[DRAWN];
    const armtol_arm *puma = armtol_arm_named("puma560");
    armtol_drive drives[16];
    armtol_arm driven = *puma;
    for (size_t i = 0; i < puma->n_links; i++) {
        drives[i] = armtol_drive_unknown;
        drives[i].backlash = 0;
        drives[i].resolution = 1e-30; /* known, and in no error that counts */
    }
    driven.drives = drives;
    draw_poses(&drawn, puma, 3);
    map_well(&drawn.question, ARMTOL_MAP_WORST, ARMTOL_MAP_POSITION, fast);
    drawn.question.arm = &driven;
    map_well(&drawn.question, ARMTOL_MAP_WORST, ARMTOL_MAP_POSITION, slow);
    for (size_t p = 0; p < DRAWN; p++) {
        check_same(fast[p], slow[p], "pose %zu", p);
    }
    drawn.tolerances[5] = (double)INFINITY;
    map_well(&drawn.question, ARMTOL_MAP_WORST, 0, slow);
    TEST_ASSERT_TRUE(isinf(slow[3]));
    drawn.question.drives_apart = true;
    map_well(&drawn.question, ARMTOL_MAP_WORST, 0, fast);
    TEST_ASSERT_TRUE(isinf(fast[3]));
}

static void test_the_least_tolerance_is_that_of_an_answer_for_the_pose(void)
{
    static drawn drawn;
    static double values[DRAWN];
    bool lengths[MOST_COLUMNS] = {false};
    armtol_column columns[MOST_COLUMNS];
    const armtol_arm *arm = armtol_arm_named("ur5e");
    draw_poses(&drawn, arm, 11);
    drawn.question.tolerances = NULL;
    drawn.question.accuracy = drawn.accuracy;
    armtol_columns(arm->links, arm->n_links, columns, drawn.n_columns);
    for (size_t k = 0; k < drawn.n_columns; k++) {
        lengths[k] = armtol_parameter_is_length(columns[k].parameter);
    }
    const armtol_map map = {.value = ARMTOL_MAP_TOLERANCE, .columns = lengths};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_map_values(&drawn.question, &map, values, NULL));
    for (size_t p = 0; p < DRAWN; p++) {
        double least = (double)INFINITY;
        armtol_answer *answer = answer_of(&drawn, p);
        for (size_t k = 0; k < drawn.n_columns; k++) {
            least = lengths[k] ? fmin(least, answer->tolerances[k]) : least;
        }
        check_same(least, values[p], "pose %zu", p);
        armtol_answer_destroy(answer);
    }
}

/* ---- drives: one upright link of 500 mm, turned about y, with a mass at its end ---- */

typedef struct hanging {
    armtol_link links[2];
    armtol_drive drives[2];
    armtol_mass masses[2];
    armtol_arm arm;
    double q[40];
    armtol_question question;
} hanging;

static hanging boom;

/* Link 0 turns z to where y was: joint 1 then turns in the xz plane, upwards for q > 0. */
static void make_boom(void)
{
    boom = (hanging){
        .links = {{ARMTOL_NPR, ARMTOL_FIXED, .alpha = PI / 2}, {ARMTOL_NPR, ARMTOL_REVOLUTE, .a = 500}},
        .drives = {armtol_drive_unknown, armtol_drive_unknown},
        .masses = {{0, {0, 0, 0}}, {4, {0, 0, 0}}},
        .arm = {.name = "boom", .title = "a boom", .source = "the test", .n_links = 2},
        .question = {.arm = &boom.arm, .q = boom.q, .n_poses = 40},
    };
    boom.arm.links = boom.links;
    boom.arm.drives = boom.drives;
    boom.arm.masses = boom.masses;
    for (size_t i = 0; i < 40; i++) {
        boom.q[i] = -3.0 + 0.15 * (double)i;
    }
}

/* It gives way by c m g l cos q: the tool sinks by l (sin(q) - sin(q - that)), and moves by the chord of it. */
static void test_the_droop_of_a_boom_in_closed_form(void)
{
    double whole[40], dz[40];
    const double compliance = 2e-6, moment = 4 * G * 0.5;
    make_boom();
    boom.drives[1].backlash = 0;
    boom.drives[1].compliance = compliance;
    map_well(&boom.question, ARMTOL_MAP_DROOP, ARMTOL_MAP_POSITION, whole);
    map_well(&boom.question, ARMTOL_MAP_DROOP, 2, dz);
    for (size_t i = 0; i < 40; i++) {
        const double q = boom.q[i], turn = compliance * moment * cos(q);
        check_within(1e-10, 2 * 500 * fabs(sin(turn / 2)), whole[i], "droop at %g", q);
        check_within(1e-10, fabs(500 * (sin(q) - sin(q - turn))), dz[i], "dz at %g", q);
    }
}

/*
 * Half a step and three of the noise to either side everywhere; half the play beside it where the moment is no more
 * than the friction.
 */
static void test_what_is_left_open_at_each_arrival(void)
{
    double values[40];
    const double play = 1e-4, step = 2e-5, noise = 3e-6, friction = 8;
    make_boom();
    boom.drives[1] = (armtol_drive){.low = -4, .high = 4, .backlash = play, .compliance = 1e-5, .resolution = step,
                                    .friction = friction, .noise = noise};
    map_well(&boom.question, ARMTOL_MAP_REPEATABILITY, ARMTOL_MAP_POSITION, values);
    int held = 0;
    for (size_t i = 0; i < 40; i++) {
        const double q = boom.q[i], moment = 4 * G * 0.5 * fabs(cos(q));
        const double half = step / 2 + 3 * noise + (moment >= friction ? 0 : play / 2);
        held += moment >= friction;
        check_within(1e-12, 500 * half, values[i], "repeatability at %g", q);
    }
    TEST_ASSERT_TRUE(held > 5 && held < 35);
}

/* Of two loads the larger; what --wish motors leaves out of the errors is asked for here all the same. */
static void test_the_largest_of_all_loads_counts(void)
{
    double one[40], both[40];
    const armtol_mass payloads[2] = {{3, {0, 0, 0}}, {1, {0, 0, 0}}};
    armtol_loading loading = armtol_loading_standard;
    loading.n_payloads = 1;
    loading.payloads = payloads;
    make_boom();
    boom.drives[1].backlash = 0;
    boom.drives[1].compliance = 2e-6;
    boom.question.loading = &loading;
    map_well(&boom.question, ARMTOL_MAP_DROOP, 2, one);
    loading.n_payloads = 2;
    boom.question.drives_apart = true;
    map_well(&boom.question, ARMTOL_MAP_DROOP, 2, both);
    for (size_t i = 0; i < 40; i++) {
        check_same(one[i], both[i], "load of pose %zu", i);
    }
}

/* ---- poses that could not be reached, and what is wrong ---- */

static void test_a_pose_out_of_reach_has_no_value(void)
{
    static double worst[GRID], droop[GRID];
    make_flat();
    two.tolerances[0] = 1e-3;
    two.q[2 * 5] = two.q[2 * 5 + 1] = (double)NAN;
    map_well(&two.question, ARMTOL_MAP_WORST, 1, worst);
    map_well(&two.question, ARMTOL_MAP_DROOP, 1, droop);
    TEST_ASSERT_TRUE(isnan(worst[5]) && isnan(droop[5]));
    TEST_ASSERT_TRUE(worst[4] > 0 && worst[6] > 0);
}

static void check_fault(const armtol_map *map, armtol_status status, armtol_subject about, size_t number)
{
    static double values[GRID];
    armtol_fault fault;
    TEST_ASSERT_EQUAL_INT(status, armtol_map_values(&two.question, map, values, &fault));
    TEST_ASSERT_EQUAL_INT(status, fault.status);
    TEST_ASSERT_EQUAL_INT(about, fault.about);
    TEST_ASSERT_EQUAL_UINT(number, fault.number);
}

static void test_what_is_wrong_is_said(void)
{
    const armtol_map worst = {.value = ARMTOL_MAP_WORST}, tolerance = {.value = ARMTOL_MAP_TOLERANCE};
    const armtol_map none = {.value = ARMTOL_MAP_VALUE_COUNT};
    const armtol_map seventh = {.value = ARMTOL_MAP_WORST, .component = ARMTOL_MAP_COMPONENT_COUNT};
    const armtol_map droop = {.value = ARMTOL_MAP_DROOP};
    make_flat();
    check_fault(&none, ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0);
    check_fault(&seventh, ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0);
    check_fault(&tolerance, ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0);
    two.q[2 * 300 + 1] = (double)INFINITY;
    check_fault(&worst, ARMTOL_NOT_FINITE, ARMTOL_ABOUT_POSE, 300);
    check_fault(&droop, ARMTOL_NOT_FINITE, ARMTOL_ABOUT_POSE, 300);
    two.tolerances[3] = -1;
    check_fault(&worst, ARMTOL_BAD_TOLERANCE, ARMTOL_ABOUT_TOLERANCES, 3);
    two.drives[1].compliance = 1;
    check_fault(&worst, ARMTOL_BAD_LOAD, ARMTOL_ABOUT_DRIVES, 1);
    check_fault(&droop, ARMTOL_BAD_LOAD, ARMTOL_ABOUT_DRIVES, 1);
    two.question.n_poses = 0;
    check_fault(&droop, ARMTOL_BAD_QUESTION, ARMTOL_ABOUT_QUESTION, 0);
    TEST_ASSERT_EQUAL_STRING("repeatability", armtol_map_value_name(ARMTOL_MAP_REPEATABILITY));
    TEST_ASSERT_EQUAL_STRING("?", armtol_map_value_name(ARMTOL_MAP_VALUE_COUNT));
}

/* |y| t is more than a number can be in one pose. */
static void test_a_worst_case_that_overflows_is_said(void)
{
    armtol_link far[LINKS];
    const armtol_map worst = {.value = ARMTOL_MAP_WORST, .component = 0};
    make_flat();
    memcpy(far, flat, sizeof far);
    far[0].a = 1e308;
    two.arm.links = far;
    two.tolerances[0] = 10;
    for (size_t p = 0; p < GRID; p++) {
        two.q[2 * p] = p == 123 ? 1 : 0;
    }
    check_fault(&worst, ARMTOL_NOT_FINITE, ARMTOL_ABOUT_POSE, 123);
}

/* Play that takes more than the accuracy leaves no tolerance. */
static void test_where_nothing_is_left_the_tolerance_is_0(void)
{
    static double values[GRID];
    static const double accuracy[6] = {0.1, 0.1, 0.1, 1, 1, 1};
    const bool all[MOST_COLUMNS] = {true, true, true, true, true, true, true, true};
    const armtol_map map = {.value = ARMTOL_MAP_TOLERANCE, .columns = all};
    make_flat();
    two.question.tolerances = NULL;
    two.question.accuracy = accuracy;
    two.drives[0].backlash = 0.1 / 300; /* enough at the elbow, too much where the arm is stretched */
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_map_values(&two.question, &map, values, NULL));
    for (size_t p = 0; p < GRID; p++) {
        const double *q = two.q + 2 * p, c = cos(q[0] + q[1]), s = sin(q[0] + q[1]);
        const double most = fmax(fabs(300 * cos(q[0]) + 200 * c), fabs(300 * sin(q[0]) + 200 * s));
        TEST_ASSERT_TRUE((values[p] > 0) == (most < 300));
    }
}

/* ---- joint values for the points of a plane ---- */

enum { WIDE = 29, HIGH = 27, POINTS = WIDE * HIGH };

typedef struct plane_map {
    double q[POINTS * 8];
    unsigned char marks[POINTS];
    armtol_map_plane plane;
} plane_map;

static plane_map found;

/* Upright or level, through `first`, with sides of `step`. */
static armtol_map_plane plane_of(const double first[3], size_t up, double step)
{
    armtol_map_plane plane = {.n_across = WIDE, .n_up = HIGH, .axes = armtol_transform_identity(), .point_only = true};
    memcpy(plane.first, first, sizeof plane.first);
    plane.across[0] = step;
    plane.up[up] = step;
    return plane;
}

static void point_of(const armtol_map_plane *plane, size_t k, double point[3])
{
    const size_t column = k % WIDE, row = k / WIDE;
    for (int d = 0; d < 3; d++) {
        point[d] = plane->first[d] + (double)column * plane->across[d] + (double)row * plane->up[d];
    }
}

static void find_poses(const armtol_inverse_setup *setup)
{
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_map_poses(setup, &found.plane, NULL, NULL, found.q, found.marks));
}

/* The tool by the chain's transform, a routine that the search does not use. */
static void tool_of(const armtol_inverse_setup *setup, const double q[], armtol_transform *tool)
{
    armtol_link links[16];
    const armtol_arm *arm = setup->arm;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_arm_place(arm, q, armtol_arm_joint_count(arm), links));
    *tool = armtol_chain_transform(links, arm->n_links, &armtol_errata_none);
    for (int i = 0; i < 3; i++) {
        const double *row = tool->m[i], *offset = setup->offset;
        tool->m[i][3] += row[0] * offset[0] + row[1] * offset[1] + row[2] * offset[2];
    }
}

static size_t check_reached(const armtol_inverse_setup *setup)
{
    const size_t n = armtol_arm_joint_count(setup->arm);
    size_t reached = 0;
    for (size_t k = 0; k < POINTS; k++) {
        if ((found.marks[k] & ARMTOL_MAP_REACHED) == 0) {
            TEST_ASSERT_TRUE(isnan(found.q[k * n]) && found.marks[k] == 0);
            continue;
        }
        double point[3];
        armtol_transform tool;
        reached++;
        point_of(&found.plane, k, point);
        tool_of(setup, found.q + k * n, &tool);
        for (int d = 0; d < 3; d++) {
            check_within(1e-6, point[d], tool.m[d][3], "point %zu", k);
            for (int e = 0; e < 3 && !found.plane.point_only; e++) {
                check_within(1e-9, found.plane.axes.m[d][e], tool.m[d][e], "axes at point %zu", k);
            }
        }
    }
    return reached;
}

/* Two flat links reach what is neither nearer than their difference nor farther than their sum, and nothing else. */
static void test_two_flat_links_reach_a_ring(void)
{
    const double first[3] = {-560, -520, 0}, near[2] = {0.3, 1.2};
    const armtol_inverse_setup setup = {.arm = &two.arm, .near = near};
    make_flat();
    found.plane = plane_of(first, 1, 40);
    find_poses(&setup);
    check_reached(&setup);
    for (size_t k = 0; k < POINTS; k++) {
        double point[3];
        point_of(&found.plane, k, point);
        const double r = sqrt(point[0] * point[0] + point[1] * point[1]);
        if (fabs(r - 100) > 1e-6 && fabs(r - 500) > 1e-6) {
            TEST_ASSERT_TRUE_MESSAGE((found.marks[k] != 0) == (r > 100 && r < 500), "the ring");
        }
        if (found.marks[k] != 0 && r > 140 && r < 460) { /* the elbow stays on the side on which it began */
            TEST_ASSERT_TRUE(sin(found.q[2 * k + 1]) > 0);
        }
    }
}

/* The elbow's limits leave one side of it above, the other below: between them is a seam, and nowhere else. */
static void test_a_seam_lies_where_the_arm_changes_its_elbow(void)
{
    const double first[3] = {-560, -520, 0}, near[2] = {0.3, 1.2};
    const armtol_inverse_setup setup = {.arm = &two.arm, .near = near};
    size_t seams = 0;
    make_flat();
    two.drives[0].low = -1.5;
    two.drives[0].high = 1.5;
    two.drives[1].low = -2.6;
    two.drives[1].high = 2.6;
    found.plane = plane_of(first, 1, 40);
    find_poses(&setup);
    TEST_ASSERT_TRUE(check_reached(&setup) > 100);
    for (size_t k = 0; k < POINTS; k++) {
        const bool next = k % WIDE + 1 < WIDE && found.marks[k] != 0 && found.marks[k + 1] != 0;
        if (!next) {
            TEST_ASSERT_TRUE((found.marks[k] & ARMTOL_MAP_JOINS_NEXT) == 0);
            continue;
        }
        const double *one = found.q + 2 * k, *other = one + 2;
        const bool joined = (found.marks[k] & ARMTOL_MAP_JOINS_NEXT) != 0;
        TEST_ASSERT_TRUE(fabs(one[0]) <= 1.5 && fabs(one[1]) <= 2.6);
        if (fabs(one[1]) > 0.5 && fabs(other[1]) > 0.5) { /* away from where the two sides meet */
            TEST_ASSERT_TRUE(joined == ((one[1] > 0) == (other[1] > 0)));
        }
        seams += !joined;
    }
    TEST_ASSERT_TRUE(seams > 0);
}

/* A Puma that keeps its tool's axes: all that is reached is reached by them. */
static void test_the_axes_are_kept(void)
{
    const double first[3] = {-800, -150, -500}, near[6] = {0, 0.8, -2.8, 0, 0.9, 0}, offset[3] = {0, 0, 80};
    armtol_inverse_setup setup = {.arm = armtol_arm_named("puma560"), .near = near};
    armtol_transform tool;
    memcpy(setup.offset, offset, sizeof offset);
    found.plane = plane_of(first, 2, 55);
    tool_of(&setup, near, &tool);
    found.plane.axes = tool;
    found.plane.point_only = false;
    find_poses(&setup);
    TEST_ASSERT_TRUE(check_reached(&setup) > 100);
}

/* The arms of 1987 by their own inverse kinematics: the Adept's reach is a ring too, whatever its quill does. */
static void test_the_arms_of_1987_go_their_own_way(void)
{
    const double first[3] = {-840, -780, 100};
    const armtol_inverse_setup setup = {.arm = armtol_arm_named("adeptone")};
    found.plane = plane_of(first, 1, 60);
    found.plane.point_only = false;
    find_poses(&setup);
    check_reached(&setup);
    for (size_t k = 0; k < POINTS; k++) {
        double point[3], wish[4] = {0}, q[4];
        armtol_reach reach;
        point_of(&found.plane, k, point);
        memcpy(wish, point, sizeof point);
        const armtol_status status = armtol_adept_one.inverse(wish, &armtol_errata_none, q, &reach);
        TEST_ASSERT_TRUE((status == ARMTOL_OK) == (found.marks[k] != 0));
        for (int j = 0; j < 4 && status == ARMTOL_OK; j++) {
            check_within(1e-9, q[j], found.q[4 * k + (size_t)j], "joint %d of point %zu", j, k);
        }
    }
}

/* ---- in parts ---- */

static armtol_status find_part(const armtol_inverse_setup *setup, size_t first, size_t count, unsigned char results[],
                               const double q[])
{
    const armtol_map_search search = {first, count, results, q};
    return armtol_map_poses_in_parts(setup, &found.plane, &search, NULL, NULL, found.q, found.marks);
}

/* Rows from `row` on, as a process for itself: its results, and joint values where a search found them, are added. */
static size_t share_rows(const armtol_inverse_setup *setup, size_t row, size_t rows, unsigned char results[],
                         double q[])
{
    static unsigned char own[POINTS];
    const size_t n = armtol_arm_joint_count(setup->arm), first = row * WIDE, count = rows * WIDE;
    memset(own, ARMTOL_MAP_NOT_SEARCHED, sizeof own);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, find_part(setup, first, count, own, NULL));
    memcpy(results + first, own + first, count);
    memcpy(q + first * n, found.q + first * n, count * n * sizeof *q);
    return check_reached(setup);
}

/*
 * A strip that cuts a ring in two: from the one piece no step leads to the other, which is found by a search in one of
 * every third row alone. So a part of rows between them does not have all of it, and together they have, to the bit.
 */
static void test_parts_of_two_pieces_are_the_whole(void)
{
    static unsigned char results[POINTS], marks[POINTS];
    static double q[POINTS * 8], whole[POINTS * 8];
    const double first[3] = {-560, -65, 0}, near[2] = {0, 1.5};
    const armtol_inverse_setup setup = {.arm = &two.arm, .near = near};
    make_flat();
    found.plane = plane_of(first, 1, 40);
    found.plane.up[1] = 5;
    find_poses(&setup);
    const size_t all = check_reached(&setup);
    memcpy(whole, found.q, sizeof whole);
    memcpy(marks, found.marks, sizeof marks);
    TEST_ASSERT_TRUE(share_rows(&setup, 3, HIGH - 3, results, q) == all);
    TEST_ASSERT_TRUE(share_rows(&setup, 1, 2, results, q) < all);
    TEST_ASSERT_TRUE(share_rows(&setup, 0, 1, results, q) == all);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, find_part(&setup, 0, POINTS, results, q));
    TEST_ASSERT_EQUAL_INT(0, memcmp(marks, found.marks, sizeof marks));
    for (size_t k = 0; k < POINTS * 2; k++) {
        TEST_ASSERT_TRUE(isnan(whole[k]) ? isnan(found.q[k]) : memcmp(&whole[k], &found.q[k], sizeof *q) == 0);
    }
}

static size_t count_of(const unsigned char results[], size_t n, unsigned char result)
{
    size_t count = 0;
    for (size_t k = 0; k < n; k++) {
        count += results[k] == result;
    }
    return count;
}

/* Beyond its points a part searches in the first of all, and nowhere else; what is known is not searched again. */
static void test_a_part_searches_in_its_own_points(void)
{
    static unsigned char results[POINTS];
    const double first[3] = {-560, -520, 0}, near[2] = {0.3, 1.2};
    const armtol_inverse_setup setup = {.arm = &two.arm, .near = near};
    make_flat();
    found.plane = plane_of(first, 1, 40);
    memset(results, ARMTOL_MAP_NOT_SEARCHED, sizeof results);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, find_part(&setup, 0, 0, results, NULL));
    TEST_ASSERT_EQUAL_UINT(1, count_of(results, POINTS, ARMTOL_MAP_FOUND));
    TEST_ASSERT_EQUAL_UINT(0, count_of(results, POINTS, ARMTOL_MAP_IN_VAIN));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, find_part(&setup, 0, WIDE, results, NULL));
    TEST_ASSERT_EQUAL_UINT(10, count_of(results, WIDE, ARMTOL_MAP_IN_VAIN)); /* every third of 29, beyond the ring */
    TEST_ASSERT_EQUAL_UINT(10, count_of(results, POINTS, ARMTOL_MAP_IN_VAIN));
    memset(results, ARMTOL_MAP_IN_VAIN, sizeof results);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, find_part(&setup, 0, POINTS, results, NULL));
    TEST_ASSERT_EQUAL_UINT(0, check_reached(&setup)); /* as it was told */
}

static bool end_at(void *context, size_t done, size_t total)
{
    TEST_ASSERT_EQUAL_UINT(POINTS, total);
    TEST_ASSERT_TRUE(done <= total);
    return done < *(const size_t *)context;
}

static void test_whoever_waits_can_end_it(void)
{
    const double first[3] = {-560, -520, 0}, near[2] = {0.3, 1.2};
    const armtol_inverse_setup setup = {.arm = &two.arm, .near = near};
    make_flat();
    found.plane = plane_of(first, 1, 40);
    find_poses(&setup);
    const size_t all = check_reached(&setup);
    for (size_t most = 1; most < POINTS; most += 97) {
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_map_poses(&setup, &found.plane, end_at, &most, found.q, found.marks));
        const size_t reached = check_reached(&setup);
        TEST_ASSERT_TRUE(most < all ? reached < all && reached <= most + 4 : reached <= all);
    }
}

static void test_a_plane_that_is_none(void)
{
    const armtol_inverse_setup setup = {.arm = &two.arm};
    const double first[3] = {0, 0, (double)NAN};
    make_flat();
    found.plane = plane_of(first, 1, 40);
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE,
                          armtol_map_poses(&setup, &found.plane, NULL, NULL, found.q, found.marks));
    found.plane.n_up = 0;
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_QUESTION,
                          armtol_map_poses(&setup, &found.plane, NULL, NULL, found.q, found.marks));
    found.plane = plane_of((const double[3]){-560, -520, 300}, 1, 40); /* above all that a flat arm reaches */
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_map_poses(&setup, &found.plane, NULL, NULL, found.q, found.marks));
    TEST_ASSERT_EQUAL_UINT(0, check_reached(&setup));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_worst_case_of_two_flat_links_in_closed_form);
    RUN_TEST(test_the_worst_case_is_the_answers_to_the_bit);
    RUN_TEST(test_both_ways_to_the_worst_case_agree);
    RUN_TEST(test_the_least_tolerance_is_that_of_an_answer_for_the_pose);
    RUN_TEST(test_the_droop_of_a_boom_in_closed_form);
    RUN_TEST(test_what_is_left_open_at_each_arrival);
    RUN_TEST(test_the_largest_of_all_loads_counts);
    RUN_TEST(test_a_pose_out_of_reach_has_no_value);
    RUN_TEST(test_what_is_wrong_is_said);
    RUN_TEST(test_a_worst_case_that_overflows_is_said);
    RUN_TEST(test_where_nothing_is_left_the_tolerance_is_0);
    RUN_TEST(test_two_flat_links_reach_a_ring);
    RUN_TEST(test_a_seam_lies_where_the_arm_changes_its_elbow);
    RUN_TEST(test_the_axes_are_kept);
    RUN_TEST(test_the_arms_of_1987_go_their_own_way);
    RUN_TEST(test_parts_of_two_pieces_are_the_whole);
    RUN_TEST(test_a_part_searches_in_its_own_points);
    RUN_TEST(test_whoever_waits_can_end_it);
    RUN_TEST(test_a_plane_that_is_none);
    return UNITY_END();
}
