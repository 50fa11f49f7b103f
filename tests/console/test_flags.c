/* Options and the one argument behind them, as the programs that have one read them. */

#include "console/flags.h"
#include "console/message.h"

#include "support/said.h"
#include "unity.h"

#include <string.h>

enum { MOST = 6 };

static const struct option names[] = {{"count", required_argument, NULL, 'c'}, {"quiet", no_argument, NULL, 'q'}, {0}};

void setUp(void)
{
}

void tearDown(void)
{
}

/* What was taken, letter by letter, with the arguments. */
typedef struct taken {
    char text[64];
} taken;

static bool take(int option, const char *argument, void *context)
{
    taken *taken = context;
    const size_t length = strlen(taken->text);
    snprintf(taken->text + length, sizeof taken->text - length, "%c%s ", option, argument != NULL ? argument : "");
    return argument == NULL || strcmp(argument, "wrong") != 0;
}

/* Reads these words, up to a NULL; what is said is in *said, and what was taken is returned. */
static taken read_words(const char *const words[], bool *fine, const char **argument, said *said)
{
    static char texts[MOST][32];
    char *argv[MOST + 1];
    int argc = 0;
    taken taken = {""};
    for (; words[argc] != NULL; argc++) {
        snprintf(texts[argc], sizeof texts[argc], "%s", words[argc]);
        argv[argc] = texts[argc];
    }
    argv[argc] = NULL;
    optind = 1;
    said_begin();
    *fine = flags_read(argc, argv, "+:c:q", names, take, &taken);
    *argument = *fine ? flags_argument(argc, argv, "the table", "test [-q] TABLE") : NULL;
    said_end(said);
    return taken;
}

static void check_read(const char *const words[], const char *expected_taken, const char *expected_argument)
{
    said said;
    bool fine;
    const char *argument;
    const taken taken = read_words(words, &fine, &argument, &said);
    TEST_ASSERT_EQUAL_STRING("", said.text);
    TEST_ASSERT_TRUE(fine);
    TEST_ASSERT_EQUAL_STRING(expected_taken, taken.text);
    TEST_ASSERT_EQUAL_STRING(expected_argument, argument);
}

static void test_options_come_before_the_argument(void)
{
    check_read((const char *const[]){"test", "-q", "-c", "3", "t.tsv", NULL}, "q c3 ", "t.tsv");
    check_read((const char *const[]){"test", "--count=4", "--quiet", "--", "-q", NULL}, "c4 q ", "-q");
    check_read((const char *const[]){"test", "t.tsv", NULL}, "", "t.tsv");
}

static void check_refused(const char *const words[], const char *message)
{
    said said;
    bool fine;
    const char *argument;
    read_words(words, &fine, &argument, &said);
    TEST_ASSERT_EQUAL_STRING(message, said.text);
    TEST_ASSERT_NULL(argument);
}

static void test_what_is_wrong_is_named(void)
{
    check_refused((const char *const[]){"test", NULL}, "test: the table is missing; expected test [-q] TABLE\n");
    check_refused((const char *const[]){"test", "a", "b", "c", NULL},
                  "test: unexpected argument \"b\"; expected test [-q] TABLE\n");
    check_refused((const char *const[]){"test", "-x", "a", NULL},
                  "test: unknown option \"-x\"; expected options as in --help\n");
    check_refused((const char *const[]){"test", "-c", NULL},
                  "test: an argument is missing after \"-c\"; expected options as in --help\n");
    check_refused((const char *const[]){"test", "-c", "wrong", "a", NULL}, "");
}

int main(void)
{
    message_start("test");
    UNITY_BEGIN();
    RUN_TEST(test_options_come_before_the_argument);
    RUN_TEST(test_what_is_wrong_is_named);
    return UNITY_END();
}
