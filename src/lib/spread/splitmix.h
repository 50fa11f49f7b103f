#ifndef ARMTOL_LIB_SPREAD_SPLITMIX_H
#define ARMTOL_LIB_SPREAD_SPLITMIX_H

#include <stdint.h>

/*
 * The generator splitmix64 (Steele, Lea, Flood 2014): its state goes up in steps, draw n is its state after n
 * + 1.
 */
#define SPLITMIX_STEP 0x9e3779b97f4a7c15u

/* How a state is mixed, in three steps; for single numbers and vectors alike. */
#define SPLITMIX_FIRST(z) (((z) ^ ((z) >> 30)) * 0xbf58476d1ce4e5b9u)
#define SPLITMIX_SECOND(z) (((z) ^ ((z) >> 27)) * 0x94d049bb133111ebu)
#define SPLITMIX_LAST(z) ((z) ^ ((z) >> 31))

static inline uint64_t splitmix_mix(uint64_t state)
{
    const uint64_t first = SPLITMIX_FIRST(state), second = SPLITMIX_SECOND(first);
    return SPLITMIX_LAST(second);
}

/* Of a state, uniform in [0, 1). */
static inline double splitmix_uniform(uint64_t state)
{
    return (double)(splitmix_mix(state) >> 11) * 0x1p-53;
}

#endif
