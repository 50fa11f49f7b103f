#include "support/short_main.h"

#include "console/exit_code.h"

#include "support/said.h"
#include "support/short_memory.h"

#include "unity.h"

#include <fcntl.h>
#include <getopt.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

enum { MOST = 16, LENGTH = 4400 /* the longest path and more */ };
static char texts[MOST][LENGTH];

/* What it prints before memory runs out is nobody's business here. */
static int run_quietly(main_routine *entry, int argc, char *argv[])
{
    fflush(stdout);
    const int before = dup(STDOUT_FILENO), nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    close(nowhere);
    optind = 1;
    const int code = entry(argc, argv);
    fflush(stdout);
    dup2(before, STDOUT_FILENO);
    close(before);
    return code;
}

/* A copy of their own: a main may change them. */
static int take_arguments(const char *const arguments[], char *argv[])
{
    int argc = 0;
    for (; arguments[argc] != NULL; argc++) {
        TEST_ASSERT_TRUE(argc < MOST);
        snprintf(texts[argc], sizeof texts[argc], "%s", arguments[argc]);
        argv[argc] = texts[argc];
    }
    argv[argc] = NULL;
    return argc;
}

/* Its exit code, and what it said. */
static int run_once(main_routine *entry, const char *const arguments[], said *said)
{
    char *argv[MOST + 1];
    const int argc = take_arguments(arguments, argv);
    said_begin();
    const int code = run_quietly(entry, argc, argv);
    said_end(said);
    return code;
}

static main_routine *starved;

/* It with no descriptor to be had. */
static int starve(int argc, char *argv[])
{
    struct rlimit before;
    TEST_ASSERT_EQUAL_INT(0, getrlimit(RLIMIT_NOFILE, &before));
    const struct rlimit none = {0, before.rlim_max};
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_NOFILE, &none));
    const int code = starved(argc, argv);
    TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_NOFILE, &before));
    return code;
}

void check_main_without_descriptors(main_routine *entry, const char *const arguments[], const char *file)
{
    said said;
    char message[LENGTH];
    snprintf(message, sizeof message, "%s: %s: Too many open files\n", arguments[0], file);
    starved = entry;
    TEST_ASSERT_EQUAL_INT(EXIT_FAILED, run_once(starve, arguments, &said));
    TEST_ASSERT_EQUAL_STRING(message, said.text);
}

void check_main_ends_well(main_routine *entry, const char *const arguments[])
{
    said said;
    const int code = run_once(entry, arguments, &said);
    TEST_ASSERT_EQUAL_STRING("", said.text);
    TEST_ASSERT_EQUAL_INT(EXIT_OK, code);
}

/* Whether it came to its end: without a word, or refusing what the refusal begins with. */
static bool ends(int code, const said *said, const char *refusal)
{
    return refusal == NULL ? code == EXIT_OK && said->text[0] == '\0'
                           : strncmp(said->text, refusal, strlen(refusal)) == 0;
}

static void check_lack(main_routine *entry, const char *const arguments[], memory_lack lack, const char *refusal,
                       long least)
{
    bool enough = false;
    long n = 0;
    for (; !enough; n++) {
        char message[96];
        said said;
        snprintf(message, sizeof message, "%s: out of memory\n", arguments[0]);
        memory_is_left(n, lack);
        const int code = run_once(entry, arguments, &said);
        enough = !memory_was_short();
        memory_is_enough();
        if (!ends(code, &said, refusal)) {
            TEST_ASSERT_EQUAL_STRING(message, said.text);
            TEST_ASSERT_TRUE(code == EXIT_FAILED && !enough);
        } else {
            TEST_ASSERT_TRUE(enough || lack == LACK_ONCE);
        }
    }
    TEST_ASSERT_TRUE_MESSAGE(n > least, "too few allocations: were they seen?");
}

void check_short_main(main_routine *entry, const char *const arguments[], long least)
{
    check_short_refused(entry, arguments, NULL, least);
}

void check_short_refused(main_routine *entry, const char *const arguments[], const char *refusal, long least)
{
    for (memory_lack lack = LACK_FOR_GOOD; lack < LACKS; lack++) {
        check_lack(entry, arguments, lack, refusal, least);
    }
}
