#include "1987/dialogue.h"

#include "console/exit_code.h"
#include "console/message.h"
#include "console/number.h"

#include <errno.h>
#include <math.h>
#include <string.h>

typedef enum outcome { OUTCOME_ANSWERED, OUTCOME_WRONG, OUTCOME_ENDED, OUTCOME_FAILED } outcome;

void dialogue_start(dialogue *dialogue, FILE *stream, bool interactive, const armtol_errata *errata)
{
    reader_start(&dialogue->reader, stream, interactive);
    dialogue->errata = errata;
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

static void explain_number(const question *question, size_t i, const char *word, number_fault fault)
{
    message("%s: %s %s; expected a decimal number such as 200 or -1.5e2", question->names[i],
            message_quote(word, &(quoted){""}), number_fault_text(fault));
}

/* The word as the program stores it. */
static number_fault parse_stored(const char *word, const armtol_errata *errata, double *value)
{
    double parsed = 0;
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
    message_answered();
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

int dialogue_ask(dialogue *dialogue, const question *question, judge *judge, void *context, double answer[])
{
    for (;;) {
        message_prompt(question->prompt);
        const outcome outcome = read_answer(dialogue, question, answer);
        if (outcome == OUTCOME_FAILED) {
            message("cannot read the input: %s", strerror(errno));
            return EXIT_FAILED;
        }
        if (outcome == OUTCOME_ANSWERED && judge(answer, context)) {
            return EXIT_OK;
        }
        if (outcome == OUTCOME_ENDED || !dialogue->reader.interactive) {
            return EXIT_WRONG;
        }
        reader_drop_line(&dialogue->reader);
    }
}
