/* Memory that runs out while a URDF is read: a message, and nothing is kept. Linked with --wrap. */

#include "armtol/urdf/urdf.h"

#include "console/message.h"

#include "support/said.h"
#include "support/short_memory.h"

#include "unity.h"

#include <expat.h>
#include <stdbool.h>
#include <stdlib.h>

/* expat's own allocations are counted with the others. */
XML_Parser __wrap_XML_ParserCreate(const XML_Char *encoding);

static void *get(size_t size)
{
    return malloc(size);
}

static void *get_again(void *old, size_t size)
{
    return realloc(old, size);
}

static void give_back(void *block)
{
    free(block);
}

XML_Parser __wrap_XML_ParserCreate(const XML_Char *encoding)
{
    static const XML_Memory_Handling_Suite counted = {get, get_again, give_back};
    return XML_ParserCreate_MM(encoding, &counted, NULL);
}

void setUp(void)
{
}

void tearDown(void)
{
}

/* With no allocation that succeeds, with one, with two ... until there are enough. */
static void check_lack(memory_lack lack)
{
    bool fine = false;
    long n = 0;
    for (; !fine; n++) {
        arm_model model;
        said said;
        FILE *const stream = fopen(TEST_UR5E, "r");
        TEST_ASSERT_NOT_NULL(stream);
        said_begin();
        memory_is_left(n, lack);
        fine = urdf_read(stream, "ur5e.urdf", "base_link", "tool0", &model);
        TEST_ASSERT_TRUE(fine != memory_was_short());
        memory_is_enough();
        said_end(&said);
        fclose(stream);
        TEST_ASSERT_EQUAL_STRING(fine ? "" : "armtol: out of memory\n", said.text);
        arm_model_free(&model);
    }
    /* A name for each of 11 links, three for each of 10 joints, four tables of an arm, five parts of it. */
    TEST_ASSERT_TRUE(n > 11 + 3 * 10 + 4 + 5);
}

static void test_the_ur5e(void)
{
    check_lack(LACK_FOR_GOOD);
    check_lack(LACK_ONCE);
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_the_ur5e);
    return UNITY_END();
}
