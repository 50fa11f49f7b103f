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

static void test_an_interrupt_while_values_are_found(void)
{
    char arguments[][32] = {MAP, "--tolerances=lengths=.1", "--tsv=interrupted.tsv"};
    enum { COUNT = sizeof arguments / sizeof arguments[0] };
    char *argv[COUNT + 1] = {NULL};
    said said;
    for (size_t i = 0; i < COUNT; i++) {
        argv[i] = arguments[i];
    }
    is_interrupted = true;
    optind = 1;
    said_begin();
    const int code = armtol_main(COUNT, argv);
    said_end(&said);
    TEST_ASSERT_EQUAL_INT(EXIT_FAILED, code);
    TEST_ASSERT_EQUAL_STRING("armtol: interrupted; nothing is written\n", said.text);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_memory_for_tables);
    RUN_TEST(test_memory_for_a_picture);
    RUN_TEST(test_an_interrupt_while_values_are_found);
    return UNITY_END();
}
