/* Numbers as doubles, and what a float variable sees that stands on one half of them: a row of Markdown each. */

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

static uint32_t word_of(float value)
{
    uint32_t word;
    memcpy(&word, &value, sizeof word);
    return word;
}

/* Toward zero: a VAX double begins with the digits of the float, so that the others are cut off. */
static float leading_digits(double value)
{
    const float nearest = (float)value;
    const double beyond = value < 0 ? value - nearest : nearest - value;
    return beyond > 0 ? float_of(word_of(nearest) - 1) : nearest;
}

int main(int argc, char *argv[])
{
    for (int i = 1; i < argc; i++) {
        const double x = strtod(argv[i], NULL);
        const float cut = leading_digits(x);
        uint64_t bits;
        memcpy(&bits, &x, sizeof bits);
        const uint32_t upper = (uint32_t)(bits >> 32), lower = (uint32_t)bits;
        printf("| %s | `%08x %08x` | `%08x` %.8f | `%08x` %.3g | `%08x` %.8f | `%08x` %.8f |\n", argv[i],
               (unsigned)upper, (unsigned)lower, (unsigned)upper, float_of(upper), (unsigned)lower,
               float_of(lower), (unsigned)word_of(cut), cut, (unsigned)word_of((float)x), (float)x);
    }
    return 0;
}
