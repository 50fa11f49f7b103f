#ifndef ARMTOL_1987_DIALOGUE_H
#define ARMTOL_1987_DIALOGUE_H

#include "1987/reader.h"

#include "armtol/errata.h"

#include <stdbool.h>
#include <stddef.h>

/* Questions on stderr, answers from a stream. */
typedef struct dialogue {
    reader reader;
    const armtol_errata *errata; /* an answer is stored as the programs stored it */
    size_t answered;             /* numbers, by now */
} dialogue;

typedef struct question {
    const char *prompt;
    const char *const *names; /* of the numbers asked for, in messages */
    size_t count;
} question;

/* Judges an answer: says what is wrong with it and returns false, or returns true. */
typedef bool judge(const double answer[], void *context);

void dialogue_start(dialogue *dialogue, FILE *stream, bool interactive, const armtol_errata *errata);

/*
 * Ask, read the numbers into answer, have them judged. What is wrong is explained; on a terminal the question
 * is then asked again. EXIT_OK, or the code to end the run with.
 */
int dialogue_ask(dialogue *dialogue, const question *question, judge *judge, void *context,
                 double answer[]);

/* After the last answer: say what is left of the input, as far as it is there by now. It stays unread. */
void dialogue_end(dialogue *dialogue);

#endif
