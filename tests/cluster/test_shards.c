/* Verifications in shards, as whole runs: any split gives the bytes of one process, and what does not fit says so. */

#include "armtol/runs.h"
#include "cluster/shard_runs.h"
#include "support/process.h"

#include "unity.h"

#include <fcntl.h>
#include <inttypes.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#define ASKED "puma560", "--joints", "0,45,-90,0,45,0", "--degrees", "--accuracy", ".5,.5,.5,.01,.01,.01"

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
    draw_shard(process, folder, NULL, question, shard, tally);
}

static void draw_well(const char *folder, const char *const question[], const char *shard, const char *tally)
{
    process process;
    draw(&process, folder, question, shard, tally);
    process_check_status(&process, 0, tally);
    text_check("", 0, &process.errors, tally);
    check_says(&process, ": drawn, ");
}

/* ---- any split ---- */

typedef struct split {
    const char *shards[TALLIES]; /* in the order in which they are merged */
    const char *threads;
} split;

/* Where ends of shards of several numbers of them meet, they fit together. */
static const split splits[] = {
    {{"1/1"}, "3"},
    {{"1/2", "2/2"}, "1"},
    {{"3/3", "1/3", "2/3"}, "2"},
    {{"7/7", "5/7", "1/7", "6/7", "2/7", "4/7", "3/7"}, "1"},
    {{"4/4", "1/2", "3/4"}, "2"},
    {{"2/9", "8/9", "9/9", "2/3", "1/9", "7/9", "3/9"}, "3"},
};
enum { SPLITS = sizeof splits / sizeof splits[0] };

static void check_split(const char *const question[], const split *split, const process *whole)
{
    const string folder = folder_new();
    const char *tallies[TALLIES + 1] = {NULL}, *drawn[SHARD_WORDS] = {NULL};
    string names[TALLIES];
    process merged;
    join(drawn, question);
    join(drawn, (const char *const[]){"--threads", split->threads, NULL});
    for (int i = 0; i < TALLIES && split->shards[i] != NULL; i++) {
        names[i] = string_of("%d.tally", i);
        tallies[i] = names[i].text;
        draw_well(folder.text, drawn, split->shards[i], tallies[i]);
    }
    merge(&merged, folder.text, tallies);
    process_check_status(&merged, 0, split->shards[0]);
    text_check("", 0, &merged.errors, split->shards[0]);
    text_check(whole->output.bytes, whole->output.length, &merged.output, split->shards[0]);
}

static void check_splits(const char *const question[])
{
    process whole;
    run_well(&whole, NULL, question);
    check_says(&whole, "9009");
    for (int i = 0; i < SPLITS; i++) {
        check_split(question, &splits[i], &whole);
    }
}

static void test_any_split_of_text(void)
{
    check_splits((const char *const[]){ASKED, "--budget", "--verify", "9009", NULL});
}

static void test_any_split_of_json(void)
{
    check_splits((const char *const[]){ASKED, "--json", "--seed", "3", "--verify", "9009", NULL});
}

/* Drives, loads and statistical tolerances, of which some arms miss the accuracy. */
static void test_any_split_of_loaded_arms(void)
{
    check_splits((const char *const[]){ASKED, "--method", "rss", "--drives",
                                       "backlash=.0001,moment=5,compliance=1e-6", "--frame", "tool",
                                       "--tool-offset", "0,0,100", "--json", "--verify", "9009", NULL});
}

/* Balls are measured too, each by a histogram of its own. */
static void test_any_split_of_balls(void)
{
    check_splits((const char *const[]){"puma560", "--joints", "0,45,-90,0,45,0", "--degrees", "--accuracy",
                                       "r=.5,w=.01",
                                       "--verify", "9009", NULL});
}

/* One arm a shard, and more shards than that are none. */
static void test_an_arm_a_shard(void)
{
    const char *const three[] = {ASKED, "--verify", "3", NULL};
    const string folder = folder_new();
    process whole, merged, refused;
    run_well(&whole, NULL, three);
    draw_well(folder.text, three, "1/3", "1");
    draw_well(folder.text, three, "2/3", "2");
    draw_well(folder.text, three, "3/3", "3");
    merge(&merged, folder.text, (const char *const[]){"1", "2", "3", NULL});
    text_check(whole.output.bytes, whole.output.length, &merged.output, "an arm a shard");
    draw(&refused, folder.text, three, "1/4", "4");
    process_check_status(&refused, 2, "four shards");
    folder_check(folder.text, "1 2 3", "four shards");
}

/* Words of the command may hold anything, and the files that it names are read again where they are. */
static void test_words_that_are_hard_to_write(void)
{
    const string folder = folder_new();
    const char *arm = "an arm,\n100 % \xc3\xa4.csv";
    process shown, whole, merged;
    run_well(&shown, NULL, (const char *const[]){"puma560", "--show", NULL});
    file_write(path_in(folder.text, arm).text, shown.output.bytes);
    const char *const question[] = {arm, "--joints", "0,.8,-1.6,0,.8,0", "--accuracy", "1,1,1,-,-,-", "--verify", "9",
                                    NULL};
    run_well(&whole, folder.text, question);
    draw_well(folder.text, question, "1/1", "\xff tally");
    merge(&merged, folder.text, (const char *const[]){"\xff tally", NULL});
    text_check(whole.output.bytes, whole.output.length, &merged.output, "hard words");
}

/* ---- what does not fit ---- */

static const char *const hundred[] = {ASKED, "--verify", "100", NULL};

static string folder_of_four(void)
{
    const string folder = folder_new();
    draw_well(folder.text, hundred, "1/4", "1");
    draw_well(folder.text, hundred, "2/4", "2");
    draw_well(folder.text, hundred, "3/4", "3");
    draw_well(folder.text, hundred, "4/4", "4");
    return folder;
}

static void test_missing_and_doubled(void)
{
    const string folder = folder_of_four();
    draw_well(folder.text, hundred, "2/3", "odd");
    check_refused(folder.text, (const char *const[]){"1", "3", "4", NULL},
                  "armtol: arms 25 to 49 of 100 are missing; expected a tally that has them, --shard 2/4\n");
    check_refused(folder.text, (const char *const[]){"4", NULL},
                  "armtol: arms 0 to 74 of 100 are missing; expected a tally that has them, --shard 1/4 to 3/4\n");
    check_refused(folder.text, (const char *const[]){"2", "4", NULL}, "arms 0 to 24 of 100 are missing");
    check_refused(folder.text, (const char *const[]){"2", "4", NULL}, "arms 50 to 74 of 100 are missing");
    check_refused(folder.text, (const char *const[]){"1", "2", NULL}, ", --shard 3/4 to 4/4\n");
    check_refused(folder.text, (const char *const[]){"odd", "4", "1", NULL},
                  "arms 25 to 33 of 100 are missing; expected a "
                                                                             "tally that has them\n");
    check_refused(folder.text, (const char *const[]){"1", "2", "3", "4", "2", NULL},
                  "armtol: 2 and 2 have the same arms, from 25 on; expected every arm in one tally\n");
    check_refused(folder.text, (const char *const[]){"1", "2", "odd", "3", "4", NULL},
                  "have the same arms, from 34 on");
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
    check_foreign(folder.text, (const char *const[]){ASKED, "--verify", "101", NULL}, "number of arms");
    check_foreign(folder.text, (const char *const[]){ASKED, "--verify", "100", "--seed", "1", NULL}, "seed");
    check_foreign(folder.text, (const char *const[]){ASKED, "--verify", "100", "--frame", "tool", NULL}, "tool");
    check_foreign(folder.text, (const char *const[]){ASKED, "--verify", "100", "--weights", "motors=2", NULL},
                  "tolerances");
    check_foreign(folder.text, (const char *const[]){"puma560", "--joints", "0,45,-91,0,45,0", "--degrees",
                                                     "--accuracy",
                                                     ".5,.5,.5,.01,.01,.01", "--verify", "100", NULL}, "arm");
    check_foreign(folder.text, (const char *const[]){ASKED, "--verify", "100", "--drives", "moment=1,compliance=1e-9",
                                                     NULL}, "tolerances");
    check_foreign(folder.text, (const char *const[]){ASKED, "--tolerances", "lengths=.01,angles=.0001", "--verify",
                                                     "100", NULL}, "tolerances");
}

/* In both the tolerances are the same, and what arms are held against is not. */
static void test_another_accuracy(void)
{
    const char *const one[] = {"puma560", "--joints", "0,.8,-1.6,0,.8,0", "--tolerances", "lengths=.01", "--accuracy",
                               "1,1,1,-,-,-",
                               "--verify", "100", NULL};
    const char *const other[] = {"puma560", "--joints", "0,.8,-1.6,0,.8,0", "--tolerances", "lengths=.01", "--accuracy",
                                 "1,1,2,-,-,-", "--verify", "100", NULL};
    const string folder = folder_new();
    draw_well(folder.text, one, "1/2", "1");
    draw_well(folder.text, other, "2/2", "2");
    check_refused(folder.text, (const char *const[]){"2", "1", NULL}, "1: not of the same run as 2: another accuracy;");
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

static void test_cut_damaged_and_other_files(void)
{
    const string folder = folder_of_four();
    const string one = path_in(folder.text, "1"), two = path_in(folder.text, "2"), three = path_in(folder.text, "3");
    struct stat status;
    file_write(path_in(folder.text, "poem").text, "roses are red\n");
    TEST_ASSERT_EQUAL_INT(0, stat(one.text, &status));
    TEST_ASSERT_EQUAL_INT(0, truncate(one.text, status.st_size / 2));
    replace_in(two.text, "within 0 ", "within 0 0");
    replace_in(three.text, "armtol tally 1", "armtol tally 2");
    check_refused(folder.text, (const char *const[]){"4", "1", NULL}, ": the tally is cut: its end is missing\n");
    check_refused(folder.text, (const char *const[]){"4", "2", NULL}, "armtol: 2:");
    check_refused(folder.text, (const char *const[]){"4", "3", NULL},
                  "armtol: 3:1:1: this is no tally of this armtol; ");
    check_refused(folder.text, (const char *const[]){"poem", NULL},
                  "armtol: poem:1:1: this is no tally of this armtol; ");
    check_refused(folder.text, (const char *const[]){"4", "none", NULL}, "armtol: none: No such file or directory\n");
    check_refused(folder.text, (const char *const[]){NULL},
                  "armtol: merge: the tallies are missing; expected armtol merge FILE");
    check_refused(folder.text, (const char *const[]){"4", "--json", NULL},
                  "armtol: unknown option of merge \"--json\"");
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

static void test_a_tally_of_another_version(void)
{
    const string folder = folder_of_four(), one = path_in(folder.text, "1");
    replace_in(one.text, "version " TEST_VERSION, "version 9.9.9");
    check_refused(folder.text, (const char *const[]){"1", NULL}, "the checksum is not that of the lines before");
    seal(one.text);
    check_refused(folder.text, (const char *const[]){"1", NULL},
                  "armtol: 1: drawn by armtol 9.9.9; expected " TEST_VERSION);
}

/* A forged command is no way to another answer. */
static void test_a_command_that_is_not_the_tally_s(void)
{
    const string folder = folder_new(), tally = path_in(folder.text, "t");
    static text right;
    draw_well(folder.text, hundred, "1/1", "t");
    file_read(tally.text, &right);
    replace_in(tally.text, "word 100\n", "word 101\n");
    seal(tally.text);
    check_refused(folder.text, (const char *const[]){"t", NULL},
                  "armtol: t: the command in it is not the one that its arms");
    file_write(tally.text, right.bytes);
    replace_in(tally.text, "word --verify\n", "word --verifi\n");
    seal(tally.text);
    check_refused(folder.text, (const char *const[]){"t", NULL}, "armtol: unknown option \"--verifi\"");
    file_write(tally.text, right.bytes);
    replace_in(tally.text, "word --degrees\n", "word --version\n");
    seal(tally.text);
    check_refused(folder.text, (const char *const[]){"t", NULL},
                  "armtol: t: the command in it is not the one that its arms");
}

/* The command is in the tally, and the arm that it names is not. */
static void test_an_arm_that_has_changed(void)
{
    const string folder = folder_new(), arm = path_in(folder.text, "arm.csv");
    const char *const question[] = {"arm.csv", "--joints", "0,.8,-1.6,0,.8,0", "--accuracy", "1,1,1,-,-,-",
                                    "--verify", "9", NULL};
    process shown;
    run_well(&shown, NULL, (const char *const[]){"puma560", "--show", NULL});
    file_write(arm.text, shown.output.bytes);
    draw_well(folder.text, question, "1/1", "1");
    run_well(&shown, NULL, (const char *const[]){"stanford", "--show", NULL});
    file_write(arm.text, shown.output.bytes);
    check_refused(folder.text, (const char *const[]){"1", NULL},
                  "1: the command in it asks now for another arm than when");
    TEST_ASSERT_EQUAL_INT(0, unlink(arm.text));
    check_refused(folder.text, (const char *const[]){"1", NULL}, "arm.csv: No such file or directory");
}

/* ---- a shard once more ---- */

static void test_what_is_there_is_kept(void)
{
    const string folder = folder_new(), tally = path_in(folder.text, "tally");
    static text before, after;
    process process;
    draw_well(folder.text, hundred, "2/4", "tally");
    file_read(tally.text, &before);
    draw(&process, folder.text, hundred, "2/4", "tally");
    process_check_status(&process, 0, "again");
    text_check("", 0, &process.errors, "again");
    const char said[] = "shard 2/4, arms 25 to 49 of 100: there already, tally\n";
    text_check(said, strlen(said), &process.output, "again");
    file_read(tally.text, &after);
    text_check(before.bytes, before.length, &after, "again");
}

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

static void test_what_is_something_else_is_drawn_anew(void)
{
    const string folder = folder_new(), tally = path_in(folder.text, "tally");
    draw_well(folder.text, hundred, "2/4", "tally");
    check_drawn_anew(folder.text, hundred, "3/4", "armtol: tally: another shard; it is drawn anew\n");
    check_drawn_anew(folder.text, (const char *const[]){ASKED, "--verify", "100", "--seed", "5", NULL}, "3/4",
                     "armtol: tally: another seed; it is drawn anew\n");
    TEST_ASSERT_EQUAL_INT(0, truncate(tally.text, 300));
    check_drawn_anew(folder.text, hundred, "3/4", "the tally is cut: its end is missing\n");
}

static void test_a_tally_of_another_version_is_drawn_anew(void)
{
    const string folder = folder_new(), tally = path_in(folder.text, "tally");
    draw_well(folder.text, hundred, "2/4", "tally");
    replace_in(tally.text, "version " TEST_VERSION, "version 9.9.9");
    seal(tally.text);
    check_drawn_anew(folder.text, hundred, "2/4", "armtol: tally: another version of armtol; it is drawn anew\n");
}

static void check_in_the_way(const char *folder, const char *name, int status, const char *words)
{
    process process;
    draw(&process, folder, hundred, "1/4", name);
    process_check_status(&process, status, name);
    text_check("", 0, &process.output, name);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(process.errors.bytes, words), process.errors.bytes);
}

static void test_what_is_in_the_way(void)
{
    const string folder = folder_new(), poem = path_in(folder.text, "poem");
    file_write(poem.text, "roses are red\n");
    folder_below(folder.text, "below");
    TEST_ASSERT_EQUAL_INT(0, mkfifo(path_in(folder.text, "fifo").text, 0600));
    check_in_the_way(folder.text, "poem", 2, "armtol: --tally: poem is in the way; expected no file, or a tally\n");
    file_check(poem.text, "roses are red\n", "poem");
    check_in_the_way(folder.text, "below", 1, "below: exists and is not a regular file\n");
    check_in_the_way(folder.text, "fifo", 1, "fifo: exists and is not a regular file\n");
    check_in_the_way(folder.text, "below/", 1, "armtol: below/: is no name of a file\n");
    check_in_the_way(folder.text, "nowhere/tally", 1, "armtol: output folder \"nowhere\": No such file or directory\n");
    const string longest = string_of("%0300d", 1), deep = string_of("%04200d/1", 1);
    check_in_the_way(folder.text, longest.text, 1, ": File name too long\n");
    check_in_the_way(folder.text, deep.text, 1, ": File name too long\n");
    draw_well(folder.text, hundred, "1/4", "below/tally");
    draw_well(folder.text, hundred, "2/4", path_in(folder.text, "absolute").text);
    folder_check(folder.text, "absolute below fifo poem", "in the way");
}

/* Links to what cannot be opened, or not be read. */
static void test_links_in_the_way(void)
{
    const string folder = folder_new();
    TEST_ASSERT_EQUAL_INT(0, symlink("endless", path_in(folder.text, "endless").text));
    TEST_ASSERT_EQUAL_INT(0, symlink(".", path_in(folder.text, "here").text));
    check_in_the_way(folder.text, "endless", 1, "armtol: endless: Too many levels of symbolic links\n");
    check_in_the_way(folder.text, "here", 1, "armtol: here: Is a directory\n");
}

/* The other end of a FIFO that is read by now: at most some seconds are waited for that. */
static int open_read_fifo(const char *path)
{
    const struct timespec moment = {0, 10000000};
    int descriptor = -1;
    for (int tries = 0; tries < 1000 && descriptor < 0; tries++) {
        descriptor = open(path, O_WRONLY | O_NONBLOCK);
        nanosleep(&moment, NULL);
    }
    TEST_ASSERT_TRUE(descriptor >= 0);
    return descriptor;
}

/* A folder comes into the place of the tally while it is looked at: nothing is replaced, and no draft is left. */
static void test_what_comes_into_the_way(void)
{
    static const char cut[] = "armtol tally 1\n";
    const string folder = folder_new(), fifo = path_in(folder.text, "fifo"), tally = path_in(folder.text, "t");
    static const char *const arguments[] = {ASKED, "--verify", "9", "--shard", "1/1", "--tally", "t", NULL};
    process process;
    const process_setup setup = {.program = TEST_ARMTOL, .arguments = arguments, .folder = folder.text};
    TEST_ASSERT_EQUAL_INT(0, mkfifo(fifo.text, 0600));
    TEST_ASSERT_EQUAL_INT(0, symlink("fifo", tally.text));
    process_start(&process, &setup);
    const int writer = open_read_fifo(fifo.text);
    TEST_ASSERT_EQUAL_INT(0, unlink(tally.text));
    folder_below(folder.text, "t");
    TEST_ASSERT_EQUAL_INT(strlen(cut), write(writer, cut, strlen(cut)));
    close(writer);
    process_finish(&process);
    process_check_status(&process, 1, "a folder");
    TEST_ASSERT_EQUAL_STRING("armtol: ./t: exists and is not a regular file", process_last_line(&process).text);
    folder_check(folder.text, "fifo t", "a folder");
}

/* Names as long as a file's may be have drafts that are shorter. */
static void test_a_long_name(void)
{
    const string folder = folder_new(), name = string_of("%0255d", 1);
    draw_well(folder.text, hundred, "1/1", name.text);
    folder_check(folder.text, name.text, "a long name");
}

/* ---- options ---- */

static void check_usage(const char *const arguments[], const char *words)
{
    process process;
    run(&process, NULL, arguments);
    process_check_status(&process, 2, words);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(process.errors.bytes, words), process.errors.bytes);
}

static void test_wrong_options(void)
{
    static const char *const wrong[] = {"0/4", "5/4", "1/0", "1", "/", "1/", "/4", "-1/4", "1/4/4", "1/1000001",
                                        "a/b", ""};
    const string endless = string_of("%04000d", 1);
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        check_usage((const char *const[]){ASKED, "--verify", "100", "--shard", wrong[i], "--tally", "t", NULL},
                    " is no shard; expected I/N, I from 1 to N and N at most 1000000\n");
    }
    check_usage((const char *const[]){ASKED, "--verify", "9", "--shard", endless.text, "--tally", "t", NULL},
                " is no shard;");
    check_usage((const char *const[]){ASKED, "--verify", "9", "--shard", "1/2", NULL},
                "--shard I/N and --tally FILE go together");
    check_usage((const char *const[]){ASKED, "--verify", "9", "--tally", "t", NULL},
                "--shard I/N and --tally FILE go together");
    check_usage((const char *const[]){ASKED, "--shard", "1/2", "--tally", "t", NULL},
                "together, with --verify N or armtol map\n");
    check_usage((const char *const[]){ASKED, "--verify", "9", "--shard", "1/10", "--tally", "t", NULL},
                "--shard: more shards than arms to draw\n");
}

/* The link turns about its own x, which moves no point of it, so that alpha has no bound, and wx none either. */
static void test_a_wish_without_a_bound(void)
{
    const string folder = folder_new();
    process process;
    file_write(path_in(folder.text, "arm.csv").text,
               "units: mm rad\njoint,kind,a,alpha,d,theta\ntheta,npr,100,0,0,0\n");
    file_write(path_in(folder.text, "t.csv").text, "link,parameter,tolerance\n0,theta,.001\n0,alpha,inf\n");
    draw(&process, folder.text, (const char *const[]){"arm.csv", "--joints", "0", "--tolerances", "t.csv", "--accuracy",
                                                      "1,1,1,.1,.1,.1", "--verify", "9", NULL}, "1/2", "t");
    process_check_status(&process, 2, "no bound");
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(process.errors.bytes,
                                        "armtol: --verify: the tolerances leave wx without a bound; "),
                                 process.errors.bytes);
    folder_check(folder.text, "arm.csv t.csv", "no bound");
}

/* What the reader would not take is not written. */
static void test_a_word_that_is_too_long(void)
{
    static char list[20000];
    const string folder = folder_new();
    process process;
    for (size_t i = 0; i + 12 < sizeof list; i += 8) {
        memcpy(list + i, "0.a<=.1,", 9);
    }
    list[strlen(list) - 1] = '\0';
    draw(&process, folder.text, (const char *const[]){ASKED, "--given", list, "--verify", "9", NULL}, "1/2", "t");
    process_check_status(&process, 2, "a long word");
    folder_check(folder.text, "", "a long word");
}

static void test_merge_has_help(void)
{
    process help, merge_help;
    run_well(&help, NULL, (const char *const[]){"--help", NULL});
    run_well(&merge_help, NULL, (const char *const[]){"merge", "--help", NULL});
    text_check(help.output.bytes, help.output.length, &merge_help.output, "merge --help");
    check_says(&help, "armtol merge FILE...");
}

/* ---- interrupted ---- */

static void test_an_interrupted_shard_writes_nothing(void)
{
    const string folder = folder_new();
    const struct timespec moment = {0, 300000000};
    process process;
    const process_setup setup = {
        .program = TEST_ARMTOL,
        .arguments = (const char *const[]){ASKED, "--verify", "100000000000", "--shard", "1/2", "--tally", "t", NULL},
        .folder = folder.text};
    process_start(&process, &setup);
    nanosleep(&moment, NULL);
    kill(process.id, SIGINT);
    process_finish(&process);
    process_check_status(&process, 1, "interrupted");
    const char said[] = "armtol: interrupted: no tally is written\n";
    text_check(said, strlen(said), &process.errors, "interrupted");
    folder_check(folder.text, "", "interrupted");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_any_split_of_text);
    RUN_TEST(test_any_split_of_json);
    RUN_TEST(test_any_split_of_loaded_arms);
    RUN_TEST(test_any_split_of_balls);
    RUN_TEST(test_an_arm_a_shard);
    RUN_TEST(test_words_that_are_hard_to_write);
    RUN_TEST(test_missing_and_doubled);
    RUN_TEST(test_foreign_tallies);
    RUN_TEST(test_another_accuracy);
    RUN_TEST(test_cut_damaged_and_other_files);
    RUN_TEST(test_a_tally_of_another_version);
    RUN_TEST(test_a_command_that_is_not_the_tally_s);
    RUN_TEST(test_an_arm_that_has_changed);
    RUN_TEST(test_what_is_there_is_kept);
    RUN_TEST(test_what_is_something_else_is_drawn_anew);
    RUN_TEST(test_what_is_in_the_way);
    RUN_TEST(test_a_tally_of_another_version_is_drawn_anew);
    RUN_TEST(test_links_in_the_way);
    RUN_TEST(test_what_comes_into_the_way);
    RUN_TEST(test_a_long_name);
    RUN_TEST(test_wrong_options);
    RUN_TEST(test_a_wish_without_a_bound);
    RUN_TEST(test_a_word_that_is_too_long);
    RUN_TEST(test_merge_has_help);
    RUN_TEST(test_an_interrupted_shard_writes_nothing);
    return UNITY_END();
}
