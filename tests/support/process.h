#ifndef TEST_PROCESS_H
#define TEST_PROCESS_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/resource.h>
#include <sys/types.h>

/*
 * Programs, run as their users run them: on pipes, or on a terminal of their own; and the files that they
 * leave. What stands in a test's way (no such program, no answer in time, no such file) fails the test. One
 * process runs at a time. Every test program calls process_clean_up in its tearDown.
 */

/* What a program wrote, or what a file holds. A zero byte follows. */
typedef struct text {
    size_t length;
    char bytes[1 << 15];
} text;

/* A path, a line, a name: fit for an argument of its own. */
typedef struct string {
    char text[4400];
} string;

/* Printf-like. */
string string_of(const char *format, ...)
#ifdef __GNUC__
    __attribute__((format(printf, 1, 2)))
#endif
    ;

/* Fail the test, printf-like. */
void fail_with(const char *format, ...)
#ifdef __GNUC__
    __attribute__((format(printf, 1, 2)))
#endif
    ;

/* ---- processes ---- */

/* What a standard stream of the program is. */
typedef enum wire {
    WIRE_PIPE,     /* a pipe from or to the test */
    WIRE_TERMINAL, /* a terminal of its own: echo on, lines end in a plain newline */
    WIRE_CLOSED
} wire;

#define ALL_ON_TERMINAL {WIRE_TERMINAL, WIRE_TERMINAL, WIRE_TERMINAL}

/* What to run, and how. What is left 0 or NULL is as it is in the test. */
typedef struct process_setup {
    const char *program;
    const char *const *arguments;   /* up to a NULL, without the program's name */
    const char *const *environment; /* "NAME=VALUE" up to a NULL, set beside the test's own */
    const char *folder;             /* to run in */
    wire wires[3];                  /* of standard input, standard output, standard error */
    const char *input_path;         /* what standard input reads, in place of its wire */
    const char *output_path;        /* where standard output goes, in place of its wire */
    uid_t user;                     /* to run as; only root can change it */
    rlim_t largest_file;            /* RLIMIT_FSIZE, bytes */
    int ignored;                    /* a signal that it starts with ignored */
} process_setup;

typedef struct process {
    pid_t id;
    text output; /* standard output, where it is a pipe */
    text errors; /* standard error, where it is a pipe; else all that the terminal showed */
    size_t seen; /* how much of errors process_expect has passed */
    int status;  /* exit status, or 128 and the signal */
} process;

/* A process has 20 seconds from its start to its end. What it says is collected whenever the test waits. */
void process_start(process *process, const process_setup *setup);

/* Wait until standard error, after what was expected before, says these words. */
void process_expect(process *process, const char *words);

/* Give it something to read. A program that does not care to is no failure. */
void process_send(process *process, const char *bytes, size_t length);
void process_say(process *process, const char *words);

/* Read no more of its standard error, a pipe: from now on it is a broken one. */
void process_close_errors(process *process);

/* End its input (not a terminal's), collect the rest and wait for its end. */
void process_finish(process *process);

/* Start, say, finish. */
void process_run(process *process, const process_setup *setup, const char *input);

/* The exit status that it ended with; a failure shows what it said. */
void process_check_status(const process *process, int status, const char *what);

/* The last line on standard error, without its newline. */
string process_last_line(const process *process);

/* After a test, passed or failed: nothing runs on, and no temporary folder is left. */
void process_clean_up(void);

/* Have Unity count the test as ignored; older ones would not call tearDown then. */
void process_ignore_test(const char *why);

/* ---- folders and files ---- */

/* A new, empty folder under $TMPDIR, else in the build tree. process_clean_up removes it and all in it. */
string folder_new(void);

/* A new folder in one that there is. */
string folder_below(const char *parent, const char *name);

/* The names in a folder, sorted, a blank between each; "" for an empty one. */
void folder_list(const char *folder, text *names);
void folder_check(const char *folder, const char *names, const char *what);

void file_read(const char *file, text *content);
void file_write(const char *file, const char *content);

/* Equal to the last byte; the failure shows the first line that is not. */
void text_check(const char *expected, size_t length, const text *actual, const char *what);
void file_check(const char *file, const char *expected, const char *what);
void file_check_same(const char *expected_file, const char *file, const char *what);

#endif
