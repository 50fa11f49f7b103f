#include "exit_code.h"

#include "message.h"

#include <stdio.h>

int exit_code_of_output(int code)
{
    if (fflush(stdout) != 0 || ferror(stdout)) {
        message("cannot write to standard output");
        return EXIT_FAILED;
    }
    return code;
}
