#include "armtol/craig.h"

#include "support/check.h"
#include "support/random.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* Craig, Eq. (3.6), by the images of the origin and of the axes. */
static void test_one_link_in_closed_form(void)
{
    const double alpha = 0.4, theta = 0.7, a = 2, d = 3;
    const armtol_craig_link link = {ARMTOL_FIXED, a, alpha, d, theta};
    const armtol_transform t = armtol_craig_transform(&link, 99, &armtol_errata_none);
    const double expected[3][4] = {
        {cos(theta), -sin(theta), 0, a},
        {sin(theta) * cos(alpha), cos(theta) * cos(alpha), -sin(alpha), -sin(alpha) * d},
        {sin(theta) * sin(alpha), cos(theta) * sin(alpha), cos(alpha), cos(alpha) * d},
    };
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            check_within(1e-15, expected[i][j], t.m[i][j], "row %d, column %d", i, j);
        }
    }
}

static void test_joint_values_move_theta_or_d(void)
{
    const armtol_craig_link revolute = {ARMTOL_REVOLUTE, .theta = 0.2}, turned = {ARMTOL_FIXED, .theta = 0.5};
    const armtol_craig_link prismatic = {ARMTOL_PRISMATIC, .d = 2};
    const armtol_transform moved = armtol_craig_transform(&revolute, 0.3, &armtol_errata_none);
    const armtol_transform fixed = armtol_craig_transform(&turned, 0, &armtol_errata_none);
    check_same(fixed.m[1][0], moved.m[1][0], "revolute");
    check_same(7, armtol_craig_transform(&prismatic, 5, &armtol_errata_none).m[2][3], "prismatic");
}

/* A planar arm: x = a cos q1 + b cos(q1 + q2), and a prismatic joint across the plane. */
static void test_a_planar_chain_in_closed_form(void)
{
    const armtol_craig_link links[] = {
        {ARMTOL_FIXED, .d = 10},
        {ARMTOL_REVOLUTE, .a = 0},
        {ARMTOL_REVOLUTE, .a = 3},
        {ARMTOL_PRISMATIC, .a = 2},
    };
    const double q[] = {0.3, 0.4, -1};
    const armtol_transform t = armtol_craig_chain(links, 4, q, &armtol_errata_none);
    check_within(1e-15, 3 * cos(0.3) + 2 * cos(0.7), t.m[0][3], "x");
    check_within(1e-15, 3 * sin(0.3) + 2 * sin(0.7), t.m[1][3], "y");
    check_within(1e-14, 9, t.m[2][3], "z");
    check_within(1e-15, sin(0.7), t.m[1][0], "sine of the tool's angle");
}

/* What transf of 1987 does, with casts where K&R C widens: parameters, sines, cosines and output are floats. */
static void test_1987_stores_parameters_sines_and_cosines(void)
{
    random_source source = {1};
    for (int n = 0; n < 100; n++) {
        const double a = random_between(&source, -400, 400), alpha = random_between(&source, -3, 3);
        const double d = random_between(&source, -400, 400), theta = random_between(&source, -3, 3);
        const armtol_craig_link link = {ARMTOL_FIXED, a, alpha, d, theta};
        const armtol_transform t = armtol_craig_transform(&link, 0, &armtol_errata_1987);
        const float n1 = (float)sin((double)(float)alpha), n2 = (float)cos((double)(float)alpha);
        const float n3 = (float)sin((double)(float)theta), n4 = (float)cos((double)(float)theta);
        const float kd = (float)d;
        const float expected[3][4] = {
            {n4, -n3, 0, (float)a},
            {(float)((double)n3 * (double)n2), (float)((double)n4 * (double)n2), -n1,
             (float)(-(double)n1 * (double)kd)},
            {(float)((double)n3 * (double)n1), (float)((double)n4 * (double)n1), n2, (float)((double)n2 * (double)kd)},
        };
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 4; j++) {
                check_same((double)expected[i][j], t.m[i][j], "draw %d, row %d, column %d", n, i, j);
            }
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_one_link_in_closed_form);
    RUN_TEST(test_joint_values_move_theta_or_d);
    RUN_TEST(test_a_planar_chain_in_closed_form);
    RUN_TEST(test_1987_stores_parameters_sines_and_cosines);
    return UNITY_END();
}
