#include "armtol/tables/text_lines.h"

#include "console/exit_code.h"
#include "console/file_message.h"
#include "console/list_room.h"
#include "console/message.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#define SAVE_AS "save the table as UTF-8 (in a spreadsheet: CSV, UTF-8)"

void text_lines_start(text_lines *lines, FILE *stream, const char *path)
{
    *lines = (text_lines){.stream = stream, .path = path};
}

void text_lines_free(text_lines *lines)
{
    free(lines->text);
    lines->text = NULL;
}

size_t text_characters(const char *text, const char *end)
{
    size_t count = 0;
    for (; text != end; text++) {
        count += ((unsigned char)*text & 0xc0) != 0x80; /* all but the first byte of a character are 10xxxxxx */
    }
    return count;
}

static bool append(text_lines *lines, char c)
{
    char *text = list_room(lines->text, lines->length, &lines->room, 1);
    if (text != NULL) {
        lines->text = text;
        lines->text[lines->length++] = c;
    }
    return text != NULL;
}

static file_place place_at(const text_lines *lines, size_t offset)
{
    return (file_place){lines->path, lines->number, 1 + text_characters(lines->text, lines->text + offset)};
}

static bool is_end(text_lines *lines, int c)
{
    if (c == '\r') {
        const int after = getc(lines->stream);
        if (after != '\n' && after != EOF) {
            ungetc(after, lines->stream);
        }
    }
    return c == '\r' || c == '\n';
}

/* The bytes of a line, a zero behind them. */
static line_result read_bytes(text_lines *lines)
{
    lines->length = 0;
    errno = 0;
    int c = getc(lines->stream);
    const bool none = c == EOF;
    for (; c != EOF && !is_end(lines, c); c = getc(lines->stream)) {
        if (lines->length == TEXT_LINE_MOST) {
            const file_place place = place_at(lines, lines->length);
            file_message(&place, "the line is too long; expected at most %d bytes", TEXT_LINE_MOST);
            return LINE_WRONG;
        }
        if (!append(lines, (char)c)) {
            return LINE_WRONG;
        }
    }
    if (ferror(lines->stream)) {
        exit_code_note_error(errno);
        message("%s: %s", lines->path, errno != 0 ? strerror(errno) : "cannot be read");
        return LINE_WRONG;
    }
    if (!append(lines, '\0')) {
        return LINE_WRONG;
    }
    lines->length--;
    return none ? LINE_NONE : LINE_THERE;
}

/* How long the character is that begins here; 0 where none does. No longer forms than needed, no surrogates. */
static size_t character_length(const unsigned char *c)
{
    static const struct {
        unsigned char first, last, low, high; /* of the first byte, of the second */
        size_t length;
    } forms[] = {
        {0x00, 0x7f, 0x00, 0x00, 1}, {0xc2, 0xdf, 0x80, 0xbf, 2}, {0xe0, 0xe0, 0xa0, 0xbf, 3},
        {0xe1, 0xec, 0x80, 0xbf, 3}, {0xed, 0xed, 0x80, 0x9f, 3}, {0xee, 0xef, 0x80, 0xbf, 3},
        {0xf0, 0xf0, 0x90, 0xbf, 4}, {0xf1, 0xf3, 0x80, 0xbf, 4}, {0xf4, 0xf4, 0x80, 0x8f, 4},
    };
    for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        if (c[0] >= forms[i].first && c[0] <= forms[i].last) {
            bool fine = forms[i].length == 1 || (c[1] >= forms[i].low && c[1] <= forms[i].high);
            for (size_t k = 2; fine && k < forms[i].length; k++) {
                fine = (c[k] & 0xc0) == 0x80;
            }
            return fine ? forms[i].length : 0;
        }
    }
    return 0;
}

/* Also those that UTF-8 writes as C2 80 to C2 9F: a terminal may obey them. */
static bool is_control(const unsigned char *c)
{
    return (c[0] < ' ' && c[0] != '\t') || c[0] == 127 || (c[0] == 0xc2 && c[1] < 0xa0);
}

/* What is wrong with the character that begins here, of that length; NULL where nothing is. */
static const char *fault_of(const unsigned char *c, size_t length)
{
    if (length == 0) {
        return "a character that is not UTF-8; " SAVE_AS;
    }
    if (*c == '\0') {
        return "a zero byte: UTF-16, or no text; " SAVE_AS;
    }
    return is_control(c) ? "a control character, which has no meaning here" : NULL;
}

void text_make_printable(char *text)
{
    for (unsigned char *c = (unsigned char *)text; *c != '\0';) {
        const size_t length = character_length(c);
        if (*c == '\t' || fault_of(c, length) != NULL) {
            *c++ = '?';
        } else {
            c += length;
        }
    }
}

static bool check_characters(const text_lines *lines)
{
    const unsigned char *text = (const unsigned char *)lines->text;
    size_t length;
    for (size_t i = 0; i < lines->length; i += length) {
        length = character_length(text + i);
        const char *fault = fault_of(text + i, length);
        if (fault != NULL) {
            const file_place place = place_at(lines, i);
            file_message(&place, "%s", fault);
            return false;
        }
    }
    return true;
}

/* The marks of the first line: UTF-8's is dropped, UTF-16's refused. */
static bool check_mark(text_lines *lines)
{
    if (strncmp(lines->text, "\xff\xfe", 2) == 0 || strncmp(lines->text, "\xfe\xff", 2) == 0) {
        const file_place place = place_at(lines, 0);
        file_message(&place, "the file is UTF-16; " SAVE_AS);
        return false;
    }
    if (strncmp(lines->text, "\xef\xbb\xbf", 3) == 0) {
        lines->length -= 3;
        memmove(lines->text, lines->text + 3, lines->length + 1);
    }
    return true;
}

line_result text_lines_next(text_lines *lines)
{
    lines->number++;
    const line_result result = read_bytes(lines);
    if (result != LINE_THERE) {
        lines->number -= result == LINE_NONE;
        return result;
    }
    const bool fine = (lines->number > 1 || check_mark(lines)) && check_characters(lines);
    return fine ? LINE_THERE : LINE_WRONG;
}
