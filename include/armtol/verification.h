#ifndef ARMTOL_VERIFICATION_H
#define ARMTOL_VERIFICATION_H

#include "armtol/answer.h"
#include "armtol/interface.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

ARMTOL_INTERFACE_BEGIN

/*
 * Called now and then, by the thread that called armtol_verify and by no other: `done` of `total` arms are drawn, 0 as
 * long as corners are searched. False ends the work early. It may take its time, and must not call back.
 */
typedef bool (*armtol_progress)(void *context, uint64_t done, uint64_t total);

/* What is drawn, and how. A member that is 0 or NULL has the meaning said here. */
typedef struct armtol_draw {
    uint64_t samples; /* arms; 0: corners are searched and none is drawn */
    uint64_t seed;
    size_t n_threads;         /* at most, the caller's own among them; 0 is 1 */
    armtol_progress progress; /* NULL: nobody looks on */
    void *context;            /* handed to progress */
} armtol_draw;

enum { ARMTOL_QUANTILES = 4 };

/*
 * One component, or norm, of the tool's exact error, magnitudes, the largest of all poses. A quantile is what that
 * share of the arms does not exceed, rounded up by no more than 2^-10 of itself and never above worst_drawn; below
 * 2^-63 of the predicted worst case and remainder, and of what the arm reaches, which is below the rounding of an
 * error, it is rounded up to that. All are nan for a component that depends on a parameter without a bound.
 */
typedef struct armtol_verified {
    double quantiles[ARMTOL_QUANTILES];
    double worst_drawn;
    uint64_t worst_arm;  /* the first arm that had it, as armtol_sampler_parameters counts them */
    double worst_corner; /* exact error in the corners that A's signs point to, and climbing on from them */
} armtol_verified;

typedef struct armtol_verification {
    uint64_t drawn;  /* fewer than asked for where it was ended early */
    uint64_t within; /* every component and norm in every pose keeps to the accuracy; all, where none is asked for */
    uint64_t beyond; /* some component or norm exceeds its accuracy by more than its remainder */
    double share_low, share_high;           /* 95 % interval of the share within (share_interval.h) */
    double probabilities[ARMTOL_QUANTILES]; /* of the quantiles: 0.5, 0.9, 0.99, 0.999 */
    armtol_verified components[6];
    armtol_verified norms[ARMTOL_MOST_NORMS]; /* as many as the answer has */
} armtol_verification;

/*
 * Hold an answer against the exact kinematics: search the corners of the box of tolerances, and draw arms with errors
 * that are uniform within them.
 *
 * Given:
 *    answer     tolerances, poses and accuracy; NULL is not allowed
 *    draw       how many arms, and how; NULL is not allowed
 *
 * Returned:
 *    *found     the caller's; of no use after an error
 *    *fault     what the status is about; may be NULL
 *
 * Notes:
 * 1) A parameter with an infinite tolerance is not drawn, and is exact for the components that do not depend on it; of
 *    those that do nothing is said, and none of them may have an accuracy to keep to.
 * 2) The result depends on answer, samples and seed alone, to the bit, and not on the number of threads, unless
 *    progress ends it early: the arms drawn until then are counted, whole blocks of them, and corners not yet searched
 *    left out. That is no error.
 * 3) Threads are POSIX threads. They are begun and ended within the call, all signals blocked: signals come to the
 *    program's own threads. Threads that cannot be had, and memory for them, are done without.
 * 4) Each thread takes 3 MB and 0.5 MB a norm; poses take some 500 bytes a link.
 *
 * Errors:
 *    ARMTOL_NO_MEMORY
 *    ARMTOL_UNBOUNDED       about the accuracy: the component has one, and depends on a parameter without a bound;
 *                           about the norm likewise
 *    those of armtol_sampler_start, about the tolerances
 */
armtol_status armtol_verify(const armtol_answer *answer, const armtol_draw *draw, armtol_verification *found,
                            armtol_fault *fault);

ARMTOL_INTERFACE_END

#endif
