/* The whole of joint-orders in this process, memory running out at every place where it can. Built with --wrap. */

#include "support/short_main.h"
#include "support/short_memory.h"

#include "unity.h"

#include <stddef.h>

int joint_orders_main(int argc, char *argv[]);

void setUp(void)
{
}

void tearDown(void)
{
    memory_is_enough();
}

/* So much is given that the survey is done in no time. */
#define GIVEN \
    "--given=sines=double,base=inverse,constants=double,order=q6,last-link=matrix,right-angle=float,plane=written," \
    "q345=x5,wrist=t06"

static void test_a_survey(void)
{
    check_short_main(joint_orders_main, (const char *const[]){"joint-orders", GIVEN, TEST_PUBLISHED, NULL}, 25);
}

static void test_a_table_that_cannot_be_opened(void)
{
    check_main_without_descriptors(joint_orders_main, (const char *const[]){"joint-orders", TEST_ONE_CASE, NULL},
                                   TEST_ONE_CASE);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_table_that_cannot_be_opened);
    RUN_TEST(test_a_survey);
    return UNITY_END();
}
