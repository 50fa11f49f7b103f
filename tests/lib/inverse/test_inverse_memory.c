/* Memory that inverse kinematics cannot have. Built with the linker's --wrap. */

#include "armtol/inverse.h"
#include "support/short_memory.h"

#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
    memory_is_enough();
}

static void test_every_allocation(void)
{
    const armtol_inverse_setup setup = {.arm = armtol_arm_named("puma560")};
    for (memory_lack lack = LACK_FOR_GOOD; lack < LACKS; lack++) {
        armtol_status status = ARMTOL_NO_MEMORY;
        long had = 0;
        for (; status != ARMTOL_OK; had++) {
            armtol_inverse *inverse;
            memory_is_left(had, lack);
            status = armtol_inverse_create(&setup, &inverse);
            TEST_ASSERT_TRUE(memory_was_short() ? status == ARMTOL_NO_MEMORY : status == ARMTOL_OK);
            memory_is_enough();
            TEST_ASSERT_TRUE((inverse != NULL) == (status == ARMTOL_OK));
            armtol_inverse_destroy(inverse);
        }
        TEST_ASSERT_TRUE(had > 4);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_allocation);
    return UNITY_END();
}
