#ifndef ARMTOL_ASK_WATCHED_H
#define ARMTOL_ASK_WATCHED_H

#include "armtol/arrivals.h"
#include "armtol/tally.h"
#include "armtol/verification.h"

/*
 * armtol_verify with somebody who waits for it: a progress bar on standard error where that is a terminal and the
 * drawing takes longer than a second; an interrupt (SIGINT) ends the work, not the program, and a second one the
 * program. progress and context of the draw are not looked at.
 */
armtol_status watched_verify(const armtol_answer *answer, const armtol_draw *draw, armtol_verification *found,
                             armtol_fault *fault);

/* armtol_tally_draw and armtol_tally_verify in the same way. */
armtol_status watched_tally_draw(const armtol_answer *answer, const armtol_draw *draw, uint64_t first,
                                 armtol_tally *tally, armtol_fault *fault);
armtol_status watched_tally_verify(const armtol_answer *answer, const armtol_draw *draw, const armtol_tally *tally,
                                   armtol_verification *found, armtol_fault *fault);

/* armtol_arrivals_create in the same way. */
armtol_status watched_arrivals(const armtol_answer *answer, const armtol_draw *draw, size_t cycles,
                               armtol_arrivals **arrivals, armtol_fault *fault);

#endif
