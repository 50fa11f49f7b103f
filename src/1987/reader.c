#include "1987/reader.h"

#include <poll.h>
#include <string.h>

void reader_start(reader *reader, FILE *stream, bool interactive)
{
    reader->stream = stream;
    reader->interactive = interactive;
    reader->begun = false;
    reader->waiting = true;
    reader->looked_at = 0;
    reader->ended = false;
    reader_drop_line(reader);
    if (!interactive) {
        setvbuf(stream, NULL, _IONBF, 0); /* what is ready can then be asked of the descriptor */
    }
}

void reader_wait_no_more(reader *reader)
{
    reader->waiting = false;
}

/* Whether reading would not wait: never where the stream has no descriptor. */
static bool is_ready(const reader *reader)
{
    struct pollfd input = {.fd = fileno(reader->stream), .events = POLLIN};
    return input.fd < 0 || poll(&input, 1, 0) > 0;
}

bool reader_is_ahead(const reader *reader)
{
    return reader_words_left(reader) > 0 || is_ready(reader);
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

static int next_of_stream(reader *reader)
{
    if (!reader->waiting && (reader->looked_at++ == READER_LINE || !is_ready(reader))) {
        return EOF;
    }
    return getc(reader->stream);
}

static int next_character(reader *reader)
{
    if (!reader->interactive) {
        return next_of_stream(reader);
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

static read_result next_word(reader *reader, char word[READER_WORD])
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

read_result reader_next(reader *reader, char word[READER_WORD])
{
    static const char mark[] = "\xef\xbb\xbf";
    const size_t length = sizeof mark - 1;
    const read_result result = next_word(reader, word);
    const bool first = !reader->begun && (result == READ_WORD || result == READ_TOO_LONG);
    reader->begun = reader->begun || first;
    if (!first || strncmp(word, mark, length) != 0) {
        return result;
    }
    memmove(word, word + length, strlen(word + length) + 1);
    return word[0] != '\0' ? result : next_word(reader, word);
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
    reader->ended = c == EOF;
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
