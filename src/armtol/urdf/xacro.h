#ifndef ARMTOL_URDF_XACRO_H
#define ARMTOL_URDF_XACRO_H

#include <stddef.h>
#include <stdio.h>

enum { XACRO_ARGUMENTS_MOST = 100 };

/*
 * What the program xacro makes of a file, with arguments NAME:=VALUE, XACRO_ARGUMENTS_MOST at most: a stream at its
 * start, the caller's to close. The program is the one on the PATH, and no shell is between. EXIT_OK, or an exit code
 * after a message.
 */
int xacro_expand(const char *path, const char *const arguments[], size_t n_arguments, FILE **expanded);

#endif
