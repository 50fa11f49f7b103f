/* The whole of yield in this process, memory running out at every place where it can. Built with --wrap. */

#include "support/short_main.h"
#include "support/short_memory.h"

#include "unity.h"

#include <stddef.h>

int yield_main(int argc, char *argv[]);

void setUp(void)
{
}

void tearDown(void)
{
    memory_is_enough();
}

static void test_a_run(void)
{
    check_short_main(yield_main, (const char *const[]){"yield", "-n", "1", TEST_ONE_CASE, NULL}, 18);
}

static void test_a_table_that_cannot_be_opened(void)
{
    check_main_without_descriptors(yield_main, (const char *const[]){"yield", TEST_ONE_CASE, NULL}, TEST_ONE_CASE);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_table_that_cannot_be_opened);
    RUN_TEST(test_a_run);
    return UNITY_END();
}
