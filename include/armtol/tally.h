#ifndef ARMTOL_TALLY_H
#define ARMTOL_TALLY_H

#include "armtol/answer.h"
#include "armtol/interface.h"
#include "armtol/verification.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

ARMTOL_INTERFACE_BEGIN

/*
 * armtol_verify in parts: any process on any machine draws a range of the arms into a tally, tallies are added up, and
 * the sum of them all gives what armtol_verify gives, to the bit. A tally is counts, and the largest errors with the
 * first arm that had them: in which order tallies are added does not matter.
 */
typedef struct armtol_tally armtol_tally;

/* An empty tally, of 7 MB, to be freed with armtol_tally_destroy. Error: ARMTOL_NO_MEMORY, and *tally is NULL. */
armtol_status armtol_tally_create(armtol_tally **tally);

/* tally may be NULL. */
void armtol_tally_destroy(armtol_tally *tally);

/* As armtol_tally_create made it. */
void armtol_tally_clear(armtol_tally *tally);

/*
 * Draw a range of arms.
 *
 * Given:
 *    answer     tolerances, poses and accuracy; NULL is not allowed
 *    draw       samples: how many arms of the range; seed, n_threads, progress and context as for armtol_verify
 *    first      the first arm of the range, from 0
 *
 * Returned:
 *    *tally     of these arms alone; of no use after an error
 *    *fault     what the status is about; may be NULL
 *
 * Notes:
 * 1) Arms are numbered: arm i is the same in whatever range it is drawn, by however many threads.
 * 2) Where progress ends it early, the arms drawn are those from `first` on; the member "drawn" says how many.
 *
 * Errors: those of armtol_verify.
 */
armtol_status armtol_tally_draw(const armtol_answer *answer, const armtol_draw *draw, uint64_t first,
                                armtol_tally *tally, armtol_fault *fault);

/*
 * Add the counts of other arms to a tally.
 *
 * Given:
 *    into, part   tallies of the same answer and seed, of arms that are not the same
 *
 * Returned:
 *    *into        of the arms of both
 */
void armtol_tally_add(armtol_tally *into, const armtol_tally *part);

/*
 * What armtol_verify returns, with arms that were counted in place of arms to be drawn.
 *
 * Given:
 *    answer     as it was when the arms were drawn; NULL is not allowed
 *    draw       progress and context are called while corners are searched; NULL is not allowed
 *    tally      of arms of this answer
 *
 * Returned:
 *    *found     the caller's; of no use after an error
 *    *fault     what the status is about; may be NULL
 *
 * Errors:
 *    ARMTOL_NO_MEMORY
 *    ARMTOL_UNBOUNDED   as armtol_verify
 */
armtol_status armtol_tally_verify(const armtol_answer *answer, const armtol_draw *draw, const armtol_tally *tally,
                                  armtol_verification *found, armtol_fault *fault);

/* ---- a tally as data, to be sent elsewhere ---- */

/* One member of a tally. It points into the tally, to be read and written; one of counts and numbers is NULL. */
typedef struct armtol_tally_member {
    const char *name; /* small letters and _ */
    size_t length;
    uint64_t *counts;
    double *numbers;
} armtol_tally_member;

/* How many members there are, and one of them, from 0. A tally is all of them and nothing else. */
size_t armtol_tally_member_count(void);
armtol_tally_member armtol_tally_member_at(armtol_tally *tally, size_t number);

/* Whether members that were written can be what `count` arms from `first` on come to: false for a tally with damage. */
bool armtol_tally_is_of(const armtol_tally *tally, uint64_t first, uint64_t count);

/* What tallies that are added must have in common, beside the seed and the version of the library. */
typedef enum armtol_tally_subject {
    ARMTOL_TALLY_ARM,        /* links, placed in every pose and load */
    ARMTOL_TALLY_TOOL,       /* the tool's point and the frame of the components */
    ARMTOL_TALLY_TOLERANCES, /* what every parameter is drawn within */
    ARMTOL_TALLY_LOADS,      /* what loads shift the joints by, and means all parameters */
    ARMTOL_TALLY_SPREADS,    /* how errors are distributed, and which are drawn as one */
    ARMTOL_TALLY_ACCURACY,   /* what arms are held against, remainders and ranges of histograms included */
    ARMTOL_TALLY_SUBJECT_COUNT
} armtol_tally_subject;

/* "arm", "tool", "tolerances", "loads", "distributions", "accuracy"; "?" for a value that is none. */
const char *armtol_tally_subject_name(armtol_tally_subject subject);

/*
 * 64 bits that differ where what two answers have of a subject does.
 *
 * Given:
 *    answer     NULL is not allowed
 *    subject    of what the bits are
 *
 * Returned (function value):
 *    FNV-1a of the numbers, by value, so that it is the same on all machines
 *
 * Notes:
 * 1) Two subjects can have the same bits by chance, or by intention: it finds mistakes, and is no signature.
 *
 * Reference:
 *    Fowler, Noll, Vo: FNV hash, 64 bits.
 */
uint64_t armtol_tally_fingerprint(const armtol_answer *answer, armtol_tally_subject subject);

ARMTOL_INTERFACE_END

#endif
