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

/* Reads, and frees what it has read. */
typedef bool reader(FILE *stream);

/* With no allocation that succeeds, with one, with two ... until there are enough. */
static void check_lack(reader *read, FILE *stream, memory_lack lack, long least)
{
    bool fine = false;
    long n = 0;
    TEST_ASSERT_NOT_NULL(stream);
    for (; !fine; n++) {
        said said;
        rewind(stream);
        said_begin();
        memory_is_left(n, lack);
        fine = read(stream);
        TEST_ASSERT_TRUE(fine != memory_was_short());
        memory_is_enough();
        said_end(&said);
        TEST_ASSERT_EQUAL_STRING(fine ? "" : "armtol: out of memory\n", said.text);
    }
    fclose(stream);
    TEST_ASSERT_TRUE(n > least);
}

static bool read_ur5e(FILE *stream)
{
    arm_model model;
    const bool fine = urdf_read(stream, "ur5e.urdf", "base_link", "tool0", &model);
    arm_model_free(&model);
    return fine;
}

static void test_the_ur5e(void)
{
    /* A name for each of 11 links, three for each of 10 joints, seven tables of an arm, five parts of it. */
    check_lack(read_ur5e, fopen(TEST_UR5E, "r"), LACK_FOR_GOOD, 11 + 3 * 10 + 7 + 5);
    check_lack(read_ur5e, fopen(TEST_UR5E, "r"), LACK_ONCE, 11 + 3 * 10 + 7 + 5);
}

/* One that follows, one with a fault that does not matter, and leaves of which one is to be found. */
static const char coupled[] =
    "<robot name='r'><link name='a'/><link name='b'/><link name='c'/><link name='d'/>"
    "<joint name='j' type='revolute'><parent link='a'/><child link='b'/></joint>"
    "<joint name='k' type='revolute'><parent link='b'/><child link='c'/><mimic joint='j'/></joint>"
    "<joint name='l' type='ball'><parent link='a'/><child link='d'/></joint></robot>";

static bool read_coupled(FILE *stream)
{
    arm_model model;
    const bool fine = urdf_read(stream, "arm.urdf", NULL, NULL, &model);
    arm_model_free(&model);
    return fine;
}

static bool draw_coupled(FILE *stream)
{
    static const urdf_units units = {1, 1, "m", "rad"};
    FILE *const drawn = fopen("/dev/null", "w");
    const bool fine = drawn != NULL && urdf_draw(stream, "arm.urdf", &units, drawn);
    if (drawn != NULL) {
        fclose(drawn);
    }
    return fine;
}

static void test_a_robot_with_a_follower(void)
{
    for (memory_lack lack = LACK_FOR_GOOD; lack < LACKS; lack++) {
        check_lack(read_coupled, stream_of(coupled, sizeof coupled - 1), lack, 4 + 3 * 3 + 2 + 7 + 6);
        check_lack(draw_coupled, stream_of(coupled, sizeof coupled - 1), lack, 4 + 3 * 3 + 2 + 2);
    }
}

int main(void)
{
    message_start("armtol");
    UNITY_BEGIN();
    RUN_TEST(test_the_ur5e);
    RUN_TEST(test_a_robot_with_a_follower);
    return UNITY_END();
}
