/*
 * The largest errors of a region. Judges: closed forms of an arm of two links in a plane and of a SCARA; the worst
 * case of the engine's own A in the poses that are named; how armtol_answer_create's 25 poses of one height do
 * elsewhere. Drawn poses of all built-in arms are in region_poses.c.
 */

#include "armtol/region.h"
#include "support/check.h"

#include "unity.h"

#include <math.h>
#include <string.h>

#define DEGREE 0.017453292519943295
#define FREE ((double)INFINITY)

enum { THETA_1, A_1, ALPHA_1, BETA_1, THETA_2, A_2, PLANAR_COLUMNS = 8 };

void setUp(void)
{
}

void tearDown(void)
{
}

static const double length_1 = 300, length_2 = 200;

static const armtol_link planar_links[] = {
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 300},
    {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 200},
};

static const armtol_drive no_drives[4] = {{-FREE, FREE, (double)NAN}, {-FREE, FREE, (double)NAN},
                                          {-FREE, FREE, (double)NAN}, {-FREE, FREE, (double)NAN}};

static const armtol_arm planar = {.name = "planar", .title = "planar", .source = "", .unit = ARMTOL_MILLIMETRE,
                                  .n_links = 2, .links = planar_links, .drives = no_drives};

static armtol_region_answer *answer_of(const armtol_question *question, const armtol_region *region,
                                       const armtol_enclosing *how)
{
    armtol_region_answer *answer;
    armtol_fault fault;
    armtol_region_fault why;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_region_answer_create(question, region, how, &answer, &fault, &why));
    TEST_ASSERT_TRUE(fault.status == ARMTOL_OK && why == ARMTOL_REGION_FINE && answer != NULL);
    return answer;
}

/* The bounds are on both sides of the expected, to what counts as in a region, and no further apart than asked for. */
static void check_encloses(double expected, double gap, const armtol_enclosure *found, const char *what)
{
    TEST_ASSERT_TRUE_MESSAGE(found->low <= expected * (1 + 1e-8) && found->high >= expected * (1 - 1e-12), what);
    TEST_ASSERT_TRUE_MESSAGE(found->high <= found->low * (1 + gap) * (1 + 1e-12), what);
    TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_ENDED_GAP, found->ended, what);
}

/* ---- two links in a plane ---- */

/*
 * theta 1 off by s and theta 2 by t move the tool by s p and t p_2 across, p from the base and p_2 from the elbow: as
 * a vector, turned back, s l_1 e_1 + (s + t) l_2 e_2. Its length is largest with both errors of one sign where e_1
 * and e_2 are nearest.
 */
static void planar_disc(double elbow, double gap)
{
    const double s = 1e-3, t = 2e-3, tolerances[PLANAR_COLUMNS] = {[THETA_1] = s, [THETA_2] = t};
    const double low[] = {-3, elbow}, high[] = {3, elbow + 1};
    const armtol_norm disc = {3, FREE};
    const armtol_region region = {.low = low, .high = high};
    const armtol_enclosing how = {.gap = gap};
    const armtol_question question = {.arm = &planar, .tolerances = tolerances, .norms = &disc, .n_norms = 1};
    armtol_region_answer *answer = answer_of(&question, &region, &how);
    TEST_ASSERT_EQUAL_UINT64(1, answer->n_enclosures);
    TEST_ASSERT_EQUAL_UINT(3, answer->enclosures[0].components);
    const double x = s * length_1 + (s + t) * length_2 * cos(elbow), y = (s + t) * length_2 * sin(elbow);
    check_encloses(sqrt(x * x + y * y), gap, &answer->enclosures[0], "disc");
    const size_t pose = answer->enclosures[0].pose;
    check_within(gap * 4, elbow, answer->q[2 * pose + 1], "the elbow where it is worst");
    armtol_region_answer_destroy(answer);
}

static void test_the_disc_of_a_planar_arm(void)
{
    planar_disc(0, 1e-2);
    planar_disc(0.4, 1e-2);
    planar_disc(0.4, 1e-4);
}

/* |dx| = s |y| + t |y_2|, and both grow with both joints here. */
static void test_a_component_of_a_planar_arm_at_the_end_of_its_ranges(void)
{
    const double s = 1e-3, t = 2e-3, tolerances[PLANAR_COLUMNS] = {[THETA_1] = s, [THETA_2] = t};
    const double low[] = {0, 0}, high[] = {0.7, 0.8}, accuracy[] = {1, FREE, FREE, FREE, FREE, FREE};
    const armtol_region region = {.low = low, .high = high};
    const armtol_question question = {.arm = &planar, .tolerances = tolerances, .accuracy = accuracy};
    armtol_region_answer *answer = answer_of(&question, &region, NULL);
    const double y_2 = length_2 * sin(1.5), y = length_1 * sin(0.7) + y_2;
    check_encloses(s * y + t * y_2, 0.01, &answer->enclosures[0], "dx");
    check_within(1e-9, s * y + t * y_2, answer->enclosures[0].low, "an error at ends of ranges is found as it is");
    armtol_region_answer_destroy(answer);
}

/* sigma sqrt(((s y)^2 + (t y_2)^2) / 3) there. */
static void test_standard_deviations_of_a_planar_arm(void)
{
    const double s = 1e-3, t = 2e-3, tolerances[PLANAR_COLUMNS] = {[THETA_1] = s, [THETA_2] = t};
    const double low[] = {0, 0}, high[] = {0.7, 0.8}, accuracy[] = {1, FREE, FREE, FREE, FREE, FREE};
    const armtol_region region = {.low = low, .high = high};
    const armtol_question question = {.arm = &planar, .tolerances = tolerances, .accuracy = accuracy,
                                      .method = ARMTOL_METHOD_RSS, .sigma = 2};
    armtol_region_answer *answer = answer_of(&question, &region, NULL);
    const double y_2 = length_2 * sin(1.5), y = length_1 * sin(0.7) + y_2;
    check_encloses(2 * sqrt((s * s * y * y + t * t * y_2 * y_2) / 3), 0.01, &answer->enclosures[0], "dx");
    armtol_region_answer_destroy(answer);
}

/* Behind the tool nothing but theta 2 turns what it sees: along its own y the motors move it by s (l_1 cos q_2 + l_2)
   + t l_2. */
static void test_along_the_tool_of_a_planar_arm(void)
{
    const double s = 1e-3, t = 2e-3, tolerances[PLANAR_COLUMNS] = {[THETA_1] = s, [THETA_2] = t};
    const double low[] = {-1, 0.3}, high[] = {2, 1.2}, accuracy[] = {FREE, 1, FREE, FREE, FREE, FREE};
    const armtol_region region = {.low = low, .high = high};
    const armtol_question question = {.arm = &planar, .tolerances = tolerances, .accuracy = accuracy,
                                      .tool.frame = ARMTOL_TOOL_FRAME};
    armtol_region_answer *answer = answer_of(&question, &region, NULL);
    check_encloses(s * (length_1 * cos(0.3) + length_2) + t * length_2, 0.01, &answer->enclosures[0], "dy of the tool");
    armtol_region_answer_destroy(answer);
}

/* The tool within a ring is the elbow beyond an angle, by the law of cosines. */
static void test_a_ring_of_a_planar_arm(void)
{
    const double s = 1e-3, tolerances[PLANAR_COLUMNS] = {[THETA_1] = s};
    const double low[] = {-3, 0}, high[] = {3, 3};
    const armtol_norm disc = {3, FREE};
    const armtol_ring ring = {.axis = {0, 0, 2}, .inner = 150, .outer = 400, .bottom = -1, .top = 1};
    const armtol_region region = {.low = low, .high = high, .ring = &ring};
    const armtol_question question = {.arm = &planar, .tolerances = tolerances, .norms = &disc, .n_norms = 1};
    armtol_region_answer *answer = answer_of(&question, &region, NULL);
    check_encloses(s * 400, 0.01, &answer->enclosures[0], "theta 1 moves the tool by its distance");
    const double *q = answer->q + 2 * answer->enclosures[0].pose;
    const double x = length_1 + length_2 * cos(q[1]), y = length_2 * sin(q[1]), away = sqrt(x * x + y * y);
    TEST_ASSERT_TRUE(away <= 400 + 1e-6 && away >= 400 * 0.99);
    armtol_region_answer_destroy(answer);
}

/* Within 5 mm of the line from (400, -50) to (400, 50) no point is further from the base than |(405, 50)| and less
   than 5 more. */
static void test_a_path_of_a_planar_arm(void)
{
    const double s = 1e-3, tolerances[PLANAR_COLUMNS] = {[THETA_1] = s};
    const double low[] = {-3, 0}, high[] = {3, 3}, points[] = {400, -50, 0, 400, 50, 0};
    const armtol_norm disc = {3, FREE};
    const armtol_path path = {points, 2, 5};
    const armtol_region region = {.low = low, .high = high, .path = &path};
    const armtol_question question = {.arm = &planar, .tolerances = tolerances, .norms = &disc, .n_norms = 1};
    armtol_region_answer *answer = answer_of(&question, &region, NULL);
    check_encloses(s * (sqrt(400 * 400 + 50 * 50) + 5), 0.01, &answer->enclosures[0],
                   "the end of the path, and 5 mm further");
    armtol_region_answer_destroy(answer);
}

/* A block bounds |y|: theta 1 moves the tool by that along x. */
static void test_a_block_of_a_planar_arm(void)
{
    const double s = 1e-3, tolerances[PLANAR_COLUMNS] = {[THETA_1] = s};
    const double low[] = {-3, 0}, high[] = {3, 3}, accuracy[] = {1, FREE, FREE, FREE, FREE, FREE};
    const armtol_block block = {{100, -20, -FREE}, {FREE, 70, FREE}};
    const armtol_region region = {.low = low, .high = high, .block = &block};
    const armtol_question question = {.arm = &planar, .tolerances = tolerances, .accuracy = accuracy};
    armtol_region_answer *answer = answer_of(&question, &region, NULL);
    check_encloses(s * 70, 0.01, &answer->enclosures[0], "dx");
    armtol_region_answer_destroy(answer);
}

/* The tool is on the ring's own axis, and nowhere else. */
static void test_the_axis_of_a_ring(void)
{
    const double s = 1e-3, tolerances[PLANAR_COLUMNS] = {[THETA_1] = s}, none[] = {0, 0};
    const armtol_norm disc = {3, FREE};
    const armtol_ring ring = {.axis = {0, 0, 1}, .point = {500, 0, 0}, .outer = 1, .bottom = -1, .top = 1};
    const armtol_region region = {.low = none, .high = none, .ring = &ring};
    const armtol_question question = {.arm = &planar, .tolerances = tolerances, .norms = &disc, .n_norms = 1};
    armtol_region_answer *answer = answer_of(&question, &region, NULL);
    check_encloses(s * (length_1 + length_2), 0.01, &answer->enclosures[0], "stretched");
    armtol_region_answer_destroy(answer);
}

/* The second joint turns back what the first turns, but for 0.3: the second link keeps its direction. */
static void test_a_joint_that_follows(void)
{
    const double s = 1e-3, tolerances[PLANAR_COLUMNS] = {[THETA_1] = s}, low[] = {0}, high[] = {0.7};
    const double accuracy[] = {1, FREE, FREE, FREE, FREE, FREE};
    const armtol_motion motions[] = {{0, 1, 0, 1}, {0, -1, 0.3, 1}};
    armtol_arm arm = planar;
    arm.motions = motions;
    const armtol_region region = {.low = low, .high = high};
    const armtol_question question = {.arm = &arm, .tolerances = tolerances, .accuracy = accuracy};
    armtol_region_answer *answer = answer_of(&question, &region, NULL);
    check_encloses(s * (length_1 * sin(0.7) + length_2 * sin(0.3)), 0.01, &answer->enclosures[0], "dx");
    armtol_region_answer_destroy(answer);
}

/*
 * A short second link turns a million times as fast: the tool is near a point at full reach for very little of
 * the joint's range. Poses that are drawn do not get there; boxes do.
 */
static void test_a_region_that_is_hard_to_find(void)
{
    enum { TURNS = 200000 };
    const double times = 1e6, turn = 360 * DEGREE, s = 1e-3, tolerances[PLANAR_COLUMNS] = {[THETA_1] = s};
    const double at = TURNS * turn / times, point[] = {301 * cos(at), 301 * sin(at), 0}, low[] = {0}, high[] = {3};
    const armtol_motion motions[] = {{0, 1, 0, 1}, {0, times, 0, 1}};
    const armtol_link links[] = {planar_links[0], {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 1}};
    const armtol_norm disc = {3, FREE}, wish = {3, 0.02};
    const armtol_path path = {point, 1, 1e-5};
    const armtol_region region = {.low = low, .high = high, .path = &path};
    armtol_arm arm = planar;
    arm.links = links;
    arm.motions = motions;
    const armtol_question given = {.arm = &arm, .tolerances = tolerances, .norms = &disc, .n_norms = 1};
    const armtol_question asked = {.arm = &arm, .norms = &wish, .n_norms = 1};
    armtol_region_answer *answer = answer_of(&given, &region, NULL);
    check_encloses(s * 301, 0.01, &answer->enclosures[0], "at full reach");
    armtol_region_answer_destroy(answer);
    answer = answer_of(&asked, &region, NULL);
    TEST_ASSERT_TRUE(answer->enclosures[0].high <= 0.02 && answer->enclosures[0].low >= 0.02 / 1.01);
    for (size_t i = 0; i < answer->n_poses; i++) {
        const double q = answer->q[i], x = 300 * cos(q) + cos((1 + times) * q), y = 300 * sin(q) + sin((1 + times) * q);
        check_within(2e-5, point[0], x, "x of pose %zu", i);
        check_within(2e-5, point[1], y, "y of pose %zu", i);
    }
    armtol_region_answer_destroy(answer);
}

/* Of so many joints no box has few enough corners: what is found is told, and that nothing is proved. */
static void test_a_snake_has_no_bound(void)
{
    enum { JOINTS = 17 };
    double tolerances[4 * JOINTS] = {[THETA_1] = 1e-3}, low[JOINTS] = {0}, high[JOINTS];
    armtol_link links[JOINTS];
    armtol_drive drives[JOINTS];
    armtol_arm snake = planar;
    for (size_t i = 0; i < JOINTS; i++) {
        links[i] = (armtol_link){ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 10};
        drives[i] = no_drives[0];
        high[i] = 0.01;
    }
    snake.n_links = JOINTS;
    snake.links = links;
    snake.drives = drives;
    const armtol_norm disc = {3, FREE};
    const armtol_enclosing few = {.most = 20};
    const armtol_region region = {.low = low, .high = high};
    const armtol_question question = {.arm = &snake, .tolerances = tolerances, .norms = &disc, .n_norms = 1};
    armtol_region_answer *answer = answer_of(&question, &region, &few);
    const armtol_enclosure *found = &answer->enclosures[0];
    TEST_ASSERT_TRUE(found->ended == ARMTOL_ENDED_MOST && isinf(found->high));
    check_within(1e-3 * 0.17, 0.17, found->low, "stretched");
    armtol_region_answer_destroy(answer);
}

/* ---- a SCARA ---- */

static const armtol_arm *scara(void)
{
    return armtol_arm_named("scara");
}

static size_t column_of(const armtol_arm *arm, size_t link, armtol_parameter parameter)
{
    armtol_column columns[64];
    const size_t n = armtol_column_count(arm->links, arm->n_links);
    size_t k = 0;
    armtol_columns(arm->links, arm->n_links, columns, n);
    while (k < n && (columns[k].link != link || columns[k].parameter != parameter)) {
        k++;
    }
    TEST_ASSERT_TRUE(k < n);
    return k;
}

/* Where the joints may be, as the arm's limits have it. */
static void limits_of(const armtol_arm *arm, double low[], double high[])
{
    size_t joint = 0;
    for (size_t i = 0; i < arm->n_links; i++) {
        if (armtol_arm_is_driven(arm, i)) {
            low[joint] = arm->drives[i].low;
            high[joint++] = arm->drives[i].high;
        }
    }
}

/* A first axis that is tilted moves the tool across by its depth below the arm: 210 mm at most. */
static void test_the_slide_of_a_scara(void)
{
    double tolerances[17] = {0}, low[4], high[4];
    const armtol_norm disc = {3, FREE};
    tolerances[column_of(scara(), 0, ARMTOL_ALPHA)] = 1e-4;
    limits_of(scara(), low, high);
    const armtol_region region = {.low = low, .high = high};
    const armtol_question question = {.arm = scara(), .tolerances = tolerances, .norms = &disc, .n_norms = 1};
    armtol_region_answer *answer = answer_of(&question, &region, NULL);
    check_encloses(1e-4 * 210, 0.01, &answer->enclosures[0], "tilt");
    armtol_region_answer_destroy(answer);
}

/* All that turns about z adds up, in every pose: bounds from both sides are the same. */
static void test_the_rotation_of_a_scara(void)
{
    double tolerances[17] = {0}, low[4], high[4];
    const double accuracy[] = {FREE, FREE, FREE, FREE, FREE, 1};
    tolerances[column_of(scara(), 0, ARMTOL_THETA)] = 1e-4;
    tolerances[column_of(scara(), 1, ARMTOL_THETA)] = 2e-4;
    tolerances[column_of(scara(), 3, ARMTOL_THETA)] = 3e-4;
    limits_of(scara(), low, high);
    const armtol_region region = {.low = low, .high = high};
    const armtol_question question = {.arm = scara(), .tolerances = tolerances, .accuracy = accuracy};
    armtol_region_answer *answer = answer_of(&question, &region, NULL);
    check_within(1e-14, 6e-4, answer->enclosures[0].low, "found");
    check_within(1e-9, 6e-4, answer->enclosures[0].high, "bound");
    TEST_ASSERT_EQUAL_UINT64(1, answer->enclosures[0].boxes);
    armtol_region_answer_destroy(answer);
}

enum { HEIGHTS = 25 };

/* 25 poses with the tool at one height, near the top of the slide. */
static armtol_answer *tolerances_of_one_height(const armtol_norm *disc)
{
    double q[4 * HEIGHTS];
    for (size_t i = 0; i < HEIGHTS; i++) {
        const size_t first = i / 5, second = i % 5;
        const double pose[] = {(-100 + 50 * (double)first) * DEGREE, (-140 + 70 * (double)second) * DEGREE, 20, 0};
        memcpy(q + 4 * i, pose, sizeof pose);
    }
    const armtol_question question = {.arm = scara(), .q = q, .n_poses = HEIGHTS, .norms = disc, .n_norms = 1};
    armtol_answer *answer;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&question, &answer, NULL));
    return answer;
}

/* What holds in them does not hold lower down: that is what regions are for. */
static void test_tolerances_of_25_poses_do_not_hold_elsewhere(void)
{
    const armtol_norm disc = {3, 0.02};
    double low[4], high[4];
    armtol_answer *poses = tolerances_of_one_height(&disc);
    limits_of(scara(), low, high);
    const armtol_region region = {.low = low, .high = high};
    const armtol_question given = {.arm = scara(), .tolerances = poses->tolerances, .norms = &disc, .n_norms = 1};
    armtol_region_answer *elsewhere = answer_of(&given, &region, NULL);
    TEST_ASSERT_TRUE(elsewhere->enclosures[0].low > 0.02 * 1.2);
    armtol_region_answer_destroy(elsewhere);
    armtol_answer_destroy(poses);
}

/* And those of the region do, and are all but the largest that can. */
static void test_tolerances_of_a_region_hold_everywhere(void)
{
    const armtol_norm disc = {3, 0.02};
    double low[4], high[4];
    limits_of(scara(), low, high);
    const armtol_region region = {.low = low, .high = high};
    const armtol_question asked = {.arm = scara(), .norms = &disc, .n_norms = 1};
    armtol_region_answer *found = answer_of(&asked, &region, NULL);
    const armtol_enclosure *enclosure = &found->enclosures[0];
    TEST_ASSERT_TRUE(enclosure->high <= 0.02 && enclosure->low >= 0.02 / 1.01);
    check_within(1e-9 * 0.02, enclosure->low, found->answer->norms[0].of.worst,
                 "the engine's worst case is what was found");
    TEST_ASSERT_TRUE(found->answer->norms[0].limit == 0.02 && found->answer->norms[0].of.binds > 0.999);
    const armtol_question given = {.arm = scara(), .tolerances = found->answer->tolerances, .norms = &disc,
                                   .n_norms = 1};
    const armtol_enclosing finer = {.gap = 1e-3};
    armtol_region_answer *again = answer_of(&given, &region, &finer);
    TEST_ASSERT_TRUE(again->enclosures[0].high <= 0.02 && again->enclosures[0].high >= enclosure->low);
    armtol_region_answer_destroy(again);
    armtol_region_answer_destroy(found);
}

/* ---- ends ---- */

static bool stop_at_once(void *context, double open, uint64_t boxes)
{
    double *seen = context;
    *seen = open;
    return boxes == 0;
}

/* What is reached is told, and is right: wider than asked for. */
static void test_bounds_that_are_ended_early(void)
{
    const double tolerances[] = {1e-3, .1, 1e-3, 1e-3, .1, .1, 1e-3, 1e-3, .1, 1e-3, .1, .1, 1e-3, 1e-3, .1, .1, 1e-3,
                                 1e-3,
                                 .1, .1, 1e-3, 1e-3, .1, .1, 1e-3};
    const armtol_arm *arm = armtol_arm_named("puma560");
    double low[6], high[6], open = -1;
    const double accuracy[] = {1, FREE, FREE, FREE, FREE, FREE};
    limits_of(arm, low, high);
    const armtol_region region = {.low = low, .high = high};
    const armtol_question question = {.arm = arm, .tolerances = tolerances, .accuracy = accuracy};
    const armtol_enclosing usual = {.gap = 0.05}, few = {.gap = 0.05, .most = 5},
                           watched = {.gap = 0.05, .progress = stop_at_once, .context = &open};
    armtol_region_answer *whole = answer_of(&question, &region, &usual), *cut = answer_of(&question, &region, &few);
    armtol_region_answer *ended = answer_of(&question, &region, &watched);
    TEST_ASSERT_TRUE(whole->ended == ARMTOL_ENDED_GAP && cut->ended == ARMTOL_ENDED_MOST &&
                     ended->ended == ARMTOL_ENDED_CALLER);
    TEST_ASSERT_TRUE(cut->enclosures[0].boxes >= 5 && cut->enclosures[0].boxes <= 6 && ended->enclosures[0].boxes < 5);
    TEST_ASSERT_TRUE(open > 0 && open <= 1);
    TEST_ASSERT_TRUE(cut->enclosures[0].high > whole->enclosures[0].high &&
                     ended->enclosures[0].high >= cut->enclosures[0].high);
    TEST_ASSERT_TRUE(whole->enclosures[0].low <= cut->enclosures[0].high);
    armtol_region_answer_destroy(whole);
    armtol_region_answer_destroy(cut);
    armtol_region_answer_destroy(ended);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_disc_of_a_planar_arm);
    RUN_TEST(test_a_component_of_a_planar_arm_at_the_end_of_its_ranges);
    RUN_TEST(test_standard_deviations_of_a_planar_arm);
    RUN_TEST(test_along_the_tool_of_a_planar_arm);
    RUN_TEST(test_a_ring_of_a_planar_arm);
    RUN_TEST(test_a_path_of_a_planar_arm);
    RUN_TEST(test_a_block_of_a_planar_arm);
    RUN_TEST(test_the_axis_of_a_ring);
    RUN_TEST(test_a_joint_that_follows);
    RUN_TEST(test_a_region_that_is_hard_to_find);
    RUN_TEST(test_a_snake_has_no_bound);
    RUN_TEST(test_the_slide_of_a_scara);
    RUN_TEST(test_the_rotation_of_a_scara);
    RUN_TEST(test_tolerances_of_25_poses_do_not_hold_elsewhere);
    RUN_TEST(test_tolerances_of_a_region_hold_everywhere);
    RUN_TEST(test_bounds_that_are_ended_early);
    return UNITY_END();
}
