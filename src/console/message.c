#include "console/message.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const char *name = "?";
static bool line_open = false;
static void (*taker)(const char *text) = NULL;

void message_start(const char *program_name)
{
    name = program_name;
}

void message_hand_to(void (*take)(const char *text))
{
    taker = take;
}

void message_prompt(const char *prompt)
{
    fputs(prompt, stderr);
    line_open = true;
}

void message_answered(bool line_ended)
{
    line_open = !line_ended;
    message_end_line();
}

void message_end_line(void)
{
    if (line_open) {
        fputs("\n", stderr);
    }
    line_open = false;
}

/*
 * What a terminal may obey: control characters, also those that UTF-8 writes as C2 80 to C2 9F. A newline that is not
 * the remark's own would let a file's name pass for another message.
 */
static void disarm(char *text, bool lines)
{
    for (unsigned char *c = (unsigned char *)text; *c != '\0'; c++) {
        const bool control = (*c < ' ' && !(lines && *c == '\n')) || *c == 127;
        const bool second_set = c[0] == 0xc2 && c[1] >= 0x80 && c[1] <= 0x9f;
        if (control) {
            *c = '?';
        } else if (second_set) {
            c[0] = c[1] = '?';
        }
    }
}

/* A line of its own, or several. */
LIKE_PRINTF(3, 0)
static void say(const char *before, bool lines, const char *format, va_list arguments)
{
    char text[6000]; /* the longest path and more */
    vsnprintf(text, sizeof text, format, arguments);
    disarm(text, lines);
    if (taker != NULL) {
        taker(text);
        return;
    }
    fflush(stdout); /* both may go to one file: in the order of the program, not of a buffer */
    fprintf(stderr, "%s%s%s\n", line_open ? "\n" : "", before, text);
    line_open = false;
}

void message(const char *format, ...)
{
    va_list arguments;
    char before[32];
    snprintf(before, sizeof before, "%s: ", name);
    va_start(arguments, format);
    say(before, false, format, arguments);
    va_end(arguments);
}

void message_note(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    say("", true, format, arguments);
    va_end(arguments);
}

const char *message_quote(const char *text, quoted *quote)
{
    enum { MOST = 40 };
    char *to = quote->text;
    *to++ = '"';
    for (; *text != '\0' && to - quote->text <= MOST; text++) {
        *to++ = *text >= ' ' && *text <= '~' ? *text : '?';
    }
    strcpy(to, *text != '\0' ? "...\"" : "\"");
    return quote->text;
}
