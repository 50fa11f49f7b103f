#ifndef ARMTOL_ENGINE_VERIFICATION_DRAW_H
#define ARMTOL_ENGINE_VERIFICATION_DRAW_H

#include "armtol/engine/verification.h"
#include "armtol/engine/verification_tally.h"

#include <stdbool.h>

/*
 * Draw task->samples arms on up to task->n_threads threads, this one among them; fewer where threads or
 * memory for more cannot be had. An interrupt ends it after the arms in work. Every tolerance is finite.
 * False after a message.
 */
bool verification_draw(const verification_task *task, const tally_limits *limits, tally *tally);

#endif
