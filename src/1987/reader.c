#include "1987/reader.h"

void reader_start(reader *reader, FILE *stream, bool interactive)
{
    reader->stream = stream;
    reader->interactive = interactive;
    reader_drop_line(reader);
}

void reader_drop_line(reader *reader)
{
    reader->line[0] = '\0';
    reader->at = 0;
}

/* White space of the C locale. */
static bool is_space(int c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* A zero byte would end a word or a line early, and make part of it pass for the whole. */
static char visible(int c)
{
    return c == '\0' ? '?' : (char)c;
}

static int next_character(reader *reader)
{
    if (!reader->interactive) {
        return getc(reader->stream);
    }
    const char c = reader->line[reader->at];
    if (c == '\0') {
        return EOF;
    }
    reader->at++;
    return (unsigned char)c;
}

static read_result why_none(const reader *reader)
{
    if (reader->interactive) {
        return READ_LINE_ENDS;
    }
    return ferror(reader->stream) ? READ_FAILED : READ_END;
}

read_result reader_next(reader *reader, char word[READER_WORD])
{
    size_t length = 0;
    bool cut = false;
    int c = next_character(reader);
    while (is_space(c)) {
        c = next_character(reader);
    }
    if (c == EOF) {
        return why_none(reader);
    }
    for (; c != EOF && !is_space(c); c = next_character(reader)) {
        if (length == READER_WORD - 1) {
            cut = true;
            break;
        }
        word[length++] = visible(c);
    }
    word[length] = '\0';
    return cut ? READ_TOO_LONG : READ_WORD;
}

read_result reader_load_line(reader *reader)
{
    size_t length = 0;
    int c = getc(reader->stream);
    reader_drop_line(reader);
    if (c == EOF) {
        return ferror(reader->stream) ? READ_FAILED : READ_END;
    }
    for (; c != EOF && c != '\n'; c = getc(reader->stream)) {
        if (length < sizeof reader->line - 1) { /* more than a terminal's line can hold */
            reader->line[length++] = visible(c);
        }
    }
    reader->line[length] = '\0';
    return READ_LINE_ENDS;
}

size_t reader_words_left(const reader *reader)
{
    size_t words = 0;
    bool inside = false;
    for (const char *c = reader->line + reader->at; *c != '\0'; c++) {
        const bool now_inside = !is_space((unsigned char)*c);
        words += now_inside && !inside;
        inside = now_inside;
    }
    return words;
}
