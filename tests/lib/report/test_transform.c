#include "armtol/transform.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static armtol_transform random_motion(random_source *source)
{
    const armtol_link link = {
        .a = random_between(source, -400, 400),   .alpha = random_between(source, -3, 3),
        .d = random_between(source, -400, 400),   .theta = random_between(source, -3, 3),
        .beta = random_between(source, -1.5, 1.5),
    };
    armtol_transform motion;
    reference_link(&link, motion.m);
    return motion;
}

static void check_equal(const armtol_transform *expected, const armtol_transform *actual, double tolerance)
{
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            check_within(tolerance, expected->m[i][j], actual->m[i][j], "row %d, column %d", i, j);
        }
    }
}

static void test_a_motion_and_its_inverse_cancel(void)
{
    random_source source = {1};
    const armtol_transform identity = armtol_transform_identity();
    for (int n = 0; n < 50; n++) {
        const armtol_transform motion = random_motion(&source);
        const armtol_transform inverse = armtol_transform_inverse(&motion, &armtol_errata_none);
        const armtol_transform one = armtol_transform_product(&motion, &inverse, &armtol_errata_none);
        const armtol_transform other = armtol_transform_product(&inverse, &motion, &armtol_errata_none);
        check_equal(&identity, &one, 1e-12);
        check_equal(&identity, &other, 1e-12);
    }
}

static void test_a_product_by_hand(void)
{
    /* a quarter turn about z and 10 along x, then 5 along the new x, which is y */
    const armtol_transform quarter = {{{0, -1, 0, 10}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    const armtol_transform along_x = {{{1, 0, 0, 5}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    const armtol_transform expected = {{{0, -1, 0, 10}, {1, 0, 0, 5}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    const armtol_transform product = armtol_transform_product(&quarter, &along_x, &armtol_errata_1987);
    check_equal(&expected, &product, 0);
}

static void test_products_of_1987_round_at_every_step(void)
{
    /* in float 2^24 + 1 is 2^24 again, so that of 2^24 + 1 + 1 nothing of the ones is left */
    const double big = 16777216;
    const armtol_transform left = {{{big, 1, 1, 0}}};
    const armtol_transform right = {{{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 0}}};
    check_same(big, armtol_transform_product(&left, &right, &armtol_errata_1987).m[0][0], "float");
    check_same(big + 2, armtol_transform_product(&left, &right, &armtol_errata_none).m[0][0], "double");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_motion_and_its_inverse_cancel);
    RUN_TEST(test_a_product_by_hand);
    RUN_TEST(test_products_of_1987_round_at_every_step);
    return UNITY_END();
}
