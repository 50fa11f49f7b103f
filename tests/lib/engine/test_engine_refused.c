/* Memory and threads that the engine cannot have: a status, or fewer threads. Built with the linker's --wrap. */

#include "armtol/budget.h"
#include "armtol/tally.h"
#include "lib/engine/one_link.h"
#include "support/short_memory.h"

#include "unity.h"

#include <errno.h>
#include <pthread.h>
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

static one_link one;
static armtol_answer *answer;

void setUp(void)
{
    memory_is_enough();
    threads_left = MANY;
    one_link_make(&one, 30011);
    one.draw.n_threads = 5;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_answer_create(&one.question, &answer, NULL));
}

void tearDown(void)
{
    memory_is_enough();
    threads_left = MANY;
    armtol_answer_destroy(answer);
}

static armtol_verification without_refusals(void)
{
    armtol_verification found;
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_verify(answer, &one.draw, &found, NULL));
    return found;
}

static void test_threads_that_are_refused_are_done_without(void)
{
    const armtol_verification expected = without_refusals();
    for (int had = 0; had < 4; had++) {
        armtol_verification found;
        threads_left = had;
        TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_verify(answer, &one.draw, &found, NULL));
        TEST_ASSERT_EQUAL_INT(-1, threads_left); /* it asked for one more, and then no more */
        TEST_ASSERT_EQUAL_MEMORY(&expected, &found, sizeof found);
    }
}

/* Without memory for what all need there is none; without that for another thread, no such thread. */
static void test_memory_that_a_verification_is_refused(void)
{
    const armtol_verification expected = without_refusals();
    int failed = 0, done = 0;
    for (int had = 0; had < 12; had++) {
        armtol_verification found;
        armtol_fault fault;
        memory_is_left(had, LACK_FOR_GOOD);
        const armtol_status status = armtol_verify(answer, &one.draw, &found, &fault);
        memory_is_enough();
        TEST_ASSERT_TRUE(status == ARMTOL_OK || (status == ARMTOL_NO_MEMORY && done == 0));
        TEST_ASSERT_TRUE(fault.status == status && fault.about == ARMTOL_ABOUT_NOTHING);
        if (status == ARMTOL_OK) {
            TEST_ASSERT_EQUAL_MEMORY(&expected, &found, sizeof found);
        }
        done += status == ARMTOL_OK;
        failed += status != ARMTOL_OK;
    }
    TEST_ASSERT_TRUE(failed >= 3 && done >= 3);
}

static void test_memory_that_a_tally_is_refused(void)
{
    const armtol_verification expected = without_refusals();
    armtol_tally *tally;
    armtol_verification found;
    armtol_fault fault;
    memory_is_left(0, LACK_FOR_GOOD);
    TEST_ASSERT_EQUAL_INT(ARMTOL_NO_MEMORY, armtol_tally_create(&tally));
    memory_is_enough();
    TEST_ASSERT_NULL(tally);
    armtol_tally_destroy(tally);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tally_create(&tally));
    memory_is_left(0, LACK_FOR_GOOD);
    TEST_ASSERT_EQUAL_INT(ARMTOL_NO_MEMORY, armtol_tally_draw(answer, &one.draw, 0, tally, &fault));
    TEST_ASSERT_TRUE(fault.status == ARMTOL_NO_MEMORY && fault.about == ARMTOL_ABOUT_NOTHING);
    memory_is_enough();
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tally_draw(answer, &one.draw, 0, tally, NULL));
    memory_is_left(0, LACK_FOR_GOOD);
    TEST_ASSERT_EQUAL_INT(ARMTOL_NO_MEMORY, armtol_tally_verify(answer, &one.draw, tally, &found, &fault));
    memory_is_enough();
    TEST_ASSERT_TRUE(fault.status == ARMTOL_NO_MEMORY && fault.about == ARMTOL_ABOUT_NOTHING);
    TEST_ASSERT_EQUAL_INT(ARMTOL_OK, armtol_tally_verify(answer, &one.draw, tally, &found, NULL));
    TEST_ASSERT_EQUAL_MEMORY(&expected, &found, sizeof found);
    armtol_tally_destroy(tally);
}

/* One after the other fails, until none does; valgrind looks whether what was had before is given back. */
static int count_failures_of_answers(const armtol_question *question, memory_lack lack)
{
    for (int had = 0;; had++) {
        armtol_answer *short_of_it;
        armtol_fault fault;
        memory_is_left(had, lack);
        const armtol_status status = armtol_answer_create(question, &short_of_it, &fault);
        const bool was_short = memory_was_short();
        memory_is_enough();
        TEST_ASSERT_EQUAL_INT(was_short ? ARMTOL_NO_MEMORY : ARMTOL_OK, status);
        TEST_ASSERT_TRUE(fault.status == status && fault.about == ARMTOL_ABOUT_NOTHING && fault.number == 0);
        TEST_ASSERT_TRUE((short_of_it == NULL) == was_short);
        armtol_answer_destroy(short_of_it);
        if (!was_short) {
            return had;
        }
    }
}

static void test_memory_that_an_answer_is_refused(void)
{
    static const double accuracy[6] = {1, 1, 1, 1, 1, 1};
    armtol_question wish = one.question;
    wish.accuracy = accuracy;
    wish.tolerances = NULL;
    armtol_question round = wish;
    round.norms = (const armtol_norm[]){{003, 0.9}, {070, 1}};
    round.n_norms = 2;
    for (memory_lack lack = 0; lack < LACKS; lack++) {
        TEST_ASSERT_EQUAL_INT(20, count_failures_of_answers(&one.question, lack));
        TEST_ASSERT_EQUAL_INT(35, count_failures_of_answers(&wish, lack));
        TEST_ASSERT_TRUE(count_failures_of_answers(&round, lack) > 36); /* cuts, and what they hold */
    }
}

static void test_memory_that_a_budget_is_refused(void)
{
    for (int had = 0; had < 3; had++) {
        armtol_budget *budget;
        memory_is_left(had, LACK_FOR_GOOD);
        const armtol_status status = armtol_budget_create(answer, &budget);
        memory_is_enough();
        TEST_ASSERT_EQUAL_INT(ARMTOL_NO_MEMORY, status);
        TEST_ASSERT_NULL(budget);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_threads_that_are_refused_are_done_without);
    RUN_TEST(test_memory_that_a_verification_is_refused);
    RUN_TEST(test_memory_that_a_tally_is_refused);
    RUN_TEST(test_memory_that_an_answer_is_refused);
    RUN_TEST(test_memory_that_a_budget_is_refused);
    return UNITY_END();
}
