/* Memory and threads that cannot be had: a message, or fewer threads. Built with the linker's --wrap. */

#include "armtol/one_link.h"
#include "console/message.h"
#include "support/said.h"
#include "support/short_memory.h"

#include "unity.h"

#include <errno.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { MANY = 1000 };

/* The threads that are left until one is refused. */
static int threads_left = MANY;

typedef void *thread_body(void *context);
int __real_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, thread_body *body,
                          void *context);
int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, thread_body *body,
                          void *context);

int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, thread_body *body,
                          void *context)
{
    return threads_left-- > 0 ? __real_pthread_create(thread, attributes, body, context) : EAGAIN;
}

void setUp(void)
{
    memory_is_enough();
    threads_left = MANY;
    message_start("test");
}

void tearDown(void)
{
    memory_is_enough();
    threads_left = MANY;
}

static verification_task task_of(one_link *one)
{
    verification_task task = one_link_task(one, 30011);
    task.n_threads = 5;
    return task;
}

static verification without_refusals(void)
{
    one_link one;
    const verification_task task = task_of(&one);
    verification found;
    memset(&found, 0, sizeof found);
    TEST_ASSERT_TRUE(verification_run(&task, &found));
    return found;
}

static void test_threads_that_are_refused_are_done_without(void)
{
    const verification expected = without_refusals();
    for (int had = 0; had < 4; had++) {
        one_link one;
        const verification_task task = task_of(&one);
        verification found;
        memset(&found, 0, sizeof found);
        threads_left = had;
        TEST_ASSERT_TRUE(verification_run(&task, &found));
        TEST_ASSERT_EQUAL_INT(-1, threads_left); /* it asked for one more, and then no more */
        TEST_ASSERT_EQUAL_MEMORY(&expected, &found, sizeof found);
    }
}

/* Without memory for what all need there is a message; without that for another thread, no such thread. */
static void test_memory_that_is_refused(void)
{
    const verification expected = without_refusals();
    int failed = 0, done = 0;
    for (int had = 0; had < 12; had++) {
        one_link one;
        const verification_task task = task_of(&one);
        verification found;
        said said;
        memset(&found, 0, sizeof found);
        said_begin();
        memory_is_left(had, LACK_FOR_GOOD);
        const bool fine = verification_run(&task, &found);
        memory_is_enough();
        said_end(&said);
        TEST_ASSERT_EQUAL_STRING(fine ? "" : "test: out of memory\n", said.text);
        TEST_ASSERT_TRUE(fine || done == 0);
        if (fine) {
            TEST_ASSERT_EQUAL_MEMORY(&expected, &found, sizeof found);
        }
        done += fine;
        failed += !fine;
    }
    TEST_ASSERT_TRUE(failed >= 3 && done >= 3);
}

static void test_what_cannot_be_drawn_is_refused(void)
{
    one_link one;
    const verification_task task = task_of(&one);
    verification found;
    said said;
    one.tolerances[0] = -1;
    said_begin();
    const bool fine = verification_run(&task, &found);
    said_end(&said);
    TEST_ASSERT_FALSE(fine);
    TEST_ASSERT_EQUAL_STRING("test: cannot draw arms: a tolerance is not greater than zero\n", said.text);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_threads_that_are_refused_are_done_without);
    RUN_TEST(test_memory_that_is_refused);
    RUN_TEST(test_what_cannot_be_drawn_is_refused);
    return UNITY_END();
}
