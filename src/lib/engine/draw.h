#ifndef ARMTOL_LIB_ENGINE_DRAW_H
#define ARMTOL_LIB_ENGINE_DRAW_H

#include "armtol/verification.h"
#include "lib/engine/tally.h"
#include "lib/private_names.h"

/*
 * Draw draw->samples arms, from arm `first` on, by up to draw->n_threads threads, this one among them; fewer where
 * threads or memory for more cannot be had. What has no bound is not drawn. Ended early after the arms in work. Errors:
 * ARMTOL_NO_MEMORY, and those of armtol_sampler_start.
 */
armtol_status draw_arms(const armtol_answer *answer, const armtol_draw *draw, uint64_t first,
                        const tally_limits *limits, tally *tally);

#endif
