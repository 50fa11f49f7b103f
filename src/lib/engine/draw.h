#ifndef ARMTOL_LIB_ENGINE_DRAW_H
#define ARMTOL_LIB_ENGINE_DRAW_H

#include "armtol/sampler.h"
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

/*
 * Prepare to draw the answer's arms in one pose, as its drives and loads shift them and with those tolerances, a column
 * each. shifted: n_links places of no further use; links: n_links, which stay with the sampler. Errors: those of
 * armtol_sampler_start.
 */
armtol_status draw_start_sampler(const armtol_answer *answer, size_t pose, const double tolerances[], uint64_t seed,
                                 armtol_link shifted[], armtol_sampled_link links[], armtol_sampler *sampler);

#endif
