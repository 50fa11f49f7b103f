#ifndef TEST_FAULT_H
#define TEST_FAULT_H

#include <stdbool.h>
#include <sys/types.h>

/*
 * What is to go wrong in a run of a program, and what the run then did. Both are between the harness (faulted.h) and
 * the shared object that is loaded before the program (faulty_*.c), through a pipe and through shared memory.
 *
 * Calls are those system calls that change files or write: open for writing, write, fsync, rename, link, unlink,
 * truncate, close; of any thread, libc's own too. They are counted from 1, from the beginning of main, as are
 * allocations.
 */

typedef enum fault_action {
    ACTION_KILL,      /* SIGKILL before the call is made */
    ACTION_HALF_KILL, /* where it writes, half of that is written first */
    ACTION_SIGNAL,    /* a signal comes before the call, which is then made */
    ACTION_ERROR      /* the call is not made, and fails */
} fault_action;

/* 0 or false is: not at all. */
typedef struct fault {
    bool resume;     /* no new run: the one that SIGSTOP came to goes on */
    long allocation; /* that one fails */
    bool all_after;  /* and all after it */
    bool disk_full;  /* files take disk_room bytes together, then writing fails: no space left */
    long disk_room;
    bool output_full; /* the same for standard output */
    long output_room;
    bool short_writes; /* a byte at a time */
    long call;         /* before or instead of that call: */
    fault_action action;
    int number; /* of the signal, or the error */
    int closed;          /* bits 0 to 2: these standard streams are closed */
    int broken;          /* bits 1 and 2: these are pipes that nobody reads */
    bool pipes_ignored;  /* SIGPIPE is */
    uid_t user;          /* to run as; only root can change it */
    long memory;         /* RLIMIT_AS: so many bytes more than are in use when main begins */
    long file_size;      /* RLIMIT_FSIZE */
    int descriptors;     /* RLIMIT_NOFILE */
    bool one_process;    /* RLIMIT_NPROC: no thread more; binds other users than root */
} fault;

typedef struct fault_outcome {
    bool happened;    /* what was to go wrong by its number did */
    bool ended;       /* by exit or a return from main */
    bool low;         /* a file was written to through a descriptor of the standard streams */
    long allocations; /* so many there were */
    long calls;
    long live;  /* blocks of the program's own that nobody has freed, if it ended */
    long bytes; /* written to files */
} fault_outcome;

/* The harness writes faults to one descriptor and reads a waitpid status and an outcome for each from the other. */
enum { FAULT_COMMANDS = 198, FAULT_REPLIES = 199 };

typedef struct fault_reply {
    int status;
    fault_outcome outcome;
} fault_reply;

#endif
