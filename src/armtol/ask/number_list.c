#include "armtol/ask/number_list.h"

#include "console/message.h"
#include "console/number.h"
#include "console/word.h"

#include <math.h>
#include <string.h>

/* Commas and blanks set numbers apart, one comma at a time: "1,,2" lacks a number. */
static const char separators[] = " \t\n";

static bool is_free(const char *word)
{
    return strcmp(word, "-") == 0 || strcmp(word, "inf") == 0;
}

/* Copies the item at *at, cut to fit, and moves on behind it and the comma that ends it. False where it was cut. */
static bool next_word(const char **at, char word[WORD], bool *more)
{
    *at += strspn(*at, separators);
    const bool fits = word_take(at, " \t\n,", word);
    *at += strspn(*at, separators);
    *more = **at != '\0';
    *at += **at == ',';
    return fits;
}

static void wrong_number(const char *option, const char *word, number_fault fault, bool may_be_free)
{
    message("%s: %s %s%s", option, message_quote(word, &(quoted){""}), number_fault_text(fault),
            may_be_free ? "; expected a number, or - for a component that is free" : "");
}

static bool parse_word(const char *option, const char *word, bool may_be_free, double *value)
{
    if (may_be_free && is_free(word)) {
        *value = (double)INFINITY;
        return true;
    }
    const number_fault fault = number_parse(word, value);
    if (fault != NUMBER_FINE) {
        wrong_number(option, word, fault, may_be_free);
        return false;
    }
    return true;
}

bool number_list_parse(const char *option, const char *text, const char *what, bool may_be_free, size_t count,
                       double values[])
{
    size_t n = 0;
    bool more = *text != '\0';
    while (more) {
        char word[WORD];
        double value;
        if (!next_word(&text, word, &more)) {
            wrong_number(option, word, NUMBER_TOO_LONG, may_be_free);
            return false;
        }
        if (!parse_word(option, word, may_be_free, &value)) {
            return false;
        }
        if (n < count) {
            values[n] = value;
        }
        n++;
    }
    if (n != count) {
        message("%s: %zu number%s given; expected %zu: %s", option, n, n == 1 ? " is" : "s are", count, what);
        return false;
    }
    return true;
}

bool number_option_parse(const char *option, const char *text, double *value)
{
    return parse_word(option, text, false, value);
}

bool number_option_positive(const char *option, const char *text, double *value)
{
    double parsed;
    if (!number_option_parse(option, text, &parsed)) {
        return false;
    }
    if (!(parsed > 0)) {
        message("%s: %s is not greater than zero", option, message_quote(text, &(quoted){""}));
        return false;
    }
    *value = parsed;
    return true;
}
