#include "faults/commands.h"

#include "unity.h"

#include <dirent.h>
#include <errno.h>
#include <string.h>
#include <unistd.h>

#define POSE "--joints", "0,45,-90,0,45,0", "--degrees"
#define ACCURACY "--accuracy", ".5,.5,.5,.01,.01,.01"

const char *const commands[COMMANDS][COMMAND_ARGUMENTS] = {
    {"puma560", POSE, ACCURACY},
    {"puma560", POSE, ACCURACY, "--budget", "--grades", "--verify", "9000", "--threads", "3"},
    {"puma560", POSE, ACCURACY, "--json", "--budget", "--grades", "--verify", "100"},
    {"puma560", POSE, ACCURACY, "--csv", "--grades"},
    {"puma560", POSE, ACCURACY, "--method", "sphere"},
    {"puma560", "--show"},
    {"--list"},
    {"--help"},
    {"--version"},
    {"arm.csv", "--poses", "poses.csv", "--method", "rss", "--weights", "weights.csv", ACCURACY},
    {"arm.csv", POSE, "--tolerances", "tolerances.csv", "--spread", "spread.csv"},
    {"arm.csv", POSE, "--deviations", "deviations.csv"},
    {"arm.csv", POSE, "--drawing", "drawing.csv", "--accuracy", "r=.5", "--write-drawing", "-"},
    {"map", "arm.csv", "--plane", "xz", "--range", "300..500,0..200", "--grid", "3,2", "--tolerances", "lengths=.1",
     "--tsv",
     "-"},
    {"map", "arm.csv", POSE, "--plane", "xy", "--offset", "596", "--range", "600..650,-170..-140", "--grid", "3,2",
     ACCURACY,
     "--json"},
    {"ur5e.urdf", "--tip", "tool0", "--joints", "10,-80,70,-60,50,40", "--degrees", ACCURACY},
};

string name_of_command(int command)
{
    string name = string_of("armtol");
    for (int i = 0; commands[command][i] != NULL; i++) {
        const string longer = string_of("%s %s", name.text, commands[command][i]);
        name = longer;
    }
    return name;
}

/* What armtol prints becomes a file. */
static void write_output(const char *folder, const char *name, const char *const arguments[])
{
    const string path = string_of("%s/%s", folder, name);
    const process_setup setup = {.program = TEST_ARMTOL, .arguments = arguments};
    process process;
    process_run(&process, &setup, "");
    process_check_status(&process, 0, name);
    file_write(path.text, process.output.bytes);
}

string folder_for_commands(void)
{
    const string folder = folder_new();
    const string poses = string_of("%s/poses.csv", folder.text), weights = string_of("%s/weights.csv", folder.text);
    const string urdf = string_of("%s/ur5e.urdf", folder.text);
    static text source;
    write_output(folder.text, "arm.csv", (const char *const[]){"puma560", "--show", NULL});
    write_output(folder.text, "tolerances.csv", commands[3]);
    file_write(poses.text, "0,.8,-1.6,0,.8,0\n.1,.7,-1.5,.1,.9,0\n");
    file_write(weights.text, "link,parameter,weight\n0,d,2\n1,theta,3\n");
    file_write(string_of("%s/deviations.csv", folder.text).text, "link,parameter,deviation\n1,a,-0.25\n");
    file_write(string_of("%s/drawing.csv", folder.text).text, "link,distance,angle,split\n1,.05,.01,a\n2,.05,-,even\n");
    file_write(string_of("%s/spread.csv", folder.text).text,
               "link,parameter,distribution,shift,group\n1,a,normal:3,.01,lathe\n2,d,normal:3,0,lathe\n");
    file_read(TEST_UR5E, &source);
    file_write(urdf.text, source.bytes);
    return folder;
}

void start_command(int command, const char *folder)
{
    const faulted_setup setup = {.program = TEST_ARMTOL, .arguments = commands[command], .folder = folder};
    faulted_start(&setup);
}

string start_session(const tested *program)
{
    const string folder = folder_new(), input = right_answers(program);
    const faulted_setup setup = {.program = program->path, .folder = folder.text, .input = input.text};
    faulted_start(&setup);
    return folder;
}

static bool is_of_folder(const struct dirent *entry)
{
    return strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0;
}

static DIR *open_folder(const char *folder)
{
    DIR *open = opendir(folder);
    if (open == NULL) {
        fail_with("cannot list %s: %s", folder, strerror(errno));
    }
    return open;
}

void prepare_session(const char *folder, const tested *program, bool old)
{
    DIR *open = open_folder(folder);
    for (const struct dirent *entry; (entry = readdir(open)) != NULL;) {
        if (!is_of_folder(entry)) {
            unlinkat(dirfd(open), entry->d_name, 0);
        }
    }
    closedir(open);
    if (old) {
        write_old_files(folder, program);
    }
}

/* Whether a name is one that a killed run leaves: .NAME.NUMBERS.part, of one of the four. */
static bool is_draft(const char *name, const tested *program)
{
    for (int i = 0; i < FILES; i++) {
        const string begin = string_of(".%s.1.", program->files[i]);
        const size_t length = strlen(begin.text);
        if (strncmp(name, begin.text, length) == 0) {
            const size_t numbers = strspn(name + length, "0123456789-");
            return strcmp(name + length + numbers, ".part") == 0;
        }
    }
    return false;
}

static bool is_file(const char *name, const tested *program)
{
    for (int i = 0; i < FILES; i++) {
        const string file = string_of("%s.1", program->files[i]);
        if (strcmp(name, file.text) == 0) {
            return true;
        }
    }
    return false;
}

static void check_names(const char *folder, const tested *program, bool drafts, const char *what)
{
    DIR *open = open_folder(folder);
    for (const struct dirent *entry; (entry = readdir(open)) != NULL;) {
        const char *name = entry->d_name;
        if (!is_of_folder(entry) && !is_file(name, program) && !(drafts && is_draft(name, program))) {
            const string stray = string_of("%s: a stray file %s", what, name);
            closedir(open);
            TEST_FAIL_MESSAGE(stray.text);
        }
    }
    closedir(open);
}

/* What a right run writes, read once: golden files are read only where the program changes. */
static const text *golden_file(const tested *program, int file)
{
    static const tested *whose;
    static text golden[FILES];
    for (int i = 0; i < FILES && whose != program; i++) {
        const string name = string_of("%s.1", program->files[i]);
        const string path = golden_of(golden_1987, program, 1, name.text);
        file_read(path.text, &golden[i]);
    }
    whose = program;
    return &golden[file];
}

int check_session_files(const char *folder, const tested *program, bool old, bool drafts, const char *what)
{
    int n_new = 0;
    check_names(folder, program, drafts, what);
    for (int i = 0; i < FILES; i++) {
        const string path = file_of(folder, program, i);
        static text found;
        if (access(path.text, F_OK) != 0) {
            TEST_ASSERT_FALSE_MESSAGE(old, what);
            continue;
        }
        file_read(path.text, &found);
        const text *golden = golden_file(program, i);
        if (found.length == golden->length && memcmp(found.bytes, golden->bytes, found.length) == 0) {
            if (n_new != i) {
                fail_with("%s: %s is new, and one before it is not", what, path.text);
            }
            n_new++;
        } else if (old) {
            check_old_files(folder, program, i, i + 1, what);
        } else {
            fail_with("%s: %s is not whole: %zu bytes", what, path.text, found.length);
        }
    }
    return n_new;
}
