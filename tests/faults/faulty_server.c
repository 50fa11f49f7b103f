/*
 * Loaded before the program, this stops it where main would begin, and forks a run of it for every fault that the
 * harness asks for: that spares starting the program thousands of times. Without a harness, under valgrind, the
 * allocation of the program FAULT_PROGRAM fails that FAULT_ALLOCATION numbers; others (valgrind is one) are let alone.
 */

#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */

#include "faults/faulty.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

fault faulty_plan;
fault_outcome *faulty_outcome;

static fault_outcome *shared;

static void close_standard_streams(void)
{
    for (int i = 0; i < 3; i++) {
        int ends[2];
        if ((faulty_plan.broken >> i & 1) != 0 && pipe(ends) == 0) {
            dup2(ends[1], i);
            close(ends[0]);
            close(ends[1]);
        }
        if ((faulty_plan.closed >> i & 1) != 0) {
            close(i);
        }
    }
}

static void set_limit(int resource, rlim_t value)
{
    const struct rlimit limit = {value, value};
    if (setrlimit(resource, &limit) < 0) {
        _exit(126);
    }
}

/* The address space in use, from the kernel's own account, without memory for a stream. */
static long size_in_use(void)
{
    char text[64] = "";
    const int descriptor = open("/proc/self/statm", O_RDONLY);
    if (descriptor < 0 || read(descriptor, text, sizeof text - 1) <= 0) {
        _exit(126);
    }
    close(descriptor);
    return atol(text) * sysconf(_SC_PAGESIZE);
}

static void change_user(uid_t user)
{
    if (user != 0 && (setgid((gid_t)user) < 0 || setuid(user) < 0)) {
        _exit(126);
    }
}

static void set_limits(void)
{
    if (faulty_plan.file_size > 0) {
        set_limit(RLIMIT_FSIZE, (rlim_t)faulty_plan.file_size);
    }
    if (faulty_plan.one_process) {
        set_limit(RLIMIT_NPROC, 1);
    }
    if (faulty_plan.memory > 0) {
        set_limit(RLIMIT_AS, (rlim_t)(size_in_use() + faulty_plan.memory));
    }
    if (faulty_plan.descriptors > 0) {
        set_limit(RLIMIT_NOFILE, (rlim_t)faulty_plan.descriptors);
    }
}

/* In the run: everything as the plan has it, then on to main. */
static void begin_run(void)
{
    lseek(STDIN_FILENO, 0, SEEK_SET);
    close(FAULT_COMMANDS);
    close(FAULT_REPLIES);
    if (faulty_plan.pipes_ignored) {
        signal(SIGPIPE, SIG_IGN);
    }
    close_standard_streams();
    change_user(faulty_plan.user);
    set_limits();
    faulty_outcome = shared;
    faulty_calls_start();
}

/* False once the harness asks for no more. */
static bool next_plan(void)
{
    return read(FAULT_COMMANDS, &faulty_plan, sizeof faulty_plan) == (ssize_t)sizeof faulty_plan;
}

/* The new run, which is to go back to its main, is 0. */
static pid_t start_or_resume(pid_t stopped)
{
    if (faulty_plan.resume) {
        kill(stopped, SIGCONT);
        return stopped;
    }
    *shared = (fault_outcome){0};
    return fork();
}

static void serve(void)
{
    pid_t run = -1;
    while (next_plan()) {
        run = start_or_resume(run);
        if (run == 0) {
            begin_run();
            return;
        }
        fault_reply reply = {.status = -1};
        while (run > 0 && waitpid(run, &reply.status, WUNTRACED) < 0 && errno == EINTR) {
        }
        reply.outcome = *shared;
        if (write(FAULT_REPLIES, &reply, sizeof reply) != (ssize_t)sizeof reply) {
            break;
        }
    }
    _exit(0);
}

static bool is_this(const char *program)
{
    char path[4096] = "";
    return program != NULL && readlink("/proc/self/exe", path, sizeof path - 1) > 0 && strcmp(path, program) == 0;
}

__attribute__((constructor)) static void start(void)
{
    const char *allocation = getenv("FAULT_ALLOCATION");
    faulty_memory_start();
    shared = mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) {
        _exit(126);
    }
    if (allocation == NULL) {
        serve();
    } else if (is_this(getenv("FAULT_PROGRAM"))) {
        faulty_plan.allocation = atol(allocation);
        faulty_outcome = shared;
    }
}

/* What is not freed by now never is. Streams are still flushed after this. */
__attribute__((destructor)) static void end(void)
{
    if (faulty_outcome != NULL) {
        faulty_outcome->ended = true;
    }
}
