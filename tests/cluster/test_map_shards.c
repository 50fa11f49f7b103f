/* Maps in shards, as whole runs: any split gives the bytes of one process, and what does not fit says so. */

#include "armtol/runs.h"
#include "cluster/shard_runs.h"
#include "support/process.h"

#include "unity.h"

#include <inttypes.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { TALLIES = 12 };

void setUp(void)
{
}

void tearDown(void)
{
    process_clean_up();
}

static void draw(process *process, const char *folder, const char *const question[], const char *shard,
                 const char *tally)
{
    draw_shard(process, folder, "map", question, shard, tally);
}

static void draw_well(const char *folder, const char *const question[], const char *shard, const char *tally)
{
    process process;
    draw(&process, folder, question, shard, tally);
    text_check("", 0, &process.errors, tally);
    process_check_status(&process, 0, tally);
    check_says(&process, ": drawn, ");
}

/* Of golden's arms the one of that name, read and written anew. */
static void put_arm(const char *folder, const char *name)
{
    process shown;
    run_well(&shown, TEST_GOLDEN, (const char *const[]){name, "--show", NULL});
    file_write(path_in(folder, name).text, shown.output.bytes);
}

/* Two links and tolerances of them, arms with masses, drives and a follower, and a chain without joints. */
static string folder_of_arms(void)
{
    const string folder = folder_new();
    file_write(path_in(folder.text, "flat.csv").text,
               "units: mm rad\njoint a alpha d theta\ntheta 300 0 0 0\ntheta 200 0 0 0\n");
    file_write(path_in(folder.text, "t.csv").text, "link,parameter,tolerance\n0,a,inf\n");
    file_write(path_in(folder.text, "fixed.csv").text, "units: mm rad\njoint a alpha d theta\nfixed 300 0 0 0\n");
    put_arm(folder.text, "level.csv");
    put_arm(folder.text, "palletizer.csv");
    return folder;
}

/* ---- any split ---- */

static void check_same_files(const char *one, const char *other, const char *what)
{
    FILE *a = fopen(one, "rb"), *b = fopen(other, "rb");
    int c;
    TEST_ASSERT_TRUE_MESSAGE(a != NULL && b != NULL, what);
    do {
        c = getc(a);
        TEST_ASSERT_EQUAL_INT_MESSAGE(c, getc(b), what);
    } while (c != EOF);
    fclose(a);
    fclose(b);
}

typedef struct split {
    const char *shards[TALLIES]; /* in the order in which they are merged */
    const char *threads;         /* of recipes: they change nothing */
} split;

/* Of five rows; where ends of shards of several numbers of them meet, they fit together. */
static const split splits[] = {
    {{"1/1"}, "3"},
    {{"2/2", "1/2"}, "1"},
    {{"3/3", "1/3", "2/3"}, "2"},
    {{"5/5", "3/5", "1/5", "2/5", "4/5"}, "1"},
    {{"5/5", "1/2", "4/5"}, "2"},
};
enum { SPLITS = sizeof splits / sizeof splits[0] };

static void check_split(const char *folder, const char *const question[], const split *split, const process *whole)
{
    const char *tallies[TALLIES + 1] = {NULL}, *drawn[SHARD_WORDS] = {NULL};
    string names[TALLIES];
    process merged;
    join(drawn, question);
    join(drawn, (const char *const[]){"--threads", split->threads, "--tsv", "merged.tsv", "--svg", "merged.svg", NULL});
    for (int i = 0; i < TALLIES && split->shards[i] != NULL; i++) {
        names[i] = string_of("%d.tally", i);
        tallies[i] = names[i].text;
        unlink(path_in(folder, tallies[i]).text);
        draw_well(folder, drawn, split->shards[i], tallies[i]);
        TEST_ASSERT_TRUE_MESSAGE(access(path_in(folder, "merged.tsv").text, F_OK) != 0, "its tally alone");
    }
    merge(&merged, folder, tallies);
    text_check("", 0, &merged.errors, split->shards[0]);
    process_check_status(&merged, 0, split->shards[0]);
    text_check(whole->output.bytes, whole->output.length, &merged.output, split->shards[0]);
    check_same_files(path_in(folder, "whole.tsv").text, path_in(folder, "merged.tsv").text, split->shards[0]);
    check_same_files(path_in(folder, "whole.svg").text, path_in(folder, "merged.svg").text, split->shards[0]);
    unlink(path_in(folder, "merged.tsv").text);
}

static void check_splits(const char *const question[], const char *says)
{
    const string folder = folder_of_arms();
    const char *words[SHARD_WORDS] = {"map", NULL};
    process whole;
    join(words, question);
    join(words, (const char *const[]){"--tsv", "whole.tsv", "--svg", "whole.svg", NULL});
    run_well(&whole, folder.text, words);
    check_says(&whole, says);
    for (int i = 0; i < SPLITS; i++) {
        check_split(folder.text, question, &splits[i], &whole);
    }
}

static void test_any_split_of_a_worst_case(void)
{
    check_splits((const char *const[]){"scara", "--plane", "xy", "--offset", "200", "--range", "-700..700,-700..700",
                                       "--grid", "13,5", "--joints", "30,-70,120,15", "--degrees", "--accuracy",
                                       ".02,.02,.02,.01,.01,.01", "--of", "dx", NULL}, "of 65 points reached");
}

static void test_any_split_of_tolerances(void)
{
    check_splits((const char *const[]){"puma560", "--plane", "xz", "--range", "-800..800,-400..800", "--grid", "9,5",
                                       "--joints", "0,45,-90,0,45,0", "--degrees", "--accuracy",
                                       "r=.5,w=.01", "--what", "tolerance", "--of", "angles", "--json", NULL},
                 "\"tolerance\"");
}

static void test_any_split_of_a_droop(void)
{
    check_splits((const char *const[]){"level.csv", "--plane", "xz", "--range", "-.8..0.8,-.2..0.8", "--grid", "9,5",
                                       "--what", "droop", "--payload", "0", "--payload", "5", NULL}, "of 45 points");
}

static void test_any_split_of_an_arm_of_1987(void)
{
    check_splits((const char *const[]){"adeptone", "--plane", "xy", "--range", "-.8..0.8,-.8..0.8", "--grid", "9,5",
                                       "--orientation", "0,0,0", "--tolerances", "lengths=.00005,motors=.0002",
                                       "--metres", NULL}, "of 45 points");
}

/* Of a tolerance without a bound the worst case is infinite. */
static void test_any_split_without_a_bound(void)
{
    check_splits((const char *const[]){"flat.csv", "--plane", "xy", "--range", "-450..450,-450..450", "--grid", "7,5",
                                       "--tolerances", "t.csv", NULL}, "without a bound: ");
}

/*
 * Two pieces of the ring, of which the second is found by a search in the lowest row alone, and followed to in all
 * others: shards of those rows know nothing of that, and what they leave is found where they are merged.
 */
static void test_any_split_of_two_regions(void)
{
    check_splits((const char *const[]){"flat.csv", "--plane", "xy", "--range", "-600..600,-60..60", "--grid", "25,5",
                                       "--joints", "0,1.5", "--orientation", "free", "--tolerances", "lengths=.02",
                                       NULL}, "of 125 points");
}

static void test_any_split_of_an_arm_without_joints(void)
{
    check_splits((const char *const[]){"fixed.csv", "--plane", "xy", "--range", "0..600,-60..60", "--grid", "5,5",
                                       "--tolerances", "lengths=.02", NULL}, "1 of 25 points reached");
}

/* A joint that follows another one. */
static void test_any_split_of_coupled_joints(void)
{
    check_splits((const char *const[]){"palletizer.csv", "--plane", "xz", "--range", "-90..90,-20..90", "--grid", "7,5",
                                       "--tolerances", "lengths=.002", "--of", "rotation", NULL}, "of 35 points");
}

/* ---- what does not fit ---- */

#define FLAT "flat.csv", "--plane", "xy", "--range", "-450..450,-450..450"
#define LENGTHS "--tolerances", "lengths=.02,angles=.001"

static const char *const four_rows[] = {FLAT, "--grid", "3,4", LENGTHS, NULL};

static string folder_of_four(void)
{
    const string folder = folder_of_arms();
    draw_well(folder.text, four_rows, "1/4", "1");
    draw_well(folder.text, four_rows, "2/4", "2");
    draw_well(folder.text, four_rows, "3/4", "3");
    draw_well(folder.text, four_rows, "4/4", "4");
    return folder;
}

static void test_missing_and_doubled(void)
{
    const string folder = folder_of_four();
    draw_well(folder.text, four_rows, "1/2", "half");
    check_refused(folder.text, (const char *const[]){"1", "4", NULL},
                  "armtol: rows 1 to 2 of 4 are missing; expected a tally that has them, --shard 2/4 to 3/4\n");
    check_refused(folder.text, (const char *const[]){"1", "2", "3", "half", "4", NULL},
                  "armtol: 1 and half have the same rows, from 0 on; expected every row in one tally\n");
}

static void check_foreign(const char *folder, const char *const question[], const char *words)
{
    const string says = string_of("armtol: other: not of the same run as 1: another %s;", words);
    unlink(path_in(folder, "other").text);
    draw_well(folder, question, "2/4", "other");
    check_refused(folder, (const char *const[]){"1", "other", "3", "4", NULL}, says.text);
}

static void test_foreign_tallies(void)
{
    const string folder = folder_of_four();
    process process;
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,5", LENGTHS, NULL}, "number of rows");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "4,4", LENGTHS, NULL}, "number of points");
    check_foreign(folder.text, (const char *const[]){"scara", "--plane", "xy", "--range", "-450..450,-450..450",
                                                     "--grid", "3,4", LENGTHS, NULL}, "number of joints");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--ignore-limits", NULL}, "arm");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--drives", "backlash=.001", NULL},
                  "arm");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--joints", "0,1", NULL}, "pose");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--offset", "1", NULL}, "plane");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--orientation", "0,0,0", NULL},
                  "plane");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--of", "dx", NULL}, "value");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--what", "droop", NULL}, "value");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--frame", "tool", NULL}, "tool");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--tool-offset", "1,0,0", NULL},
                  "tool");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", "--tolerances",
                                                     "lengths=.02,angles=.002", NULL}, "tolerances");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--payload", "1", NULL}, "loads");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--force", "1,0,0", NULL},
                  "loads");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--accuracy", "1,1,1,-,-,-", NULL},
                  "accuracy");
    check_foreign(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--accuracy", "xy=1", NULL},
                  "accuracy");
    unlink(path_in(folder.text, "other").text);
    run_well(&process, folder.text,
             (const char *const[]){"flat.csv", "--joints", "0,1", LENGTHS, "--accuracy", "9,9,9,-,-,-", "--verify", "4",
                                   "--shard", "2/4", "--tally", "other", NULL});
    check_refused(folder.text, (const char *const[]){"1", "other", "3", "4", NULL},
                  "armtol: other: not of the same run as 1: another kind;");
    check_refused(folder.text, (const char *const[]){"other", "1", NULL},
                  "armtol: 1: not of the same run as other: another kind;");
}

/* How it is shown is asked of the tally with the first rows, and is no other run. */
static void test_what_is_shown_is_no_other_question(void)
{
    const string folder = folder_of_four();
    process whole, merged;
    unlink(path_in(folder.text, "1").text);
    draw_well(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--json", "--contour", "1", NULL},
              "1/4", "1");
    run_well(&whole, folder.text,
             (const char *const[]){"map", FLAT, "--grid", "3,4", LENGTHS, "--json", "--contour", "1", NULL});
    merge(&merged, folder.text, (const char *const[]){"3", "2", "1", "4", NULL});
    text_check(whole.output.bytes, whole.output.length, &merged.output, "the first rows' words");
}

static void replace_in(const char *path, const char *old, const char *new)
{
    static text content;
    file_read(path, &content);
    char *at = strstr(content.bytes, old);
    TEST_ASSERT_NOT_NULL_MESSAGE(at, old);
    memcpy(at, new, strlen(new));
    file_write(path, content.bytes);
}

/* The file with an end that has the right checksum (FNV-1a, of its authors' page). */
static void seal(const char *path)
{
    static text content;
    uint64_t checksum = 14695981039346656037u;
    file_read(path, &content);
    char *const end = strstr(content.bytes, "\nend ");
    TEST_ASSERT_NOT_NULL(end);
    for (const char *at = content.bytes; at <= end; at++) {
        checksum ^= (unsigned char)*at;
        checksum *= 1099511628211u;
    }
    sprintf(end + 1, "end %016" PRIx64 "\n", checksum);
    file_write(path, content.bytes);
}

static void test_cut_and_damaged(void)
{
    const string folder = folder_of_four(), one = path_in(folder.text, "1"), two = path_in(folder.text, "2");
    struct stat status;
    TEST_ASSERT_EQUAL_INT(0, stat(one.text, &status));
    TEST_ASSERT_EQUAL_INT(0, truncate(one.text, status.st_size - 30));
    replace_in(two.text, "points 3", "points 4");
    check_refused(folder.text, (const char *const[]){"4", "1", NULL}, ": the tally is cut: its end is missing\n");
    check_refused(folder.text, (const char *const[]){"4", "2", NULL}, "armtol: 2:");
    replace_in(path_in(folder.text, "3").text, "version " TEST_VERSION, "version 9.9.9");
    seal(path_in(folder.text, "3").text);
    check_refused(folder.text, (const char *const[]){"4", "3", NULL},
                  "armtol: 3: drawn by armtol 9.9.9; expected " TEST_VERSION);
}

/* Numbers of rows that a forged tally has beside the fingerprints of others. */
static void test_forged_tallies(void)
{
    const string folder = folder_of_arms(), tally = path_in(folder.text, "t");
    draw_well(folder.text, (const char *const[]){FLAT, "--grid", "9,9", LENGTHS, "--offset", "999", NULL}, "1/1", "t");
    replace_in(tally.text, "rows 9", "rows 8");
    seal(tally.text);
    check_refused(folder.text, (const char *const[]){"t", NULL},
                  "armtol: t: its rows are not those of its plane and its arm: the tally is damaged\n");
    replace_in(tally.text, "rows 8", "rows 9");
    replace_in(tally.text, "joints 2", "joints 9");
    seal(tally.text);
    check_refused(folder.text, (const char *const[]){"t", NULL}, "its rows are not those of its plane and its arm");
    replace_in(tally.text, "word map\n", "word -h\n\n");
    seal(tally.text);
    check_refused(folder.text, (const char *const[]){"t", NULL}, "armtol: t:4:1: the tally is damaged here");
    unlink(tally.text);
    draw_well(folder.text, (const char *const[]){FLAT, "--grid", "9,9", LENGTHS, "--degrees", NULL}, "1/1", "t");
    replace_in(tally.text, "word --degrees\n", "word --version\n");
    seal(tally.text);
    check_refused(folder.text, (const char *const[]){"t", NULL},
                  "armtol: t: the command in it is not the one that its rows were drawn for: the tally is damaged\n");
}

/* The command is in the tally, and the arm that it names is another one by now. */
static void test_an_arm_that_has_changed(void)
{
    const string folder = folder_of_four();
    replace_in(path_in(folder.text, "flat.csv").text, "theta 300", "theta 299");
    check_refused(folder.text, (const char *const[]){"1", "2", "3", "4", NULL},
                  "armtol: 1: the command in it asks now for another arm than when the rows were drawn; expected");
}

/* ---- a shard once more ---- */

static void check_drawn_anew(const char *folder, const char *const question[], const char *shard, const char *words)
{
    process process;
    draw(&process, folder, question, shard, "tally");
    process_check_status(&process, 0, words);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(process.errors.bytes, words), process.errors.bytes);
    check_says(&process, ": drawn, tally\n");
    draw(&process, folder, question, shard, "tally");
    check_says(&process, ": there already, tally\n");
}

static void test_what_is_there(void)
{
    const string folder = folder_of_arms(), tally = path_in(folder.text, "tally");
    static text before, after;
    process process;
    draw_well(folder.text, four_rows, "2/4", "tally");
    file_read(tally.text, &before);
    draw(&process, folder.text, four_rows, "2/4", "tally");
    const char said[] = "shard 2/4, rows 1 to 1 of 4: there already, tally\n";
    text_check(said, strlen(said), &process.output, "again");
    file_read(tally.text, &after);
    text_check(before.bytes, before.length, &after, "again");
    check_drawn_anew(folder.text, four_rows, "3/4", "armtol: tally: another shard; it is drawn anew\n");
    check_drawn_anew(folder.text, (const char *const[]){FLAT, "--grid", "3,4", LENGTHS, "--of", "dy", NULL}, "3/4",
                     "armtol: tally: another value; it is drawn anew\n");
    TEST_ASSERT_EQUAL_INT(0, truncate(tally.text, 300));
    check_drawn_anew(folder.text, four_rows, "3/4", "the tally is cut: its end is missing\n");
    unlink(tally.text);
    run_well(&process, folder.text,
             (const char *const[]){"flat.csv", "--joints", "0,1", LENGTHS, "--accuracy", "9,9,9,-,-,-", "--verify", "4",
                                   "--shard", "1/4", "--tally", "tally", NULL});
    check_drawn_anew(folder.text, four_rows, "3/4", "armtol: tally: another kind; it is drawn anew\n");
    file_write(tally.text, "roses are red\n");
    draw(&process, folder.text, four_rows, "1/4", "tally");
    process_check_status(&process, 2, "in the way");
    file_check(tally.text, "roses are red\n", "in the way");
}

/* ---- options ---- */

static void check_usage(const char *folder, const char *const question[], const char *shard, const char *words)
{
    process process;
    draw(&process, folder, question, shard, "t");
    process_check_status(&process, 2, words);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(process.errors.bytes, words), process.errors.bytes);
    TEST_ASSERT_TRUE(access(path_in(folder, "t").text, F_OK) != 0);
}

static void test_wrong_options(void)
{
    const string folder = folder_of_arms();
    process process;
    check_usage(folder.text, four_rows, "1/5", "armtol: --shard: more shards than the 4 rows of the map\n");
    check_usage(folder.text, (const char *const[]){FLAT, LENGTHS, "--seed", "5", NULL}, "1/2", "are not for a map");
    check_usage(folder.text, (const char *const[]){FLAT, LENGTHS, "--verify", "5", NULL}, "1/2", "are not for a map");
    run(&process, folder.text, (const char *const[]){"map", FLAT, LENGTHS, "--shard", "1/2", NULL});
    process_check_status(&process, 2, "no tally");
    TEST_ASSERT_NOT_NULL(strstr(process.errors.bytes, "--shard I/N and --tally FILE go together"));
    run(&process, folder.text, (const char *const[]){"map", FLAT, LENGTHS, "--threads", "2", NULL});
    process_check_status(&process, 2, "threads");
    draw(&process, folder.text, four_rows, "1/2", "nowhere/t");
    process_check_status(&process, 1, "nowhere");
}

/* More joint values than a tally has room for: refused before anything is reached for. */
static void test_a_map_that_no_tally_holds(void)
{
    static char table[1 << 13] = "units: mm rad\njoint a alpha d theta\n";
    const string folder = folder_new();
    for (int i = 0; i < 135; i++) {
        strcat(table, "theta 10 0 0 0\n");
    }
    file_write(path_in(folder.text, "snake.csv").text, table);
    check_usage(folder.text, (const char *const[]){"snake.csv", "--plane", "xy", "--range", "0..1,0..1", "--grid",
                                                   "1000,1000", LENGTHS, NULL}, "1/2",
                "armtol: --shard: 1000 rows of 1000 points, of 135 joints each, are more than 134217728 joint values;");
}

/* A point of a map that has no number is an error of the shard, and no tally is there. */
static void test_a_shard_that_fails(void)
{
    const string folder = folder_new();
    process process;
    file_write(path_in(folder.text, "slide.csv").text,
               "units: mm rad\njoint a alpha d theta\nd 0 0 1e308 0\ntheta 300 0 0 0\n");
    draw(&process, folder.text, (const char *const[]){"slide.csv", "--plane", "xy", "--range", "-600..600,-600..600",
                                                      "--grid", "9,9", LENGTHS, "--joints", "1e308,0", NULL},
         "1/2", "t");
    process_check_status(&process, 2, "no number");
    folder_check(folder.text, "slide.csv", "nothing is written");
}

static void test_an_interrupted_shard_writes_nothing(void)
{
    const string folder = folder_new();
    const char *const arguments[] = {"map", "puma560", "--plane", "xz", "--range", "-900..900,-900..900", "--grid",
                                     "1000,1000", LENGTHS, "--shard", "1/2", "--tally", "t", NULL};
    const process_setup setup = {.program = TEST_ARMTOL, .arguments = arguments, .folder = folder.text,
                                 .wires = ALL_ON_TERMINAL};
    process process;
    process_start(&process, &setup);
    process_expect(&process, "points reached for");
    process_send(&process, "\x03", 1);
    process_finish(&process);
    process_check_status(&process, 1, "interrupted");
    TEST_ASSERT_NOT_NULL(strstr(process.errors.bytes, "interrupted; nothing is written"));
    folder_check(folder.text, "", "nothing is written");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_any_split_of_a_worst_case);
    RUN_TEST(test_any_split_of_tolerances);
    RUN_TEST(test_any_split_of_a_droop);
    RUN_TEST(test_any_split_of_an_arm_of_1987);
    RUN_TEST(test_any_split_without_a_bound);
    RUN_TEST(test_any_split_of_two_regions);
    RUN_TEST(test_any_split_of_an_arm_without_joints);
    RUN_TEST(test_any_split_of_coupled_joints);
    RUN_TEST(test_missing_and_doubled);
    RUN_TEST(test_foreign_tallies);
    RUN_TEST(test_what_is_shown_is_no_other_question);
    RUN_TEST(test_cut_and_damaged);
    RUN_TEST(test_forged_tallies);
    RUN_TEST(test_an_arm_that_has_changed);
    RUN_TEST(test_what_is_there);
    RUN_TEST(test_wrong_options);
    RUN_TEST(test_a_map_that_no_tally_holds);
    RUN_TEST(test_a_shard_that_fails);
    RUN_TEST(test_an_interrupted_shard_writes_nothing);
    return UNITY_END();
}
