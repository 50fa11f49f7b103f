/* Memory that a region cannot have: a status, and nothing is lost. Built with the linker's --wrap. */

#include "armtol/region.h"
#include "support/short_memory.h"

#include "unity.h"

#include <math.h>

void setUp(void)
{
    memory_is_enough();
}

void tearDown(void)
{
    memory_is_enough();
}

/* Every allocation of it fails once. */
static void test_every_allocation_may_fail(void)
{
    const double low[4] = {0, 0.2, 100, 0}, high[4] = {0.2, 0.4, 110, 0}, free_one = (double)INFINITY;
    const double accuracy[6] = {0.02, free_one, free_one, free_one, free_one, free_one};
    const armtol_ring ring = {.axis = {0, 0, 1}, .inner = 100, .outer = 590, .bottom = 0, .top = 400};
    const armtol_region region = {.low = low, .high = high, .ring = &ring};
    const armtol_question question = {.arm = armtol_arm_named("scara"), .accuracy = accuracy};
    armtol_status status = ARMTOL_NO_MEMORY;
    int allowed = 0;
    for (; status == ARMTOL_NO_MEMORY && allowed < 5000; allowed++) {
        armtol_region_answer *answer;
        armtol_fault fault;
        memory_is_left(allowed, LACK_ONCE);
        status = armtol_region_answer_create(&question, &region, NULL, &answer, &fault, NULL);
        memory_is_enough();
        TEST_ASSERT_TRUE((status == ARMTOL_OK) == (answer != NULL) && fault.status == status);
        armtol_region_answer_destroy(answer);
    }
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, status);
    TEST_ASSERT_GREATER_THAN_INT(30, allowed);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_allocation_may_fail);
    return UNITY_END();
}
