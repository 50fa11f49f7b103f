#include "armtol/errata.h"

#include "unity.h"

#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* The names that people type after --fix; they may grow in number but never change. */
static const char *const ids[] = {
    "mtransf-typo", "parallel-arm", "adept-shift", "skew-residue",    "root-of-ratio", "copied-counts", "signed-mach",
    "short-pi",     "beta-sign",    "half-turns",  "prismatic-alpha", "base-twist",    "float",         "labels",
    "gppp-clearing", "distance-share",
};
enum { IDS = sizeof ids / sizeof ids[0] };

static size_t index_of(const char *id)
{
    size_t i = 0;
    while (i < armtol_errata_count() && strcmp(armtol_erratum(i)->id, id) != 0) {
        i++;
    }
    return i;
}

static size_t kept_count(const armtol_errata *errata)
{
    size_t kept = 0;
    for (size_t i = 0; i < armtol_errata_count(); i++) {
        kept += armtol_erratum_is_kept(errata, i);
    }
    return kept;
}

static void test_the_table_has_every_erratum_with_its_texts(void)
{
    TEST_ASSERT_EQUAL_INT(IDS, armtol_errata_count());
    for (int i = 0; i < IDS; i++) {
        const armtol_erratum_info *erratum = armtol_erratum(index_of(ids[i]));
        TEST_ASSERT_NOT_NULL_MESSAGE(erratum, ids[i]);
        TEST_ASSERT_TRUE_MESSAGE(strlen(erratum->slip) > 5 && strlen(erratum->touches) > 5, ids[i]);
        TEST_ASSERT_NULL_MESSAGE(strchr(erratum->slip, '\n'), ids[i]);
        TEST_ASSERT_NULL_MESSAGE(strchr(erratum->touches, '\n'), ids[i]);
    }
    TEST_ASSERT_NULL(armtol_erratum(armtol_errata_count()));
}

static void test_1987_keeps_all_and_none_keeps_none(void)
{
    TEST_ASSERT_EQUAL_INT(IDS, kept_count(&armtol_errata_1987));
    TEST_ASSERT_EQUAL_INT(0, kept_count(&armtol_errata_none));
    TEST_ASSERT_FALSE(armtol_erratum_is_kept(&armtol_errata_1987, armtol_errata_count()));
}

static void test_each_name_switches_itself_alone(void)
{
    for (int i = 0; i < IDS; i++) {
        armtol_errata errata = armtol_errata_1987;
        TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_OK, armtol_erratum_keep(&errata, ids[i], false), ids[i]);
        TEST_ASSERT_EQUAL_INT_MESSAGE(IDS - 1, kept_count(&errata), ids[i]);
        TEST_ASSERT_FALSE_MESSAGE(armtol_erratum_is_kept(&errata, index_of(ids[i])), ids[i]);
        TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_OK, armtol_erratum_keep(&errata, ids[i], true), ids[i]);
        TEST_ASSERT_EQUAL_INT_MESSAGE(IDS, kept_count(&errata), ids[i]);
    }
}

static void test_each_name_switches_the_field_that_it_means(void)
{
    armtol_errata errata = armtol_errata_none;
    const struct {
        const char *id;
        const bool *field;
    } pairs[] = {
        {"mtransf-typo", &errata.mtransf_typo},       {"parallel-arm", &errata.parallel_arm},
        {"adept-shift", &errata.adept_shift},         {"skew-residue", &errata.skew_residue},
        {"root-of-ratio", &errata.root_of_ratio},     {"copied-counts", &errata.copied_counts},
        {"signed-mach", &errata.signed_mach},         {"short-pi", &errata.short_pi},
        {"prismatic-alpha", &errata.prismatic_alpha}, {"beta-sign", &errata.beta_sign},
        {"half-turns", &errata.half_turns},           {"base-twist", &errata.base_twist},
        {"float", &errata.float_storage},             {"labels", &errata.labels},
        {"gppp-clearing", &errata.gppp_clearing},     {"distance-share", &errata.distance_share},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        errata = armtol_errata_none;
        armtol_erratum_keep(&errata, pairs[i].id, true);
        TEST_ASSERT_TRUE_MESSAGE(*pairs[i].field, pairs[i].id);
    }
}

static void test_all_switches_every_one(void)
{
    armtol_errata errata = armtol_errata_1987;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_erratum_keep(&errata, "all", false));
    TEST_ASSERT_EQUAL_INT(0, kept_count(&errata));
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_erratum_keep(&errata, "all", true));
    TEST_ASSERT_EQUAL_INT(IDS, kept_count(&errata));
}

static void test_an_unknown_name_changes_nothing(void)
{
    static const char *const wrong[] = {"", "mtransf", "Float", "all ", "mtransf-typo,float"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        armtol_errata errata = armtol_errata_1987;
        TEST_ASSERT_EQUAL_INT_MESSAGE(ARMTOL_UNKNOWN_ERRATUM, armtol_erratum_keep(&errata, wrong[i], false),
                                      wrong[i]);
        TEST_ASSERT_EQUAL_INT_MESSAGE(IDS, kept_count(&errata), wrong[i]);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_table_has_every_erratum_with_its_texts);
    RUN_TEST(test_1987_keeps_all_and_none_keeps_none);
    RUN_TEST(test_each_name_switches_itself_alone);
    RUN_TEST(test_each_name_switches_the_field_that_it_means);
    RUN_TEST(test_all_switches_every_one);
    RUN_TEST(test_an_unknown_name_changes_nothing);
    return UNITY_END();
}
