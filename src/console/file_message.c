#include "console/file_message.h"

#include "console/message.h"

#include <stdio.h>

void file_message_list(const file_place *place, const char *format, va_list arguments)
{
    char text[1000];
    vsnprintf(text, sizeof text, format, arguments);
    message("%s:%zu:%zu: %s", place->path, place->line, place->column, text);
}

void file_message(const file_place *place, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    file_message_list(place, format, arguments);
    va_end(arguments);
}
