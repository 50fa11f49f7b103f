#include "armtol/arm.h"
#include "armtol/error_matrix.h"
#include "armtol/robots.h"
#include "armtol/tool_matrix.h"

#include "lib/optimum/told_to_nlopt.h"
#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The optimum held against that of a general solver (told_to_nlopt.h). */

enum { MOST_LINKS = 8 };

static problem given;

void setUp(void)
{
}

void tearDown(void)
{
}

static void compare(problem *problem, const char *what)
{
    double expected[MOST_COLUMNS], actual[MOST_COLUMNS], multipliers[MOST_ROWS];
    const size_t size = armtol_optimum_workspace(problem->n_rows, problem->n_columns);
    double *workspace = malloc(size * sizeof *workspace);
    TEST_ASSERT_NOT_NULL(workspace);
    for (int sum = 0; sum < ARMTOL_SUM_COUNT; sum++) {
        problem->sum = (armtol_sum)sum;
        const armtol_status status = armtol_optimum(problem->sum, problem->matrix, problem->n_rows,
                                                     problem->n_columns, problem->limits, problem->weights,
                                                     actual, multipliers, workspace);
        TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_OK, status, what);
        solve_with_nlopt(problem, expected);
        for (size_t k = 0; k < problem->n_columns; k++) {
            check_within(1e-6 * expected[k], expected[k], actual[k], "%s, sum %d, column %zu", what, sum, k);
        }
    }
    free(workspace);
}

/* ---- problems ---- */

static void even_weights(problem *problem)
{
    for (size_t k = 0; k < problem->n_columns; k++) {
        problem->weights[k] = 1;
    }
}

static void random_weights(random_source *source, problem *problem)
{
    for (size_t k = 0; k < problem->n_columns; k++) {
        problem->weights[k] = random_between(source, 0.1, 10);
    }
}

/* A of placed links, below the rows that there are. */
static void add_pose(problem *problem, const armtol_link placed[], size_t n_links)
{
    problem->n_columns = armtol_column_count(placed, n_links);
    TEST_ASSERT_TRUE(problem->n_columns <= MOST_COLUMNS && problem->n_rows + 6 <= MOST_ROWS);
    double *a = problem->matrix + problem->n_rows * problem->n_columns;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_error_matrix(placed, n_links, &armtol_errata_none, a,
                                                         problem->n_columns));
    armtol_tool_matrix_clear(placed, n_links, &armtol_tool_origin, a, problem->n_columns);
    for (size_t i = 0; i < 6; i++) {
        problem->limits[problem->n_rows++] = i < 3 ? 0.5 : 0.1;
    }
}

static void compare_robot(const armtol_robot *robot, const double wish[], const char *what)
{
    armtol_link links[MOST_LINKS];
    double q[6];
    armtol_reach reach;
    robot->links(&armtol_errata_none, links);
    TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_OK, robot->inverse(wish, &armtol_errata_none, q, &reach), what);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(links, robot->n_links, q, robot->n_joints,
                                                        &armtol_errata_none, links));
    given.n_rows = 0;
    add_pose(&given, links, robot->n_links);
    even_weights(&given);
    compare(&given, what);
    for (size_t i = 3; i < 6; i++) {
        given.limits[i] = 1e-4;
    }
    random_source source = {1};
    random_weights(&source, &given);
    compare(&given, what);
}

static void test_the_arms_of_1987(void)
{
    static const double intelledex[2][6] = {{200, 200, 0, 0, 1.57, 0}, {-200, 200, 100, 0, 1.57, 0}};
    static const double adept[2][4] = {{200, 200, 0, 0}, {-200, 200, 100, 0}};
    compare_robot(&armtol_intelledex_605t, intelledex[0], "Intelledex, case 1");
    compare_robot(&armtol_intelledex_605t, intelledex[1], "Intelledex, case 2");
    compare_robot(&armtol_adept_one, adept[0], "Adept, case 1");
    compare_robot(&armtol_adept_one, adept[1], "Adept, case 2");
}

/* At joint values within the limits that are known. */
static void compare_arm(random_source *source, const armtol_arm *arm)
{
    armtol_link links[MOST_LINKS];
    double q[MOST_LINKS];
    size_t n_joints = 0;
    TEST_ASSERT_TRUE(arm->n_links <= MOST_LINKS);
    for (size_t i = 0; i < arm->n_links; i++) {
        if (arm->links[i].joint != ARMTOL_FIXED) {
            const armtol_drive *drive = &arm->drives[i];
            q[n_joints++] = random_between(source, fmax(drive->low, -3), fmin(drive->high, 300));
        }
    }
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(arm->links, arm->n_links, q, n_joints, &armtol_errata_none,
                                                        links));
    given.n_rows = 0;
    add_pose(&given, links, arm->n_links);
    random_weights(source, &given);
    compare(&given, arm->name);
}

static void test_every_built_in_arm(void)
{
    random_source source = {1987};
    for (size_t i = 0; i < armtol_arm_count(); i++) {
        for (int pose = 0; pose < 3; pose++) {
            compare_arm(&source, armtol_arm_at(i));
        }
    }
}

static void draw_arm(random_source *source, armtol_link links[], size_t n_links)
{
    for (size_t i = 0; i < n_links; i++) {
        links[i] = (armtol_link){
            .kind = (armtol_kind)random_between(source, 0, ARMTOL_KIND_COUNT),
            .a = random_between(source, -400, 400),
            .alpha = random_between(source, -2, 2),
            .d = random_between(source, -400, 400),
            .beta = random_between(source, -0.1, 0.1),
        };
    }
}

static void turn(random_source *source, armtol_link links[], size_t n_links)
{
    for (size_t i = 0; i < n_links; i++) {
        links[i].theta = random_between(source, -3, 3);
    }
}

static void test_random_arms_in_one_pose_or_several(void)
{
    random_source source = {2};
    for (int round = 0; round < 20; round++) {
        char what[40];
        armtol_link links[MOST_LINKS];
        const size_t n_links = (size_t)random_between(&source, 2, MOST_LINKS + 1);
        const int n_poses = round % 2 == 0 ? 1 : (int)random_between(&source, 2, MOST_ROWS / 6 + 1);
        draw_arm(&source, links, n_links);
        given.n_rows = 0;
        for (int pose = 0; pose < n_poses; pose++) {
            turn(&source, links, n_links);
            add_pose(&given, links, n_links);
        }
        random_weights(&source, &given);
        snprintf(what, sizeof what, "arm %d in %d poses", round, n_poses);
        compare(&given, what);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_arms_of_1987);
    RUN_TEST(test_every_built_in_arm);
    RUN_TEST(test_random_arms_in_one_pose_or_several);
    return UNITY_END();
}
