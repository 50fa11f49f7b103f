/* What an armtol says that was built without expat: urdf/without.c stands in for the reader here. */

#include "armtol/urdf/urdf.h"

#include "console/message.h"

#include "support/said.h"
#include "unity.h"

#include <stdio.h>

void setUp(void)
{
}

void tearDown(void)
{
}

#define REFUSED                                                                                                        \
    "armtol: arm.urdf is a URDF, and this armtol was built without expat, which reads them; install expat with "       \
    "its headers (package libexpat1-dev, expat-devel or expat) and build armtol again\n"

static void test_it_says_what_to_install(void)
{
    arm_model model;
    said said;
    said_begin();
    const bool fine = urdf_read(stdin, "arm.urdf", NULL, NULL, &model);
    said_end(&said);
    TEST_ASSERT_FALSE(fine);
    TEST_ASSERT_EQUAL_STRING(REFUSED, said.text);
}

static void test_it_draws_nothing(void)
{
    said said;
    said_begin();
    const bool fine = urdf_draw(stdin, "arm.urdf", NULL, stdout);
    said_end(&said);
    TEST_ASSERT_FALSE(fine);
    TEST_ASSERT_EQUAL_STRING(REFUSED, said.text);
}

static void test_it_can_be_asked(void)
{
    TEST_ASSERT_FALSE(urdf_is_built_in());
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_it_says_what_to_install);
    RUN_TEST(test_it_draws_nothing);
    RUN_TEST(test_it_can_be_asked);
    return UNITY_END();
}
