#include "support/random.h"

uint64_t random_bits(random_source *source)
{
    uint64_t z = source->state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double random_between(random_source *source, double low, double high)
{
    return low + (high - low) * (double)(random_bits(source) >> 11) / 9007199254740992.0;
}
