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

void message(const char *format, ...)
{
    va_list arguments;
    if (line_open) {
        fputc('\n', stderr);
        line_open = false;
    }
    fprintf(stderr, "%s: ", name);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
}

quoted message_quote(const char *text)
{
    enum { MOST = 40 };
    quoted quote;
    size_t n = 0;
    quote.text[n++] = '"';
    for (; *text != '\0' && n <= MOST; text++) {
        const unsigned char c = (unsigned char)*text;
        quote.text[n++] = c < ' ' || c == 127 ? '?' : (char)c;
    }
    for (int dots = 0; *text != '\0' && dots < 3; dots++) {
        quote.text[n++] = '.';
    }
    quote.text[n++] = '"';
    quote.text[n] = '\0';
    return quote;
}
