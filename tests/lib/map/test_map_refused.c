/* Memory that a map cannot have, at every place where it asks for some. Built with the linker's --wrap. */

#include "armtol/map.h"
#include "support/short_memory.h"

#include "unity.h"

#include <string.h>

enum { WIDE = 4, HIGH = 3, POINTS = WIDE * HIGH, MOST_COLUMNS = 64 };

static const armtol_link flat[2] = {{ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 300}, {ARMTOL_PPR, ARMTOL_REVOLUTE, .a = 200}};
static const double near[2] = {0.3, 1.2}, accuracy[6] = {1, 1, 1, 1, 1, 1};
static const bool all[MOST_COLUMNS] = {true, true, true, true, true, true, true, true};
static double q[POINTS * 2], tolerances[MOST_COLUMNS], values[POINTS];
static unsigned char marks[POINTS];
static armtol_drive drives[2];
static armtol_arm arm;

void setUp(void)
{
    memory_is_enough();
    drives[0] = drives[1] = armtol_drive_unknown;
    arm = (armtol_arm){.name = "flat", .title = "two links", .source = "the test", .n_links = 2, .links = flat,
                       .drives = drives};
}

void tearDown(void)
{
    memory_is_enough();
}

/* One after the other fails, until none does; valgrind looks whether what was had before is given back. */
static void check_values(const armtol_question *question, const armtol_map *map)
{
    for (memory_lack lack = 0; lack < LACKS; lack++) {
        bool was_short = true;
        int had = 0;
        for (; was_short; had++) {
            armtol_fault fault;
            memory_is_left(had, lack);
            const armtol_status status = armtol_map_values(question, map, values, &fault);
            was_short = memory_was_short();
            memory_is_enough();
            TEST_ASSERT_EQUAL_INT(was_short ? ARMTOL_NO_MEMORY : ARMTOL_OK, status);
            TEST_ASSERT_TRUE(fault.status == status && fault.about == ARMTOL_ABOUT_NOTHING);
        }
        TEST_ASSERT_TRUE(had > 3);
    }
}

static void test_memory_that_values_are_refused(void)
{
    armtol_question question = {.arm = &arm, .q = q, .n_poses = POINTS, .tolerances = tolerances};
    check_values(&question, &(armtol_map){.value = ARMTOL_MAP_WORST});
    check_values(&question, &(armtol_map){.value = ARMTOL_MAP_DROOP});
    check_values(&question, &(armtol_map){.value = ARMTOL_MAP_REPEATABILITY});
    question.tolerances = NULL;
    question.accuracy = accuracy;
    check_values(&question, &(armtol_map){.value = ARMTOL_MAP_TOLERANCE, .columns = all});
}

static void test_memory_that_joint_values_are_refused(void)
{
    const armtol_inverse_setup setup = {.arm = &arm, .near = near};
    const armtol_map_plane plane = {.first = {200, 100, 0}, .across = {50, 0, 0}, .up = {0, 50, 0}, .n_across = WIDE,
                                    .n_up = HIGH, .point_only = true};
    for (memory_lack lack = 0; lack < LACKS; lack++) {
        bool was_short = true;
        int had = 0;
        for (; was_short; had++) {
            memory_is_left(had, lack);
            const armtol_status status = armtol_map_poses(&setup, &plane, NULL, NULL, q, marks);
            was_short = memory_was_short();
            memory_is_enough();
            TEST_ASSERT_EQUAL_INT(was_short ? ARMTOL_NO_MEMORY : ARMTOL_OK, status);
        }
        TEST_ASSERT_TRUE(had > 6);
        TEST_ASSERT_TRUE((marks[0] & ARMTOL_MAP_REACHED) != 0);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_memory_that_values_are_refused);
    RUN_TEST(test_memory_that_joint_values_are_refused);
    return UNITY_END();
}
