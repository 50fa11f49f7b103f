#include "armtol/armtol.h"

#include "unity.h"

#include <stdio.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_every_status_has_a_text_of_its_own(void)
{
    for (int i = 0; i < ARMTOL_STATUS_COUNT; i++) {
        const char *text = armtol_status_text((armtol_status)i);
        TEST_ASSERT_NOT_NULL(text);
        TEST_ASSERT_TRUE(strlen(text) > 5);
        for (int j = 0; j < i; j++) {
            TEST_ASSERT_TRUE_MESSAGE(strcmp(text, armtol_status_text((armtol_status)j)) != 0, text);
        }
    }
}

static void test_a_value_that_is_no_status_has_a_text_too(void)
{
    TEST_ASSERT_EQUAL_STRING("unknown status", armtol_status_text(ARMTOL_STATUS_COUNT));
    TEST_ASSERT_EQUAL_STRING("unknown status", armtol_status_text((armtol_status)-1));
}

static void test_the_version_has_three_parts(void)
{
    int part[3], end = 0;
    TEST_ASSERT_EQUAL_INT(3, sscanf(armtol_version(), "%d.%d.%d%n", &part[0], &part[1], &part[2], &end));
    TEST_ASSERT_EQUAL_INT((int)strlen(armtol_version()), end);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_status_has_a_text_of_its_own);
    RUN_TEST(test_a_value_that_is_no_status_has_a_text_too);
    RUN_TEST(test_the_version_has_three_parts);
    return UNITY_END();
}
