/*
 * What can go wrong beside the input: folders, names, signals, a standard error that nobody reads. A file
 * appears whole or not at all, what was there before a failed run is still there, and nothing else is left.
 */

#include "programs/programs.h"

#include "unity.h"

#include <limits.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

void setUp(void)
{
    umask(022);
}

void tearDown(void)
{
    process_clean_up();
}

/* ---- folders that take no files ---- */

/* The run fails before it asks anything. */
static void check_fails_at_once(const process *process, const tested *program, const char *words,
                                const char *what)
{
    process_check_status(process, 1, what);
    check_message(process, program, words, what);
    TEST_ASSERT_TRUE_MESSAGE(strstr(process->errors.bytes, "enter desired") == NULL, what);
}

static void test_folders_that_are_none(void)
{
    static const char *const names[] = {"nowhere",    "nowhere/below", "file", "file/",
                                        "file/below", "dangling",      ""};
    for (int i = 0; i < PROGRAMS; i++) {
        const string here = folder_new(), file = string_of("%s/file", here.text);
        const string dangling = string_of("%s/dangling", here.text);
        file_write(file.text, "a file\n");
        TEST_ASSERT_EQUAL_INT(0, symlink("nowhere", dangling.text));
        for (size_t j = 0; j < sizeof names / sizeof names[0]; j++) {
            const char *const arguments[] = {"--output", names[j], NULL};
            const string what = command_of(&programs[i], arguments), input = right_answers(&programs[i]);
            const string words = string_of("output folder \"%s\": ", names[j]);
            process process;
            run_in(here.text, &programs[i], arguments, input.text, &process);
            check_fails_at_once(&process, &programs[i], words.text, what.text);
            folder_check(here.text, "dangling file", what.text);
        }
        file_check(file.text, "a file\n", programs[i].name);
    }
}

/* A name is shown, and a terminal that shows it does not obey it: ESC, DEL, and CSI as UTF-8 writes it. */
static void test_a_folder_whose_name_a_terminal_may_obey(void)
{
    static const struct {
        const char *name, *shown;
    } rows[] = {
        {"\033[31mno", "output folder \"?[31mno\": "},
        {"a\177b", "output folder \"a?b\": "},
        {"a\302\23331mb", "output folder \"a??31mb\": "},
        {"na\303\257ve", "output folder \"na\303\257ve\": "},
    };
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof rows / sizeof rows[0]; j++) {
            const char *const arguments[] = {"--output", rows[j].name, NULL};
            const string here = folder_new(), input = right_answers(&programs[i]);
            process process;
            run_in(here.text, &programs[i], arguments, input.text, &process);
            check_fails_at_once(&process, &programs[i], rows[j].shown, rows[j].shown);
        }
    }
}

/* Permissions do not bind root, so that a test of root's runs the programs as another user, nobody. */
static uid_t ordinary_user(void)
{
    const process_setup setup = {
        .program = programs[0].path, .arguments = (const char *const[]){"--version", NULL}, .user = 65534};
    if (geteuid() != 0) {
        return 0;
    }
    process process;
    process_run(&process, &setup, "");
    if (process.status != 0) {
        process_ignore_test("this is root, and running a program as another user is not possible here");
    }
    return setup.user;
}

static void test_folders_without_permission(void)
{
    static const mode_t modes[] = {0555, 0444, 0666, 0000};
    const uid_t user = ordinary_user();
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof modes / sizeof modes[0]; j++) {
            const string what = string_of("%s, folder of mode %o", programs[i].name, (unsigned)modes[j]);
            const string here = folder_new(), out = folder_below(here.text, "out");
            const string input = right_answers(&programs[i]);
            const process_setup setup = {.program = programs[i].path,
                                         .arguments = (const char *const[]){"-o", "out", NULL},
                                         .folder = here.text,
                                         .user = user};
            process process;
            TEST_ASSERT_EQUAL_INT(0, chmod(out.text, modes[j]));
            process_run(&process, &setup, input.text);
            check_fails_at_once(&process, &programs[i], "output folder \"out\": ", what.text);
            TEST_ASSERT_EQUAL_INT(0, chmod(out.text, 0755));
            folder_check(out.text, "", what.text);
        }
    }
}

/* ---- folders with unusual names ---- */

static void check_writes_into(const char *here, const char *name, const char *folder)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const char *const arguments[] = {"-o", name, NULL};
        const string what = string_of("%s, folder %.300s", programs[i].name, name);
        const string input = right_answers(&programs[i]), listing = listing_of(&programs[i], 2, 1);
        const string other = listing_of(&programs[1 - i], 2, 1);
        process process;
        run_in(here, &programs[i], arguments, input.text, &process);
        process_check_status(&process, 0, what.text);
        const string both = string_of("%s %s", listing.text, other.text);
        folder_check(folder, i == 0 ? listing.text : both.text, what.text);
    }
}

static void test_folders_with_unusual_names(void)
{
    static const char *const names[] = {
        " two  words ", "\xc3\xbc\xe2\x82\xac", "it's \"quoted\"", "-r", "%s%n", "a\\b", "*", "$HOME", "~"};
    const string here = folder_new();
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const string folder = folder_below(here.text, names[i]);
        check_writes_into(here.text, names[i], folder.text);
    }
}

/* Folders within folders, down to a path of that length. */
static string deep_folder(size_t length)
{
    string folder = folder_new();
    while (strlen(folder.text) < length) {
        char name[256] = "";
        const size_t left = length - strlen(folder.text), size = left > 250 ? 200 : left;
        memset(name, 'd', size - 1);
        const string below = folder_below(folder.text, name);
        folder = below;
    }
    return folder;
}

/* The longest name, the longest path, and paths that get too long with a file's name after them. */
static void test_folders_with_long_names(void)
{
#if defined PATH_MAX && PATH_MAX <= 4096
    static const size_t lengths[] = {PATH_MAX - 200, PATH_MAX - 20, PATH_MAX - 8, PATH_MAX - 1};
    char longest[NAME_MAX + 1] = "";
    memset(longest, 'n', NAME_MAX);
    const string here = folder_new(), wide = folder_below(here.text, longest);
    check_writes_into(here.text, longest, wide.text);
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        const string deep = deep_folder(lengths[i]);
        check_writes_into(here.text, deep.text, deep.text);
    }
#else
    process_ignore_test("the longest path is not known here");
#endif
}

static void test_folders_with_names_that_are_too_long(void)
{
    static const int lengths[] = {300, 4096, 4300};
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof lengths / sizeof lengths[0]; j++) {
            const string name = string_of("%0*d", lengths[j], 1), folder = folder_new();
            const char *const arguments[] = {"-o", name.text, NULL};
            process process;
            run_in(folder.text, &programs[i], arguments, "", &process);
            /* its last line is longer than a string may be */
            process_check_status(&process, 1, "a name that is too long");
            TEST_ASSERT_TRUE(strstr(process.errors.bytes, ": output folder \"0") != NULL);
        }
    }
}

/* ---- names that are taken ---- */

static void make_entry(const char *name, mode_t kind)
{
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, kind == S_IFDIR ? mkdir(name, 0777) : mkfifo(name, 0666), name);
}

/* A file's name is a folder's or a FIFO's: that stays, its companion keeps what it held, no run waits for it.
 */
static void check_taken_name(const tested *program, int file, mode_t kind)
{
    const string folder = folder_new(), input = right_answers(program), listing = listing_of(program, 2, 1);
    const string words = string_of("%s.1: ", program->files[file]);
    const string name = file_of(folder.text, program, file);
    const string what =
        string_of("%s, %s is a %s", program->name, program->files[file], kind == S_IFDIR ? "folder" : "FIFO");
    const int companion = file ^ 1;
    process process;
    struct stat status;
    write_old_files(folder.text, program);
    TEST_ASSERT_EQUAL_INT(0, unlink(name.text));
    make_entry(name.text, kind);
    run_in(folder.text, program, NULL, input.text, &process);
    process_check_status(&process, 1, what.text);
    check_message(&process, program, words.text, what.text);
    folder_check(folder.text, listing.text, what.text);
    TEST_ASSERT_EQUAL_INT(0, lstat(name.text, &status));
    TEST_ASSERT_TRUE_MESSAGE((status.st_mode & S_IFMT) == kind, what.text);
    check_old_files(folder.text, program, companion, companion + 1, what.text);
    if (file < FILE_TOLERANCES) {
        check_old_files(folder.text, program, FILE_TOLERANCES, FILES, what.text);
    } else {
        check_golden(folder.text, 1, program, golden_1987, 1, FILE_TOLERANCES, what.text);
    }
}

static void test_names_that_are_taken(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        for (int file = 0; file < FILES; file++) {
            check_taken_name(&programs[i], file, S_IFDIR);
            check_taken_name(&programs[i], file, S_IFIFO);
        }
    }
}

/* ---- files that are there, and modes ---- */

/* Longer ones, and ones that nobody may write to: a new file takes their place. */
static void test_existing_files_are_replaced(void)
{
    string old;
    memset(old.text, 'x', sizeof old.text - 1);
    old.text[sizeof old.text - 1] = '\0';
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new(), input = right_answers(&programs[i]);
        const string listing = listing_of(&programs[i], 2, 1);
        process process;
        for (int j = 0; j < FILES; j++) {
            const string name = file_of(folder.text, &programs[i], j);
            file_write(name.text, old.text);
            TEST_ASSERT_EQUAL_INT(0, chmod(name.text, 0444));
        }
        run_in(folder.text, &programs[i], NULL, input.text, &process);
        process_check_status(&process, 0, programs[i].name);
        folder_check(folder.text, listing.text, programs[i].name);
        check_golden(folder.text, 1, &programs[i], golden_1987, 1, FILES, programs[i].name);
    }
}

static void test_modes_follow_umask(void)
{
    static const mode_t masks[] = {0, 002, 022, 027, 077};
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof masks / sizeof masks[0]; j++) {
            const string folder = folder_new(), input = right_answers(&programs[i]);
            process process;
            umask(masks[j]);
            run_in(folder.text, &programs[i], NULL, input.text, &process);
            umask(022);
            for (int k = 0; k < FILES; k++) {
                const string name = file_of(folder.text, &programs[i], k);
                struct stat status;
                TEST_ASSERT_EQUAL_INT_MESSAGE(0, stat(name.text, &status), name.text);
                TEST_ASSERT_EQUAL_HEX_MESSAGE(0666 & ~masks[j], status.st_mode & 07777, name.text);
            }
        }
    }
}

/* ---- a folder that goes ---- */

static void test_folder_is_removed_during_the_run(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const tested *program = &programs[i];
        const string here = folder_new(), out = folder_below(here.text, "out");
        const process_setup setup = {
            .program = program->path, .arguments = (const char *const[]){"-oout", NULL}, .folder = here.text};
        const string words = string_of("%s.1: ", program->files[FILE_TOLERANCES]);
        process process;
        start_up_to(&process, &setup, program, QUESTION_DELTA);
        for (int file = FILE_A; file < FILE_TOLERANCES; file++) {
            const string name = file_of(out.text, program, file);
            TEST_ASSERT_EQUAL_INT_MESSAGE(0, unlink(name.text), name.text);
        }
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, rmdir(out.text), program->name);
        say_answers(&process, program, QUESTION_DELTA, QUESTIONS);
        process_finish(&process);
        process_check_status(&process, 1, program->name);
        check_message(&process, program, words.text, program->name);
        folder_check(here.text, "", program->name);
    }
}

/* ---- signals ---- */

static void test_signals_at_a_prompt(void)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGKILL};
    for (int i = 0; i < PROGRAMS; i++) {
        for (int question = 0; question < QUESTIONS; question++) {
            for (size_t j = 0; j < sizeof signals / sizeof signals[0]; j++) {
                const string what =
                    string_of("%s, signal %d at question %d", programs[i].name, signals[j], question);
                const string folder = folder_new();
                const string listing = listing_of(&programs[i], question > QUESTION_WISH ? 1 : 0, 1);
                const process_setup setup = {.program = programs[i].path, .folder = folder.text};
                process process;
                start_up_to(&process, &setup, &programs[i], question);
                kill(process.id, signals[j]);
                process_finish(&process);
                process_check_status(&process, 128 + signals[j], what.text);
                folder_check(folder.text, listing.text, what.text);
            }
        }
    }
}

static void test_interrupt_on_a_terminal(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new(), listing = listing_of(&programs[i], 1, 1);
        const process_setup setup = {
            .program = programs[i].path, .folder = folder.text, .wires = ALL_ON_TERMINAL};
        process process;
        start_up_to(&process, &setup, &programs[i], QUESTION_DELTA);
        process_say(&process, ".1\003");
        process_finish(&process);
        process_check_status(&process, 128 + SIGINT, programs[i].name);
        folder_check(folder.text, listing.text, programs[i].name);
    }
}

/* Nothing, the files of A, or all four: and those whole. */
static void check_whole_files(const char *folder, const tested *program, const char *what)
{
    text names;
    folder_list(folder, &names);
    for (int pairs = 0; pairs <= 2; pairs++) {
        const string listing = listing_of(program, pairs, 1);
        if (strcmp(listing.text, names.bytes) == 0) {
            check_golden(folder, 1, program, golden_1987, 1, 2 * pairs, what);
            return;
        }
    }
    fail_with("%s: left the files \"%s\"", what, names.bytes);
}

/* How long a right run takes, in nanoseconds. */
static long time_of_run(const tested *program)
{
    const string folder = folder_new(), input = right_answers(program);
    struct timespec before, after;
    process process;
    clock_gettime(CLOCK_MONOTONIC, &before);
    run_in(folder.text, program, NULL, input.text, &process);
    clock_gettime(CLOCK_MONOTONIC, &after);
    return (after.tv_sec - before.tv_sec) * 1000000000 + after.tv_nsec - before.tv_nsec;
}

/* SIGTERM a little later each time, from before the first file until after the last. */
static void test_signals_at_any_time(void)
{
    enum { TIMES = 80 };
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new(), input = right_answers(&programs[i]);
        const process_setup setup = {.program = programs[i].path, .folder = folder.text};
        const long step = time_of_run(&programs[i]) * 5 / (4 * TIMES);
        for (int j = 0; j < TIMES; j++) {
            const struct timespec later = {j * step / 1000000000, j * step % 1000000000};
            process process;
            process_start(&process, &setup);
            process_say(&process, input.text);
            nanosleep(&later, NULL);
            kill(process.id, SIGTERM);
            process_finish(&process);
            TEST_ASSERT_TRUE(process.status == 0 || process.status == 128 + SIGTERM);
            check_whole_files(folder.text, &programs[i], programs[i].name);
        }
    }
}

/* ---- a standard error that nobody reads ---- */

static void test_standard_streams_are_closed(void)
{
    static const wire kinds[][3] = {
        {WIRE_PIPE, WIRE_PIPE, WIRE_CLOSED},
        {WIRE_PIPE, WIRE_CLOSED, WIRE_PIPE},
        {WIRE_PIPE, WIRE_CLOSED, WIRE_CLOSED},
    };
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof kinds / sizeof kinds[0]; j++) {
            const string folder = folder_new(), input = right_answers(&programs[i]);
            process_setup setup = {.program = programs[i].path, .folder = folder.text};
            memcpy(setup.wires, kinds[j], sizeof kinds[j]);
            process process;
            process_run(&process, &setup, input.text);
            process_check_status(&process, 0, programs[i].name);
            check_golden(folder.text, 1, &programs[i], golden_1987, 1, FILES, programs[i].name);
        }
    }
}

/* Whoever reads it goes away at one of the prompts; the rest of the answers waits already. */
static void test_standard_error_breaks(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        for (int question = 0; question < QUESTIONS; question++) {
            const string what = string_of("%s, question %d", programs[i].name, question);
            const string folder = folder_new();
            const process_setup setup = {.program = programs[i].path, .folder = folder.text};
            process process;
            start_up_to(&process, &setup, &programs[i], question);
            process_close_errors(&process);
            say_answers(&process, &programs[i], question, QUESTIONS);
            process_finish(&process);
            check_whole_files(folder.text, &programs[i], what.text);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_folders_that_are_none);
    RUN_TEST(test_a_folder_whose_name_a_terminal_may_obey);
    RUN_TEST(test_folders_without_permission);
    RUN_TEST(test_folders_with_unusual_names);
    RUN_TEST(test_folders_with_long_names);
    RUN_TEST(test_folders_with_names_that_are_too_long);
    RUN_TEST(test_names_that_are_taken);
    RUN_TEST(test_existing_files_are_replaced);
    RUN_TEST(test_modes_follow_umask);
    RUN_TEST(test_folder_is_removed_during_the_run);
    RUN_TEST(test_signals_at_a_prompt);
    RUN_TEST(test_interrupt_on_a_terminal);
    RUN_TEST(test_signals_at_any_time);
    RUN_TEST(test_standard_streams_are_closed);
    RUN_TEST(test_standard_error_breaks);
    return UNITY_END();
}
