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

/*
 * What the repeatability of a pose is at most, for many arrivals.
 *
 * Given:
 *    answer   poses, drives and loads; NULL is not allowed
 *    pose     of the answer, from 0
 *    noise    n_links standard deviations in the place of those that the drives have, >= 0; infinity for joints that
 *             do not move the tool point, 0 for fixed links. NULL: those that the drives have
 *
 * Returned:
 *    shares   n_links: of T, their sum 1; all 0 where T is 0
 *
 * Returns the bound, in the arm's unit of length; infinity where it overflows.
 *
 * Notes:
 * 1) Method. The covariance of the positions, to first order, has the trace
 *        T = sum over joints of |A_k|^2 (noise_k^2 + step_k^2 / 3 + play_k^2 / 3),
 *    A_k the position's part of A, step and play half widths (armtol_drive_arrival). With l the distance from the mean,
 *    m its mean and S its deviation, m^2 + S^2 = T. A sum of even and normal errors along lines has m >= sqrt(2/pi)
 *    sqrt T, which is m of a normal error along one line, and m + 3 S falls in m beyond sqrt(T / 10). So
 *        RP <= (sqrt(2/pi) + 3 sqrt(1 - 2/pi)) sqrt T = 2.6063 sqrt T.
 *    docs/iso9283.md has the proof. Noise of one joint alone reaches it; three alike at right angles reach 0.801 of
 *    it; a step alone 0.908 of it.
 * 2) RP of few arrivals scatters about that of many: by some 9 % of it for 30.
 *
 * Reference:
 *    not in the report nor in ISO 9283; ours.
 */
double armtol_arrivals_bound(const armtol_answer *answer, size_t pose, const double noise[], double shares[]);

/*
 * The largest noise that drives may have for a wished repeatability: the largest product of standard deviations.
 *
 * Given:
 *    answer   poses, drives and loads; NULL is not allowed. Steps and plays count, the noise that drives have does not
 *    wish     RP, > 0 and finite, in the arm's unit of length
 *
 * Returned:
 *    noise    n_links: of each joint that moves, of followers too, its standard deviation, radians or a length;
 *             infinity where it moves the tool point in no pose; 0 for fixed links. All 0 after an error
 *    *fault   what the status is about; may be NULL
 *
 * Notes:
 * 1) armtol_arrivals_bound is no more than the wish in each pose and load, up to rounding. Squares of noises are in its
 *    T one by one: the optimum is armtol_optimum's, ARMTOL_ROOT_SUM_SQUARES, a row a pose, all weights 1.
 *
 * Errors:
 *    ARMTOL_NO_MEMORY
 *    ARMTOL_BAD_TOLERANCE  about the accuracy: the wish
 *    ARMTOL_NOTHING_LEFT   about a pose of the answer: steps and plays alone use it up there
 *    ARMTOL_BAD_LOAD       about the drives: a joint that moves what its link's kind does not count
 *    those of armtol_optimum, about the method
 */
armtol_status armtol_arrivals_noise(const armtol_answer *answer, double wish, double noise[], armtol_fault *fault);

ARMTOL_INTERFACE_END

#endif
