#include "console/word.h"

#include <string.h>

size_t word_among(const char *text, const char *const names[], size_t count)
{
    size_t i = 0;
    while (i < count && strcmp(text, names[i]) != 0) {
        i++;
    }
    return i;
}

bool word_take(const char **at, const char *ends, char word[WORD])
{
    const size_t length = strcspn(*at, ends);
    const size_t kept = length < WORD ? length : WORD - 1;
    memcpy(word, *at, kept);
    word[kept] = '\0';
    *at += length;
    return kept == length;
}

bool words_each(const char *list, word_taker *take, void *context)
{
    char word[WORD];
    word_take(&list, ",", word);
    while (take(word, context)) {
        if (*list++ == '\0') {
            return true;
        }
        word_take(&list, ",", word);
    }
    return false;
}
