#include "1987/dialogue.h"

#include "console/exit_code.h"
#include "console/message.h"
#include "console/number.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

typedef enum outcome { OUTCOME_ANSWERED, OUTCOME_WRONG, OUTCOME_ENDED, OUTCOME_FAILED } outcome;

void dialogue_start(dialogue *dialogue, FILE *stream, bool interactive, const armtol_errata *errata)
{
    reader_start(&dialogue->reader, stream, interactive);
    dialogue->errata = errata;
    dialogue->answered = 0;
}

/* "x y z", the names from `first` on, as far as they fit. */
static void join_names(const question *question, size_t first, char *text, size_t size)
{
    size_t length = 0;
    text[0] = '\0';
    for (size_t i = first; i < question->count && length < size; i++) {
        length += (size_t)snprintf(text + length, size - length, "%s%s", i > first ? " " : "", question->names[i]);
    }
}

static void explain_missing(const question *question, size_t have)
{
    char all[128];
    join_names(question, 0, all, sizeof all);
    message("%s: missing; expected %zu number%s (%s), got %zu", question->names[have], question->count,
            question->count == 1 ? "" : "s", all, have);
}

/* What the user may not know, told from what was typed. */
static const char *expected_in_place_of(const char *word)
{
    if (strpbrk(word, ",;:|") != NULL) {
        return "numbers separated by blanks, with a point for decimals, such as 200 -1.5e2";
    }
    if (strchr(word, '\033') != NULL) {
        return "a decimal number such as 200 or -1.5e2; arrows and such keys edit nothing here";
    }
    return "a decimal number such as 200 or -1.5e2";
}

static void explain_number(const question *question, size_t i, const char *word, number_fault fault)
{
    message("%s: %s %s; expected %s", question->names[i], message_quote(word, &(quoted){""}), number_fault_text(fault),
            expected_in_place_of(word));
}

/* Documents have another minus than keyboards. */
static void type_minus(char *word)
{
    char *to = word;
    for (const char *from = word; *from != '\0';) {
        const size_t typeset = number_typeset_minus(from);
        *to++ = typeset > 0 ? '-' : *from;
        from += typeset > 0 ? typeset : 1;
    }
    *to = '\0';
}

/* The word as the program stores it. */
static number_fault parse_stored(char *word, const armtol_errata *errata, double *value)
{
    double parsed = 0;
    type_minus(word);
    const number_fault fault = number_parse(word, &parsed);
    if (fault != NUMBER_FINE) {
        return fault;
    }
    const double stored = armtol_stored(errata, parsed);
    if (!isfinite(stored)) {
        return NUMBER_TOO_LARGE;
    }
    *value = stored;
    return NUMBER_FINE;
}

/*
 * A terminal's line has ended before all numbers were there. As in 1987 the rest may come on the next line; but
 * who types all of them again means those.
 */
static outcome next_line(dialogue *dialogue, const question *question, size_t *have)
{
    if (dialogue->reader.ended) {
        return OUTCOME_ENDED;
    }
    if (*have > 0) {
        char rest[128];
        join_names(question, *have, rest, sizeof rest);
        message("%s: missing; go on with %s, or type all %zu numbers again", question->names[*have], rest,
                question->count);
    }
    switch (reader_load_line(&dialogue->reader)) {
    case READ_END:
        return OUTCOME_ENDED;
    case READ_FAILED:
        return OUTCOME_FAILED;
    default:
        break;
    }
    message_answered(!dialogue->reader.ended);
    if (reader_words_left(&dialogue->reader) == question->count) {
        *have = 0;
    }
    return OUTCOME_ANSWERED;
}

static outcome read_answer(dialogue *dialogue, const question *question, double answer[])
{
    size_t have = 0;
    while (have < question->count) {
        char word[READER_WORD];
        outcome outcome = OUTCOME_ANSWERED;
        number_fault fault;
        switch (reader_next(&dialogue->reader, word)) {
        case READ_WORD:
            fault = parse_stored(word, dialogue->errata, &answer[have]);
            if (fault == NUMBER_FINE) {
                have++;
                break;
            }
            explain_number(question, have, word, fault);
            return OUTCOME_WRONG;
        case READ_TOO_LONG:
            explain_number(question, have, word, NUMBER_TOO_LONG);
            return OUTCOME_WRONG;
        case READ_LINE_ENDS:
            outcome = next_line(dialogue, question, &have);
            break;
        case READ_END:
            outcome = OUTCOME_ENDED;
            break;
        case READ_FAILED:
            outcome = OUTCOME_FAILED;
            break;
        }
        if (outcome == OUTCOME_ENDED) {
            explain_missing(question, have);
        }
        if (outcome != OUTCOME_ANSWERED) {
            return outcome;
        }
    }
    return OUTCOME_ANSWERED;
}

/* Whether a user sees what is said beside what was typed. Into a file the dialogue goes as in 1987. */
static bool on_screen(const dialogue *dialogue)
{
    return dialogue->reader.interactive && isatty(STDERR_FILENO);
}

/* A line had more numbers than were asked for. As in 1987 they answer the question that comes now. */
static void tell_carried_over(const dialogue *dialogue, const question *question)
{
    const size_t left = reader_words_left(&dialogue->reader);
    if (left > 0 && on_screen(dialogue)) {
        reader ahead = dialogue->reader;
        char word[READER_WORD];
        reader_next(&ahead, word);
        message("more on the line than was asked for: %s is taken as %s%s", message_quote(word, &(quoted){""}),
                question->names[0], left > 1 ? ", and so on" : "");
    }
}

/* An answer that was typed before its question stands above it, so that the user does not end the question's line. */
static void prompt(const dialogue *dialogue, const question *question)
{
    const bool ahead = on_screen(dialogue) && reader_is_ahead(&dialogue->reader);
    message_prompt(question->prompt);
    if (ahead) {
        message_end_line();
    }
}

int dialogue_ask(dialogue *dialogue, const question *question, judge *judge, void *context, double answer[])
{
    tell_carried_over(dialogue, question);
    for (;;) {
        prompt(dialogue, question);
        const outcome outcome = read_answer(dialogue, question, answer);
        if (outcome == OUTCOME_FAILED) {
            message("cannot read the input: %s", strerror(errno));
            return EXIT_FAILED;
        }
        if (outcome == OUTCOME_ANSWERED && judge(answer, context)) {
            dialogue->answered += question->count;
            return EXIT_OK;
        }
        if (outcome == OUTCOME_ENDED || !dialogue->reader.interactive) {
            return EXIT_WRONG;
        }
        reader_drop_line(&dialogue->reader);
    }
}

static bool next_left_over(reader *reader, char word[READER_WORD])
{
    const read_result result = reader_next(reader, word);
    return result == READ_WORD || result == READ_TOO_LONG;
}

static void tell_left_over(dialogue *dialogue)
{
    enum { SHOWN = 6 };
    reader *reader = &dialogue->reader;
    char text[SHOWN * sizeof(quoted)] = "", word[READER_WORD];
    size_t length = 0;
    bool more = next_left_over(reader, word);
    for (int i = 0; i < SHOWN && more; i++) {
        length += (size_t)snprintf(text + length, sizeof text - length, " %s", message_quote(word, &(quoted){""}));
        more = next_left_over(reader, word);
    }
    if (length > 0) {
        message("warning: more than the %zu numbers asked for; not used:%s%s", dialogue->answered, text,
                more ? " ..." : "");
    }
}

void dialogue_end(dialogue *dialogue)
{
    reader *reader = &dialogue->reader;
    const off_t at = reader->interactive ? -1 : ftello(reader->stream);
    reader_wait_no_more(reader);
    tell_left_over(dialogue);
    if (at >= 0) {
        fseeko(reader->stream, at, SEEK_SET); /* another program may go on in this file */
    }
}
