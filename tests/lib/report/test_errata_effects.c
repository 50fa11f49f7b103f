/*
 * Every erratum, kept and corrected, by what it does to the results of the paper's cases. Expected values are the
 * paper's, or those of central differences of Eq. (4.1), or are worked out here by hand.
 */

#include "1987/analysis.h"
#include "1987/program.h"
#include "1987/report.h"

#include "support/check.h"
#include "support/reference.h"
#include "unity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct paper_case {
    const char *name;
    const armtol_robot *robot;
    double wish[6];
} paper_case;

enum { INTELLA_1, INTELLA_2, ADPTA_1, ADPTA_2, CASES };

static const paper_case cases[CASES] = {
    {"intella 1", &armtol_intelledex_605t, {200, 200, 0, 0, 1.57, 0}},
    {"intella 2", &armtol_intelledex_605t, {-200, 200, 100, 0, 1.57, 0}},
    {"adpta 1", &armtol_adept_one, {200, 200, 0, 0}},
    {"adpta 2", &armtol_adept_one, {-200, 200, 100, 0}},
};

static analysis with;

void setUp(void)
{
    memset(&with, 0, sizeof with);
}

void tearDown(void)
{
    analysis_free(&with);
}

/* The case once more, with these errata, in `with`. */
static void analyse(int index, const armtol_errata *errata)
{
    double wish[6], tolerances[6];
    for (int i = 0; i < 6; i++) {
        wish[i] = armtol_stored(errata, cases[index].wish[i]);
        tolerances[i] = armtol_stored(errata, i < 3 ? 0.5 : 0.1);
    }
    analysis_free(&with);
    TEST_ASSERT_TRUE(analysis_start(&with, cases[index].robot, errata));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, analysis_place(&with, wish));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, analysis_matrix(&with, NULL));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, analysis_tolerances(&with, tolerances, armtol_stored(errata, 0.1)));
}

/* All of 1987 but the one; and nothing of it but the one. */
static void analyse_corrected(int index, const char *erratum)
{
    armtol_errata errata = armtol_errata_1987;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_erratum_keep(&errata, erratum, false));
    analyse(index, &errata);
}

static void analyse_alone(int index, const char *erratum)
{
    armtol_errata errata = armtol_errata_none;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_erratum_keep(&errata, erratum, true));
    analyse(index, &errata);
}

static void check_bounds(int index, const char *distance, const char *angle)
{
    check_printed(distance, with.bounds.distance, "%s, distance bound", cases[index].name);
    check_printed(angle, with.bounds.angle, "%s, angle bound", cases[index].name);
}

static void test_1987_gives_the_paper_s_bounds(void)
{
    static const char *const distance[CASES] = {"0.035243", "0.041592", "0.043655", "0.045870"};
    static const char *const angle[CASES] = {"0.000370", "0.000440", "0.000508", "0.000666"};
    for (int i = 0; i < CASES; i++) {
        analyse(i, &armtol_errata_1987);
        check_bounds(i, distance[i], angle[i]);
    }
}

/* Eqs (4.25) to (4.31) of central differences of Eq. (4.1), worked out apart from this program. */
static void test_corrected_gives_the_bounds_for_the_tool_point(void)
{
    static const char *const distance[CASES] = {"0.049833", "0.051587", "0.043655", "0.074368"};
    static const char *const angle[CASES] = {"0.000599", "0.000671", "0.000730", "0.000855"};
    for (int i = 0; i < CASES; i++) {
        analyse(i, &armtol_errata_none);
        check_bounds(i, distance[i], angle[i]);
    }
}

/* From central differences likewise, the twist referred to the base's origin as in the paper. */
static void test_base_twist(void)
{
    static const char *const distance[CASES] = {"0.043934", "0.051770", "0.057735", "0.053668"};
    static const char *const angle[CASES] = {"0.000625", "0.000459", "0.000589", "0.000589"};
    for (int i = 0; i < CASES; i++) {
        analyse_alone(i, "base-twist");
        check_bounds(i, distance[i], angle[i]);
    }
}

/* Without it the Intelledex's first case would have had nearly the right bounds, the rest of 1987 kept. */
static void test_mtransf_typo(void)
{
    analyse_corrected(INTELLA_1, "mtransf-typo");
    check_bounds(INTELLA_1, "0.043073", "0.000626");
    analyse_alone(INTELLA_1, "mtransf-typo");
    TEST_ASSERT_TRUE(fabs(with.bounds.distance - 0.049833) > 0.005);
}

/* The column of link 3's theta: its motion is that of a body turning about joint 3, so that v is in it. */
static void test_parallel_arm(void)
{
    const size_t theta_3 = 12;
    double g[6][ARMTOL_PARAMETER_COUNT];
    size_t count;
    analyse_corrected(INTELLA_1, "parallel-arm");
    TEST_ASSERT_EQUAL_INT(3, with.columns[theta_3].link);
    TEST_ASSERT_EQUAL_INT(ARMTOL_THETA, with.columns[theta_3].parameter);
    armtol_link_jacobian(&with.links[3], &with.errata, g, &count);
    check_same(armtol_stored(&armtol_errata_1987, 373.4), g[1][0], "corrected: the upper arm's length");
    const double corrected = with.bounds.angle;
    analyse(INTELLA_1, &armtol_errata_1987);
    armtol_link_jacobian(&with.links[3], &with.errata, g, &count);
    check_same(0, g[1][0], "kept: d, which is 0");
    TEST_ASSERT_TRUE(fabs(corrected - with.bounds.angle) > 1e-6);
}

static void test_adept_shift(void)
{
    analyse(ADPTA_1, &armtol_errata_1987);
    check_same(0, with.links[1].a, "kept, link 1");
    check_same(425, with.links[2].a, "kept, link 2");
    check_same(375, with.links[3].a, "kept, link 3");
    check_printed("0.078971", with.machining[1], "kept, rd[1] as published: no length");
    analyse_corrected(ADPTA_1, "adept-shift");
    check_same(425, with.links[1].a, "corrected, link 1");
    check_same(375, with.links[2].a, "corrected, link 2");
    check_same(0, with.links[3].a, "corrected, link 3");
    check_printed("0.055844", with.machining[1], "corrected, rd[1] is the 425 mm link's");
    check_printed("0.078971", with.machining[3], "corrected, rd[3] has no length");
}

/* 0.005315 and 0.006080: what the legacy program gives when its skew matrix starts at zero. */
static void test_skew_residue(void)
{
    analyse(ADPTA_1, &armtol_errata_1987);
    check_printed("0.005313", with.shares.angle, "adpta 1, kept, as published");
    analyse_corrected(ADPTA_1, "skew-residue");
    check_printed("0.005315", with.shares.angle, "adpta 1, corrected");
    analyse(ADPTA_2, &armtol_errata_1987);
    check_printed("0.006081", with.shares.angle, "adpta 2, kept, as published");
    analyse_corrected(ADPTA_2, "skew-residue");
    check_printed("0.006080", with.shares.angle, "adpta 2, corrected");
}

/* The Intelledex's tool has alpha = a = 0, so that the words on the stack are zeros too. */
static void test_skew_residue_of_the_intelledex_is_zero(void)
{
    for (int i = INTELLA_1; i <= INTELLA_2; i++) {
        double kept[6 * 32];
        analyse(i, &armtol_errata_1987);
        memcpy(kept, with.matrix, sizeof kept);
        analyse_corrected(i, "skew-residue");
        TEST_ASSERT_EQUAL_MEMORY(kept, with.matrix, sizeof kept);
    }
}

/* Too loose by sqrt(1/r): about 5 times for lengths, 39 to 52 times for angles. */
static void test_root_of_ratio(void)
{
    for (int i = 0; i < CASES; i++) {
        analyse(i, &armtol_errata_1987);
        const armtol_shares kept = with.shares;
        analyse_corrected(i, "root-of-ratio");
        check_within(1e-6, 1 / sqrt(with.bounds.distance), kept.distance / with.shares.distance, "lengths");
        check_within(1e-4, 1 / sqrt(with.bounds.angle), kept.angle / with.shares.angle, "angles");
    }
}

static void test_copied_counts(void)
{
    analyse(ADPTA_1, &armtol_errata_1987);
    const armtol_shares kept = with.shares;
    analyse_corrected(ADPTA_1, "copied-counts");
    check_within(1e-6, sqrt(14.0 / 9), with.shares.distance / kept.distance, "lengths");
    check_within(1e-6, sqrt(18.0 / 16), with.shares.angle / kept.angle, "angles");
    analyse(INTELLA_1, &armtol_errata_1987);
    const armtol_shares right = with.shares;
    analyse_corrected(INTELLA_1, "copied-counts");
    check_same(right.distance, with.shares.distance, "the Intelledex's counts are its own");
}

static void test_signed_mach(void)
{
    analyse(ADPTA_1, &armtol_errata_1987);
    check_printed("-0.055833", with.machining[4], "kept, rd[4]");
    check_printed("-0.055833", with.motor[3], "kept, td[3]");
    analyse_corrected(ADPTA_1, "signed-mach");
    /* h + rd = sqrt((h + s)^2 + s^2) with h = 203.2 */
    const double s = with.shares.distance, h = 203.2;
    check_within(1e-5, hypot(h + s, s) - h, with.machining[4], "corrected, rd[4]");
    check_same(with.machining[4], with.motor[3], "corrected, td[3]");
}

static void test_short_pi(void)
{
    analyse(ADPTA_1, &armtol_errata_1987);
    check_printed("2.429293", with.q[1], "kept, as published");
    analyse_corrected(ADPTA_1, "short-pi");
    check_printed("2.429296", with.q[1], "corrected: pi - acos(c)");
    analyse_corrected(INTELLA_1, "short-pi");
    check_printed("1.571239", with.q[0], "corrected, intella 1");
}

/* Nothing published shows it: a and alpha of the Adept's prismatic link are 0. */
static void test_prismatic_alpha(void)
{
    double kept[6 * 25];
    analyse(ADPTA_1, &armtol_errata_1987);
    memcpy(kept, with.matrix, sizeof kept);
    analyse_corrected(ADPTA_1, "prismatic-alpha");
    TEST_ASSERT_EQUAL_MEMORY(kept, with.matrix, sizeof kept);

    const armtol_link link = {.kind = ARMTOL_PPP, .a = 100, .alpha = 0.25};
    double g[6][ARMTOL_PARAMETER_COUNT];
    size_t count;
    armtol_link_jacobian(&link, &armtol_errata_none, g, &count);
    check_within(1e-12, 100 * cos(0.25), g[1][1], "corrected: a cos alpha");
    armtol_link_jacobian(&link, &armtol_errata_1987, g, &count);
    check_within(1e-7, 0.25 * cos(0.25), g[1][1], "kept: alpha cos alpha");
}

/* With beta = 0 it turns the sign of the beta columns and leaves everything else. */
static void test_beta_sign(void)
{
    double kept[6 * 32];
    analyse(INTELLA_1, &armtol_errata_1987);
    const armtol_bounds bounds = with.bounds;
    memcpy(kept, with.matrix, sizeof kept);
    analyse_corrected(INTELLA_1, "beta-sign");
    for (size_t k = 0; k < with.n_columns; k++) {
        const double sign = with.columns[k].parameter == ARMTOL_BETA ? -1 : 1;
        for (size_t i = 0; i < 6; i++) {
            check_same(sign * kept[i * with.n_columns + k], with.matrix[i * with.n_columns + k],
                       "row %zu, column %zu", i, k);
        }
    }
    check_same(bounds.angle, with.bounds.angle, "angle bound");
}

/* The tool that A is made of stands where the check says, or turned by half about the base's axis. */
static void test_half_turns(void)
{
    for (int i = ADPTA_1; i <= ADPTA_2; i++) {
        armtol_errata errata = armtol_errata_none;
        analyse(i, &errata);
        armtol_transform tool = armtol_chain_transform(with.links, 6, &errata);
        check_within(1e-9, cases[i].wish[0], tool.m[0][3], "corrected, x");
        check_within(1e-9, cases[i].wish[1], tool.m[1][3], "corrected, y");
        check_within(1e-9, cases[i].wish[2], tool.m[2][3], "corrected, z");
        errata.half_turns = true;
        analyse(i, &errata);
        tool = armtol_chain_transform(with.links, 6, &errata);
        check_within(1e-9, -cases[i].wish[0], tool.m[0][3], "kept, x");
        check_within(1e-9, -cases[i].wish[1], tool.m[1][3], "kept, y");
        check_within(1e-9, cases[i].wish[2], tool.m[2][3], "kept, z");
    }
}

static void test_half_turns_take_the_residue_with_them(void)
{
    analyse_corrected(ADPTA_1, "half-turns");
    const armtol_residue residue = armtol_skew_residue(with.links, 6, &with.errata);
    check_same(0, residue.diagonal[0], "high word of alpha = 0");
    check_same(0, residue.diagonal[1], "sin 0");
}

static bool all_floats(const double values[], size_t count)
{
    bool all = true;
    for (size_t i = 0; i < count; i++) {
        all = all && values[i] == (double)(float)values[i];
    }
    return all;
}

static void test_float(void)
{
    for (int i = 0; i < CASES; i++) {
        analyse(i, &armtol_errata_1987);
        TEST_ASSERT_TRUE(all_floats(with.q, with.robot->n_joints));
        TEST_ASSERT_TRUE(all_floats(with.check, with.robot->n_wish));
        TEST_ASSERT_TRUE(all_floats(with.matrix, 6 * with.n_columns));
        TEST_ASSERT_TRUE(all_floats(with.machining, with.robot->n_links));
        TEST_ASSERT_TRUE(all_floats(with.motor, with.robot->n_joints));
        TEST_ASSERT_TRUE(all_floats(&with.bounds.distance, 1) && all_floats(&with.bounds.angle, 1));
        analyse_corrected(i, "float");
        TEST_ASSERT_FALSE(all_floats(with.q, with.robot->n_joints));
        TEST_ASSERT_FALSE(all_floats(with.matrix, 6 * with.n_columns));
    }
    analyse(ADPTA_1, &armtol_errata_1987);
    check_printed("-203.199997", with.q[3], "kept, d[4] as published");
    analyse_corrected(ADPTA_1, "float");
    check_printed("-203.200000", with.q[3], "corrected, d[4]");
}

/* The label lines of the tolerance file, one after the other. */
static void check_labels(const char *expected)
{
    const report report = {&program_adpta, &with};
    char *text = NULL, seen[64] = "";
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    TEST_ASSERT_NOT_NULL(stream);
    report_tolerances(stream, &report);
    fclose(stream);
    for (const char *at = strstr(text, " dw"); at != NULL; at = strstr(at + 1, " dw")) {
        strncat(seen, at, 4);
    }
    free(text);
    TEST_ASSERT_EQUAL_STRING(expected, seen);
}

static void test_labels(void)
{
    analyse(ADPTA_1, &armtol_errata_1987);
    check_labels(" dwx dwx dwx");
    analyse_corrected(ADPTA_1, "labels");
    check_labels(" dwx dwy dwz");
}

/* Nothing published shows it: what gppp does not clear was 0. What was not is kept where gppp sets nothing. */
static void test_gppp_clearing(void)
{
    double kept[6 * 25];
    analyse(ADPTA_1, &armtol_errata_1987);
    memcpy(kept, with.matrix, sizeof kept);
    analyse_corrected(ADPTA_1, "gppp-clearing");
    TEST_ASSERT_EQUAL_MEMORY(kept, with.matrix, sizeof kept);

    static const char left_alone[6][ARMTOL_PARAMETER_COUNT + 1] = {"00011", "00011", "00011",
                                                                   "00001", "00010", "00001"};
    const armtol_link links[] = {{.kind = ARMTOL_PPP, .alpha = 0.25}, {.kind = ARMTOL_PPR, .alpha = 0.25}};
    for (size_t n = 0; n < 4; n++) {
        double g[6][ARMTOL_PARAMETER_COUNT];
        size_t count;
        for (size_t i = 0; i < 6; i++) {
            for (size_t k = 0; k < ARMTOL_PARAMETER_COUNT; k++) {
                g[i][k] = 42;
            }
        }
        armtol_link_jacobian(&links[n / 2], n % 2 == 0 ? &armtol_errata_1987 : &armtol_errata_none, g, &count);
        for (size_t i = 0; i < 6; i++) {
            for (size_t k = 0; k < count; k++) {
                const bool left = n == 0 && left_alone[i][k] == '1';
                TEST_ASSERT_EQUAL_INT_MESSAGE(left, g[i][k] > 41, n == 0 ? "kept" : "corrected, or no gppp");
            }
        }
    }
}

/* The norm of the length or angle columns of a row, by central differences of Eq. (4.1). */
static double reference_norm(size_t row, bool of_lengths)
{
    double sum = 0;
    for (size_t k = 0; k < with.n_columns; k++) {
        double twist[6];
        reference_column(with.links, with.robot->n_links, with.columns[k], true, twist);
        if (armtol_parameter_is_length(with.columns[k].parameter) == of_lengths) {
            sum += twist[row] * twist[row];
        }
    }
    return sqrt(sum);
}

/* Eq. (4.31) by central differences; and that the bound is never smaller than the programs' is. */
static void test_distance_share(void)
{
    static const char *const kept[CASES] = {"0.043073", "0.043722", "0.043655", "0.045870"};
    for (int i = 0; i < CASES; i++) {
        double angle = INFINITY, distance = INFINITY;
        analyse_alone(i, "distance-share");
        check_printed(kept[i], with.bounds.distance, "%s, kept", cases[i].name);
        const double of_1987 = with.bounds.distance;
        analyse(i, &armtol_errata_none);
        for (size_t row = 0; row < 6; row++) {
            angle = fmin(angle, (row < 3 ? 0.5 - 0.1 : 0.1) / reference_norm(row, false));
        }
        for (size_t row = 0; row < 3; row++) {
            distance = fmin(distance, (0.5 - reference_norm(row, false) * angle) / reference_norm(row, true));
        }
        check_within(1e-8, distance, with.bounds.distance, "%s, corrected", cases[i].name);
        TEST_ASSERT_TRUE(with.bounds.distance >= of_1987 * (1 - 1e-12));
    }
}

/* By the table of errata: what can change a program's results does so in one of its cases, and nothing else does. */
static void test_what_each_erratum_changes(void)
{
    static const char *const names[CASES] = {"intella", "intella", "adpta", "adpta"};
    for (size_t n = 0; n < armtol_errata_count(); n++) {
        const armtol_erratum_info *erratum = armtol_erratum(n);
        bool changed[CASES] = {false};
        for (int i = 0; i < CASES && strcmp(erratum->id, "labels") != 0; i++) {
            double matrix[6 * 32], machining[8];
            analyse(i, &armtol_errata_1987);
            const size_t matrix_size = 6 * with.n_columns * sizeof *matrix;
            const size_t machining_size = with.robot->n_links * sizeof *machining;
            const armtol_shares shares = with.shares;
            memcpy(matrix, with.matrix, matrix_size);
            memcpy(machining, with.machining, machining_size);
            analyse_corrected(i, erratum->id);
            changed[i] = memcmp(matrix, with.matrix, matrix_size) != 0 ||
                         memcmp(machining, with.machining, machining_size) != 0 ||
                         memcmp(&shares, &with.shares, sizeof shares) != 0;
        }
        for (int i = 0; i < CASES && strcmp(erratum->id, "labels") != 0; i += 2) {
            TEST_ASSERT_EQUAL_INT_MESSAGE(strstr(erratum->changes, names[i]) != NULL, changed[i] || changed[i + 1],
                                          erratum->id);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_1987_gives_the_paper_s_bounds);
    RUN_TEST(test_corrected_gives_the_bounds_for_the_tool_point);
    RUN_TEST(test_mtransf_typo);
    RUN_TEST(test_parallel_arm);
    RUN_TEST(test_adept_shift);
    RUN_TEST(test_skew_residue);
    RUN_TEST(test_skew_residue_of_the_intelledex_is_zero);
    RUN_TEST(test_root_of_ratio);
    RUN_TEST(test_copied_counts);
    RUN_TEST(test_signed_mach);
    RUN_TEST(test_short_pi);
    RUN_TEST(test_prismatic_alpha);
    RUN_TEST(test_beta_sign);
    RUN_TEST(test_half_turns);
    RUN_TEST(test_half_turns_take_the_residue_with_them);
    RUN_TEST(test_base_twist);
    RUN_TEST(test_float);
    RUN_TEST(test_labels);
    RUN_TEST(test_gppp_clearing);
    RUN_TEST(test_distance_share);
    RUN_TEST(test_what_each_erratum_changes);
    return UNITY_END();
}
