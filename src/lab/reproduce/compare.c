#include "lab/reproduce/compare.h"

#include <stdio.h>
#include <string.h>

/* The number that follows " LABEL = " or "\nLABEL = ". */
static bool find(const char *files, const char *label, char computed[32])
{
    const size_t length = strlen(label);
    for (const char *at = strstr(files, label); at != NULL; at = strstr(at + 1, label)) {
        const bool begins = at == files || at[-1] == ' ' || at[-1] == '\n';
        if (begins && strncmp(at + length, " = ", 3) == 0) {
            return sscanf(at + length + 3, "%31s", computed) == 1;
        }
    }
    return false;
}

static comparison compare_label(const published_number *number, const char *label, const char *files)
{
    comparison result = {VERDICT_MISSING, ""};
    if (find(files, label, result.computed)) {
        const bool negative = result.computed[0] == '-';
        const char *shown = number->without_sign && negative ? result.computed + 1 : result.computed;
        const bool same = strcmp(shown, number->value) == 0;
        result.verdict = !same                           ? VERDICT_DIFFERS
                         : shown == result.computed ? VERDICT_AGREES
                                                         : VERDICT_AGREES_WITHOUT_SIGN;
    }
    return result;
}

comparison compare_number(const published_number *number, const char *files)
{
    char name[32];
    int first, last;
    if (sscanf(number->quantity, "%31[^[][%d..%d]", name, &first, &last) != 3) {
        return compare_label(number, number->quantity, files);
    }
    comparison result = {VERDICT_MISSING, ""};
    for (int i = first; i <= last; i++) {
        char label[64];
        snprintf(label, sizeof label, "%s[%d]", name, i);
        result = compare_label(number, label, files);
        if (result.verdict == VERDICT_DIFFERS || result.verdict == VERDICT_MISSING) {
            break;
        }
    }
    return result;
}

bool compare_agrees(const comparison *comparison)
{
    return comparison->verdict == VERDICT_AGREES || comparison->verdict == VERDICT_AGREES_WITHOUT_SIGN;
}
