#include "armtol/cluster/tally_file.h"

#include "armtol/ask/options.h"
#include "console/exit_code.h"
#include "console/file_message.h"
#include "console/list_room.h"
#include "console/message.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* A word of the longest, each character as three, and its name. */
enum { LINE = 3 * TALLY_WORD_MOST + 64 };

typedef struct reader {
    FILE *stream;
    const char *path;
    size_t line; /* at hand, from 1 */
    uint64_t checksum; /* of the lines before it */
    tally_result result; /* TALLY_WHOLE as long as nothing is wrong */
    tally_head *head;
    tally_content *content;
    size_t room; /* of the head's words */
    char text[LINE]; /* of the line, without its end */
} reader;

/* ---- lines ---- */

static const char no_tally[] = "this is no tally of this armtol; expected the first line \"armtol tally 1\"";

/* What does not begin as a tally is another file. */
static bool fail(reader *reader, const char *what)
{
    const file_place place = {reader->path, reader->line, 1};
    reader->result = reader->line > 1 ? TALLY_DAMAGED : TALLY_NONE;
    file_message(&place, "%s", reader->line > 1 ? what : no_tally);
    return false;
}

static bool damaged(reader *reader)
{
    return fail(reader, "the tally is damaged here; expected it as it was written");
}

static bool out_of_room(reader *reader)
{
    reader->result = TALLY_UNREADABLE;
    return false;
}

static bool ended(reader *reader)
{
    if (ferror(reader->stream)) {
        exit_code_note_error(errno);
        message("%s: %s", reader->path, strerror(errno));
        reader->result = TALLY_UNREADABLE;
        return false;
    }
    return fail(reader, "the tally is cut: its end is missing");
}

/* The next line, the one before it counted in the checksum. A line that does not end is cut. */
static bool next_line(reader *reader)
{
    if (reader->line > 0) {
        reader->checksum = tally_checksum(reader->checksum, reader->text, strlen(reader->text));
        reader->checksum = tally_checksum(reader->checksum, "\n", 1);
    }
    reader->line++;
    errno = 0;
    if (fgets(reader->text, sizeof reader->text, reader->stream) == NULL) {
        reader->text[0] = '\0';
        return ended(reader);
    }
    const size_t length = strlen(reader->text);
    if (length > 0 && reader->text[length - 1] == '\n') {
        reader->text[length - 1] = '\0';
        return true;
    }
    return feof(reader->stream) ? ended(reader) : damaged(reader);
}

/* ---- what is in a line ---- */

/* What is behind the name and a blank; NULL where another name stands there. */
static const char *behind(const char *text, const char *name)
{
    const size_t length = strlen(name);
    return strncmp(text, name, length) == 0 && text[length] == ' ' ? text + length + 1 : NULL;
}

static bool take_digit(char c, unsigned base, uint64_t *value)
{
    const unsigned digit = c >= '0' && c <= '9'   ? (unsigned)(c - '0')
                           : c >= 'a' && c <= 'f' ? (unsigned)(c - 'a') + 10
                                                  : 16;
    if (digit >= base || *value > (UINT64_MAX - digit) / base) {
        return false;
    }
    *value = *value * base + digit;
    return true;
}

/* A whole number, as it is written: no sign, no blank. *at is moved behind it, to the next one where there is one. */
static bool take_number(const char **at, unsigned base, uint64_t *value)
{
    const char *begin = *at;
    *value = 0;
    while (**at != ' ' && **at != '\0') {
        if (!take_digit(**at, base, value)) {
            return false;
        }
        ++*at;
    }
    const bool fine = *at > begin;
    *at += **at == ' ' && (*at)[1] != '\0';
    return fine;
}

/* A line of the name and a number. */
static bool take_line(reader *reader, const char *name, unsigned base, uint64_t *number)
{
    const char *at = next_line(reader) ? behind(reader->text, name) : NULL;
    const bool fine = at != NULL && take_number(&at, base, number) && *at == '\0';
    return fine || (reader->result == TALLY_WHOLE && damaged(reader));
}

/* ---- the head ---- */

static bool take_first_lines(reader *reader)
{
    static const char form[] = "armtol tally 1";
    if (!next_line(reader)) {
        return false;
    }
    if (strcmp(reader->text, form) != 0) {
        return damaged(reader);
    }
    const char *version = next_line(reader) ? behind(reader->text, "version") : NULL;
    if (version == NULL || strlen(version) >= sizeof reader->head->version) {
        return reader->result == TALLY_WHOLE && damaged(reader);
    }
    memcpy(reader->head->version, version, strlen(version) + 1);
    return true;
}

/* The word as it was typed, in the same place. */
static bool unescape(char *word)
{
    char *to = word;
    for (const char *at = word; *at != '\0'; to++) {
        uint64_t byte = (unsigned char)*at;
        if (*at++ == '%') {
            byte = 0;
            if (!take_digit(at[0], 16, &byte) || !take_digit(at[1], 16, &byte) || byte == 0) {
                return false;
            }
            at += 2;
        }
        *to = (char)(unsigned char)byte;
    }
    *to = '\0';
    return true;
}

static bool add_word(reader *reader, const char *text)
{
    tally_head *head = reader->head;
    char **words = list_room(head->words, head->n_words + 1, &reader->room, sizeof *words);
    if (words == NULL) {
        return out_of_room(reader);
    }
    head->words = words;
    words[head->n_words] = strdup(text);
    if (words[head->n_words] == NULL) {
        out_of_memory();
        return out_of_room(reader);
    }
    words[++head->n_words] = NULL;
    return unescape(words[head->n_words - 1]) || damaged(reader);
}

/* All words, and the line behind them is at hand. */
static bool take_words(reader *reader)
{
    while (next_line(reader)) {
        const char *word = behind(reader->text, "word");
        if (word == NULL) {
            return true;
        }
        if (!add_word(reader, word)) {
            return false;
        }
    }
    return false;
}

/* Of which form the tally is, by the name of the line at hand, and how many arms or rows there are. */
static bool take_form(reader *reader)
{
    static const tally_form *const forms[] = {&tally_of_arms, &tally_of_rows};
    tally_head *head = reader->head;
    for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        const char *at = behind(reader->text, forms[i]->many);
        if (at != NULL) {
            head->form = forms[i];
            return (take_number(&at, 10, &head->total) && *at == '\0') || damaged(reader);
        }
    }
    return damaged(reader);
}

static bool take_shard(reader *reader)
{
    tally_head *head = reader->head;
    const char *at = behind(reader->text, "shard");
    const bool fine = at != NULL && take_number(&at, 10, &head->shard) && take_number(&at, 10, &head->n_shards) &&
                      *at == '\0';
    if (!fine) {
        return damaged(reader);
    }
    if (!next_line(reader) || !take_form(reader)) {
        return false;
    }
    const bool sound = head->shard >= 1 && head->shard <= head->n_shards && head->n_shards <= MOST_SHARDS &&
                       head->n_shards <= head->total && head->total <= head->form->most && head->n_words > 0;
    return sound || damaged(reader);
}

static bool take_numbers(reader *reader)
{
    tally_head *head = reader->head;
    for (size_t i = 0; i < head->form->n_numbers; i++) {
        if (!take_line(reader, head->form->numbers[i], 10, &head->numbers[i])) {
            return false;
        }
    }
    return head->form->is_sound(head) || damaged(reader);
}

static bool take_head(reader *reader)
{
    tally_head *head = reader->head;
    bool fine = take_first_lines(reader) && take_words(reader) && take_shard(reader) && take_numbers(reader);
    for (size_t i = 0; fine && i < head->form->n_subjects; i++) {
        char name[40];
        snprintf(name, sizeof name, "fingerprint %s", head->form->subject(i));
        fine = take_line(reader, name, 16, &head->fingerprints[i]);
    }
    return fine;
}

/* ---- the contents ---- */

static bool take_value(const armtol_tally_member *member, size_t place, const char **at)
{
    uint64_t value;
    if (!take_number(at, member->counts != NULL ? 10 : 16, &value)) {
        return false;
    }
    if (member->counts != NULL) {
        member->counts[place] = value;
    } else {
        memcpy(&member->numbers[place], &value, sizeof value);
    }
    return true;
}

static bool take_values(const armtol_tally_member *member, const char *at)
{
    uint64_t place;
    bool fine = take_number(&at, 10, &place);
    for (; fine && *at != '\0'; place++) {
        fine = place < member->length && take_value(member, (size_t)place, &at);
    }
    return fine;
}

static bool take_member(reader *reader)
{
    const tally_form *form = reader->head->form;
    for (size_t i = 0; i < form->member_count(); i++) {
        const armtol_tally_member member = form->member(reader->content, i);
        const char *at = behind(reader->text, member.name);
        if (at != NULL) {
            return take_values(&member, at) || damaged(reader);
        }
    }
    return damaged(reader);
}

static bool take_end(reader *reader, const char *at)
{
    uint64_t checksum;
    if (!take_number(&at, 16, &checksum) || *at != '\0') {
        return damaged(reader);
    }
    if (checksum != reader->checksum) {
        return fail(reader, "the checksum is not that of the lines before: the tally is damaged");
    }
    if (getc(reader->stream) != EOF) {
        return fail(reader, "something stands behind the end of the tally");
    }
    return true;
}

static bool take_members(reader *reader)
{
    while (next_line(reader)) {
        const char *end = behind(reader->text, "end");
        if (end != NULL) {
            return take_end(reader, end);
        }
        if (!take_member(reader)) {
            return false;
        }
    }
    return false;
}

static bool take_content(reader *reader)
{
    const tally_head *head = reader->head;
    const tally_form *form = head->form;
    if (!form->start(reader->content, head, tally_head_range(head).count)) {
        out_of_memory();
        return out_of_room(reader);
    }
    return take_members(reader) && (form->fits(reader->content, head) || fail(reader, form->misfit));
}

tally_result tally_file_read(FILE *stream, const char *path, tally_head *head, tally_content *content)
{
    reader *reader = malloc(sizeof *reader);
    *head = (tally_head){.words = NULL};
    if (reader == NULL) {
        out_of_memory();
        return TALLY_UNREADABLE;
    }
    *reader = (struct reader){.checksum = TALLY_CHECKSUM_START, .result = TALLY_WHOLE};
    reader->stream = stream;
    reader->path = path;
    reader->head = head;
    reader->content = content;
    const bool fine = take_head(reader) && take_content(reader);
    const tally_result result = reader->result;
    if (!fine) {
        tally_head_free(head);
    }
    free(reader);
    return result;
}
