#ifndef ARMTOL_CONSOLE_MESSAGE_H
#define ARMTOL_CONSOLE_MESSAGE_H

#include <stdbool.h>
#include <stdio.h>

/* For the compiler to check: argument `text` is printf's format, `rest` the first that goes into it; 0: a list does. */
#ifdef __GNUC__
#define LIKE_PRINTF(text, rest) __attribute__((format(printf, text, rest)))
#else
#define LIKE_PRINTF(text, rest)
#endif

/*
 * "NAME: " and the text, on a line of stderr of its own. NAME is what message_start got. Control characters, which
 * a name of a file may hold, come out as question marks.
 */
void message_start(const char *program_name);
void message(const char *format, ...) LIKE_PRINTF(1, 2);

/* The same without the name, and in as many lines as the text has: a remark. */
void message_note(const char *format, ...) LIKE_PRINTF(1, 2);

/*
 * Whole texts, of messages without the name, go to `take` in place of stderr; NULL: to stderr again. For a caller that
 * is no program on a terminal.
 */
void message_hand_to(void (*take)(const char *text));

/*
 * Ask on stderr; the line stays open for the answer. A message that comes before message_answered begins a
 * new line first. A user who answers ends the line as a rule; where the line is not ended, it is ended here.
 */
void message_prompt(const char *prompt);
void message_answered(bool line_ended);

/* End the line that is open, if one is. */
void message_end_line(void);

/* Room for a quotation: message_quote(text, &(quoted){""}). */
typedef struct quoted {
    char text[48];
} quoted;

/* What a user typed, in quotes, fit to print: plain ASCII and not endless. Returns quote->text. */
const char *message_quote(const char *text, quoted *quote);

#endif
