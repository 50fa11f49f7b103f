#include "console/exit_code.h"

#include "console/message.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>

static bool machine_failed = false;

void exit_code_note_error(int error)
{
    machine_failed = machine_failed || error == ENOMEM || error == EMFILE || error == ENFILE || error == EIO;
}

void out_of_memory(void)
{
    message("out of memory");
    exit_code_note_error(ENOMEM);
}

int exit_code_of_output(int code)
{
    if (fflush(stdout) != 0 || ferror(stdout)) {
        message("cannot write to standard output");
        return EXIT_FAILED;
    }
    return code == EXIT_WRONG && machine_failed ? EXIT_FAILED : code;
}
