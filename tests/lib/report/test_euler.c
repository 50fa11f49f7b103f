#include "armtol/euler.h"

#include "support/check.h"
#include "support/random.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static void check_turn(int angle, const double from[3], const double to[3])
{
    double pose[6] = {10, 20, 30, 0, 0, 0};
    pose[angle] = 1.5707963267948966;
    const armtol_transform t = armtol_pose_to_transform(pose, &armtol_errata_none);
    for (int i = 0; i < 3; i++) {
        const double turned = t.m[i][0] * from[0] + t.m[i][1] * from[1] + t.m[i][2] * from[2];
        check_within(1e-15, to[i], turned, "angle %d, component %d", angle, i);
        check_same(pose[i], t.m[i][3], "position %d", i);
    }
}

static void test_gamma_beta_and_alpha_turn_about_x_y_and_z(void)
{
    const double x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
    check_turn(3, y, z);
    check_turn(4, z, x);
    check_turn(5, x, y);
}

/* gamma acts first, alpha last. */
static void test_the_order_is_z_y_x(void)
{
    const double quarter = 1.5707963267948966;
    const double pose[6] = {0, 0, 0, quarter, 0.25, quarter};
    const armtol_transform t = armtol_pose_to_transform(pose, &armtol_errata_none);
    /* Rz Ry Rx z = Rz Ry (-y) = Rz (-y) = x */
    check_within(1e-15, 1, t.m[0][2], "x of the turned z axis");
    check_within(1e-15, 0, t.m[1][2], "y of the turned z axis");
    check_within(1e-15, 0, t.m[2][2], "z of the turned z axis");
}

static void test_there_and_back(void)
{
    random_source source = {1};
    for (int n = 0; n < 100; n++) {
        double pose[6], back[6];
        for (int i = 0; i < 6; i++) {
            const double range = i < 3 ? 500 : i == 4 ? 1.5 : 3.1;
            pose[i] = random_between(&source, -range, range);
        }
        const armtol_transform t = armtol_pose_to_transform(pose, &armtol_errata_none);
        armtol_transform_to_pose(&t, &armtol_errata_none, back);
        for (int i = 0; i < 6; i++) {
            check_within(1e-12, pose[i], back[i], "component %d", i);
        }
    }
}

/* What eulerzyx of 1987 does, with casts where K&R C widens: sines and cosines are floats. */
static void test_1987_stores_sines_and_cosines(void)
{
    random_source source = {2};
    for (int n = 0; n < 100; n++) {
        double pose[6];
        for (int i = 0; i < 6; i++) {
            pose[i] = (double)(float)random_between(&source, -3, 3);
        }
        const armtol_transform t = armtol_pose_to_transform(pose, &armtol_errata_1987);
        const double cg = (double)(float)cos(pose[3]), sg = (double)(float)sin(pose[3]);
        const double cb = (double)(float)cos(pose[4]), sb = (double)(float)sin(pose[4]);
        const double ca = (double)(float)cos(pose[5]), sa = (double)(float)sin(pose[5]);
        const float expected[3][3] = {
            {(float)(ca * cb), (float)(ca * sb * sg - sa * cg), (float)(ca * sb * cg + sa * sg)},
            {(float)(sa * cb), (float)(sa * sb * sg + ca * cg), (float)(sa * sb * cg - ca * sg)},
            {(float)-sb, (float)(cb * sg), (float)(cb * cg)},
        };
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                check_same((double)expected[i][j], t.m[i][j], "draw %d, row %d, column %d", n, i, j);
            }
            check_same(pose[i], t.m[i][3], "draw %d, row %d", n, i);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_gamma_beta_and_alpha_turn_about_x_y_and_z);
    RUN_TEST(test_the_order_is_z_y_x);
    RUN_TEST(test_there_and_back);
    RUN_TEST(test_1987_stores_sines_and_cosines);
    return UNITY_END();
}
