#include "console/file_message.h"

#include "console/message.h"

#include <stdarg.h>
#include <stdio.h>

void file_message(const file_place *place, const char *format, ...)
{
    char text[1000];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    message("%s:%zu:%zu: %s", place->path, place->line, place->column, text);
}
