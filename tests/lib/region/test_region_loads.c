/*
 * The largest errors of a region when loads bend the drives. Judges: closed forms of arms of one and two links in a
 * plane, as a mass pulls on them across their axes; the engine's own answers in the poses that are named. Drawn poses
 * of all built-in arms are in region_loads.c.
 */

#include "armtol/region.h"
#include "support/check.h"

#include "unity.h"

#include <math.h>

#define FREE ((double)INFINITY)

enum { DX, DY, DZ, COLUMNS_1 = 4, COLUMNS_2 = 8 };

static const double gravity = 10, length_1 = 300, length_2 = 200, none[COLUMNS_2] = {0};
static const armtol_link links[] = {
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 300},
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 200},
};
static armtol_drive drives[2];
static armtol_mass masses[2], payloads[2];
static armtol_arm arm;
static armtol_loading loading;
static armtol_question question;
static double low[2], high[2], accuracy[6];
static const armtol_region region = {.low = low, .high = high};

/* Links in the plane of x and y, which masses fall along -y in. One is held at the tool: 4 kg. */
void setUp(void)
{
    for (int i = 0; i < 2; i++) {
        drives[i] = armtol_drive_unknown;
        low[i] = high[i] = 0;
    }
    payloads[0] = (armtol_mass){.mass = 4};
    loading = (armtol_loading){.gravity = {0, -gravity, 0}, .payloads = payloads, .n_payloads = 1};
    arm = (armtol_arm){.name = "planar", .title = "", .source = "", .unit = ARMTOL_MILLIMETRE, .n_links = 1,
                       .links = links, .drives = drives};
    question = (armtol_question){.arm = &arm, .tolerances = none, .loading = &loading, .accuracy = accuracy};
}

void tearDown(void)
{
}

static armtol_region_answer *answer_of(unsigned component, double gap)
{
    armtol_region_answer *answer;
    const armtol_enclosing how = {.gap = gap};
    for (unsigned i = 0; i < 6; i++) {
        accuracy[i] = component == i ? 1e9 : FREE;
    }
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_region_answer_create(&question, &region, &how, &answer, NULL, NULL));
    return answer;
}

/* The bounds of one measure are on both sides of the expected, no further apart than asked. */
static void check_encloses(double expected, unsigned component, double gap, const char *what)
{
    armtol_region_answer *answer = answer_of(component, gap);
    const armtol_enclosure *found = &answer->enclosures[0];
    TEST_ASSERT_TRUE_MESSAGE(found->ended == ARMTOL_ENDED_GAP && found->low <= expected * (1 + 1e-9), what);
    TEST_ASSERT_TRUE_MESSAGE(found->high >= expected * (1 - 1e-12) && found->high <= found->low * (1 + gap), what);
    armtol_region_answer_destroy(answer);
}

static void range(size_t joint, double from, double to)
{
    low[joint] = from;
    high[joint] = to;
}

/* The largest of a function of one angle, to 1e-8 of it. */
static double largest(double (*function)(double), double from, double to)
{
    enum { STEPS = 100000 };
    double most = 0;
    for (int i = 0; i <= STEPS; i++) {
        most = fmax(most, function(from + (to - from) * i / STEPS));
    }
    return most;
}

/* ---- one link ---- */

static const double give = 2e-5; /* radians a N m */

/* The moment of 4 kg at the end, in N m: it bends the joint by give times that. */
static double bent(double q)
{
    return give * 4 * gravity * length_1 * 1e-3 * cos(q);
}

/* m g l cos q about the axis moves the tool along y by l cos q of it: largest where the link is level. */
static void test_a_link_droops_by_the_square_of_its_reach(void)
{
    drives[0].compliance = give;
    range(0, 0.3, 1.2);
    check_encloses(bent(0.3) * length_1 * cos(0.3), DY, 0.01, "from 0.3 on");
    range(0, -0.6, 0.5);
    check_encloses(bent(0) * length_1, DY, 0.01, "level");
    range(0, -3, 3);
    check_encloses(bent(0) * length_1, DY, 1e-4, "all around");
}

/* And along x by l sin q: sin q cos q is largest half way up. */
static void test_a_link_droops_across_most_half_way_up(void)
{
    drives[0].compliance = give;
    range(0, 0.2, 1.5);
    check_encloses(bent(0) * length_1 / 2, DX, 0.01, "45 degrees");
    range(0, 1, 1.5);
    check_encloses(bent(1) * length_1 * sin(1), DX, 1e-3, "from 1 on");
}

/* Turned about its first joint this arm is another one: what pulls on it does not turn too. */
static void test_the_first_joint_is_seen_where_gravity_is_across_its_axis(void)
{
    const armtol_norm disc = {3, 1e9};
    drives[0].compliance = give;
    question.norms = &disc;
    question.n_norms = 1;
    range(0, -0.2, 1.4);
    check_encloses(bent(0) * length_1, 9, 0.01, "its middle is at 0.6");
}

static void test_a_share_that_is_compensated(void)
{
    drives[0].compliance = give;
    loading.compensated = 0.25;
    range(0, 0.3, 1.2);
    check_encloses(0.75 * bent(0.3) * length_1 * cos(0.3), DY, 0.01, "three quarters");
    loading.compensated = 1;
    drives[0].resolution = 1e-4;
    check_encloses(0.5e-4 * length_1 * cos(0.3), DY, 0.01, "half a step");
}

static void test_the_worst_of_load_cases(void)
{
    drives[0].compliance = give;
    payloads[1] = (armtol_mass){.mass = 3, .center = {200, 0, 0}};
    loading.n_payloads = 2;
    range(0, 0.3, 1.2);
    check_encloses(bent(0.3) / 4 / 300 * 3 * 500 * length_1 * cos(0.3), DY, 0.01, "3 kg at 500 mm");
}

/* A force along x at the tool: its moment is -F l sin q. */
static void test_a_force_at_the_tool(void)
{
    drives[0].compliance = give;
    loading.n_payloads = 0;
    loading.force[0] = 50;
    range(0, 0.2, 1.1);
    check_encloses(give * 50 * 0.3 * sin(1.1) * length_1 * sin(1.1), DX, 0.01, "dx");
    check_encloses(give * 50 * 0.3 * sin(1.1), 5, 0.01, "rotation");
}

/* A typed moment is a doubt beside that of the payload, and an encoder half a step. */
static void test_doubt_about_a_moment(void)
{
    drives[0].compliance = give;
    drives[0].moment = 3;
    drives[0].resolution = 4e-5;
    range(0, 0.3, 1.2);
    check_encloses((bent(0.3) + give * 3 + 2e-5) * length_1 * cos(0.3), DY, 0.01, "doubt");
}

/* ---- play ---- */

static const double play = 1e-4;

static double swing(double q)
{
    return (fabs(bent(q)) + play) * length_1 * fabs(sin(q));
}

/* Play lies where the load has it: the same side as what the drive gives way by. */
static void test_play_on_the_side_of_the_load(void)
{
    drives[0].compliance = give;
    drives[0].backlash = play;
    range(0, 0.3, 1.2);
    check_encloses((bent(0.3) + play) * length_1 * cos(0.3), DY, 0.01, "one side");
    range(0, 1.2, 1.9);
    check_encloses(largest(swing, 1.2, 1.9), DX, 0.01, "over the top: both sides");
}

/* Two drives that are off to opposite sides: the elbow is held up by a counterweight that is lighter. */
static void test_play_of_two_drives_against_each_other(void)
{
    arm.n_links = 2;
    drives[0].backlash = drives[1].backlash = play;
    payloads[0] = (armtol_mass){.mass = 4, .center = {-300, 0, 0}};
    range(0, 0, 0.3);
    range(1, -0.2, 0.2);
    /* The mass is behind the elbow: the first drive is off downward by p (l_1 + l_2), the second upward by p l_2. */
    check_encloses(play * length_1, DY, 0.01, "the difference");
}

static double loose(double q)
{
    return (fabs(bent(q)) + 3 / sqrt(3) * play) * length_1 * fabs(sin(q));
}

/* Within the friction no load says where the play is: a tolerance. Standard deviations see that. */
static void test_play_that_friction_leaves_on_either_side(void)
{
    drives[0].compliance = give;
    drives[0].backlash = play;
    drives[0].friction = 4 * gravity * 0.3 * cos(1.1);
    question.method = ARMTOL_METHOD_RSS;
    question.sigma = 3;
    range(0, 1.2, 1.9);
    check_encloses(largest(loose, 1.2, 1.9), DX, 0.01, "not held");
    range(0, 0.3, 1);
    check_encloses((bent(0.3) + play) * length_1 * cos(0.3), DY, 0.01, "held");
    range(0, 1.09, 1.9);
    check_encloses(largest(loose, 1.1, 1.9), DX, 0.01, "held on a little of it");
}

/* Without friction the link is balanced upright alone: an error that no pose nearby has, by standard deviations. */
static void test_play_of_a_link_that_is_balanced(void)
{
    drives[0].backlash = play;
    question.method = ARMTOL_METHOD_RSS;
    question.sigma = 3;
    range(0, 1.2, 1.9);
    check_encloses(3 / sqrt(3) * play * length_1, DX, 0.01, "upright");
    question.sigma = 1; /* less than the root of 3: play does more as a shift */
    drives[0].resolution = 4 * play;
    check_encloses((1 + 2 / sqrt(3)) * play * length_1, DX, 0.01, "nearly upright");
}

/* Gravity along the axis has no moment, to the last digit. A tolerance beyond that of the drive counts. */
static void test_no_moment_about_a_vertical_axis(void)
{
    const double given[COLUMNS_1] = {1.5e-4};
    drives[0].compliance = give;
    drives[0].backlash = play;
    loading.gravity[1] = 0;
    loading.gravity[2] = -gravity;
    question.method = ARMTOL_METHOD_RSS;
    question.sigma = 2;
    range(0, 0.2, 1);
    check_encloses(2 / sqrt(3) * play * length_1 * sin(1), DX, 0.01, "play");
    question.tolerances = given;
    check_encloses(2 / sqrt(3) * 1.5e-4 * length_1 * sin(1), DX, 0.01, "a tolerance");
}

/* ---- two links ---- */

/* m g (c_1 (l_1 c_1 + l_2 c_12)^2 + c_2 (l_2 c_12)^2) of what is held. */
static void test_two_links_droop(void)
{
    const double weight = 4 * gravity * 1e-3, x_2 = length_2 * cos(0.5), x = length_1 * cos(0.3) + x_2;
    arm.n_links = 2;
    drives[0].compliance = give;
    drives[1].compliance = 3 * give;
    range(0, 0.3, 0.9);
    range(1, 0.2, 0.8);
    check_encloses(weight * give * (x * x + 3 * x_2 * x_2), DY, 0.01, "bent");
    range(0, -1, 1);
    range(1, -1, 1);
    check_encloses(weight * give * (500. * 500 + 3 * 200 * 200), DY, 0.01, "level");
}

/* Links that weigh something themselves, and nothing held. */
static void test_masses_of_links(void)
{
    const double c_1 = cos(0.3), c_2 = cos(0.5), x = length_1 * c_1 + length_2 * c_2;
    arm.n_links = 2;
    arm.masses = masses;
    masses[0] = (armtol_mass){.mass = 5, .center = {-100, 0, 0}};
    masses[1] = (armtol_mass){.mass = 2, .center = {-50, 0, 0}};
    loading.n_payloads = 0;
    drives[0].compliance = give;
    drives[1].compliance = 3 * give;
    range(0, 0.3, 0.9);
    range(1, 0.2, 0.8);
    const double second = 2 * 150 * c_2, first = 5 * 200 * c_1 + 2 * length_1 * c_1 + second;
    check_encloses(gravity * 1e-3 * give * (first * x + 3 * second * length_2 * c_2), DY, 0.01, "masses");
}

/* ---- a slide, and lengths in metres ---- */

static void test_a_slide_gives_way_to_a_force(void)
{
    static const armtol_link slide[] = {{ARMTOL_PPP, ARMTOL_PRISMATIC, .alpha = 0}};
    arm.links = slide;
    arm.unit = ARMTOL_METRE;
    drives[0].compliance = 1e-6;
    drives[0].backlash = 2e-5;
    loading.gravity[1] = 0;
    loading.gravity[2] = -gravity;
    range(0, 0.1, 0.4);
    check_encloses(1e-6 * 40 + 2e-5, DZ, 0.01, "along z");
    armtol_region_answer *answer = answer_of(5, 0.01);
    TEST_ASSERT_TRUE(answer->enclosures[0].low == 0 && answer->enclosures[0].high < 1e-15);
    armtol_region_answer_destroy(answer);
}

/* ---- along the tool ---- */

/* Across itself the link is off by l times what the joint is, whatever its angle; that it bends by m g l cos q. */
static void test_along_the_tool(void)
{
    drives[0].compliance = give;
    question.tool.frame = ARMTOL_TOOL_FRAME;
    range(0, 0.3, 1.2);
    check_encloses(bent(0.3) * length_1, DY, 0.01, "dy of the tool");
    check_encloses(bent(0.3), 5, 0.01, "wz of the tool");
}

/* ---- a Puma ---- */

enum { PUMA_JOINTS = 6, PUMA_COLUMNS = 25 };

typedef struct puma {
    armtol_drive drives[PUMA_JOINTS];
    armtol_arm arm;
    double low[PUMA_JOINTS], high[PUMA_JOINTS];
    armtol_region region;
    armtol_question question;
} puma;

/* 60 degrees a joint, 5 kg held, drives that give way by as much as all tolerances do. */
static void make_puma(puma *puma)
{
    static const double lows[PUMA_JOINTS] = {0, -0.6, -0.5, -0.5, -0.5, 0}, turn = 1.0471975511965976;
    puma->arm = *armtol_arm_named("puma560");
    for (int i = 0; i < PUMA_JOINTS; i++) {
        puma->drives[i] = puma->arm.drives[i];
        puma->drives[i].compliance = 2e-5;
        puma->drives[i].backlash = i < 3 ? 1e-4 : 0;
        puma->low[i] = lows[i];
        puma->high[i] = lows[i] + turn;
    }
    puma->arm.drives = puma->drives;
    payloads[0].mass = 5;
    loading.gravity[1] = 0;
    loading.gravity[2] = -gravity;
    puma->region = (armtol_region){.low = puma->low, .high = puma->high};
    puma->question = (armtol_question){.arm = &puma->arm, .loading = &loading, .tool = {{0, 0, 100}, 0}};
}

static void test_a_gap_of_a_hundredth_takes_few_boxes(void)
{
    double tolerances[PUMA_COLUMNS];
    puma puma;
    armtol_region_answer *answer;
    make_puma(&puma);
    for (int k = 0; k < PUMA_COLUMNS; k++) {
        tolerances[k] = 1e-4;
    }
    puma.question.tolerances = tolerances;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                          armtol_region_answer_create(&puma.question, &puma.region, NULL, &answer, NULL, NULL));
    TEST_ASSERT_EQUAL_UINT64(6, answer->n_enclosures);
    for (int i = 0; i < 6; i++) {
        const armtol_enclosure *found = &answer->enclosures[i];
        TEST_ASSERT_TRUE(found->ended == ARMTOL_ENDED_GAP && found->high <= found->low * 1.01);
        TEST_ASSERT_LESS_THAN_UINT64(600, found->boxes);
        const size_t pose = found->pose;
        TEST_ASSERT_TRUE(answer->remainder[i / 3] >= answer->answer->remainders[6 * pose + (size_t)i]);
        check_within(1e-9 * found->low, found->low, answer->answer->components[i].worst, "component %d", i);
    }
    armtol_region_answer_destroy(answer);
}

/* What is left beside the droop is asked for; where the droop is too much nothing is. */
static void test_tolerances_beside_a_droop(void)
{
    puma puma;
    armtol_region_answer *answer;
    armtol_fault fault;
    double wish[6] = {FREE, FREE, 4, FREE, FREE, FREE};
    make_puma(&puma);
    puma.question.accuracy = wish;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK,
                          armtol_region_answer_create(&puma.question, &puma.region, NULL, &answer, NULL, NULL));
    const armtol_enclosure *found = &answer->enclosures[0];
    TEST_ASSERT_TRUE(found->high <= 4 && found->low >= 4 / 1.01 && answer->answer->components[DZ].shift > 1);
    check_within(1e-9, found->low, answer->answer->components[DZ].worst, "the engine's worst case is what was found");
    armtol_region_answer_destroy(answer);
    wish[DZ] = 1;
    TEST_ASSERT_EQUAL_INT(ARMTOL_NOTHING_LEFT,
                          armtol_region_answer_create(&puma.question, &puma.region, NULL, &answer, &fault, NULL));
    TEST_ASSERT_TRUE(answer == NULL && fault.about == ARMTOL_ABOUT_ROW);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_link_droops_by_the_square_of_its_reach);
    RUN_TEST(test_a_link_droops_across_most_half_way_up);
    RUN_TEST(test_the_first_joint_is_seen_where_gravity_is_across_its_axis);
    RUN_TEST(test_a_share_that_is_compensated);
    RUN_TEST(test_the_worst_of_load_cases);
    RUN_TEST(test_a_force_at_the_tool);
    RUN_TEST(test_doubt_about_a_moment);
    RUN_TEST(test_play_on_the_side_of_the_load);
    RUN_TEST(test_play_of_two_drives_against_each_other);
    RUN_TEST(test_play_that_friction_leaves_on_either_side);
    RUN_TEST(test_play_of_a_link_that_is_balanced);
    RUN_TEST(test_no_moment_about_a_vertical_axis);
    RUN_TEST(test_two_links_droop);
    RUN_TEST(test_masses_of_links);
    RUN_TEST(test_a_slide_gives_way_to_a_force);
    RUN_TEST(test_along_the_tool);
    RUN_TEST(test_a_gap_of_a_hundredth_takes_few_boxes);
    RUN_TEST(test_tolerances_beside_a_droop);
    return UNITY_END();
}
