/* Memory that runs out while a URDF is read: a message, and nothing is kept. Linked with --wrap. */

#include "urdf.h"

#include "message.h"

#include "said.h"
#include "unity.h"

#include <stdbool.h>
#include <limits.h>
#include <stdlib.h>

/* The allocations that are left until one fails; expat's own are not among them. */
static long left;

static bool fails(void)
{
    return left-- <= 0;
}

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
char *__real_strdup(const char *text);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *old, size_t size);
char *__wrap_strdup(const char *text);

void *__wrap_malloc(size_t size)
{
    return fails() ? NULL : __real_malloc(size);
}

void *__wrap_calloc(size_t count, size_t size)
{
    return fails() ? NULL : __real_calloc(count, size);
}

void *__wrap_realloc(void *old, size_t size)
{
    return fails() ? NULL : __real_realloc(old, size);
}

char *__wrap_strdup(const char *text)
{
    return fails() ? NULL : __real_strdup(text);
}

void setUp(void)
{
}

void tearDown(void)
{
}

/* With no allocation that succeeds, with one, with two ... until there are enough. */
static void test_the_ur5e(void)
{
    bool fine = false;
    long n = 0;
    for (; !fine; n++) {
        arm_model model;
        said said;
        FILE *const stream = fopen(TEST_UR5E, "r");
        TEST_ASSERT_NOT_NULL(stream);
        said_begin();
        left = n;
        fine = urdf_read(stream, "ur5e.urdf", "base_link", "tool0", &model);
        said_end(&said);
        fclose(stream);
        TEST_ASSERT_EQUAL_STRING(fine ? "" : "armtol: out of memory\n", said.text);
        arm_model_free(&model);
    }
    left = LONG_MAX; /* for what runs when the test has ended */
    /* A name for each of 11 links, three for each of 10 joints, four tables of an arm, five parts of it. */
    TEST_ASSERT_TRUE(n > 11 + 3 * 10 + 4 + 5);
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_the_ur5e);
    return UNITY_END();
}
