/* Regions that cannot be answered: what is wrong with each. */

#include "armtol/region.h"

#include "unity.h"

#include <math.h>

static const double low[4] = {-1, -1, 0, -1}, high[4] = {1, 1, 200, 1};
static const double accuracy[6] = {.02, .02, .02, .01, .01, .01};
static armtol_region region;
static armtol_question question;
static armtol_arm arm;

void setUp(void)
{
    arm = *armtol_arm_named("scara");
    region = (armtol_region){.low = low, .high = high};
    question = (armtol_question){.arm = &arm, .accuracy = accuracy};
}

void tearDown(void)
{
}

static void check_refused(armtol_status status, armtol_region_fault expected, const armtol_enclosing *how)
{
    armtol_region_answer *answer;
    armtol_region_fault why;
    armtol_fault fault;
    TEST_ASSERT_EQUAL_INT(status, armtol_region_answer_create(&question, &region, how, &answer, &fault, &why));
    TEST_ASSERT_TRUE(answer == NULL && fault.status == status);
    TEST_ASSERT_EQUAL_INT(expected, why);
    TEST_ASSERT_EQUAL_INT(status, armtol_region_answer_create(&question, &region, how, &answer, NULL, NULL));
}

static void test_ranges_that_are_none(void)
{
    static const double down[4] = {-1, 2, 0, -1}, endless[4] = {1, (double)INFINITY, 200, 1};
    region.low = down;
    check_refused(ARMTOL_BAD_RANGE, ARMTOL_REGION_RANGE, NULL);
    region.low = low;
    region.high = endless;
    check_refused(ARMTOL_BAD_RANGE, ARMTOL_REGION_RANGE, NULL);
}

static void test_shapes_that_are_none(void)
{
    const armtol_block block = {{0, 5, 0}, {1, 4, 1}};
    const armtol_ring ring = {.axis = {0, 0, 1}, .inner = 2, .outer = 1, .top = 1}, flat = {.outer = 1};
    const armtol_path path = {low, 1, -1};
    const armtol_cone cone = {{0, 0, 0}, 1};
    region.block = &block;
    check_refused(ARMTOL_BAD_RANGE, ARMTOL_REGION_SHAPE, NULL);
    region = (armtol_region){.low = low, .high = high, .ring = &ring};
    check_refused(ARMTOL_BAD_RANGE, ARMTOL_REGION_SHAPE, NULL);
    region.ring = &flat;
    check_refused(ARMTOL_BAD_RANGE, ARMTOL_REGION_SHAPE, NULL);
    region = (armtol_region){.low = low, .high = high, .path = &path};
    check_refused(ARMTOL_BAD_RANGE, ARMTOL_REGION_SHAPE, NULL);
    region = (armtol_region){.low = low, .high = high, .cone = &cone};
    check_refused(ARMTOL_BAD_RANGE, ARMTOL_REGION_SHAPE, NULL);
}

static void test_regions_without_a_pose(void)
{
    const armtol_ring far = {.axis = {0, 0, 1}, .inner = 601, .outer = 700, .bottom = -1000, .top = 1000};
    const armtol_cone up = {{0, 0, 1}, 0.5}; /* the tool of a SCARA points down */
    const armtol_enclosing few = {.most = 2};
    region.ring = &far;
    check_refused(ARMTOL_OUT_OF_REACH, ARMTOL_REGION_EMPTY, NULL);
    region = (armtol_region){.low = low, .high = high, .cone = &up};
    check_refused(ARMTOL_OUT_OF_REACH, ARMTOL_REGION_EMPTY, NULL);
    const armtol_block nearly = {{0, 0, 0}, {599.9, 0.05, 500}};
    const armtol_ring edge = {.axis = {0, 0, 1}, .inner = 599.99, .outer = 700, .bottom = -1000, .top = 1000};
    region = (armtol_region){.low = low, .high = high, .block = &nearly, .ring = &edge};
    check_refused(ARMTOL_NOT_SOLVED, ARMTOL_REGION_NOT_FOUND, &few);
}

static void test_what_is_asked(void)
{
    const armtol_enclosing fine = {.gap = 1e-9}, coarse = {.gap = 20};
    static const armtol_norm none = {1, 1};
    check_refused(ARMTOL_BAD_RANGE, ARMTOL_REGION_GAP, &fine);
    check_refused(ARMTOL_BAD_RANGE, ARMTOL_REGION_GAP, &coarse);
    question.method = ARMTOL_METHOD_SPHERE;
    check_refused(ARMTOL_BAD_QUESTION, ARMTOL_REGION_METHOD, NULL);
    question.method = ARMTOL_METHOD_WORST;
    question.norms = &none;
    question.n_norms = 1;
    check_refused(ARMTOL_BAD_NORM, ARMTOL_REGION_FINE, NULL);
    question.n_norms = 0;
    question.accuracy = NULL;
    check_refused(ARMTOL_BAD_QUESTION, ARMTOL_REGION_FINE, NULL);
    question.accuracy = accuracy;
    question.tool.offset[1] = (double)NAN;
    check_refused(ARMTOL_NOT_FINITE, ARMTOL_REGION_FINE, NULL);
    question.tool.offset[1] = 0;
    question.arm = NULL;
    check_refused(ARMTOL_BAD_QUESTION, ARMTOL_REGION_FINE, NULL);
}

/* What is given uses up the accuracy, or has no bound. */
static void test_tolerances_that_cannot_be(void)
{
    double tolerances[17] = {0}, largest[17];
    tolerances[0] = (double)INFINITY;
    question.tolerances = tolerances;
    check_refused(ARMTOL_UNBOUNDED, ARMTOL_REGION_FINE, NULL);
    tolerances[0] = 1;
    for (int k = 0; k < 17; k++) {
        largest[k] = tolerances[k] = k == 0 ? 1 : 0;
    }
    question.tolerances = NULL;
    question.least = tolerances;
    question.largest = largest;
    check_refused(ARMTOL_NOTHING_LEFT, ARMTOL_REGION_FINE, NULL);
}

/* Play and a typed moment, with nothing that loads the arm, are off by the same everywhere. */
static void test_drives_that_are_the_same_everywhere(void)
{
    armtol_drive drives[4];
    armtol_region_answer *answer;
    for (int i = 0; i < 4; i++) {
        drives[i] = arm.drives[i];
    }
    drives[1].compliance = 1e-6;
    drives[1].backlash = 1e-6;
    drives[1].moment = 2;
    arm.drives = drives;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_region_answer_create(&question, &region, NULL, &answer, NULL, NULL));
    TEST_ASSERT_TRUE(answer->answer->given[4] && fabs(answer->answer->tolerances[4] - 3e-6) < 1e-18);
    for (size_t i = 0; i < answer->n_enclosures; i++) {
        TEST_ASSERT_TRUE(answer->enclosures[i].high <= answer->enclosures[i].accuracy);
    }
    armtol_region_answer_destroy(answer);
    armtol_region_answer_destroy(NULL);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_ranges_that_are_none);
    RUN_TEST(test_shapes_that_are_none);
    RUN_TEST(test_regions_without_a_pose);
    RUN_TEST(test_what_is_asked);
    RUN_TEST(test_tolerances_that_cannot_be);
    RUN_TEST(test_drives_that_are_the_same_everywhere);
    return UNITY_END();
}
