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

/* Every allocation fails once: it may then do without, as where what is not seen needs no bound. */
static void check_every_allocation(const armtol_question *question, const armtol_region *region,
                                   const armtol_enclosing *how)
{
    bool enough = false;
    int allowed = 0;
    for (; !enough && allowed < 5000; allowed++) {
        armtol_region_answer *answer;
        armtol_fault fault;
        memory_is_left(allowed, LACK_ONCE);
        const armtol_status status = armtol_region_answer_create(question, region, how, &answer, &fault, NULL);
        enough = !memory_was_short();
        memory_is_enough();
        TEST_ASSERT_TRUE((status == ARMTOL_OK) == (answer != NULL) && fault.status == status);
        TEST_ASSERT_TRUE(status == ARMTOL_OK || (status == ARMTOL_NO_MEMORY && !enough));
        armtol_region_answer_destroy(answer);
    }
    TEST_ASSERT_TRUE(enough);
    TEST_ASSERT_GREATER_THAN_INT(30, allowed);
}

static void test_memory_for_a_component(void)
{
    const double low[4] = {0, 0.2, 100, 0}, high[4] = {0.2, 0.4, 110, 0}, free_one = (double)INFINITY;
    const double accuracy[6] = {0.02, free_one, free_one, free_one, free_one, free_one};
    const armtol_ring ring = {.axis = {0, 0, 1}, .inner = 100, .outer = 590, .bottom = 0, .top = 400};
    const armtol_region region = {.low = low, .high = high, .ring = &ring};
    const armtol_question question = {.arm = armtol_arm_named("scara"), .accuracy = accuracy};
    check_every_allocation(&question, &region, NULL);
}

/* The first axes of 8 poses fill the first cuts of a norm: another one needs memory of its own. So do boxes. */
static void test_memory_for_a_norm(void)
{
    const double low[4] = {0, 0.2, 100, 0}, high[4] = {0, 1.4, 100, 0};
    const armtol_norm disc = {3, 0.02};
    const armtol_enclosing fine = {.gap = 1e-3};
    const armtol_region region = {.low = low, .high = high};
    const armtol_question question = {.arm = armtol_arm_named("scara"), .norms = &disc, .n_norms = 1};
    check_every_allocation(&question, &region, &fine);
}

/* Drives under a load have corners of their own. */
static void test_memory_for_loads(void)
{
    const double low[4] = {0, 0.2, 100, 0}, high[4] = {0.05, 0.25, 105, 0};
    const double free_one = (double)INFINITY, accuracy[6] = {2, free_one, free_one, free_one, free_one, free_one};
    const armtol_enclosing coarse = {.gap = 0.1};
    const armtol_mass payload = {.mass = 2};
    const armtol_region region = {.low = low, .high = high};
    armtol_arm arm = *armtol_arm_named("scara");
    armtol_drive drives[4];
    armtol_loading loading = armtol_loading_standard;
    for (int i = 0; i < 4; i++) {
        drives[i] = arm.drives[i];
        drives[i].compliance = 1e-5;
    }
    arm.drives = drives;
    loading.gravity[0] = 3;
    loading.payloads = &payload;
    loading.n_payloads = 1;
    const armtol_question question = {.arm = &arm, .accuracy = accuracy, .loading = &loading};
    check_every_allocation(&question, &region, &coarse);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_memory_for_a_component);
    RUN_TEST(test_memory_for_a_norm);
    RUN_TEST(test_memory_for_loads);
    return UNITY_END();
}
