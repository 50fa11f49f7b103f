/* What makes two tallies be of one question, in 64 bits a subject: FNV-1a (Fowler, Noll, Vo). */

#include "armtol/tally.h"
#include "lib/engine/verification_parts.h"

#include <math.h>
#include <string.h>

/* By value, the low byte first, so that the order of bytes in memory does not matter. */
static void take_word(uint64_t *hash, uint64_t word)
{
    for (int i = 0; i < 8; i++) {
        *hash = (*hash ^ (word >> (8 * i) & 0xff)) * 0x100000001b3u;
    }
}

/* Machines differ in the bits of a nan. */
static void take_numbers(uint64_t *hash, const double numbers[], size_t n)
{
    for (size_t i = 0; i < n; i++) {
        uint64_t bits = UINT64_MAX;
        if (!isnan(numbers[i])) {
            memcpy(&bits, &numbers[i], sizeof bits);
        }
        take_word(hash, bits);
    }
}

static void take_arm(uint64_t *hash, const armtol_answer *answer)
{
    take_word(hash, answer->n_links);
    for (size_t i = 0; i < answer->n_poses * answer->n_links; i++) {
        const armtol_link *link = &answer->links[i];
        const double numbers[] = {link->a, link->alpha, link->d, link->theta, link->beta};
        take_word(hash, (uint64_t)link->kind);
        take_word(hash, (uint64_t)link->joint);
        take_numbers(hash, numbers, sizeof numbers / sizeof numbers[0]);
    }
}

/* Without discs the hash is that of tallies of before there were any. */
static void take_discs(uint64_t *hash, const armtol_answer *answer)
{
    for (size_t k = 0; k < answer->n_columns; k++) {
        if (answer->discs[k]) {
            take_word(hash, k);
        }
    }
}

static void take_spreads(uint64_t *hash, const armtol_answer *answer)
{
    for (size_t k = 0; k < answer->n_columns; k++) {
        take_word(hash, (uint64_t)answer->spreads[k].distribution);
        take_numbers(hash, &answer->factors[k], 1);
        take_word(hash, answer->leaders[k]);
    }
}

static void take_limits(uint64_t *hash, const armtol_answer *answer)
{
    tally_limits limits;
    verification_limits(answer, &limits);
    take_word(hash, limits.n_measures);
    for (size_t i = 0; i < limits.n_measures; i++) {
        const double numbers[] = {limits.range[i], limits.accuracy[i], limits.beyond[i]};
        take_word(hash, limits.components[i]);
        take_numbers(hash, numbers, sizeof numbers / sizeof numbers[0]);
    }
}

uint64_t armtol_tally_fingerprint(const armtol_answer *answer, armtol_tally_subject subject)
{
    uint64_t hash = 0xcbf29ce484222325u;
    switch (subject) {
    case ARMTOL_TALLY_ARM:
        take_arm(&hash, answer);
        break;
    case ARMTOL_TALLY_TOOL:
        take_word(&hash, (uint64_t)answer->tool.frame);
        take_numbers(&hash, answer->tool.offset, 3);
        break;
    case ARMTOL_TALLY_TOLERANCES:
        take_numbers(&hash, answer->bounded, answer->n_poses * answer->n_columns);
        take_discs(&hash, answer);
        break;
    case ARMTOL_TALLY_LOADS:
        take_numbers(&hash, answer->shifts, answer->n_poses * answer->n_columns);
        break;
    case ARMTOL_TALLY_SPREADS:
        take_spreads(&hash, answer);
        break;
    default:
        take_limits(&hash, answer);
    }
    return hash;
}

const char *armtol_tally_subject_name(armtol_tally_subject subject)
{
    static const char *const names[ARMTOL_TALLY_SUBJECT_COUNT] = {"arm",   "tool",          "tolerances",
                                                                  "loads", "distributions", "accuracy"};
    return (unsigned)subject < ARMTOL_TALLY_SUBJECT_COUNT ? names[subject] : "?";
}
