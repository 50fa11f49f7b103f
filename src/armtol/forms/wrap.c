#include "armtol/forms/wrap.h"

#include <stdarg.h>
#include <string.h>

enum { LINE = 80 };

static void begin_line(wrap *wrap, size_t indent)
{
    fprintf(wrap->stream, "%*s", (int)indent, "");
    wrap->column = indent;
    wrap->fresh = true;
}

void wrap_start(wrap *wrap, FILE *stream, size_t first, size_t indent)
{
    *wrap = (struct wrap){.stream = stream, .indent = indent};
    begin_line(wrap, first);
}

static void put_word(wrap *wrap, const char *word, size_t length)
{
    if (!wrap->fresh && wrap->column + 1 + length > LINE) {
        fputc('\n', wrap->stream);
        begin_line(wrap, wrap->indent);
    }
    fprintf(wrap->stream, "%s%.*s", wrap->fresh ? "" : " ", (int)length, word);
    wrap->column += length + (wrap->fresh ? 0 : 1);
    wrap->fresh = false;
}

void wrap_say(wrap *wrap, const char *format, ...)
{
    char text[6000];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    for (const char *word = text; *word != '\0';) {
        const size_t length = strcspn(word, " ");
        if (length > 0) {
            put_word(wrap, word, length);
        }
        word += length + (word[length] == ' ');
    }
}

void wrap_end(wrap *wrap)
{
    fputc('\n', wrap->stream);
    wrap->column = 0;
    wrap->fresh = true;
}
