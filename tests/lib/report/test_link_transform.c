#include "armtol/link_transform.h"

#include "support/check.h"
#include "support/random.h"
#include "support/reference.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static armtol_link random_link(random_source *source)
{
    return (armtol_link){
        .kind = ARMTOL_PPR,
        .a = random_between(source, -400, 400),
        .alpha = random_between(source, -3, 3),
        .d = random_between(source, -400, 400),
        .theta = random_between(source, -3, 3),
        .beta = random_between(source, -3, 3),
    };
}

static void check_equal(double expected[4][4], const armtol_transform *actual, double tolerance)
{
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            check_within(tolerance, expected[i][j], actual->m[i][j], "row %d, column %d", i, j);
        }
    }
}

static void test_corrected_it_is_the_product_of_elementary_motions(void)
{
    random_source source = {1};
    for (int n = 0; n < 100; n++) {
        const armtol_link link = random_link(&source);
        const armtol_transform transform = armtol_link_transform(&link, &armtol_errata_none);
        double expected[4][4];
        reference_link(&link, expected);
        check_equal(expected, &transform, 1e-12);
    }
}

static void test_as_of_1987_one_element_differs(void)
{
    random_source source = {2};
    armtol_errata errata = armtol_errata_none;
    errata.mtransf_typo = true;
    for (int n = 0; n < 100; n++) {
        const armtol_link link = random_link(&source);
        const armtol_transform transform = armtol_link_transform(&link, &errata);
        double expected[4][4];
        reference_link(&link, expected);
        expected[1][2] = sin(link.theta) * sin(link.beta) - sin(link.theta) * sin(link.alpha) * cos(link.beta);
        check_equal(expected, &transform, 1e-12);
    }
}

static void test_a_chain_is_the_product_of_its_links(void)
{
    random_source source = {3};
    armtol_link links[20];
    double expected[4][4];
    for (size_t i = 0; i < 20; i++) {
        links[i] = random_link(&source);
    }
    reference_chain(links, 20, expected);
    const armtol_transform chain = armtol_chain_transform(links, 20, &armtol_errata_none);
    check_equal(expected, &chain, 1e-10);
}

static void test_a_chain_of_no_links_is_the_identity(void)
{
    double identity[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    const armtol_transform chain = armtol_chain_transform(NULL, 0, &armtol_errata_1987);
    check_equal(identity, &chain, 0);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_corrected_it_is_the_product_of_elementary_motions);
    RUN_TEST(test_as_of_1987_one_element_differs);
    RUN_TEST(test_a_chain_is_the_product_of_its_links);
    RUN_TEST(test_a_chain_of_no_links_is_the_identity);
    return UNITY_END();
}
