#ifndef ARMTOL_ARRIVALS_H
#define ARMTOL_ARRIVALS_H

#include "armtol/answer.h"
#include "armtol/interface.h"
#include "armtol/verification.h"

#include <stddef.h>
#include <stdint.h>

ARMTOL_INTERFACE_BEGIN

enum {
    ARMTOL_ARRIVAL_CYCLES = 30,  /* what ISO 9283 has */
    ARMTOL_ARRIVAL_QUANTILES = 4
};

/* A number of each arm drawn, in the arm's unit of length: what shares of the arms do not exceed. */
typedef struct armtol_over_arms {
    double quantiles[ARMTOL_ARRIVAL_QUANTILES]; /* the least of the arms' numbers that so many do not exceed */
    double largest;
    uint64_t largest_arm; /* the first arm that had it, as armtol_sampler_parameters counts them */
} armtol_over_arms;

/* What arms that come to a pose again and again do. */
typedef struct armtol_repeated {
    armtol_over_arms accuracy;      /* AP, of the position; nan where that depends on a parameter without a bound */
    armtol_over_arms repeatability; /* RP, of the position */
} armtol_repeated;

typedef struct armtol_arrivals {
    uint64_t drawn; /* arms; fewer than asked for where it was ended early */
    size_t cycles;  /* arrivals of each arm at each pose */
    size_t n_poses; /* those of the answer: each pose in each load */
    double probabilities[ARMTOL_ARRIVAL_QUANTILES]; /* of the quantiles: 0.5, 0.9, 0.95, 0.99 */
    armtol_repeated *poses;                         /* n_poses */
    armtol_repeated all;                            /* of each arm the largest of all poses */
} armtol_arrivals;

/*
 * Build arms to an answer's tolerances and let each come to every pose again and again.
 *
 * Given:
 *    answer     tolerances, poses, drives and loads; NULL is not allowed
 *    draw       how many arms, the seed, and who looks on; n_threads is not looked at: the caller's thread does it all
 *    cycles     how often each arm comes to each pose, at least 2
 *
 * Returned:
 *    *arrivals   to be freed with armtol_arrivals_destroy; NULL after an error
 *    *fault      what the status is about; may be NULL
 *
 * Notes:
 * 1) Of an arm and a pose, x_j being where the tool point comes to in arrival j, x_c where it should be, m the mean of
 *    the x_j and l_j = |x_j - m|:
 *        AP = |m - x_c|,   RP = mean of l_j + 3 S,   S^2 = sum (l_j - mean)^2 / (cycles - 1).
 *    Rotations are left out.
 * 2) Every source of error is of one of three. Of the arm, once: what is off in making, and by how much the middle of a
 *    free play is off. Of the load, the same at each arrival: what moments shift, and what compliance makes of a moment
 *    in doubt, which is drawn once for each arm. Of each arrival: armtol_drive_arrival, its play and its step evenly,
 *    its noise normally and without a cut.
 * 3) What is drawn of an arm is uniform within its tolerance less ARMTOL_NOISE_SIGMAS of noise and all else that is of
 *    each arrival, and comes from the draws of armtol_verify: parameters without a drive are off by the same. The two
 *    parts together stay within the tolerance, but for noise beyond its cut.
 * 4) Where an arm's tool is without what is of each arrival is exact (armtol_sampler_draw). What each arrival adds is
 *    first order: A of the arm as meant. So arms without such sources have an RP of exactly 0.
 * 5) A parameter without a bound counts as exact, as in armtol_verify.
 * 6) The result depends on the answer, samples, cycles and seed alone, to the bit on every machine with IEEE
 *    arithmetic, unless progress ends it early: the arms drawn until then are counted, and that is no error. Without
 *    arms all numbers are nan.
 * 7) Memory: 16 bytes an arm and pose, and as many again an arm.
 *
 * Errors:
 *    ARMTOL_NO_MEMORY
 *    ARMTOL_BAD_QUESTION   about the question: fewer than 2 cycles
 *    those of armtol_sampler_start, about the tolerances
 *
 * Reference:
 *    ISO 9283:1998, 7.2.1 (pose accuracy) and 7.2.2 (pose repeatability), as the literature quotes them.
 */
armtol_status armtol_arrivals_create(const armtol_answer *answer, const armtol_draw *draw, size_t cycles,
                                     armtol_arrivals **arrivals, armtol_fault *fault);

/* arrivals may be NULL. */
void armtol_arrivals_destroy(armtol_arrivals *arrivals);

ARMTOL_INTERFACE_END

#endif
