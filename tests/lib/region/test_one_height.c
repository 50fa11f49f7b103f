/*
 * Tolerances for 25 poses of a SCARA at one height, and what they allow at another. Judge: the tool point by a chain of
 * the test's own, moved by central differences.
 */

#include "armtol/answer.h"
#include "support/check.h"

#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define DEGREE 0.017453292519943295

enum { POSES = 25, LINKS = 4, JOINTS = 4 };

void setUp(void)
{
}

void tearDown(void)
{
}

static const double accuracy[6] = {0.02, 0.02, 0.02, 0.01 * DEGREE, 0.01 * DEGREE, 0.01 * DEGREE};

/* The shoulder at -90, -45 to 90, the elbow at 30, 60 to 150 degrees, the slide where it is asked to be. */
static void poses_at(double slide, double q[POSES * JOINTS])
{
    for (size_t i = 0; i < POSES; i++) {
        const size_t shoulder = i / 5, elbow = i % 5;
        const double pose[] = {(-90 + 45 * (double)shoulder) * DEGREE, (30 + 30 * (double)elbow) * DEGREE, slide, 0};
        memcpy(q + JOINTS * i, pose, sizeof pose);
    }
}

static armtol_answer *answer_at(double slide, const double tolerances[])
{
    double q[POSES * JOINTS];
    armtol_answer *answer;
    poses_at(slide, q);
    const armtol_question question = {.arm = armtol_arm_named("scara"), .q = q, .n_poses = POSES,
                                      .accuracy = accuracy, .tolerances = tolerances};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&question, &answer, NULL));
    return answer;
}

/* ---- the judge ---- */

/* theta, d, a, alpha, beta of each link, in the order of armtol_parameter: docs/arms.md's table of the Cobra 600. */
typedef double chain[LINKS][ARMTOL_PARAMETER_COUNT];

static void chain_of(const double pose[JOINTS], chain links)
{
    const chain arm = {{pose[0], 387, 325, 0, 0}, {pose[1], 0, 275, 180 * DEGREE, 0}, {0, pose[2], 0, 0, 0},
                       {pose[3], 0, 0, 0, 0}};
    memcpy(links, arm, sizeof arm);
}

/* From the last frame's origin back to the base: about y, about x, along both, about z. */
static void tool_of(const chain links, double tool[3])
{
    memset(tool, 0, 3 * sizeof *tool);
    for (size_t i = LINKS; i-- > 0;) {
        const double *link = links[i], cb = cos(link[ARMTOL_BETA]), sb = sin(link[ARMTOL_BETA]);
        const double x = cb * tool[0] + sb * tool[2], z = -sb * tool[0] + cb * tool[2];
        const double ca = cos(link[ARMTOL_ALPHA]), sa = sin(link[ARMTOL_ALPHA]);
        const double along = link[ARMTOL_A] + x, across = ca * tool[1] - sa * z;
        const double ct = cos(link[ARMTOL_THETA]), st = sin(link[ARMTOL_THETA]);
        tool[2] = link[ARMTOL_D] + sa * tool[1] + ca * z;
        tool[0] = ct * along - st * across;
        tool[1] = st * along + ct * across;
    }
}

/* What the tolerances allow along an axis in a pose, to first order. */
static double worst_by_differences(const armtol_answer *answer, const double pose[JOINTS], int axis)
{
    const double step = 1e-4;
    double sum = 0;
    for (size_t k = 0; k < answer->n_columns; k++) {
        chain links;
        double ahead[3], behind[3];
        double *parameter = &links[answer->columns[k].link][answer->columns[k].parameter];
        chain_of(pose, links);
        *parameter += step;
        tool_of((const double (*)[ARMTOL_PARAMETER_COUNT])links, ahead);
        *parameter -= 2 * step;
        tool_of((const double (*)[ARMTOL_PARAMETER_COUNT])links, behind);
        sum += fabs(ahead[axis] - behind[axis]) / (2 * step) * answer->tolerances[k];
    }
    return sum;
}

static double largest_at(const armtol_answer *answer, double slide, int axis)
{
    double q[POSES * JOINTS], most = 0;
    poses_at(slide, q);
    for (size_t i = 0; i < POSES; i++) {
        most = fmax(most, worst_by_differences(answer, q + JOINTS * i, axis));
    }
    return most;
}

/* Halfway down the slide the same tolerances allow 0.029 mm, and at its end 0.038 mm. */
static void test_another_height_allows_half_as_much_again(void)
{
    armtol_answer *upper = answer_at(0, NULL);
    armtol_answer *middle = answer_at(105, upper->tolerances);
    for (int axis = 0; axis < 2; axis++) {
        const double halfway = largest_at(upper, 105, axis);
        check_within(1e-6, 0.02, largest_at(upper, 0, axis), "axis %d at the height asked for", axis);
        check_within(0.0001, 0.029, halfway, "axis %d halfway down", axis);
        check_within(0.0001, 0.038, largest_at(upper, 210, axis), "axis %d at the end of the slide", axis);
        check_within(1e-8, halfway, middle->components[axis].worst, "axis %d, by the engine", axis);
    }
    armtol_answer_destroy(middle);
    armtol_answer_destroy(upper);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_another_height_allows_half_as_much_again);
    return UNITY_END();
}
