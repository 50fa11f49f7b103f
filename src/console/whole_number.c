#include "console/whole_number.h"

#include "console/message.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

bool whole_number_of(const char *text, uint64_t least, uint64_t most, uint64_t *value)
{
    const size_t length = strlen(text);
    errno = 0;
    const unsigned long long parsed = strtoull(text, NULL, 10);
    const bool whole = length > 0 && strspn(text, "0123456789") == length && errno == 0;
    if (!whole || parsed < least || parsed > most) {
        return false;
    }
    *value = parsed;
    return true;
}

bool whole_number_parse(const char *option, const char *text, uint64_t least, uint64_t most, uint64_t *value)
{
    const bool fine = whole_number_of(text, least, most, value);
    if (!fine) {
        message("%s: %s is not a whole number from %llu to %llu", option, message_quote(text, &(quoted){""}),
                (unsigned long long)least, (unsigned long long)most);
    }
    return fine;
}
