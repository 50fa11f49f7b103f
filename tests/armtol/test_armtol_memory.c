/* The whole of armtol in this process, memory running out at every place where it can. Built with --wrap. */

#include "exit_code.h"

#include "said.h"
#include "short_memory.h"

#include "unity.h"

#include <fcntl.h>
#include <getopt.h>
#include <stdbool.h>
#include <stdlib.h>
#include <unistd.h>

/* The main of armtol.c, which is compiled into this program under that name. */
int armtol_main(int argc, char *argv[]);

enum { MOST = 16 };
static char texts[MOST][64];

void setUp(void)
{
}

void tearDown(void)
{
    memory_is_enough();
}

/* What it prints before memory runs out is nobody's business here. */
static int run_quietly(int argc, char *argv[])
{
    fflush(stdout);
    const int before = dup(STDOUT_FILENO), nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    close(nowhere);
    optind = 1;
    const int code = armtol_main(argc, argv);
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

static void check(const char *const arguments[], long least)
{
    int code = EXIT_FAILED;
    long n = 0;
    for (; code != EXIT_OK; n++) {
        char *argv[MOST + 1];
        const int argc = take_arguments(arguments, argv);
        said said;
        said_begin();
        memory_is_left(n);
        code = run_quietly(argc, argv);
        memory_is_enough();
        said_end(&said);
        TEST_ASSERT_EQUAL_STRING(code == EXIT_OK ? "" : "armtol: out of memory\n", said.text);
        TEST_ASSERT_TRUE(code == EXIT_OK || code == EXIT_FAILED);
    }
    TEST_ASSERT_TRUE_MESSAGE(n > least, "too few allocations: were they seen?");
}

#define ASKED "armtol", "puma560", "--joints", "0,45,-90,0,45,0", "--degrees", "--accuracy", ".5,.5,.5,.01,.01,.01"

static void test_every_answer(void)
{
    check((const char *const[]){ASKED, "--budget", "--verify", "10", "--threads", "1", NULL}, 10);
    check((const char *const[]){ASKED, "--json", "--budget", NULL}, 8);
    check((const char *const[]){ASKED, "--csv", NULL}, 6);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_answer);
    return UNITY_END();
}
