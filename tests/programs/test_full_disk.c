/*
 * A disk that takes no more: a limit on the size of files, set from the start or during the run, and file
 * systems that are full or read-only. These are mounted where nobody else sees them, which not every machine
 * allows.
 */

#define _GNU_SOURCE /* prlimit, unshare */

#include "programs/programs.h"

#include "unity.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef __linux__
#include <sched.h>
#include <sys/mount.h>
#endif

/* Where a test has mounted something; "" where it has not. */
static string mounted;

void setUp(void)
{
    mounted.text[0] = '\0';
}

void tearDown(void)
{
#ifdef __linux__
    if (mounted.text[0] != '\0') {
        umount2(mounted.text, MNT_DETACH);
    }
#endif
    process_clean_up();
}

/* ---- a limit on the size of files ---- */

static off_t size_of_golden(const tested *program, int file)
{
    const string name = string_of("%s.1", program->files[file]);
    const string golden = golden_of(golden_1987, program, 1, name.text);
    struct stat status;
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, stat(golden.text, &status), golden.text);
    return status.st_size;
}

/*
 * The files from `first` on could not be written: the last message names one of them, they are as they were,
 * and those before them are new. Old files were there or not.
 */
static void check_failed(const process *process, const tested *program, int first, int named, bool old,
                         const char *folder, const char *what)
{
    const string words = string_of("%s.1: ", program->files[named]);
    const string listing = listing_of(program, old ? 2 : first / 2, 1);
    process_check_status(process, 1, what);
    check_message(process, program, words.text, what);
    folder_check(folder, listing.text, what);
    check_golden(folder, 1, program, golden_1987, 1, first, what);
    check_old_files(folder, program, first, old ? FILES : first, what);
}

static void check_right(const process *process, const tested *program, const char *folder, const char *what)
{
    const string listing = listing_of(program, 2, 1);
    process_check_status(process, 0, what);
    folder_check(folder, listing.text, what);
    check_golden(folder, 1, program, golden_1987, 1, FILES, what);
}

/* A and A reordered are of one size, and the largest of the four. */
static void check_limited_run(const tested *program, off_t limit, bool old)
{
    const string what =
        string_of("%s, files limited to %ld, %s", program->name, (long)limit, old ? "old" : "new");
    const string folder = folder_new(), input = right_answers(program);
    const process_setup setup = {
        .program = program->path, .folder = folder.text, .largest_file = (rlim_t)limit};
    process process;
    if (old) {
        write_old_files(folder.text, program);
    }
    process_run(&process, &setup, input.text);
    if (limit < size_of_golden(program, FILE_A)) {
        check_failed(&process, program, FILE_A, FILE_A, old, folder.text, what.text);
    } else {
        check_right(&process, program, folder.text, what.text);
    }
}

static void test_files_limited_from_the_start(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const off_t size = size_of_golden(&programs[i], FILE_A);
        const off_t limits[] = {1, 71, 72, 512, 1024, size - 72, size - 1, size, size + 1, 4096};
        for (size_t j = 0; j < sizeof limits / sizeof limits[0]; j++) {
            check_limited_run(&programs[i], limits[j], false);
            check_limited_run(&programs[i], limits[j], true);
        }
    }
}

#ifdef __linux__

/* Up to the last question; then the files of tolerances are limited. */
static void start_and_limit(process *process, const tested *program, const char *folder, off_t limit)
{
    const struct rlimit limits = {(rlim_t)limit, (rlim_t)limit};
    const process_setup setup = {.program = program->path, .folder = folder};
    start_up_to(process, &setup, program, QUESTION_DELTA);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, prlimit(process->id, RLIMIT_FSIZE, &limits, NULL), strerror(errno));
}

static void check_limited_end(const tested *program, off_t limit, bool old)
{
    const string what =
        string_of("%s, last files limited to %ld, %s", program->name, (long)limit, old ? "old" : "new");
    const string folder = folder_new();
    process process;
    if (old) {
        write_old_files(folder.text, program);
    }
    start_and_limit(&process, program, folder.text, limit);
    say_answers(&process, program, QUESTION_DELTA, QUESTIONS);
    process_finish(&process);
    if (limit < size_of_golden(program, FILE_TOLERANCES)) {
        check_failed(&process, program, FILE_TOLERANCES, FILE_TOLERANCES, old, folder.text, what.text);
    } else if (limit < size_of_golden(program, FILE_MACHINING)) {
        check_failed(&process, program, FILE_TOLERANCES, FILE_MACHINING, old, folder.text, what.text);
    } else {
        check_right(&process, program, folder.text, what.text);
    }
}

static void test_files_limited_after_the_first_two(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const off_t one = size_of_golden(&programs[i], FILE_TOLERANCES);
        const off_t other = size_of_golden(&programs[i], FILE_MACHINING);
        const off_t limits[] = {0, 1, 100, one - 1, one, one + 1, other - 1, other, other + 1};
        for (size_t j = 0; j < sizeof limits / sizeof limits[0]; j++) {
            check_limited_end(&programs[i], limits[j], false);
            check_limited_end(&programs[i], limits[j], true);
        }
    }
}

/* Nor is a part of a file left where even the message about it cannot be written. */
static void test_limit_that_nobody_can_be_told_of(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        for (int file = FILE_TOLERANCES; file < FILES; file++) {
            const string what = string_of("%s, %s", programs[i].name, programs[i].files[file]);
            const string folder = folder_new(), listing = listing_of(&programs[i], 1, 1);
            process process;
            start_and_limit(&process, &programs[i], folder.text, size_of_golden(&programs[i], file) - 1);
            process_close_errors(&process);
            say_answers(&process, &programs[i], QUESTION_DELTA, QUESTIONS);
            process_finish(&process);
            folder_check(folder.text, listing.text, what.text);
        }
    }
}

/* ---- file systems of the test's own ---- */

/* A file under /proc takes what it is given in one piece or not at all. */
static bool write_proc(const char *file, const char *content)
{
    const int descriptor = open(file, O_WRONLY | O_CLOEXEC);
    const bool written = descriptor >= 0 && write(descriptor, content, strlen(content)) > 0;
    if (descriptor >= 0) {
        close(descriptor);
    }
    return written;
}

/* Become able to mount, unseen by others: root as it is, anyone else as the root of a namespace. */
static bool enter_namespace(void)
{
    if (geteuid() == 0) {
        return unshare(CLONE_NEWNS) == 0 && mount("none", "/", NULL, MS_REC | MS_PRIVATE, NULL) == 0;
    }
    const string users = string_of("0 %lu 1\n", (unsigned long)geteuid());
    const string groups = string_of("0 %lu 1\n", (unsigned long)getegid());
    return unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0 && write_proc("/proc/self/setgroups", "deny") &&
           write_proc("/proc/self/uid_map", users.text) && write_proc("/proc/self/gid_map", groups.text);
}

/* A file system in a new folder, or the test is ignored. */
static string mount_new(unsigned long flags, const char *options)
{
    static bool entered;
    const string folder = folder_new();
    entered = entered || enter_namespace();
    if (!entered || mount("tmpfs", folder.text, "tmpfs", flags, options) < 0) {
        const string why = string_of("no file system can be mounted here: %s", strerror(errno));
        process_ignore_test(why.text);
    }
    mounted = folder;
    return folder;
}

/* A run on a disk with room for so many files, at a page each, beside the old ones where there are any. */
static void check_full_disk(const tested *program, int room, bool old)
{
    const long page = sysconf(_SC_PAGESIZE);
    const string options = string_of("size=%ld", (room + (old ? FILES : 0)) * page);
    const string what = string_of("%s, room for %d files, %s", program->name, room, old ? "old" : "new");
    const string folder = mount_new(0, options.text), input = right_answers(program);
    process process;
    if (old) {
        write_old_files(folder.text, program);
    }
    run_in(folder.text, program, NULL, input.text, &process);
    /* what old files held is free again once new ones have taken their place */
    const int more = old ? 0 : FILE_TOLERANCES;
    if (room < 2) {
        check_failed(&process, program, FILE_A, room, old, folder.text, what.text);
    } else if (room < 2 + more) {
        check_failed(&process, program, FILE_TOLERANCES, room, old, folder.text, what.text);
    } else {
        check_right(&process, program, folder.text, what.text);
    }
    umount2(folder.text, MNT_DETACH);
}

static void test_full_disk(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        /* tmpfs takes a size of 0 for no limit */
        for (int room = 1; room <= FILES + 1; room++) {
            check_full_disk(&programs[i], room, false);
        }
        for (int room = 0; room <= 3; room++) {
            check_full_disk(&programs[i], room, true);
        }
    }
}

/* There is room, but for no more files: 1 for the folder itself, then the files. */
static void test_no_room_for_more_files(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        for (int room = 0; room <= FILES; room++) {
            const string options = string_of("size=1m,nr_inodes=%d", 1 + room);
            const string what = string_of("%s, room for %d inodes", programs[i].name, room);
            const string folder = mount_new(0, options.text), input = right_answers(&programs[i]);
            process process;
            run_in(folder.text, &programs[i], NULL, input.text, &process);
            if (room < FILES) {
                check_failed(&process, &programs[i], room < 2 ? FILE_A : FILE_TOLERANCES, room, false,
                             folder.text, what.text);
            } else {
                check_right(&process, &programs[i], folder.text, what.text);
            }
            umount2(folder.text, MNT_DETACH);
        }
    }
}

/* Root, whom no permission stops, is told before anything is asked. */
static void test_read_only_disk(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = mount_new(MS_RDONLY, ""), input = right_answers(&programs[i]);
        const string only =
            string_of("%s: output folder \".\": not writable: Read-only file system\n", programs[i].name);
        process process;
        run_in(folder.text, &programs[i], NULL, input.text, &process);
        process_check_status(&process, 1, programs[i].name);
        TEST_ASSERT_EQUAL_STRING(only.text, process.errors.bytes);
        umount2(folder.text, MNT_DETACH);
    }
}

#else

static void test_files_limited_after_the_first_two(void)
{
    process_ignore_test("limits of a running process are Linux's");
}

static void test_limit_that_nobody_can_be_told_of(void)
{
    process_ignore_test("limits of a running process are Linux's");
}

static void test_full_disk(void)
{
    process_ignore_test("mounts that nobody else sees are Linux's");
}

static void test_no_room_for_more_files(void)
{
    process_ignore_test("mounts that nobody else sees are Linux's");
}

static void test_read_only_disk(void)
{
    process_ignore_test("mounts that nobody else sees are Linux's");
}

#endif

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_files_limited_from_the_start);
    RUN_TEST(test_files_limited_after_the_first_two);
    RUN_TEST(test_limit_that_nobody_can_be_told_of);
    /* from here on in a namespace */
    RUN_TEST(test_full_disk);
    RUN_TEST(test_no_room_for_more_files);
    RUN_TEST(test_read_only_disk);
    return UNITY_END();
}
