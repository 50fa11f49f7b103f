#ifndef ARMTOL_CONSOLE_FILE_MESSAGE_H
#define ARMTOL_CONSOLE_FILE_MESSAGE_H

#include "console/message.h"

#include <stdarg.h>
#include <stddef.h>

/* A place in a file: line and column from 1, the column in characters. */
typedef struct file_place {
    const char *path;
    size_t line;
    size_t column;
} file_place;

/* message() with "FILE:LINE:COLUMN: " before the text, which is where editors and compilers have their places. */
void file_message(const file_place *place, const char *format, ...) LIKE_PRINTF(2, 3);
void file_message_list(const file_place *place, const char *format, va_list arguments) LIKE_PRINTF(2, 0);

#endif
