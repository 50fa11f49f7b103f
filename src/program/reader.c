#include "reader.h"

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
        /* a zero byte would end the word early and make part of it pass for the whole */
        word[length++] = c == '\0' ? '?' : (char)c;
    }
    word[length] = '\0';
    return cut ? READ_TOO_LONG : READ_WORD;
}

read_result reader_load_line(reader *reader)
{
    reader_drop_line(reader);
    if (fgets(reader->line, sizeof reader->line, reader->stream) == NULL) {
        reader_drop_line(reader);
        return ferror(reader->stream) ? READ_FAILED : READ_END;
    }
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
