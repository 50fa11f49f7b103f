#ifndef ARMTOL_CONSOLE_INPUT_FILE_H
#define ARMTOL_CONSOLE_INPUT_FILE_H

#include <stdio.h>

/*
 * Open a file to read its bytes. NULL after a message: the path and why, between what stands before ("--poses: ") and
 * behind ("; expected ...").
 */
FILE *input_file_open(const char *before, const char *path, const char *behind);

#endif
