#ifndef ARMTOL_LIB_ENGINE_TALLY_H
#define ARMTOL_LIB_ENGINE_TALLY_H

#include "armtol/norm.h"
#include "armtol/tally.h"
#include "lib/private_names.h"

#include <stddef.h>
#include <stdint.h>

/*
 * What becomes of arms drawn, of the components of their errors and, behind them, of norms: measures. Counts, so that
 * tallies of parts add up to the same whatever the parts.
 */

/*
 * The histogram's bins have a fixed relative width, as those of HdrHistogram: the exponent of a double and its first
 * bits are the number of its bin. The last is that of the range, the first has all that is below.
 */
enum {
    TALLY_BITS = 10,    /* a bin is no wider than 2^-10 of what is in it */
    TALLY_OCTAVES = 64, /* below the range: 2^-64 of it is less than rounding leaves of any error of an arm */
    TALLY_BINS = TALLY_OCTAVES << TALLY_BITS,
    TALLY_MEASURES = 6 + ARMTOL_MOST_NORMS,
    TALLY_MOST = 256 /* arms at a time: what they need stays in the nearest cache */
};

/* What an arm is held against, per measure. */
typedef struct tally_limits {
    size_t n_measures;
    unsigned components[TALLY_MEASURES]; /* of the norms, from 6 on */
    double range[TALLY_MEASURES];    /* of the histogram: a magnitude that no arm exceeds, rounding apart */
    double accuracy[TALLY_MEASURES]; /* infinity where none is asked for */
    double beyond[TALLY_MEASURES];   /* more than this is beyond the accuracy and the remainder */
} tally_limits;

typedef struct armtol_tally {
    uint64_t n_measures;
    uint64_t drawn, within, beyond;
    double worst[TALLY_MEASURES];       /* -1 before the first arm */
    uint64_t worst_arm[TALLY_MEASURES]; /* the first that had it */
    uint64_t bins[TALLY_MEASURES][TALLY_BINS]; /* those of further measures are not touched */
} tally;

void tally_start(tally *tally, size_t n_measures);

/* The bytes of it, from its beginning, that are in use. */
size_t tally_size(const tally *tally);

/*
 * Arms first to first + count - 1, in ascending order from call to call; magnitudes[i * count + j] is
 * measure i of arm first + j; count is at most TALLY_MOST.
 */
void tally_add(tally *tally, const tally_limits *limits, uint64_t first, size_t count,
               const double magnitudes[]);

void tally_merge(tally *into, const tally *part);

/*
 * The magnitude that this many thousandths of the arms do not exceed, rounded up to the end of a bin: by no more than
 * 2^-TALLY_BITS of it, or to 2^-63 of the range where that is more, and never above the worst. 0 where no arm was
 * drawn.
 */
double tally_quantile(const tally *tally, const tally_limits *limits, size_t measure, unsigned thousandths);

#endif
