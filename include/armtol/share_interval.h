#ifndef ARMTOL_SHARE_INTERVAL_H
#define ARMTOL_SHARE_INTERVAL_H

#include "armtol/interface.h"

#include <stdint.h>

ARMTOL_INTERFACE_BEGIN

typedef struct armtol_share_interval {
    double low, high;
} armtol_share_interval;

/*
 * The 95 % interval of a share of which some draws are known.
 *
 * Given:
 *    hits, samples   hits <= samples
 *
 * Notes:
 * 1) It also says something where all draws hit or none. Without samples it is 0 to 1.
 *
 * Reference:
 *    Wilson, Probable inference, the law of succession, and statistical inference, JASA 22 (1927): the score interval.
 */
armtol_share_interval armtol_share_interval_95(uint64_t hits, uint64_t samples);

ARMTOL_INTERFACE_END

#endif
