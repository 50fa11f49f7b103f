/* What whoever makes a link is told: distances, angles and motors, in one pose and in several. */

#include "armtol/answer.h"
#include "armtol/budget.h"
#include "support/check.h"

#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* A column that turns, a slide along it, and a plate: the slide's own axis and the next are parallel. */
static const armtol_link slide_links[3] = {
    {ARMTOL_NPR, ARMTOL_REVOLUTE, .alpha = 1.5707963267948966, .d = 400},
    {ARMTOL_PPP, ARMTOL_PRISMATIC, .a = 30, .d = 40},
    {ARMTOL_NPR, ARMTOL_FIXED, .a = 80},
};
static const double six_ones[6] = {1, 1, 1, 0.1, 0.1, 0.1};

static armtol_answer *answer_of(const armtol_link links[], size_t n_links, const double q[], size_t n_poses,
                                armtol_method method)
{
    armtol_drive drives[3] = {armtol_drive_unknown, armtol_drive_unknown, armtol_drive_unknown};
    const armtol_arm arm = {.name = "arm", .title = "arm", .source = "the test", .n_links = n_links, .links = links,
                            .drives = drives};
    const armtol_question question = {.arm = &arm, .q = q, .n_poses = n_poses, .accuracy = six_ones, .method = method,
                                      .sigma = 3};
    armtol_answer *answer;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&question, &answer, NULL));
    return answer;
}

/* Of the two poses the one far out, where sqrt(a^2 + d^2) grows least when a and d do, in either order. */
static void test_by_sphere_the_slide_has_the_strictest_distance_of_all_poses(void)
{
    static const double near_far[4] = {0.2, 20, 0.2, 300}, far_near[4] = {0.2, 300, 0.2, 20};
    for (int order = 0; order < 2; order++) {
        armtol_answer *answer =
            answer_of(slide_links, 3, order == 0 ? near_far : far_near, 2, ARMTOL_METHOD_SPHERE);
        const double s = answer->tolerances[2]; /* d of link 0 comes second, a third; all lengths have one share */
        double strictest = INFINITY;
        for (int pose = 0; pose < 2; pose++) {
            const double d = 40 + (pose == 0 ? 20 : 300);
            strictest = fmin(strictest, hypot(30 + s, d + s) - hypot(30, d));
        }
        check_within(1e-12, strictest, answer->parts[1].distance, "distance");
        check_within(1e-12, strictest, answer->parts[1].motor, "motor");
        armtol_answer_destroy(answer);
    }
}

/* -h + sqrt(...) leaves nothing of a share of 1e-14 of h; the derivative of h says what is right. */
static void test_by_sphere_the_distance_does_not_cancel(void)
{
    static const double q[2] = {0, 0};
    armtol_link links[3] = {slide_links[0], slide_links[1], slide_links[2]};
    links[0].a = 3e13;
    links[0].d = 4e13;
    armtol_answer *answer = answer_of(links, 3, q, 1, ARMTOL_METHOD_SPHERE);
    const double s = answer->tolerances[2];
    check_within(1e-12 * s, s * (3 + 4) / 5, answer->parts[0].distance, "distance");
    armtol_answer_destroy(answer);
}

static void test_parallel_axes_are_a_apart_and_a_slide_has_no_distance(void)
{
    static const double q[2] = {0.3, 20};
    const armtol_link links[3] = {
        {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 0, .d = 380}, slide_links[1], {ARMTOL_NPR, ARMTOL_FIXED, .a = 80, .d = 60}};
    armtol_answer *answer = answer_of(links, 3, q, 1, ARMTOL_METHOD_WORST);
    check_same(answer->tolerances[1], answer->parts[0].distance, "a = 0, d is no source");
    TEST_ASSERT_TRUE(isnan(answer->parts[1].distance));
    const double d = answer->tolerances[10], a = answer->tolerances[11];
    check_within(1e-12, hypot(80 + a, 60 + d) - 100, answer->parts[2].distance, "a and d");
    armtol_answer_destroy(answer);
}

/* One link whose slide takes the lever from theta to d: the deviation is largest where the worst case is not. */
static void test_the_budget_of_rss_is_of_the_pose_of_the_deviation(void)
{
    static const armtol_link links[2] = {{ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 3}, {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 4}};
    static const double q[4] = {0, 0, 0, 1.5707963267948966};
    static const double tolerances[8] = {0.01, 0.0, 0, 0, 0.0125, 0.03, 0, 0};
    armtol_drive drives[2] = {armtol_drive_unknown, armtol_drive_unknown};
    const armtol_arm arm = {.name = "a", .title = "a", .source = "t", .n_links = 2, .links = links, .drives = drives};
    const armtol_question question = {.arm = &arm, .q = q, .n_poses = 2, .method = ARMTOL_METHOD_RSS, .sigma = 1,
                                      .tolerances = tolerances};
    armtol_answer *answer;
    armtol_budget *budget;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&question, &answer, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_budget_create(answer, &budget));
    /* dy: pose 0 has 7 x 0.01 and 4 x 0.0125; pose 1 has 3 x 0.01 and 0.03 of a: pose 0 in either sense */
    check_within(1e-15, 0.07 + 0.05, answer->components[1].worst, "worst");
    TEST_ASSERT_TRUE(answer->components[1].deviation_pose == 0);
    /* dx: pose 0 has 0.03 of a, pose 1 has 4 x 0.01 and 4 x 0.0125 */
    TEST_ASSERT_TRUE(answer->components[0].deviation_pose == 1);
    check_within(1e-12, 1, budget->motors[0], "motors of dx");
    armtol_budget_destroy(budget);
    armtol_answer_destroy(answer);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_by_sphere_the_slide_has_the_strictest_distance_of_all_poses);
    RUN_TEST(test_by_sphere_the_distance_does_not_cancel);
    RUN_TEST(test_parallel_axes_are_a_apart_and_a_slide_has_no_distance);
    RUN_TEST(test_the_budget_of_rss_is_of_the_pose_of_the_deviation);
    return UNITY_END();
}
