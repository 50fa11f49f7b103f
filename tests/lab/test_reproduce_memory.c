/* The whole of reproduce in this process, memory running out at every place where it can. Built with --wrap. */

#include "support/process.h"
#include "support/short_main.h"
#include "support/short_memory.h"

#include "unity.h"

#include <stddef.h>

int reproduce_main(int argc, char *argv[]);

void setUp(void)
{
}

void tearDown(void)
{
    memory_is_enough();
    process_clean_up();
}

static void test_every_table(void)
{
    check_short_main(reproduce_main, (const char *const[]){"reproduce", "--errata", TEST_ONE_CASE, NULL}, 20);
    check_short_main(reproduce_main, (const char *const[]){"reproduce", "--walk", TEST_ONE_CASE, NULL}, 20);
    check_short_main(reproduce_main, (const char *const[]){"reproduce", "--portability", TEST_ONE_CASE, NULL}, 20);
}

static void test_the_cases(void)
{
    const string out = folder_new();
    check_short_main(reproduce_main, (const char *const[]){"reproduce", TEST_PROGRAMS, TEST_ONE_CASE, out.text, NULL},
                     8);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_table);
    RUN_TEST(test_the_cases);
    return UNITY_END();
}
