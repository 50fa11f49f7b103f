/* Memory that arrivals cannot have, at every place where they ask for some. Built with the linker's --wrap. */

#include "armtol/arrivals.h"
#include "support/short_memory.h"

#include "unity.h"

static const armtol_link links[1] = {{ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 400}};
static const double q[2] = {0, 1}, tolerances[4] = {0.001};
static armtol_drive drives[1];
static armtol_answer *answer;

void setUp(void)
{
    drives[0] = armtol_drive_unknown;
    drives[0].noise = 1e-4;
    const armtol_arm arm = {.name = "boom", .title = "a boom", .source = "the test", .n_links = 1, .links = links,
                            .drives = drives};
    const armtol_question question = {.arm = &arm, .q = q, .n_poses = 2, .tolerances = tolerances};
    memory_is_enough();
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&question, &answer, NULL));
}

void tearDown(void)
{
    memory_is_enough();
    armtol_answer_destroy(answer);
}

/* One after the other fails, until none does; valgrind looks whether what was had before is given back. */
static void test_memory_that_is_refused(void)
{
    const armtol_draw draw = {.samples = 100, .seed = 1};
    for (memory_lack lack = 0; lack < LACKS; lack++) {
        bool was_short = true;
        int had = 0;
        for (; was_short; had++) {
            armtol_arrivals *arrivals;
            armtol_fault fault;
            memory_is_left(had, lack);
            const armtol_status status = armtol_arrivals_create(answer, &draw, 5, &arrivals, &fault);
            was_short = memory_was_short();
            memory_is_enough();
            TEST_ASSERT_EQUAL_INT(was_short ? ARMTOL_NO_MEMORY : ARMTOL_OK, status);
            TEST_ASSERT_TRUE(fault.status == status && fault.about == ARMTOL_ABOUT_NOTHING);
            TEST_ASSERT_TRUE((arrivals == NULL) == was_short);
            armtol_arrivals_destroy(arrivals);
        }
        TEST_ASSERT_TRUE(had > 8);
    }
}

static void test_memory_for_noise_that_is_refused(void)
{
    for (memory_lack lack = 0; lack < LACKS; lack++) {
        bool was_short = true;
        int had = 0;
        for (; was_short; had++) {
            double noise[1];
            armtol_fault fault;
            memory_is_left(had, lack);
            const armtol_status status = armtol_arrivals_noise(answer, 1, noise, &fault);
            was_short = memory_was_short();
            memory_is_enough();
            TEST_ASSERT_EQUAL_INT(was_short ? ARMTOL_NO_MEMORY : ARMTOL_OK, status);
            TEST_ASSERT_TRUE(fault.status == status && fault.about == ARMTOL_ABOUT_NOTHING);
            TEST_ASSERT_TRUE((noise[0] > 0) != was_short);
        }
        TEST_ASSERT_TRUE(had > 8);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_memory_that_is_refused);
    RUN_TEST(test_memory_for_noise_that_is_refused);
    return UNITY_END();
}
