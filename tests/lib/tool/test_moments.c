/*
 * What loads make of joints: closed forms of one link, and the difference quotients of potential energy. A joint that
 * turns changes the energy by a sine and a cosine of its angle, one that slides by a straight line: of both a central
 * difference is the derivative, exactly, a quarter turn or any length apart.
 */

#include "armtol/arm.h"
#include "armtol/loads.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"

#include "unity.h"

#include <math.h>

enum { LINKS = 7, TRIES = 400 };

static const double pi = 3.14159265358979323846, g = 9.80665;

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- one link ---- */

/* Turning about a level axis, y of the base: link 0 lies the axis down. */
static void level(double q, double length, armtol_link links[2])
{
    links[0] = (armtol_link){.kind = ARMTOL_NPR, .joint = ARMTOL_FIXED, .alpha = pi / 2};
    links[1] = (armtol_link){.kind = ARMTOL_PPR, .joint = ARMTOL_REVOLUTE, .a = length, .theta = q};
}

static void test_one_link_bears_m_g_l_cos_q(void)
{
    for (int i = -18; i <= 18; i++) {
        const double q = i * pi / 18;
        armtol_link links[2];
        double moments[2];
        level(q, 0.8, links);
        const armtol_mass masses[2] = {{5, {0.1, 0.2, 0.3}}, {2, {-0.3, 0, 0}}};
        const armtol_mass payload = {3, {0.1, 0, 0}};
        const armtol_tool_point tool = {.offset = {0.1, 0, 0}};
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                              armtol_moments(links, 2, masses, &tool, &payload, &armtol_loading_standard, moments));
        check_within(1e-13, -g * (2 * 0.5 + 3 * 1) * cos(q), moments[1], "q = %g", q);
        check_same(0, moments[0], "a fixed link");
    }
}

static void test_a_force_at_the_tool(void)
{
    armtol_link links[2];
    double moments[2];
    level(0, 0.8, links);
    const armtol_loading push = {.force = {0, 7, 11}};
    const armtol_tool_point tool = {.offset = {0.2, 0, 0}};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_moments(links, 2, NULL, &tool, NULL, &push, moments));
    check_within(1e-14, 11.0, moments[1], "11 N on a metre");
}

static void test_a_slide_bears_the_force_along_it(void)
{
    const armtol_link link = {.kind = ARMTOL_NPP, .joint = ARMTOL_PRISMATIC, .d = 0.3, .alpha = 1};
    const armtol_mass mass = {4, {1, 2, 3}};
    const armtol_loading loading = {.gravity = {1, 2, -3}, .force = {5, 6, 7}};
    double force;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_moments(&link, 1, &mass, &armtol_tool_origin, NULL, &loading, &force));
    check_within(1e-13, -3 * 4 + 7.0, force, "along z");
}

/* Otherwise rounding would say on which side of its play such a joint lies. */
static void test_what_rounding_leaves_is_nothing(void)
{
    random_source source = {1};
    for (int i = 0; i < TRIES; i++) {
        const armtol_link links[2] = {
            {.kind = ARMTOL_PPR, .joint = ARMTOL_REVOLUTE, .a = 0.3, .theta = random_between(&source, -3, 3)},
            {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 0.3, .theta = random_between(&source, -3, 3), .alpha = pi}};
        const armtol_mass masses[2] = {{3, {-0.1, 0.3, 0.2}}, {2, {-0.2, 0.1, 0.4}}};
        double moments[2];
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_moments(links, 2, masses, &armtol_tool_origin, NULL,
                                                        &armtol_loading_standard, moments));
        TEST_ASSERT_TRUE(moments[0] == 0 && moments[1] == 0);
    }
}

/* ---- potential energy ---- */

typedef struct sample {
    armtol_link links[LINKS];
    armtol_mass masses[LINKS], payload;
    armtol_tool_point tool;
    armtol_loading loading;
} sample;

static armtol_mass mass_of(random_source *source)
{
    armtol_mass mass = {.mass = random_between(source, 0, 5)};
    for (int i = 0; i < 3; i++) {
        mass.center[i] = random_between(source, -1, 1);
    }
    return mass;
}

static sample sample_of(random_source *source)
{
    sample sample;
    for (int i = 0; i < LINKS; i++) {
        sample.links[i] = (armtol_link){
            .kind = (armtol_kind)random_between(source, 0, ARMTOL_KIND_COUNT),
            .joint = (armtol_joint)random_between(source, 0, ARMTOL_JOINT_COUNT),
            .a = random_between(source, -1, 1),
            .alpha = random_between(source, -pi, pi),
            .d = random_between(source, -1, 1),
            .theta = random_between(source, -pi, pi),
            .beta = random_between(source, -1, 1),
        };
        sample.masses[i] = mass_of(source);
    }
    sample.payload = mass_of(source);
    for (int i = 0; i < 3; i++) {
        sample.tool.offset[i] = random_between(source, -1, 1);
        sample.loading.gravity[i] = random_between(source, -10, 10);
        sample.loading.force[i] = random_between(source, -10, 10);
    }
    return sample;
}

/* Force times place of a point of a frame. */
static double work(double frame[4][4], const double point[3], const double force[3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        sum += force[i] * (frame[i][0] * point[0] + frame[i][1] * point[1] + frame[i][2] * point[2] + frame[i][3]);
    }
    return sum;
}

/* The energy less its constant; the sum of all works. */
static double energy(const sample *sample)
{
    double frame[4][4], held[3], sum = 0;
    for (size_t i = 0; i < LINKS; i++) {
        reference_chain(sample->links, i + 1, frame);
        sum -= sample->masses[i].mass * work(frame, sample->masses[i].center, sample->loading.gravity);
    }
    for (int i = 0; i < 3; i++) {
        held[i] = sample->tool.offset[i] + sample->payload.center[i];
    }
    return sum - sample->payload.mass * work(frame, held, sample->loading.gravity) -
           work(frame, sample->tool.offset, sample->loading.force);
}

static double energy_at(const sample *sample, size_t link, double step)
{
    struct sample moved = *sample;
    moved.links[link].theta += moved.links[link].joint == ARMTOL_REVOLUTE ? step : 0;
    moved.links[link].d += moved.links[link].joint == ARMTOL_PRISMATIC ? step : 0;
    return energy(&moved);
}

static void test_moments_are_slopes_of_the_potential_energy(void)
{
    random_source source = {2};
    for (int i = 0; i < TRIES; i++) {
        const sample sample = sample_of(&source);
        double moments[LINKS];
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_moments(sample.links, LINKS, sample.masses, &sample.tool,
                                                        &sample.payload, &sample.loading, moments));
        for (size_t j = 0; j < LINKS; j++) {
            const bool turns = sample.links[j].joint == ARMTOL_REVOLUTE;
            const double step = turns ? pi / 2 : 1;
            const double slope = (energy_at(&sample, j, step) - energy_at(&sample, j, -step)) / 2;
            check_within(1e-11, sample.links[j].joint == ARMTOL_FIXED ? 0 : -slope, moments[j], "arm %d, link %zu", i,
                         j);
        }
    }
}

/* ---- Eq. (4.20) ---- */

static void check_offset(double shift, double half, armtol_drive_offset offset)
{
    check_within(1e-15, shift, offset.shift, "shift");
    check_within(1e-15, half, offset.half, "half width");
}

static void test_the_offset_of_a_drive(void)
{
    armtol_drive drive = armtol_drive_unknown;
    TEST_ASSERT_FALSE(armtol_drive_is_known(&drive));
    check_offset(0, 0, armtol_drive_offset_under(&drive, 5, 0, 0));
    drive.backlash = 0.3;
    drive.compliance = 0.02;
    drive.resolution = 0.001;
    drive.friction = 4;
    TEST_ASSERT_TRUE(armtol_drive_is_known(&drive));
    check_offset(0.02 * 5 + 0.3, 0.0005, armtol_drive_offset_under(&drive, 5, 0, 0));
    check_offset(-0.02 * 5 - 0.3, 0.0005, armtol_drive_offset_under(&drive, -5, 0, 0));
    check_offset(0.02 * 3, 0.3005, armtol_drive_offset_under(&drive, 3, 0, 0));
    check_offset(0.02 * 5 * 0.25 + 0.3, 0.0005, armtol_drive_offset_under(&drive, 5, 0, 0.75));
    check_offset(0, 0.02 * 10 + 0.3 + 0.0005, armtol_drive_offset_under(&drive, 0, 10, 0));
    check_offset(0.02 * 6, 0.02 * 3 + 0.3 + 0.0005, armtol_drive_offset_under(&drive, 6, 3, 0));
    drive.friction = 0;
    check_offset(0, 0.3005, armtol_drive_offset_under(&drive, 0, 0, 0));
}

static void test_what_is_known_of_a_drive(void)
{
    armtol_drive drive = armtol_drive_unknown;
    drive.resolution = 0.5;
    TEST_ASSERT_TRUE(armtol_drive_is_known(&drive));
    check_offset(0, 0.25, armtol_drive_offset_under(&drive, 1, 0, 0));
    drive = armtol_drive_unknown;
    drive.compliance = 0.5;
    TEST_ASSERT_TRUE(armtol_drive_is_known(&drive));
}

/* The parts of a half width that are drawn anew are what armtol_drive_offset_under adds up, less what stays. */
static void test_what_a_drive_is_off_by_at_each_arrival(void)
{
    armtol_drive drive = armtol_drive_unknown;
    armtol_drive_arrival arrival = armtol_drive_arrival_under(&drive, 1, 0);
    check_same(0, armtol_drive_arrival_half(&arrival), "nothing is known");
    drive.noise = 0.01;
    TEST_ASSERT_TRUE(armtol_drive_is_known(&drive));
    check_offset(0, 0.03, armtol_drive_offset_under(&drive, 1, 0, 0));
    drive.backlash = 0.3;
    drive.compliance = 0.02;
    drive.resolution = 0.001;
    drive.friction = 4;
    arrival = armtol_drive_arrival_under(&drive, 5, 0);
    check_same(0, arrival.play, "held at an end of its play");
    check_same(0.0005, arrival.step, "half a step");
    check_same(0.01, arrival.noise, "noise");
    check_within(1e-15, 0.0305, armtol_drive_arrival_half(&arrival), "half width, held");
    arrival = armtol_drive_arrival_under(&drive, 5, 2);
    check_same(0.15, arrival.play, "the moment may be less than the friction");
    check_offset(0.02 * 5, armtol_drive_arrival_half(&arrival) + 0.02 * 2 + 0.15,
                 armtol_drive_offset_under(&drive, 5, 2, 0));
}

/* ---- what is wrong ---- */

static armtol_status status_of(const armtol_mass *mass, const armtol_mass *payload, const armtol_loading *loading)
{
    const armtol_link link = {.kind = ARMTOL_NPR, .joint = ARMTOL_REVOLUTE, .a = 1};
    double moment;
    return armtol_moments(&link, 1, mass, &armtol_tool_origin, payload, loading, &moment);
}

static void test_what_is_no_load(void)
{
    const armtol_mass fine = {.mass = 1}, negative = {.mass = -1}, nowhere = {1, {0, (double)NAN, 0}},
                      huge = {1e300, {1e10, 1e10, 1e10}};
    const armtol_loading odd = {.gravity = {0, 0, (double)INFINITY}};
    double moment;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, status_of(&fine, &fine, &armtol_loading_standard));
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_LOAD, status_of(&negative, NULL, &armtol_loading_standard));
    TEST_ASSERT_EQUAL_INT(ARMTOL_BAD_LOAD, status_of(NULL, &negative, &armtol_loading_standard));
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, status_of(&nowhere, NULL, &armtol_loading_standard));
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, status_of(&huge, NULL, &armtol_loading_standard));
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOT_FINITE, status_of(&fine, NULL, &odd));
    TEST_ASSERT_EQUAL_INT(ARMTOL_NO_LINKS, armtol_moments(NULL, 0, NULL, &armtol_tool_origin, NULL,
                                                          &armtol_loading_standard, &moment));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_one_link_bears_m_g_l_cos_q);
    RUN_TEST(test_a_force_at_the_tool);
    RUN_TEST(test_a_slide_bears_the_force_along_it);
    RUN_TEST(test_what_rounding_leaves_is_nothing);
    RUN_TEST(test_moments_are_slopes_of_the_potential_energy);
    RUN_TEST(test_the_offset_of_a_drive);
    RUN_TEST(test_what_is_known_of_a_drive);
    RUN_TEST(test_what_a_drive_is_off_by_at_each_arrival);
    RUN_TEST(test_what_is_no_load);
    return UNITY_END();
}
