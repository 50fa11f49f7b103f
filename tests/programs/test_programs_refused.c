/*
 * The programs of 1987 in this process, refused what they ask the system for: memory, streams, new names, a line of a
 * terminal. Built with the linker's --wrap.
 */

#include "files/outfile.h"
#include "1987/program.h"
#include "console/exit_code.h"

#include "programs/programs.h"
#include "support/said.h"
#include "support/short_memory.h"

#include "unity.h"

#include <errno.h>
#include <getopt.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const program *const mains[PROGRAMS] = {&program_intella, &program_adpta};

/* The renames that are left until one is refused. */
static long names_left = LONG_MAX;
static bool on_a_terminal;

int __real_renameat(int old_folder, const char *old_name, int folder, const char *name);
int __wrap_renameat(int old_folder, const char *old_name, int folder, const char *name);
int __wrap_isatty(int descriptor);

int __wrap_renameat(int old_folder, const char *old_name, int folder, const char *name)
{
    if (names_left-- > 0) {
        return __real_renameat(old_folder, old_name, folder, name);
    }
    errno = EIO;
    return -1;
}

int __wrap_isatty(int descriptor)
{
    return on_a_terminal && descriptor == STDIN_FILENO;
}

void setUp(void)
{
    on_a_terminal = false;
}

void tearDown(void)
{
    memory_is_enough();
    names_left = LONG_MAX;
    process_clean_up();
}

/* One run with its files in that folder; what is refused has been set before. */
static int run_here(int i, const char *folder, const char *input_path, said *said)
{
    string name = string_of("%s", programs[i].name), option = string_of("--output=%s", folder);
    char *argv[] = {name.text, option.text, NULL};
    TEST_ASSERT_NOT_NULL(freopen(input_path, "r", stdin));
    optind = 1;
    said_begin();
    const int code = program_main(2, argv, mains[i]);
    memory_is_enough();
    names_left = LONG_MAX;
    said_end(said);
    return code;
}

/* A file with right answers, in a folder of its own. */
static string answers_file(int i)
{
    const string folder = folder_new(), path = string_of("%s/answers", folder.text);
    const string answers = right_answers(&programs[i]);
    file_write(path.text, answers.text);
    return path;
}

static void check_pairs(const char *folder, int i, int pairs, const char *what)
{
    const string listing = listing_of(&programs[i], pairs, 1);
    folder_check(folder, listing.text, what);
}

/* Without memory for the first pair no file appears; then the first pair does, then both. */
static void test_memory_that_runs_out(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string answers = answers_file(i);
        int code = EXIT_FAILED, failed = 0;
        for (long n = 0; code != EXIT_OK; n++) {
            const string folder = folder_new();
            said said;
            memory_is_left(n, LACK_FOR_GOOD);
            code = run_here(i, folder.text, answers.text, &said);
            if (code != EXIT_OK) {
                TEST_ASSERT_EQUAL_INT(EXIT_FAILED, code);
                TEST_ASSERT_TRUE_MESSAGE(strstr(said.text, ": out of memory\n") != NULL ||
                                         strstr(said.text, ": Cannot allocate memory\n") != NULL, said.text);
                failed++;
            }
            text names;
            folder_list(folder.text, &names);
            const string one = listing_of(&programs[i], 1, 1), two = listing_of(&programs[i], 2, 1);
            TEST_ASSERT_TRUE_MESSAGE(strcmp(names.bytes, code == EXIT_OK ? two.text : "") == 0 ||
                                     (code != EXIT_OK && strcmp(names.bytes, one.text) == 0), names.bytes);
        }
        /* the links, the columns, their order and all numbers; a stream a file */
        TEST_ASSERT_TRUE_MESSAGE(failed >= 4 + FILES, "too few allocations: were they seen?");
    }
}

/* A file is never half there; what was refused is named, and no draft is left. */
static void test_names_that_are_refused(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        const string answers = answers_file(i);
        for (int n = 0; n < FILES; n++) {
            const string folder = folder_new(), file = file_of(folder.text, &programs[i], n);
            const string message = string_of("%s: %s: Input/output error\n", programs[i].name, file.text);
            said said;
            write_old_files(folder.text, &programs[i]);
            names_left = n;
            TEST_ASSERT_EQUAL_INT(EXIT_FAILED, run_here(i, folder.text, answers.text, &said));
            TEST_ASSERT_TRUE_MESSAGE(strstr(said.text, message.text) != NULL, said.text);
            check_pairs(folder.text, i, 2, message.text);
            check_old_files(folder.text, &programs[i], n, FILES, message.text);
        }
    }
}

static void test_a_terminal_that_cannot_be_read(void)
{
    on_a_terminal = true;
    for (int i = 0; i < PROGRAMS; i++) {
        const string folder = folder_new();
        said said;
        TEST_ASSERT_EQUAL_INT(EXIT_FAILED, run_here(i, folder.text, "/", &said));
        TEST_ASSERT_TRUE_MESSAGE(strstr(said.text, "cannot read the input: Is a directory\n") != NULL, said.text);
        check_pairs(folder.text, i, 0, said.text);
    }
}

static void write_nothing(FILE *stream, const void *data)
{
    (void)stream;
    (void)data;
}

static void test_more_files_than_can_appear_together(void)
{
    const string path = folder_new();
    const outfile files[] = {{"1", write_nothing}, {"2", write_nothing}, {"3", write_nothing},
                             {"4", write_nothing}, {"5", write_nothing}};
    folder folder;
    said said;
    TEST_ASSERT_TRUE(folder_open(&folder, path.text));
    said_begin();
    const bool five = outfiles_write(&folder, files, 5, NULL);
    said_end(&said);
    TEST_ASSERT_FALSE(five);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said.text, "/5: too many files at once\n"), said.text);
    folder_check(path.text, "", "five files");
    TEST_ASSERT_TRUE(outfiles_write(&folder, files, 4, NULL));
    folder_check(path.text, "1 2 3 4", "four files");
    folder_close(&folder);
}

static void test_programs_are_found_by_name(void)
{
    for (int i = 0; i < PROGRAMS; i++) {
        TEST_ASSERT_EQUAL_PTR(mains[i], program_named(programs[i].name));
    }
    TEST_ASSERT_NULL(program_named("armtol"));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_memory_that_runs_out);
    RUN_TEST(test_names_that_are_refused);
    RUN_TEST(test_a_terminal_that_cannot_be_read);
    RUN_TEST(test_more_files_than_can_appear_together);
    RUN_TEST(test_programs_are_found_by_name);
    return UNITY_END();
}
