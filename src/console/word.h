#ifndef ARMTOL_CONSOLE_WORD_H
#define ARMTOL_CONSOLE_WORD_H

#include <stdbool.h>
#include <stddef.h>

/* The place of a text among names; count where it is none of them. */
size_t word_among(const char *text, const char *const names[], size_t count);

/* A word of a list on the command line, a zero behind it. */
enum { WORD = 64 };

/* Copies what stands before the first of ends, cut to fit, and moves *at there. False where it was cut. */
bool word_take(const char **at, const char *ends, char word[WORD]);

/* Takes one word; false, after a message, where it is wrong. */
typedef bool word_taker(const char *word, void *context);

/* Give the words of a list, a comma between each, to the taker, those that are too long cut. False where it is. */
bool words_each(const char *list, word_taker *take, void *context);

#endif
