#ifndef PROGRAM_EXIT_CODE_H
#define PROGRAM_EXIT_CODE_H

/* What a program tells the shell. */
enum {
    EXIT_OK = 0,
    EXIT_FAILED = 1, /* input was right, something else failed: a folder, a disk, memory */
    EXIT_WRONG = 2   /* wrong input or usage */
};

/* The code to end with once all is printed: EXIT_FAILED, after a message, where standard output did not take it. */
int exit_code_of_output(int code);

#endif
