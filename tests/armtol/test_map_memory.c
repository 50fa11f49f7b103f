/*
 * Maps that are cut short, in this process: memory that runs out at every place where it can, and an interrupt while
 * values are found. Built with --wrap.
 */

#include "armtol/map.h"
#include "console/exit_code.h"
#include "support/said.h"
#include "support/short_main.h"
#include "support/short_memory.h"

#include "unity.h"

#include <getopt.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

/* The main of armtol.c, which is compiled into this program under that name. */
int armtol_main(int argc, char *argv[]);

/* What the linker calls the library's own, and what is called in its place. */
armtol_status __real_armtol_map_values(const armtol_question *question, const armtol_map *map, double values[],
                                       armtol_fault *fault);
armtol_status __wrap_armtol_map_values(const armtol_question *question, const armtol_map *map, double values[],
                                       armtol_fault *fault);

static bool is_interrupted;

/* Ctrl-C, should it be pressed, is so in the midst of the work. */
armtol_status __wrap_armtol_map_values(const armtol_question *question, const armtol_map *map, double values[],
                                       armtol_fault *fault)
{
    if (is_interrupted) {
        raise(SIGINT);
    }
    return __real_armtol_map_values(question, map, values, fault);
}

void setUp(void)
{
    is_interrupted = false;
}

void tearDown(void)
{
    memory_is_enough();
}

#define MAP "armtol", "map", "scara", "--plane=xy", "--offset=200", "--range=300..400,100..200", "--grid=2,2"
#define POSED MAP, "--joints=0,1,100,0", "--accuracy=1,1,1,1,1,1"

static void test_memory_for_tables(void)
{
    check_short_main(armtol_main, (const char *const[]){MAP, "--tolerances=lengths=.1", "--tsv=-", NULL}, 10);
    check_short_main(armtol_main, (const char *const[]){MAP, "--tolerances=lengths=.1", "--json", NULL}, 10);
    check_short_main(armtol_main, (const char *const[]){POSED, "--what=tolerance", "--of=lengths", NULL}, 15);
}

/* The pose tells the tool's axes, and what the tolerances are. */
static void test_memory_for_a_picture(void)
{
    check_short_main(armtol_main, (const char *const[]){POSED, "--svg=-", NULL}, 20);
}

/* armtol in this process, and what it said. */
static int run_main(const char *const words[], said *said)
{
    static char texts[16][40];
    char *argv[16] = {NULL};
    int argc = 0;
    for (; words[argc] != NULL; argc++) {
        snprintf(texts[argc], sizeof texts[argc], "%s", words[argc]);
        argv[argc] = texts[argc];
    }
    optind = 1;
    said_begin();
    const int code = armtol_main(argc, argv);
    said_end(said);
    return code;
}

/* Nothing is written until there is memory enough; a stream that cannot be had is told with the name of its file. */
static void check_short_shard(const char *const words[], const char *tally)
{
    said said;
    bool was_short = true;
    long n = 0;
    for (; was_short; n++) {
        memory_is_left(n, LACK_FOR_GOOD);
        const int code = run_main(words, &said);
        was_short = memory_was_short();
        memory_is_enough();
        FILE *written = fopen(tally, "rb");
        TEST_ASSERT_TRUE_MESSAGE((code == EXIT_OK) == (written != NULL) && (written != NULL) != was_short, said.text);
        TEST_ASSERT_TRUE_MESSAGE(!was_short || strstr(said.text, "memory\n") != NULL, said.text);
        if (written != NULL) {
            fclose(written);
        }
    }
    TEST_ASSERT_TRUE(n > 20);
}

/* While tallies are drawn, where one is found to be there, and while both are merged. */
static void test_memory_for_shards(void)
{
    static const char *const shards[2][16] = {
        {MAP, "--tolerances=lengths=.1", "--shard=1/2", "--tally=map_memory_1.tally", NULL},
        {MAP, "--tolerances=lengths=.1", "--shard=2/2", "--tally=map_memory_2.tally", NULL},
    };
    remove("map_memory_1.tally");
    remove("map_memory_2.tally");
    check_short_shard(shards[0], "map_memory_1.tally");
    check_short_shard(shards[1], "map_memory_2.tally");
    check_short_main(armtol_main, shards[0], 15);
    check_short_main(armtol_main,
                     (const char *const[]){"armtol", "merge", "map_memory_1.tally", "map_memory_2.tally", NULL}, 20);
    remove("map_memory_1.tally");
    remove("map_memory_2.tally");
}

static void test_an_interrupt_while_values_are_found(void)
{
    said said;
    is_interrupted = true;
    const int code = run_main((const char *const[]){MAP, "--tolerances=lengths=.1", "--tsv=interrupted.tsv", NULL},
                              &said);
    TEST_ASSERT_EQUAL_INT(EXIT_FAILED, code);
    TEST_ASSERT_EQUAL_STRING("armtol: interrupted; nothing is written\n", said.text);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_memory_for_tables);
    RUN_TEST(test_memory_for_a_picture);
    RUN_TEST(test_memory_for_shards);
    RUN_TEST(test_an_interrupt_while_values_are_found);
    return UNITY_END();
}
