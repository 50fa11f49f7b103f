/* The whole of armtol in this process, memory running out at every place where it can. Built with --wrap. */

#include "support/short_main.h"
#include "support/short_memory.h"

#include "unity.h"

#include <stddef.h>
#include <stdio.h>

/* The main of armtol.c, which is compiled into this program under that name. */
int armtol_main(int argc, char *argv[]);

void setUp(void)
{
}

void tearDown(void)
{
    memory_is_enough();
}

#define POSED "armtol", "puma560", "--joints", "0,45,-90,0,45,0", "--degrees"
#define ASKED POSED, "--accuracy", ".5,.5,.5,.01,.01,.01"

static void test_every_answer(void)
{
    check_short_main(armtol_main, (const char *const[]){ASKED, "--budget", "--verify", "10", "--threads", "1", NULL},
                     10);
    check_short_main(armtol_main, (const char *const[]){ASKED, "--json", "--budget", NULL}, 8);
    check_short_main(armtol_main, (const char *const[]){ASKED, "--csv", NULL}, 6);
    check_short_main(armtol_main, (const char *const[]){ASKED, "--drives", "noise=1e-4", "--budget", "--verify", "10",
                                                        "--iso9283", "3", "--threads", "1", NULL}, 20);
    check_short_main(armtol_main, (const char *const[]){POSED, "--accuracy", "rp=.1", "--method", "rss", "--json",
                                                        NULL}, 20);
}

static void test_positions(void)
{
    check_short_main(armtol_main, (const char *const[]){"armtol", "scara", "--at", "300,100,200", "--near", "0,0,0,0",
                                                        "--accuracy", "1,1,1,1,1,1", NULL}, 10);
    check_short_main(armtol_main,
                     (const char *const[]){"armtol", "scara", "--at", "300,100,200", "--branches", NULL}, 5);
}

static void write_file(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    TEST_ASSERT_NOT_NULL(file);
    fputs(text, file);
    fclose(file);
}

/* Both read from files. */
static void test_distributions(void)
{
    write_file("memory_spread.csv", "link,parameter,distribution,group\n1,a,normal:3,lathe\n2,d,normal:3,lathe\n");
    write_file("memory_ends.csv", "link,parameter,upper,lower\n1,a,.1,-.05\n");
    check_short_main(armtol_main, (const char *const[]){POSED, "--tolerances", "memory_ends.csv", "--spread",
                                                        "memory_spread.csv", "--budget", NULL}, 12);
    remove("memory_spread.csv");
    remove("memory_ends.csv");
}

static void test_a_drawing(void)
{
    write_file("memory_drawing.csv", "link,angle\n1,.001\n2,.001\n");
    check_short_main(armtol_main, (const char *const[]){POSED, "--drawing", "memory_drawing.csv", NULL}, 8);
    remove("memory_drawing.csv");
}

/* What leaves nothing is asked for once more, to be named. */
static void test_no_answer(void)
{
    check_short_refused(armtol_main, (const char *const[]){ASKED, "--drives", "backlash=1", NULL},
                        "armtol: no tolerances: the drives alone use ", 8);
}

static void test_another_arm(void)
{
    check_short_main(armtol_main, (const char *const[]){POSED, "--against", "ur5e", NULL}, 8);
    check_short_refused(armtol_main, (const char *const[]){POSED, "--deviations", "/dev/null", NULL},
                        "armtol: /dev/null: no table", 8);
}

/* Of words and of a file. */
static void test_regions(void)
{
    static const char words[] = "q1=0..1;q2=10;q3=5;q4=0;path=900:0,0,0:1,0,0";
    FILE *file = fopen("memory.region", "w");
    TEST_ASSERT_NOT_NULL(file);
    fprintf(file, "%s\n", words);
    fclose(file);
    check_short_main(armtol_main, (const char *const[]){"armtol", "scara", "--degrees", "--region", words, "--accuracy",
                                                        "xy=.02", "--gap", "50", NULL}, 20);
    check_short_main(armtol_main, (const char *const[]){"armtol", "scara", "--degrees", "--region", "memory.region",
                                                        "--accuracy", "xy=.02", "--method", "rss", "--gap", "50",
                                                        NULL}, 20);
    remove("memory.region");
}

/* The tallies are drawn once; then the one is found to be there, and both are merged. */
static void test_tallies(void)
{
    static const char *const shards[2][18] = {
        {ASKED, "--verify", "10", "--threads", "1", "--shard", "1/2", "--tally", "memory_1.tally", NULL},
        {ASKED, "--verify", "10", "--threads", "1", "--shard", "2/2", "--tally", "memory_2.tally", NULL},
    };
    for (int i = 0; i < 2; i++) {
        remove(shards[i][14]);
        check_main_ends_well(armtol_main, shards[i]);
    }
    check_short_main(armtol_main, shards[0], 8);
    check_short_main(armtol_main, (const char *const[]){"armtol", "merge", "memory_1.tally", "memory_2.tally", NULL},
                     20);
    remove(shards[0][14]);
    remove(shards[1][14]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_answer);
    RUN_TEST(test_positions);
    RUN_TEST(test_distributions);
    RUN_TEST(test_a_drawing);
    RUN_TEST(test_no_answer);
    RUN_TEST(test_another_arm);
    RUN_TEST(test_regions);
    RUN_TEST(test_tallies);
    return UNITY_END();
}
