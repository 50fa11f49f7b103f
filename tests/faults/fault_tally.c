/*
 * A shard whose tally cannot be written, and a merge of tallies: a disk that is full after every number of bytes, every
 * call failing (the rename among them), a kill before every call, memory that runs out. The tally is the new one,
 * whole, or what was there before.
 */

#include "faults/commands.h"

#include "unity.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define ASKED "puma560", "--joints", "0,45,-90,0,45,0", "--degrees", "--accuracy", ".5,.5,.5,.01,.01,.01", \
              "--verify", "4", "--threads", "1"

#define MAP "map", "scara", "--plane", "xy", "--range", "300..700,0..100", "--offset", "300", "--grid", "2,2", \
            "--tolerances", "lengths=.1"

/* What is asked, in shards: of arms, and of rows of a map. */
typedef struct asked {
    const char *const *shard, *const *second, *const *other; /* the first, the second, the first of another question */
} asked;

static const asked questions[] = {
    {(const char *const[]){ASKED, "--shard", "1/2", "--tally", "one", NULL},
     (const char *const[]){ASKED, "--shard", "2/2", "--tally", "two", NULL},
     (const char *const[]){ASKED, "--seed", "5", "--shard", "1/2", "--tally", "one", NULL}},
    {(const char *const[]){MAP, "--shard", "1/2", "--tally", "one", NULL},
     (const char *const[]){MAP, "--shard", "2/2", "--tally", "two", NULL},
     (const char *const[]){MAP, "--of", "dx", "--shard", "1/2", "--tally", "one", NULL}},
};
enum { KINDS = sizeof questions / sizeof questions[0] };

static const char *const merge[] = {"merge", "one", "two", NULL};

void setUp(void)
{
}

void tearDown(void)
{
    faulted_end();
    process_clean_up();
}

/* ---- the tally ---- */

static text old_tally, new_tally;

typedef enum state { STATE_NONE, STATE_OLD, STATE_NEW } state;

static bool is_same(const text *one, const text *other)
{
    return one->length == other->length && memcmp(one->bytes, other->bytes, one->length) == 0;
}

/* In a folder where drafts may be, or may not. */
static state state_of(const char *folder, bool drafts, const char *what)
{
    const string path = string_of("%s/one", folder);
    static text found, names;
    folder_list(folder, &names);
    if (!drafts) {
        TEST_ASSERT_NULL_MESSAGE(strstr(names.bytes, ".part"), what);
    }
    if (access(path.text, F_OK) != 0) {
        return STATE_NONE;
    }
    file_read(path.text, &found);
    if (!is_same(&found, &new_tally) && !is_same(&found, &old_tally)) {
        fail_with("%s: a tally of %zu bytes is neither the old one nor the new one", what, found.length);
    }
    return is_same(&found, &new_tally) ? STATE_NEW : STATE_OLD;
}

static void put_back(const char *folder, bool old)
{
    const string path = string_of("%s/one", folder);
    if (old) {
        file_write(path.text, old_tally.bytes);
    } else {
        unlink(path.text);
    }
}

static void run_once(const char *folder, const char *const arguments[])
{
    const process_setup setup = {.program = TEST_ARMTOL, .arguments = arguments, .folder = folder};
    process process;
    process_run(&process, &setup, "");
    process_check_status(&process, 0, arguments[0]);
}

/* A folder with both shards, and the program started for the first one's. The old tally is another question's. */
static string start_shard(const asked *asked)
{
    const string folder = folder_new(), path = string_of("%s/one", folder.text);
    run_once(folder.text, asked->other);
    file_read(path.text, &old_tally);
    unlink(path.text);
    run_once(folder.text, asked->shard);
    file_read(path.text, &new_tally);
    faulted_start(&(faulted_setup){.program = TEST_ARMTOL, .arguments = asked->shard, .folder = folder.text});
    return folder;
}

/* Whether the tally is new, which the status tells; a line for standard output may fail behind it. */
static state check_run(const faulted_run *run, const char *folder, bool old, const char *what)
{
    const state state = state_of(folder, false, what);
    TEST_ASSERT_TRUE_MESSAGE(run->outcome.ended && run->outcome.live == 0 && run->status <= 1, what);
    TEST_ASSERT_TRUE_MESSAGE(state == STATE_NEW || state == (old ? STATE_OLD : STATE_NONE), what);
    TEST_ASSERT_TRUE_MESSAGE(state == STATE_NEW || run->status == 1, what);
    if (state == STATE_NEW && run->status == 1) {
        faulted_check_message(run, "armtol", "cannot write to standard output", what);
    }
    return state;
}

static void fill_disk(const asked *asked)
{
    static faulted_run run;
    const string folder = start_shard(asked);
    for (long room = 0; room <= (long)new_tally.length; room++) {
        const bool old = room % 2 == 0;
        const string what = string_of("room for %ld bytes", room);
        put_back(folder.text, old);
        faulted_try(&(fault){.disk_full = true, .disk_room = room}, &run);
        const state state = check_run(&run, folder.text, old, what.text);
        TEST_ASSERT_TRUE_MESSAGE((state == STATE_NEW) == (room == (long)new_tally.length), what.text);
        if (state != STATE_NEW) {
            faulted_check_message(&run, "armtol", "/one: No space left on device", what.text);
        }
    }
    printf("armtol, a tally: disk full after 0 to %zu bytes\n", new_tally.length);
}

static void test_disk_full_after_every_byte(void)
{
    for (int i = 0; i < KINDS; i++) {
        fill_disk(&questions[i]);
    }
}

static void fail_calls(const asked *asked)
{
    static const int errors[] = {EIO, ENOSPC, EDQUOT, EROFS, EACCES};
    static faulted_run run;
    const string folder = start_shard(asked);
    long calls = 0, kept = 0;
    for (size_t j = 0; j < sizeof errors / sizeof errors[0]; j++) {
        long n = 0;
        do {
            const string what = string_of("call %ld: %s", ++n, strerror(errors[j]));
            put_back(folder.text, true);
            faulted_try(&(fault){.call = n, .action = ACTION_ERROR, .number = errors[j]}, &run);
            kept += check_run(&run, folder.text, true, what.text) == STATE_OLD;
        } while (run.outcome.happened);
        TEST_ASSERT_EQUAL_INT(0, run.status);
        calls += n - 1;
    }
    TEST_ASSERT_TRUE(kept >= 4 * 5); /* open, write, fsync, rename at least */
    printf("armtol, a tally: %ld failing calls, the old one kept after %ld of them\n", calls, kept);
}

static void test_every_call_fails(void)
{
    for (int i = 0; i < KINDS; i++) {
        fail_calls(&questions[i]);
    }
}

static void kill_at_calls(const asked *asked)
{
    static faulted_run run;
    const string folder = start_shard(asked);
    for (int action = ACTION_KILL; action <= ACTION_HALF_KILL; action++) {
        long n = 0;
        do {
            const string what = string_of("killed at call %ld", ++n);
            put_back(folder.text, n % 2 == 0);
            faulted_try(&(fault){.call = n, .action = (fault_action)action}, &run);
            state_of(folder.text, true, what.text);
            TEST_ASSERT_EQUAL_INT_MESSAGE(run.outcome.happened ? 128 + SIGKILL : 0, run.status, what.text);
            /* the next run has it, whatever a killed one left */
            const bool happened = run.outcome.happened;
            faulted_try(&(fault){0}, &run);
            TEST_ASSERT_TRUE_MESSAGE(run.status == 0 && state_of(folder.text, true, what.text) == STATE_NEW, what.text);
            run.outcome.happened = happened;
        } while (run.outcome.happened);
    }
}

static void test_killed_before_every_call(void)
{
    for (int i = 0; i < KINDS; i++) {
        kill_at_calls(&questions[i]);
    }
}

/* ---- memory ---- */

static void lack_memory(const char *folder, bool all_after, bool writes)
{
    static faulted_run run;
    long n = 0;
    do {
        const string what = string_of("allocation %ld%s", ++n, all_after ? " and all after" : "");
        if (writes) {
            put_back(folder, n % 2 == 0);
        }
        faulted_try(&(fault){.allocation = n, .all_after = all_after}, &run);
        TEST_ASSERT_TRUE_MESSAGE(run.outcome.ended && run.status <= 1, what.text);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.outcome.live, what.text);
        if (run.status == 1) {
            faulted_check_message(&run, "armtol", "memory", what.text);
        }
    } while (run.outcome.happened);
    TEST_ASSERT_EQUAL_INT(0, run.status);
    TEST_ASSERT_TRUE(n > 10);
}

static void run_out_of_memory(const asked *asked)
{
    const string folder = start_shard(asked);
    lack_memory(folder.text, false, true);
    lack_memory(folder.text, true, true);
    lack_memory(folder.text, false, false); /* the tally is there */
    run_once(folder.text, asked->second);
    faulted_start(&(faulted_setup){.program = TEST_ARMTOL, .arguments = merge, .folder = folder.text});
    lack_memory(folder.text, false, false);
    lack_memory(folder.text, true, false);
}

static void test_memory_runs_out(void)
{
    for (int i = 0; i < KINDS; i++) {
        run_out_of_memory(&questions[i]);
    }
}

/* ---- reading ---- */

static void check_strange(const char *folder, const char *name, int status, const char *words)
{
    enum { MEMORY = 24 << 20 };
    static faulted_run run;
    faulted_start(&(faulted_setup){
        .program = TEST_ARMTOL, .arguments = (const char *const[]){"merge", name, NULL}, .folder = folder});
    faulted_try(&(fault){.memory = MEMORY}, &run);
    TEST_ASSERT_EQUAL_INT_MESSAGE(status, run.status, name);
    faulted_check_message(&run, "armtol", words, name);
}

/* Files without an end, and what is no file: little memory is taken, and little time. */
static void test_strange_files_to_be_merged(void)
{
    const string folder = folder_new(), zeros = string_of("%s/zeros", folder.text);
    file_write(zeros.text, "");
    TEST_ASSERT_EQUAL_INT(0, truncate(zeros.text, (off_t)4 << 30));
    check_strange(folder.text, "zeros", 2, "zeros:1:1: this is no tally of this armtol");
    check_strange(folder.text, "/dev/zero", 2, "/dev/zero:1:1: this is no tally of this armtol");
    check_strange(folder.text, "/dev/null", 2, "/dev/null:1:1: this is no tally of this armtol");
    check_strange(folder.text, ".", 2, ".: Is a directory");
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_disk_full_after_every_byte);
    RUN_TEST(test_every_call_fails);
    RUN_TEST(test_killed_before_every_call);
    RUN_TEST(test_memory_runs_out);
    RUN_TEST(test_strange_files_to_be_merged);
    printf("%ld runs\n", faulted_count());
    return UNITY_END();
}
