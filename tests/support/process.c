#include "support/process.h"

#include "unity.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

extern char **environ; /* POSIX has no header for it */

enum { SECONDS = 60 }; /* a machine may have much else to do */

/* The process that runs, and our side of its wires; a terminal's is open to the end: a hangup is a signal. */
static struct running {
    pid_t id;                            /* 0: none */
    int input, output, errors, terminal; /* -1: none, or closed */
} running = {0, -1, -1, -1, -1};

static volatile sig_atomic_t timed_out;

/* What runs, for failures. */
static string command;

/* The folder that holds the test's folders, "" where there is none yet, and how many it has given. */
static string root;
static unsigned n_given;

void fail_with(const char *format, ...)
{
    static char message[4096];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    TEST_FAIL_MESSAGE(message);
}

string string_of(const char *format, ...)
{
    string string;
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(string.text, sizeof string.text, format, arguments);
    va_end(arguments);
    if (length < 0 || (size_t)length >= sizeof string.text) {
        fail_with("longer than %zu: %s", sizeof string.text - 1, string.text);
    }
    return string;
}

/* The line that byte `at` is on, without its newline. */
static string line_around(const char *bytes, size_t length, size_t at)
{
    size_t first = at, end = at;
    while (first > 0 && bytes[first - 1] != '\n') {
        first--;
    }
    while (end < length && bytes[end] != '\n') {
        end++;
    }
    return string_of("%.*s", (int)(end - first), bytes + first);
}

/* ---- starting a process ---- */

/* The other side of the wires: what becomes the program's standard streams. */
typedef struct ends {
    int streams[3];
    int program;
    int terminal; /* keeps it alive until the program has opened it itself; -1: none */
    const char *terminal_name;
} ends;

static void close_end(int *end)
{
    if (*end >= 0) {
        close(*end);
    }
    *end = -1;
}

/* An end of this side: no program inherits it, and nothing waits for it unasked. */
static int own(int end)
{
    if (end < 0 || fcntl(end, F_SETFD, FD_CLOEXEC) < 0 || fcntl(end, F_SETFL, O_NONBLOCK) < 0) {
        fail_with("cannot make a wire: %s", strerror(errno));
    }
    return end;
}

static int open_for_program(const char *file, int flags)
{
    const int descriptor = open(file, flags | O_CLOEXEC);
    if (descriptor < 0) {
        fail_with("cannot open %s: %s", file, strerror(errno));
    }
    return descriptor;
}

static void open_pipe(int stream, ends *ends)
{
    int pair[2], *const ours[3] = {&running.input, &running.output, &running.errors};
    if (pipe(pair) < 0) {
        fail_with("cannot make a pipe: %s", strerror(errno));
    }
    const bool from_us = stream == STDIN_FILENO;
    *ours[stream] = own(pair[from_us]);
    ends->streams[stream] = pair[!from_us];
    fcntl(pair[!from_us], F_SETFD, FD_CLOEXEC);
}

/* A carriage return before every newline would only be in the way of comparisons. */
static void set_plain_lines(int terminal)
{
    struct termios settings;
    if (tcgetattr(terminal, &settings) < 0) {
        fail_with("no settings of the terminal: %s", strerror(errno));
    }
    settings.c_oflag &= ~(tcflag_t)ONLCR;
    settings.c_lflag |= ECHO | ICANON | ISIG;
    tcsetattr(terminal, TCSANOW, &settings);
}

static void open_terminal(const process_setup *setup, ends *ends)
{
    const int master = own(posix_openpt(O_RDWR | O_NOCTTY));
    if (grantpt(master) < 0 || unlockpt(master) < 0) {
        fail_with("cannot open a terminal: %s", strerror(errno));
    }
    running.terminal = master;
    if (setup->wires[STDIN_FILENO] == WIRE_TERMINAL) {
        running.input = own(dup(master));
    }
    if (setup->wires[STDERR_FILENO] == WIRE_TERMINAL) {
        running.errors = own(dup(master));
    }
    ends->terminal_name = ptsname(master);
    ends->terminal = open_for_program(ends->terminal_name, O_RDWR | O_NOCTTY);
    set_plain_lines(ends->terminal);
}

static ends open_ends(const process_setup *setup)
{
    ends ends = {{-1, -1, -1}, -1, -1, NULL};
    bool terminal = false;
    ends.program = open_for_program(setup->program, O_RDONLY);
    if (setup->input_path != NULL) {
        ends.streams[STDIN_FILENO] = open_for_program(setup->input_path, O_RDONLY);
    }
    if (setup->output_path != NULL) {
        ends.streams[STDOUT_FILENO] = open_for_program(setup->output_path, O_WRONLY);
    }
    for (int i = 0; i < 3; i++) {
        if (ends.streams[i] < 0 && setup->wires[i] == WIRE_PIPE) {
            open_pipe(i, &ends);
        }
        terminal = terminal || setup->wires[i] == WIRE_TERMINAL;
    }
    if (terminal) {
        open_terminal(setup, &ends);
    }
    return ends;
}

static void close_ends(ends *ends)
{
    for (int i = 0; i < 3; i++) {
        close_end(&ends->streams[i]);
    }
    close_end(&ends->program);
    close_end(&ends->terminal);
}

/* From here to the program all is the child's: it must not return, and says why on its standard error. */
#ifdef __GNUC__
__attribute__((noreturn))
#endif
static void child_fails(const char *what)
{
    dprintf(STDERR_FILENO, "cannot start the program: %s: %s\n", what, strerror(errno));
    _exit(127);
}

static void child_takes_streams(const process_setup *setup, const ends *ends)
{
    /* the first terminal that a new session opens becomes its own */
    const int terminal = ends->terminal_name == NULL ? -1 : open(ends->terminal_name, O_RDWR);
    for (int i = 0; i < 3; i++) {
        const int end = ends->streams[i] >= 0 ? ends->streams[i] : terminal;
        if (ends->streams[i] < 0 && setup->wires[i] == WIRE_CLOSED) {
            close(i);
        } else if (dup2(end, i) < 0) {
            child_fails("standard streams");
        }
    }
    if (terminal > STDERR_FILENO) {
        close(terminal);
    }
}

static void child_changes_user(uid_t user)
{
    if (user != 0 && (setgid((gid_t)user) < 0 || setuid(user) < 0)) {
        child_fails("another user");
    }
}

static void child_limits_files(rlim_t largest)
{
    struct rlimit limit;
    if (largest == 0) {
        return;
    }
    if (getrlimit(RLIMIT_FSIZE, &limit) < 0) {
        child_fails("file size limit");
    }
    limit.rlim_cur = largest;
    if (setrlimit(RLIMIT_FSIZE, &limit) < 0) {
        child_fails("file size limit");
    }
}

/* What exec and putenv take is not const. */
static char *copy_of(const char *text)
{
    char *copy = strdup(text);
    if (copy == NULL) {
        child_fails(text);
    }
    return copy;
}

static void child_runs(const process_setup *setup, const ends *ends)
{
    enum { MOST = 160 };
    char *argv[MOST + 2] = {copy_of(setup->program)};
    for (int i = 0; setup->arguments != NULL && setup->arguments[i] != NULL && i < MOST; i++) {
        argv[i + 1] = copy_of(setup->arguments[i]);
    }
    for (int i = 0; setup->environment != NULL && setup->environment[i] != NULL; i++) {
        putenv(copy_of(setup->environment[i]));
    }
    setsid();
    signal(SIGPIPE, SIG_DFL);
    if (setup->ignored != 0) {
        signal(setup->ignored, SIG_IGN);
    }
    if (setup->folder != NULL && chdir(setup->folder) < 0) {
        child_fails(setup->folder);
    }
    child_takes_streams(setup, ends);
    child_limits_files(setup->largest_file);
    child_changes_user(setup->user);
    /* by descriptor: the other user may have no way to the program's folder */
    fexecve(ends->program, argv, environ);
    child_fails(setup->program);
}

static void kill_running(void)
{
    kill(-running.id, SIGKILL); /* with what it has started */
    kill(running.id, SIGKILL);
}

static void on_alarm(int number)
{
    (void)number;
    timed_out = 1;
    if (running.id != 0) {
        kill_running();
    }
}

static void name_command(const process_setup *setup)
{
    const char *slash = strrchr(setup->program, '/');
    command = string_of("%s", slash != NULL ? slash + 1 : setup->program);
    for (int i = 0; setup->arguments != NULL && setup->arguments[i] != NULL; i++) {
        const size_t length = strlen(command.text);
        snprintf(command.text + length, sizeof command.text - length, " %s", setup->arguments[i]);
    }
}

void process_start(process *process, const process_setup *setup)
{
    const struct sigaction alarmed = {.sa_handler = on_alarm};
    *process = (struct process){0};
    timed_out = 0;
    name_command(setup);
    sigaction(SIGALRM, &alarmed, NULL);
    signal(SIGPIPE, SIG_IGN);
    ends ends = open_ends(setup);
    running.id = fork();
    if (running.id == 0) {
        child_runs(setup, &ends);
    }
    close_ends(&ends);
    if (running.id < 0) {
        running.id = 0;
        fail_with("cannot start a process: %s", strerror(errno));
    }
    process->id = running.id;
    alarm(SECONDS);
}

/* ---- talking to it ---- */

static bool would_wait(void)
{
    return errno == EINTR || errno == EAGAIN;
}

/* Read what there is. An end of the program's is the end of the wire, of a terminal with an error. */
static void take(int *end, text *said)
{
    const size_t room = sizeof said->bytes - 1 - said->length;
    if (room == 0) {
        fail_with("%s: says more than %zu bytes", command.text, sizeof said->bytes - 1);
    }
    const ssize_t got = read(*end, said->bytes + said->length, room);
    if (got > 0) {
        said->length += (size_t)got;
        said->bytes[said->length] = '\0';
    } else if (got == 0 || !would_wait()) {
        close_end(end);
    }
}

/* Write what it takes; once it reads no more, the rest counts as written. */
static void give(const char **bytes, size_t *left)
{
    const ssize_t gone = write(running.input, *bytes, *left);
    if (gone >= 0) {
        *bytes += gone;
        *left -= (size_t)gone;
    } else if (!would_wait()) {
        *left = 0;
    }
}

/* Wait until something can be read or written, and do so. False when there is nothing to wait for. */
static bool exchange(process *process, const char **bytes, size_t *left)
{
    struct pollfd wires[3] = {
        {running.output, POLLIN, 0},
        {running.errors, POLLIN, 0},
        {*left > 0 ? running.input : -1, POLLOUT, 0},
    };
    if (wires[0].fd < 0 && wires[1].fd < 0 && wires[2].fd < 0) {
        return false;
    }
    if (poll(wires, 3, -1) < 0) {
        return would_wait();
    }
    if (wires[0].revents != 0) {
        take(&running.output, &process->output);
    }
    if (wires[1].revents != 0) {
        take(&running.errors, &process->errors);
    }
    if (wires[2].revents != 0) {
        give(bytes, left);
    }
    return true;
}

static bool listen_on(process *process)
{
    const char *nothing = NULL;
    size_t left = 0;
    return exchange(process, &nothing, &left);
}

static const char *in_time(void)
{
    return timed_out ? " and was ended after too long a time" : "";
}

void process_expect(process *process, const char *words)
{
    const char *found;
    while ((found = strstr(process->errors.bytes + process->seen, words)) == NULL) {
        if (!listen_on(process)) {
            fail_with("%s: expected \"%s\" after \"%.*s\"; it said \"%s\"%s", command.text, words,
                      (int)process->seen, process->errors.bytes, process->errors.bytes + process->seen,
                      in_time());
        }
    }
    process->seen = (size_t)(found - process->errors.bytes) + strlen(words);
}

void process_send(process *process, const char *bytes, size_t length)
{
    while (length > 0 && exchange(process, &bytes, &length)) {
    }
}

void process_say(process *process, const char *words)
{
    process_send(process, words, strlen(words));
}

void process_close_errors(process *process)
{
    (void)process;
    close_end(&running.errors);
}

void process_finish(process *process)
{
    int status = 0;
    close_end(&running.input);
    while (listen_on(process)) {
    }
    while (waitpid(running.id, &status, 0) < 0 && errno == EINTR) {
    }
    alarm(0);
    running.id = 0;
    close_end(&running.terminal);
    process->status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (timed_out) {
        fail_with("%s: not done after %d seconds; it said \"%s\"", command.text, SECONDS,
                  process->errors.bytes);
    }
}

void process_run(process *process, const process_setup *setup, const char *input)
{
    process_start(process, setup);
    process_say(process, input);
    process_finish(process);
}

void process_check_status(const process *process, int status, const char *what)
{
    if (process->status != status) {
        fail_with("%s: expected exit status %d, got %d; it said \"%s\"", what, status, process->status,
                  process->errors.bytes);
    }
}

string process_last_line(const process *process)
{
    const char *const said = process->errors.bytes;
    const size_t length = process->errors.length;
    const size_t end = length > 0 && said[length - 1] == '\n' ? length - 1 : length;
    return line_around(said, end, end);
}

/* ---- folders and files ---- */

string folder_below(const char *parent, const char *name)
{
    const string folder = string_of("%s/%s", parent, name);
    if (mkdir(folder.text, 0777) < 0) {
        fail_with("cannot make the folder %s: %s", folder.text, strerror(errno));
    }
    return folder;
}

static void make_root(void)
{
    const char *set = getenv("TMPDIR");
    string name = string_of("%s/armtol-XXXXXX", set != NULL && set[0] != '\0' ? set : TEST_SCRATCH);
    if (mkdtemp(name.text) == NULL) {
        fail_with("no temporary folder %s (TMPDIR can name another place): %s", name.text, strerror(errno));
    }
    root = name;
}

string folder_new(void)
{
    if (root.text[0] == '\0') {
        make_root();
    }
    const string name = string_of("%u", ++n_given);
    return folder_below(root.text, name.text);
}

static bool is_name(const char *name)
{
    return strcmp(name, ".") != 0 && strcmp(name, "..") != 0;
}

/* By descriptors: a path may be longer than any call takes. */
static void remove_tree(int parent, const char *name)
{
    struct stat status;
    if (fstatat(parent, name, &status, AT_SYMLINK_NOFOLLOW) < 0 || !S_ISDIR(status.st_mode)) {
        unlinkat(parent, name, 0);
        return;
    }
    fchmodat(parent, name, S_IRWXU, 0);
    const int descriptor = openat(parent, name, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *folder = descriptor < 0 ? NULL : fdopendir(descriptor);
    if (folder != NULL) {
        for (const struct dirent *entry; (entry = readdir(folder)) != NULL;) {
            if (is_name(entry->d_name)) {
                remove_tree(descriptor, entry->d_name);
            }
        }
        closedir(folder);
    }
    unlinkat(parent, name, AT_REMOVEDIR);
}

static int is_entry(const struct dirent *entry)
{
    return is_name(entry->d_name);
}

void folder_list(const char *folder, text *names)
{
    struct dirent **entries = NULL;
    const int count = scandir(folder, &entries, is_entry, alphasort);
    size_t length = 0;
    names->bytes[0] = '\0';
    for (int i = 0; i < count; i++) {
        const int more = snprintf(names->bytes + length, sizeof names->bytes - length, "%s%s",
                                  i > 0 ? " " : "", entries[i]->d_name);
        length += more > 0 && (size_t)more < sizeof names->bytes - length ? (size_t)more : 0;
        free(entries[i]);
    }
    free(entries);
    names->length = length;
    if (count < 0) {
        fail_with("cannot list the folder %s: %s", folder, strerror(errno));
    }
}

void folder_check(const char *folder, const char *names, const char *what)
{
    text found;
    folder_list(folder, &found);
    if (strcmp(found.bytes, names) != 0) {
        fail_with("%s: expected the files \"%s\", found \"%s\"", what, names, found.bytes);
    }
}

void file_read(const char *file, text *content)
{
    FILE *stream = fopen(file, "rb");
    if (stream == NULL) {
        fail_with("cannot read %s: %s", file, strerror(errno));
    }
    content->length = fread(content->bytes, 1, sizeof content->bytes, stream);
    fclose(stream);
    if (content->length == sizeof content->bytes) {
        fail_with("%s holds more than %zu bytes", file, sizeof content->bytes - 1);
    }
    content->bytes[content->length] = '\0';
}

void file_write(const char *file, const char *content)
{
    FILE *stream = fopen(file, "wb");
    if (stream == NULL || fputs(content, stream) == EOF || fclose(stream) == EOF) {
        fail_with("cannot write %s: %s", file, strerror(errno));
    }
}

void text_check(const char *expected, size_t length, const text *actual, const char *what)
{
    const size_t common = length < actual->length ? length : actual->length;
    size_t at = 0;
    int line = 1;
    while (at < common && expected[at] == actual->bytes[at]) {
        line += expected[at] == '\n';
        at++;
    }
    if (at == length && at == actual->length) {
        return;
    }
    const string right = line_around(expected, length, at);
    const string wrong = line_around(actual->bytes, actual->length, at);
    fail_with("%s: byte %zu, line %d: expected \"%s\", got \"%s\" (%zu bytes, %zu bytes)", what, at, line,
              right.text, wrong.text, length, actual->length);
}

void file_check(const char *file, const char *expected, const char *what)
{
    text actual;
    file_read(file, &actual);
    const string where = string_of("%s: %s", what, file);
    text_check(expected, strlen(expected), &actual, where.text);
}

void file_check_same(const char *expected_file, const char *file, const char *what)
{
    text expected, actual;
    file_read(expected_file, &expected);
    file_read(file, &actual);
    const string where = string_of("%s: %s", what, file);
    text_check(expected.bytes, expected.length, &actual, where.text);
}

/* ---- after a test ---- */

void process_clean_up(void)
{
    alarm(0);
    if (running.id != 0) {
        kill_running();
        waitpid(running.id, NULL, 0);
    }
    close_end(&running.input);
    close_end(&running.output);
    close_end(&running.errors);
    close_end(&running.terminal);
    running.id = 0;
    if (root.text[0] != '\0') {
        remove_tree(AT_FDCWD, root.text);
    }
    root.text[0] = '\0';
}

void process_ignore_test(const char *why)
{
    process_clean_up();
    TEST_IGNORE_MESSAGE(why);
}
