/* Messages of a caller that is no program. */

#include "console/message.h"

#include "support/said.h"
#include "unity.h"

#include <stdio.h>
#include <string.h>

static char taken[200];

void setUp(void)
{
    taken[0] = '\0';
}

void tearDown(void)
{
    message_hand_to(NULL);
}

static void take(const char *text)
{
    const size_t length = strlen(taken);
    snprintf(taken + length, sizeof taken - length, "<%s>", text);
}

static void test_messages_are_handed_over_without_the_name(void)
{
    message_start("name");
    message_hand_to(take);
    message("%d links", 7);
    message_note("two\nlines");
    message("a tab\there");
    TEST_ASSERT_EQUAL_STRING("<7 links><two\nlines><a tab?here>", taken);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_messages_are_handed_over_without_the_name);
    return UNITY_END();
}
