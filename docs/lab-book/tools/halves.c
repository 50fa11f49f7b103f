/* Numbers stored as floats, then passed on as doubles, and what a float sees on each half: a row of Markdown each. */

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static float float_of(uint32_t word)
{
    float value;
    memcpy(&value, &word, sizeof value);
    return value;
}

int main(int argc, char *argv[])
{
    for (int i = 1; i < argc; i++) {
        const float stored = strtof(argv[i], NULL);
        const double passed = stored;
        uint32_t word;
        uint64_t bits;
        memcpy(&word, &stored, sizeof word);
        memcpy(&bits, &passed, sizeof bits);
        const uint32_t upper = (uint32_t)(bits >> 32), lower = (uint32_t)bits;
        printf("| %s | `%08x` %.8f | `%08x %08x` | `%08x` %.8f | `%08x` %g |\n", argv[i], (unsigned)word, stored,
               (unsigned)upper, (unsigned)lower, (unsigned)upper, float_of(upper), (unsigned)lower, float_of(lower));
    }
    return 0;
}
