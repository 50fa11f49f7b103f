/*
 * Files that are not what a program expects, to be read and to be written: what is no file, what has no end, what may
 * not be read; and names that are hard to handle. Reading has little memory and little time.
 */

#include "faults/commands.h"

#include "unity.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* Of address space, beside what a program begins with: a file of this size in memory would be too much. */
enum { MEMORY = 12 << 20 };

static pid_t writer;

void setUp(void)
{
}

void tearDown(void)
{
    faulted_end();
    if (writer > 0) {
        kill(writer, SIGKILL);
        waitpid(writer, NULL, 0);
    }
    writer = 0;
    process_clean_up();
}

/* ---- files to be read ---- */

/* Where a file's name comes in; NULL is its place. */
static const char *const readers[][COMMAND_ARGUMENTS] = {
    {NULL, "--show"},
    {"puma560", "--degrees", "--accuracy", ".5,.5,.5,.01,.01,.01", "--poses", NULL},
    {"puma560", "--joints", "0,.8,-1.6,0,.8,0", "--tolerances", NULL},
    {"puma560", "--joints", "0,.8,-1.6,0,.8,0", "--accuracy", ".5,.5,.5,.01,.01,.01", "--weights", NULL},
};
enum { READERS = sizeof readers / sizeof readers[0] };

/* What each of them is to find there. */
static const char *const right_names[READERS] = {"arm.csv", "poses.csv", "made.csv", "weights.csv"};

static void fill_in(int reader, const char *name, const char *arguments[COMMAND_ARGUMENTS])
{
    int i = 0;
    memcpy(arguments, readers[reader], sizeof readers[reader]);
    while (arguments[i] != NULL) {
        i++;
    }
    arguments[i] = name;
}

static string folder_of_inputs(void)
{
    const string folder = folder_for_commands();
    const string tolerances = string_of("%s/tolerances.csv", folder.text), made = string_of("%s/made.csv", folder.text);
    static text content;
    file_read(tolerances.text, &content);
    for (char *degrees = content.bytes; (degrees = strstr(degrees, "deg")) != NULL;) {
        memcpy(degrees, "rad", 3);
    }
    file_write(made.text, content.bytes);
    return folder;
}

static void read_with(int reader, const char *name, const char *folder, const fault *fault, faulted_run *run)
{
    const char *arguments[COMMAND_ARGUMENTS];
    fill_in(reader, name, arguments);
    const faulted_setup setup = {.program = TEST_ARMTOL, .arguments = arguments, .folder = folder};
    faulted_start(&setup);
    faulted_try(fault, run);
}

static void make_socket(const char *folder)
{
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    const int descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
    char here[4096];
    TEST_ASSERT_NOT_NULL(getcwd(here, sizeof here));
    strcpy(address.sun_path, "socket");
    TEST_ASSERT_EQUAL_INT(0, chdir(folder));
    const int bound = bind(descriptor, (struct sockaddr *)&address, sizeof address);
    TEST_ASSERT_EQUAL_INT(0, chdir(here));
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, bound, strerror(errno));
    close(descriptor);
}

static void make_strange_files(const char *folder)
{
    const string zeros = string_of("%s/zeros", folder);
    const string one = string_of("%s/one", folder), other = string_of("%s/other", folder);
    const string tag = string_of("%s/tag", folder);
    folder_below(folder, "folder");
    file_write(zeros.text, "");
    file_write(tag.text, "<");
    TEST_ASSERT_EQUAL_INT(0, truncate(zeros.text, (off_t)4 << 30));
    TEST_ASSERT_EQUAL_INT(0, truncate(tag.text, (off_t)4 << 30));
    TEST_ASSERT_EQUAL_INT(0, symlink("other", one.text));
    TEST_ASSERT_EQUAL_INT(0, symlink("one", other.text));
    make_socket(folder);
}

/* The words are the file's name where those of the system differ, or those of the readers. */
static const struct {
    const char *name, *words;
} strange[] = {
    {"folder", "folder: Is a directory"},
    {"nowhere/file", "nowhere/file: No such file or directory"},
    {"arm.csv/below", "arm.csv/below: Not a directory"},
    {"one", NULL},
    {"socket", "socket: No such device or address"},
    {"/dev/zero", NULL},
    {"/dev/null", NULL},
    {"zeros", NULL},
    {"tag", NULL},
};

static void test_strange_files_to_be_read(void)
{
    static faulted_run run;
    const string folder = folder_of_inputs();
    make_strange_files(folder.text);
    for (int reader = 0; reader < READERS; reader++) {
        for (size_t i = 0; i < sizeof strange / sizeof strange[0]; i++) {
            const string what = string_of("%s in place of %s", strange[i].name, right_names[reader]);
            read_with(reader, strange[i].name, folder.text, &(fault){.memory = MEMORY}, &run);
            TEST_ASSERT_EQUAL_INT_MESSAGE(2, run.status, what.text);
            TEST_ASSERT_EQUAL_STRING_MESSAGE("", run.output.bytes, what.text);
            faulted_check_message(&run, "armtol", strange[i].words != NULL ? strange[i].words : strange[i].name,
                                  what.text);
        }
    }
}

/* Permissions do not bind root, so that a test of root's reads as another user, nobody. */
static void test_files_without_permission(void)
{
    static faulted_run run;
    const string folder = folder_of_inputs();
    const fault as_nobody = {.user = geteuid() == 0 ? 65534 : 0};
    for (int reader = 0; reader < READERS; reader++) {
        const string path = string_of("%s/%s", folder.text, right_names[reader]);
        const string words = string_of("%s: Permission denied", right_names[reader]);
        read_with(reader, right_names[reader], folder.text, &as_nobody, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, run.errors.bytes);
        TEST_ASSERT_EQUAL_INT(0, chmod(path.text, 0));
        read_with(reader, right_names[reader], folder.text, &as_nobody, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(2, run.status, right_names[reader]);
        faulted_check_message(&run, "armtol", words.text, right_names[reader]);
    }
}

/* Writes a file's bytes into a FIFO, in two pieces with time between them, or without end. */
static void start_writer(const char *fifo, const char *file, bool endless)
{
    static text content;
    file_read(file, &content);
    writer = fork();
    if (writer == 0) {
        signal(SIGPIPE, SIG_DFL);
        FILE *stream = fopen(fifo, "wb");
        const size_t half = content.length / 2;
        do {
            if (stream == NULL || fwrite(content.bytes, 1, half, stream) < half || fflush(stream) != 0) {
                _exit(1);
            }
        } while (endless);
        nanosleep(&(struct timespec){0, 20000000}, NULL);
        fwrite(content.bytes + half, 1, content.length - half, stream);
        fclose(stream);
        _exit(0);
    }
    TEST_ASSERT_TRUE(writer > 0);
}

static void end_writer(void)
{
    kill(writer, SIGKILL);
    waitpid(writer, NULL, 0);
    writer = 0;
}

/*
 * As in `armtol <(program) ...`. The name of an arm in a table is in the table. The name of tolerances is printed, and
 * the pipe's is as long, so that lines break in the same places.
 */
static void test_fifos_are_read(void)
{
    static faulted_run right, run;
    const string folder = folder_of_inputs(), fifo = string_of("%s/fifo.csv", folder.text);
    TEST_ASSERT_EQUAL_INT(0, mkfifo(fifo.text, 0666));
    for (int reader = 0; reader < READERS; reader++) {
        const string path = string_of("%s/%s", folder.text, right_names[reader]);
        read_with(reader, right_names[reader], folder.text, &(fault){0}, &right);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, right.status, right.errors.bytes);
        start_writer(fifo.text, path.text, false);
        read_with(reader, "fifo.csv", folder.text, &(fault){0}, &run);
        end_writer();
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, run.errors.bytes);
        char *named = strstr(run.output.bytes, "tolerances of fifo.csv,"); /* the one file's name that is printed */
        if (named != NULL) {
            const string tail = string_of("%s", named + strlen("tolerances of fifo.csv,"));
            sprintf(named, "tolerances of %s,%s", right_names[reader], tail.text);
            run.output.length = strlen(run.output.bytes);
        }
        text_check(right.output.bytes, right.output.length, &run.output, right_names[reader]);
    }
}

/* Every reader has an end of its own: of a file's size, of the number of poses, of a parameter that is there twice. */
static void test_fifos_without_end(void)
{
    static faulted_run run;
    static const char *const ends[READERS] = {"fifo: ", "more than 1000000 poses", "fifo:", "fifo:"};
    const string folder = folder_of_inputs(), fifo = string_of("%s/fifo", folder.text);
    TEST_ASSERT_EQUAL_INT(0, mkfifo(fifo.text, 0666));
    for (int reader = 0; reader < READERS; reader++) {
        const string path = string_of("%s/%s", folder.text, right_names[reader]);
        start_writer(fifo.text, path.text, true);
        read_with(reader, "fifo", folder.text, &(fault){.memory = 10L * MEMORY}, &run);
        end_writer();
        TEST_ASSERT_TRUE_MESSAGE(run.status == 1 || run.status == 2, right_names[reader]);
        faulted_check_message(&run, "armtol", ends[reader], right_names[reader]);
        TEST_ASSERT_TRUE_MESSAGE(run.outcome.bytes <= 17L << 20, "the copy of a pipe has an end");
    }
}

/* ---- names ---- */

static const char *const names[] = {
    " two  words ", "\xc3\xbc\xe2\x82\xac.csv", "line\nfeed", "tab\tbell\a", "--", "-x", "--json", "it's \"so\"",
    "%s%n%d", "a\\b", "*", "$HOME", "~", "#", "a=b.csv", "...", "\xff\xfe not UTF-8",
};

/* Behind -- where they look like options. A table of weights in the folder is told from a list by its path. */
static void test_names_of_files_to_be_read(void)
{
    static faulted_run right, run;
    static text content;
    const string folder = folder_for_commands(), arm = string_of("%s/arm.csv", folder.text);
    file_read(arm.text, &content);
    read_with(0, "arm.csv", folder.text, &(fault){0}, &right);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const string path = string_of("%s/%s", folder.text, names[i]);
        const faulted_setup behind = {.program = TEST_ARMTOL,
                                      .arguments = (const char *const[]){"--show", "--", names[i], NULL},
                                      .folder = folder.text};
        file_write(path.text, content.bytes);
        faulted_start(&behind);
        faulted_try(&(fault){0}, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, run.errors.bytes);
        text_check(right.output.bytes, right.output.length, &run.output, names[i]);
        read_with(0, path.text, folder.text, &(fault){0}, &run);
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, run.errors.bytes);
    }
}

/* A message is one line, whatever the name of what is not there; a terminal obeys nothing in it. */
static void check_one_line(const faulted_run *run, const char *what)
{
    const char *end = strchr(run->errors.bytes, '\n');
    TEST_ASSERT_TRUE_MESSAGE(end != NULL && end[1] == '\0', what);
    for (const char *c = run->errors.bytes; c < end; c++) {
        TEST_ASSERT_TRUE_MESSAGE((unsigned char)*c >= ' ' && *c != 127, what);
    }
}

static void test_names_in_messages(void)
{
    static faulted_run run;
    const string folder = folder_for_commands();
    for (int reader = 0; reader < READERS; reader++) {
        for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
            const string name = string_of("./nowhere/%s", names[i]);
            read_with(reader, name.text, folder.text, &(fault){0}, &run);
            TEST_ASSERT_EQUAL_INT_MESSAGE(2, run.status, names[i]);
            faulted_check_message(&run, "armtol", NULL, names[i]);
            check_one_line(&run, names[i]);
        }
    }
    for (int i = 0; i < PROGRAMS; i++) {
        for (size_t j = 0; j < sizeof names / sizeof names[0]; j++) {
            const faulted_setup setup = {.program = programs[i].path,
                                         .arguments = (const char *const[]){"--output", names[j], NULL},
                                         .folder = folder.text};
            faulted_start(&setup);
            faulted_try(&(fault){0}, &run);
            TEST_ASSERT_EQUAL_INT_MESSAGE(1, run.status, names[j]);
            faulted_check_message(&run, programs[i].name, "output folder", names[j]);
            check_one_line(&run, names[j]);
        }
    }
}

static void test_names_that_are_too_long(void)
{
    static faulted_run run;
    static const int lengths[] = {256, 4096, 4300};
    const string folder = folder_for_commands();
    for (int reader = 0; reader < READERS; reader++) {
        for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
            const string name = string_of("%0*d", lengths[i], 1);
            read_with(reader, name.text, folder.text, &(fault){0}, &run);
            TEST_ASSERT_EQUAL_INT_MESSAGE(2, run.status, "a name that is too long");
            faulted_check_message(&run, "armtol", "File name too long", "a name that is too long");
            check_one_line(&run, "a name that is too long");
        }
    }
}

/* ---- files to be written ---- */

/* What is in the place of a file stays and gets nothing, but for links: a new file takes the place of these. */
static void make_in_place(const char *path, int kind)
{
    switch (kind) {
    case 0:
        TEST_ASSERT_EQUAL_INT(0, mkdir(path, 0777));
        break;
    case 1:
        TEST_ASSERT_EQUAL_INT(0, mkfifo(path, 0666));
        break;
    case 2:
        if (mknod(path, S_IFCHR | 0666, makedev(1, 3)) != 0) {
            TEST_ASSERT_EQUAL_INT(0, mkfifo(path, 0666)); /* only root makes devices, and not everywhere */
        }
        break;
    case 3:
        TEST_ASSERT_EQUAL_INT(0, symlink("/dev/null", path));
        break;
    default:
        TEST_ASSERT_EQUAL_INT(0, symlink(strrchr(path, '/') + 1, path)); /* to itself */
        break;
    }
}

static void test_places_that_are_taken(void)
{
    static faulted_run run;
    for (int i = 0; i < PROGRAMS; i++) {
        for (int kind = 0; kind < 5; kind++) {
            for (int file = 0; file < FILES; file++) {
                const string what = string_of("%s, %s of kind %d", programs[i].name, programs[i].files[file], kind);
                const string folder = start_session(&programs[i]);
                const string path = file_of(folder.text, &programs[i], file);
                struct stat before, after;
                make_in_place(path.text, kind);
                TEST_ASSERT_EQUAL_INT(0, lstat(path.text, &before));
                faulted_try(&(fault){0}, &run);
                TEST_ASSERT_EQUAL_INT_MESSAGE(kind < 3 ? 1 : 0, run.status, what.text);
                TEST_ASSERT_EQUAL_INT(0, lstat(path.text, &after));
                if (kind < 3) {
                    TEST_ASSERT_TRUE_MESSAGE(before.st_ino == after.st_ino, what.text);
                    faulted_check_message(&run, programs[i].name, "exists and is not a regular file", what.text);
                } else {
                    TEST_ASSERT_TRUE_MESSAGE(S_ISREG(after.st_mode), what.text);
                    const int n_new = check_session_files(folder.text, &programs[i], false, false, what.text);
                    TEST_ASSERT_EQUAL_INT_MESSAGE(FILES, n_new, what.text);
                }
                faulted_end();
            }
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_strange_files_to_be_read);
    RUN_TEST(test_files_without_permission);
    RUN_TEST(test_fifos_are_read);
    RUN_TEST(test_fifos_without_end);
    RUN_TEST(test_names_of_files_to_be_read);
    RUN_TEST(test_names_in_messages);
    RUN_TEST(test_names_that_are_too_long);
    RUN_TEST(test_places_that_are_taken);
    printf("%ld runs\n", faulted_count());
    return UNITY_END();
}
