#ifndef ARMTOL_LIB_ENGINE_TALLY_H
#define ARMTOL_LIB_ENGINE_TALLY_H

#include "lib/private_names.h"

#include <stddef.h>
#include <stdint.h>

/* What becomes of arms drawn: counts, so that tallies of parts add up to the same whatever the parts. */

/*
 * The histogram's bins have a fixed relative width, as those of HdrHistogram: the exponent of a double and its first
 * bits are the number of its bin. The last is that of the range, the first has all that is below.
 */
enum {
    TALLY_BITS = 10,    /* a bin is no wider than 2^-10 of what is in it */
    TALLY_OCTAVES = 64, /* below the range: 2^-64 of it is less than rounding leaves of any error of an arm */
    TALLY_BINS = TALLY_OCTAVES << TALLY_BITS,
    TALLY_MOST = 256 /* arms at a time: what they need stays in the nearest cache */
};

/* What an arm is held against, per component. */
typedef struct tally_limits {
    double range[6];    /* of the histogram: a magnitude that no arm exceeds, rounding apart */
    double accuracy[6]; /* infinity where none is asked for */
    double beyond[6];   /* more than this is beyond the accuracy and the remainder */
} tally_limits;

typedef struct tally {
    uint64_t drawn, within, beyond;
    double worst[6];       /* -1 before the first arm */
    uint64_t worst_arm[6]; /* the first that had it */
    uint64_t bins[6][TALLY_BINS];
} tally;

void tally_start(tally *tally);

/*
 * Arms first to first + count - 1, in ascending order from call to call; magnitudes[i * count + j] is
 * component i of arm first + j; count is at most TALLY_MOST.
 */
void tally_add(tally *tally, const tally_limits *limits, uint64_t first, size_t count,
               const double magnitudes[]);

void tally_merge(tally *into, const tally *part);

/*
 * The magnitude that this many thousandths of the arms do not exceed, rounded up to the end of a bin: by no more than
 * 2^-TALLY_BITS of it, or to 2^-63 of the range where that is more, and never above the worst. 0 where no arm was
 * drawn.
 */
double tally_quantile(const tally *tally, const tally_limits *limits, size_t component, unsigned thousandths);

#endif
