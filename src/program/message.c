#include "message.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

static const char *name = "?";
static bool line_open = false;

void message_start(const char *program_name)
{
    name = program_name;
}

void message_prompt(const char *prompt)
{
    fputs(prompt, stderr);
    line_open = true;
}

void message_answered(void)
{
    line_open = false;
}

/* A line of its own. */
static void say(const char *before, const char *format, va_list arguments)
{
    fprintf(stderr, "%s%s", line_open ? "\n" : "", before);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    line_open = false;
}

void message(const char *format, ...)
{
    va_list arguments;
    char before[32];
    snprintf(before, sizeof before, "%s: ", name);
    va_start(arguments, format);
    say(before, format, arguments);
    va_end(arguments);
}

void message_note(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    say("", format, arguments);
    va_end(arguments);
}

quoted message_quote(const char *text)
{
    enum { MOST = 40 };
    quoted quote;
    size_t n = 0;
    quote.text[n++] = '"';
    for (; *text != '\0' && n <= MOST; text++) {
        quote.text[n++] = *text >= ' ' && *text <= '~' ? *text : '?';
    }
    for (int dots = 0; *text != '\0' && dots < 3; dots++) {
        quote.text[n++] = '.';
    }
    quote.text[n++] = '"';
    quote.text[n] = '\0';
    return quote;
}
