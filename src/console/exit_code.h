#ifndef ARMTOL_CONSOLE_EXIT_CODE_H
#define ARMTOL_CONSOLE_EXIT_CODE_H

#include <stdbool.h>

/* What a program tells the shell. */
enum {
    EXIT_OK = 0,
    EXIT_FAILED = 1, /* input was right, something else failed: a folder, a disk, memory */
    EXIT_WRONG = 2   /* wrong input or usage */
};

/*
 * Input is not wrong when it could not be read for want of memory, of descriptors or of a sound disk. Where such an
 * error (of errno; others are passed over) is noted, exit_code_of_output gives EXIT_FAILED in place of EXIT_WRONG.
 */
void exit_code_note_error(int error);

/* The message of that, and the note. */
void out_of_memory(void);

/* Whether there was enough: what is given, after that message where it is false. */
static inline bool enough_memory(bool enough)
{
    if (!enough) {
        out_of_memory();
    }
    return enough;
}

/* The code to end with once all is printed: EXIT_FAILED, after a message, where standard output did not take it. */
int exit_code_of_output(int code);

#endif
