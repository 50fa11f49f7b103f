#ifndef ARMTOL_LIB_TOOL_DISC_DRAW_H
#define ARMTOL_LIB_TOOL_DISC_DRAW_H

#include "armtol/sampler.h"
#include "lib/lanes/sincos.h"
#include "lib/pi.h"

/*
 * Two draws, even from -1 to 1, become a point that is even in a disc: the first is its place in the disc's area, from
 * the middle to the rim, the second its direction.
 */
LANE_INLINE void draw_in_disc(const armtol_sampled_link *link, real errors[ARMTOL_PARAMETER_COUNT])
{
    if (!(link->disc > 0)) {
        return;
    }
    real distance = 0.5 * errors[ARMTOL_ALPHA] + 0.5, sine, cosine;
    const real direction = PI * errors[ARMTOL_BETA];
    take_root(&distance);
    sine_cosine(&direction, &sine, &cosine);
    errors[ARMTOL_ALPHA] = distance * cosine * link->disc;
    errors[ARMTOL_BETA] = distance * sine * link->disc;
}

#endif
