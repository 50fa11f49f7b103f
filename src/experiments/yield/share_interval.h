#ifndef EXPERIMENTS_SHARE_INTERVAL_H
#define EXPERIMENTS_SHARE_INTERVAL_H

#include <stddef.h>

typedef struct share_interval {
    double low, high;
} share_interval;

/*
 * 95 % interval of a share of which `hits` of `samples` draws are known: Wilson's score interval, which also
 * says something where all draws hit or none. samples > 0.
 */
share_interval share_interval_95(size_t hits, size_t samples);

#endif
