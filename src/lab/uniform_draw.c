#include "lab/uniform_draw.h"

#define STEP 0x9e3779b97f4a7c15u

static uint64_t mix(uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double uniform_draw(uint64_t seed, uint64_t index)
{
    /* the seed is mixed too: the draws of neighbouring seeds would else be each other's, one place on */
    const uint64_t bits = mix(mix(seed) + STEP * (index + 1));
    return (double)(bits >> 11) / 4503599627370496.0 - 1;
}
