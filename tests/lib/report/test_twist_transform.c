#include "armtol/link_transform.h"
#include "armtol/twist_transform.h"

#include "support/check.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static const armtol_residue no_residue = {{0, 0, 0}};

/* (v; w) seen through the adjoint. */
static void map(const armtol_adjoint *adjoint, const double twist[6], double mapped[6])
{
    for (int i = 0; i < 6; i++) {
        mapped[i] = 0;
        for (int j = 0; j < 6; j++) {
            mapped[i] += adjoint->m[i][j] * twist[j];
        }
    }
}

static void test_a_twist_is_turned_and_its_v_gains_p_cross_w(void)
{
    /* a quarter turn about z, then (10, 20, 30) away: x goes to y, y to -x */
    const armtol_transform quarter = {{{0, -1, 0, 10}, {1, 0, 0, 20}, {0, 0, 1, 30}, {0, 0, 0, 1}}};
    const double twist[6] = {1, 2, 3, 4, 5, 6};
    /* R v = (-2, 1, 3), R w = (-5, 4, 6), p x R w = (20*6 - 30*4, 30*-5 - 10*6, 10*4 + 20*5) */
    const double expected[6] = {-2 + 0, 1 - 210, 3 + 140, -5, 4, 6};
    double mapped[6];
    const armtol_adjoint adjoint = armtol_twist_transform(&quarter, &no_residue, &armtol_errata_none);
    map(&adjoint, twist, mapped);
    for (int i = 0; i < 6; i++) {
        check_within(1e-12, expected[i], mapped[i], "component %d", i);
    }
}

static void test_the_residue_adds_a_diagonal_to_the_skew_matrix(void)
{
    const armtol_transform turned = armtol_link_transform(
        &(armtol_link){.a = 3, .alpha = 0.7, .d = 5, .theta = 0.4}, &armtol_errata_none);
    const armtol_residue residue = {{0.5, -2, 8}};
    const armtol_adjoint with = armtol_twist_transform(&turned, &residue, &armtol_errata_none);
    const armtol_adjoint without = armtol_twist_transform(&turned, &no_residue, &armtol_errata_none);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            check_within(1e-14, residue.diagonal[i] * turned.m[i][j], with.m[i][j + 3] - without.m[i][j + 3],
                         "row %d, column %d", i, j);
        }
    }
}

/*
 * The main program keeps 1.570795 in a float, 0x3fc90fd0; widened that is the double 0x3ff921fa00000000, whose upper
 * word is, as a float, 1 + 0x7921fa / 2^23.
 */
static void test_the_residue_of_the_adept_is_what_gnpr_left(void)
{
    armtol_link tool = {.kind = ARMTOL_NPR, .alpha = 3.14159 / 2};
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_links_place(&tool, 1, NULL, 0, &armtol_errata_1987, &tool));
    const armtol_residue residue = armtol_skew_residue(&tool, 1, &armtol_errata_1987);
    check_same(1 + 0x7921fa / 8388608.0, residue.diagonal[0], "high word of alpha");
    check_printed("1.946349", residue.diagonal[0], "high word of alpha");
    check_same(1, residue.diagonal[1], "sin alpha, a float");
    check_same(0, residue.diagonal[2], "high word of a");
}

static void test_the_residue_takes_the_last_link_s_length(void)
{
    /* 100.0 is 0x4059000000000000, and 0x40590000 as a float is 2^1 (1 + 0x590000 / 2^23) */
    const armtol_link links[] = {{.kind = ARMTOL_NPR, .a = 3, .alpha = 1}, {.kind = ARMTOL_NPR, .a = 100}};
    const armtol_residue residue = armtol_skew_residue(links, 2, &armtol_errata_1987);
    check_same(0, residue.diagonal[0], "high word of alpha");
    check_same(0, residue.diagonal[1], "sin alpha");
    check_same(2 * (1 + 0x590000 / 8388608.0), residue.diagonal[2], "high word of a");
}

static void check_zero(const armtol_residue *residue)
{
    for (int i = 0; i < 3; i++) {
        check_same(0, residue->diagonal[i], "word %d", i);
    }
}

static void test_corrected_or_unknown_there_is_no_residue(void)
{
    const armtol_link npr = {.kind = ARMTOL_NPR, .a = 2, .alpha = 1};
    const armtol_link ppr = {.kind = ARMTOL_PPR, .a = 2, .alpha = 1};
    const armtol_residue corrected = armtol_skew_residue(&npr, 1, &armtol_errata_none);
    const armtol_residue other_kind = armtol_skew_residue(&ppr, 1, &armtol_errata_1987);
    const armtol_residue no_links = armtol_skew_residue(NULL, 0, &armtol_errata_1987);
    check_zero(&corrected);
    check_zero(&other_kind);
    check_zero(&no_links);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_twist_is_turned_and_its_v_gains_p_cross_w);
    RUN_TEST(test_the_residue_adds_a_diagonal_to_the_skew_matrix);
    RUN_TEST(test_the_residue_of_the_adept_is_what_gnpr_left);
    RUN_TEST(test_the_residue_takes_the_last_link_s_length);
    RUN_TEST(test_corrected_or_unknown_there_is_no_residue);
    return UNITY_END();
}
