#define _GNU_SOURCE /* a pipe's ends that no program inherits */

#include "faults/faulted.h"

#include "unity.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SECONDS = 30 };

static struct server {
    pid_t id; /* 0: none */
    int commands, replies, output, errors;
} server;

static long count;

static int scratch_file(const char *folder, const char *name)
{
    const string path = string_of("%s/%s", folder, name);
    const int descriptor = open(path.text, O_RDWR | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        fail_with("cannot open %s: %s", path.text, strerror(errno));
    }
    return descriptor;
}

/* What exec takes is not const; the process is a child's, and ends without it. */
static char *copy_of(const char *text)
{
    char *copy = strdup(text);
    if (copy == NULL) {
        _exit(127);
    }
    return copy;
}

/* A run's input, output and errors are files: they cost nothing, and a limit on files is one on output too. */
static void become_program(const faulted_setup *setup, int input, int commands, int replies)
{
    enum { MOST = 32 };
    char *argv[MOST + 2] = {copy_of(setup->program)};
    for (int i = 0; setup->arguments != NULL && setup->arguments[i] != NULL && i < MOST; i++) {
        argv[i + 1] = copy_of(setup->arguments[i]);
    }
    setsid();
    signal(SIGPIPE, SIG_DFL);
    const bool ready = dup2(input, STDIN_FILENO) >= 0 && dup2(server.output, STDOUT_FILENO) >= 0 &&
                       dup2(server.errors, STDERR_FILENO) >= 0 && dup2(commands, FAULT_COMMANDS) >= 0 &&
                       dup2(replies, FAULT_REPLIES) >= 0 && chdir(setup->folder) == 0 &&
                       setenv("LD_PRELOAD", TEST_FAULTY, 1) == 0 && /* no path: it would be cut at blanks */
                       setenv("LD_LIBRARY_PATH", TEST_FAULTY_FOLDER, 1) == 0;
    for (int i = STDERR_FILENO + 1; i < FAULT_COMMANDS; i++) {
        close(i); /* what the test has from its parent: limits on descriptors count these too */
    }
    if (ready) {
        execv(setup->program, argv);
    }
    dprintf(STDERR_FILENO, "cannot start %s: %s\n", setup->program, strerror(errno));
    _exit(127);
}

void faulted_start(const faulted_setup *setup)
{
    const string folder = folder_new(), input_path = string_of("%s/input", folder.text);
    int commands[2], replies[2];
    faulted_end();
    file_write(input_path.text, setup->input != NULL ? setup->input : "");
    const int input = open(input_path.text, O_RDONLY | O_CLOEXEC);
    server.output = scratch_file(folder.text, "output");
    server.errors = scratch_file(folder.text, "errors");
    if (input < 0 || pipe2(commands, O_CLOEXEC) < 0 || pipe2(replies, O_CLOEXEC) < 0) {
        fail_with("cannot start a program: %s", strerror(errno));
    }
    signal(SIGPIPE, SIG_IGN);
    server.id = fork();
    if (server.id == 0) {
        become_program(setup, input, commands[0], replies[1]);
    }
    close(input);
    close(commands[0]);
    close(replies[1]);
    server.commands = commands[1];
    server.replies = replies[0];
}

static void read_back(int descriptor, text *content)
{
    const ssize_t length = pread(descriptor, content->bytes, sizeof content->bytes - 1, 0);
    content->length = length > 0 ? (size_t)length : 0;
    content->bytes[content->length] = '\0';
}

static bool reply_in_time(fault_reply *reply)
{
    struct pollfd wire = {server.replies, POLLIN, 0};
    return poll(&wire, 1, 1000 * SECONDS) == 1 && read(server.replies, reply, sizeof *reply) == (ssize_t)sizeof *reply;
}

static int shell_status(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + (WIFSTOPPED(status) ? WSTOPSIG(status) : WTERMSIG(status));
}

static void command(const fault *fault, faulted_run *run)
{
    fault_reply reply;
    if (write(server.commands, fault, sizeof *fault) != (ssize_t)sizeof *fault || !reply_in_time(&reply)) {
        read_back(server.errors, &run->errors);
        fail_with("no run, or none that ends within %d seconds; it said \"%s\"", SECONDS, run->errors.bytes);
    }
    run->status = shell_status(reply.status);
    run->outcome = reply.outcome;
    read_back(server.output, &run->output);
    read_back(server.errors, &run->errors);
}

void faulted_try(const fault *fault, faulted_run *run)
{
    if (ftruncate(server.output, 0) < 0 || ftruncate(server.errors, 0) < 0) {
        fail_with("cannot empty a file: %s", strerror(errno));
    }
    count++;
    command(fault, run);
}

void faulted_resume(faulted_run *run)
{
    command(&(fault){.resume = true}, run);
}

void faulted_end(void)
{
    if (server.id != 0) {
        kill(-server.id, SIGKILL); /* with a run that has not ended */
        kill(server.id, SIGKILL);
        waitpid(server.id, NULL, 0);
        close(server.commands);
        close(server.replies);
        close(server.output);
        close(server.errors);
    }
    server.id = 0;
}

long faulted_count(void)
{
    return count;
}

void faulted_check_message(const faulted_run *run, const char *name, const char *words, const char *what)
{
    const char *said = run->errors.bytes;
    const size_t length = run->errors.length;
    const char *last = said + (length > 0 ? length - 1 : 0);
    while (last > said && last[-1] != '\n') {
        last--;
    }
    const string begin = string_of("%s: ", name);
    if (strncmp(last, begin.text, strlen(begin.text)) != 0 || (words != NULL && strstr(last, words) == NULL)) {
        fail_with("%s: expected a last line that begins with \"%s\" and has \"%s\"; it said \"%s\"", what, begin.text,
                  words != NULL ? words : "", said);
    }
}
