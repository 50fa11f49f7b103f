#ifndef ARMTOL_CONSOLE_SHARE_INTERVAL_H
#define ARMTOL_CONSOLE_SHARE_INTERVAL_H

#include <stdint.h>

typedef struct share_interval {
    double low, high;
} share_interval;

/*
 * 95 % interval of a share of which `hits` of `samples` draws are known: Wilson's score interval, which also
 * says something where all draws hit or none. Without samples it is 0 to 1.
 */
share_interval share_interval_95(uint64_t hits, uint64_t samples);

#endif
