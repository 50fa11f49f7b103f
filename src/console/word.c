#include "console/word.h"

#include <string.h>

bool word_take(const char **at, const char *ends, char word[WORD])
{
    const size_t length = strcspn(*at, ends);
    const size_t kept = length < WORD ? length : WORD - 1;
    memcpy(word, *at, kept);
    word[kept] = '\0';
    *at += length;
    return kept == length;
}
