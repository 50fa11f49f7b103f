#ifndef TEST_RANDOM_H
#define TEST_RANDOM_H

#include <stdint.h>

/* Numbers to draw tests from, the same for a seed on every machine: splitmix64 (Steele, Lea, Flood 2014). */
typedef struct random_source {
    uint64_t state;
} random_source;

uint64_t random_bits(random_source *source);

/* Uniform in [low, high). */
double random_between(random_source *source, double low, double high);

#endif
