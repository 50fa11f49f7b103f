#ifndef ARMTOL_LIB_ENGINE_VERIFICATION_PARTS_H
#define ARMTOL_LIB_ENGINE_VERIFICATION_PARTS_H

#include "armtol/verification.h"
#include "lib/engine/check.h"
#include "lib/engine/tally.h"
#include "lib/private_names.h"

/*
 * The steps of armtol_verify, for who draws the arms in parts: each part has its tally, from draw_arms and with the
 * same limits, and the sum of all tallies gives what armtol_verify gives, to the bit. Corners are apart
 * (corner_search.h).
 */

/* ARMTOL_UNBOUNDED, about the accuracy, as of armtol_verify; else about nothing. */
armtol_fault verification_check(const armtol_answer *answer);

/* What arms are held against. */
void verification_limits(const armtol_answer *answer, tally_limits *limits);

/* What was counted; of *found all but the corners is written. */
void verification_report(const armtol_answer *answer, const tally *tally, const tally_limits *limits,
                         armtol_verification *found);

#endif
