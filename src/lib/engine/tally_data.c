/* A tally as data: its members by name, for who sends it elsewhere, and whether what came back can be one. */

#include "armtol/tally.h"
#include "lib/engine/tally.h"

#include <stdlib.h>

/* What is added to a tally has a row here, and a line in tally_merge and in armtol_tally_is_of. */
static const struct {
    const char *name;
    size_t at, length;
    bool numbers; /* else counts */
} members[] = {
    {"measures", offsetof(tally, n_measures), 1, false},
    {"drawn", offsetof(tally, drawn), 1, false},
    {"within", offsetof(tally, within), 1, false},
    {"beyond", offsetof(tally, beyond), 1, false},
    {"worst", offsetof(tally, worst), TALLY_MEASURES, true},
    {"worst_arm", offsetof(tally, worst_arm), TALLY_MEASURES, false},
    {"bins", offsetof(tally, bins), (size_t)TALLY_MEASURES * TALLY_BINS, false},
};

size_t armtol_tally_member_count(void)
{
    return sizeof members / sizeof members[0];
}

armtol_tally_member armtol_tally_member_at(armtol_tally *tally, size_t number)
{
    void *const at = (char *)tally + members[number].at;
    armtol_tally_member member = {.name = members[number].name, .length = members[number].length};
    if (members[number].numbers) {
        member.numbers = at;
    } else {
        member.counts = at;
    }
    return member;
}

armtol_status armtol_tally_create(armtol_tally **tally)
{
    *tally = malloc(sizeof **tally);
    if (*tally == NULL) {
        return ARMTOL_NO_MEMORY;
    }
    armtol_tally_clear(*tally);
    return ARMTOL_OK;
}

void armtol_tally_destroy(armtol_tally *tally)
{
    free(tally);
}

void armtol_tally_clear(armtol_tally *tally)
{
    tally_start(tally, TALLY_MEASURES);
    tally->n_measures = 0; /* until arms are counted */
}

void armtol_tally_add(armtol_tally *into, const armtol_tally *part)
{
    into->n_measures = part->n_measures > into->n_measures ? part->n_measures : into->n_measures;
    tally_merge(into, part);
}

static bool is_worst(const tally *tally, size_t measure, uint64_t first, uint64_t count)
{
    const double worst = tally->worst[measure];
    const uint64_t arm = tally->worst_arm[measure];
    return worst >= 0 ? arm >= first && arm - first < count : worst == -1 && arm == 0;
}

/* Every arm is in one bin. */
static bool is_histogram(const uint64_t bins[TALLY_BINS], uint64_t count)
{
    uint64_t left = count;
    for (size_t bin = 0; bin < TALLY_BINS; bin++) {
        if (bins[bin] > left) {
            return false;
        }
        left -= bins[bin];
    }
    return left == 0;
}

bool armtol_tally_is_of(const armtol_tally *tally, uint64_t first, uint64_t count)
{
    const bool measured = tally->n_measures <= TALLY_MEASURES && (tally->n_measures >= 6 || count == 0);
    bool fine = measured && tally->drawn == count && tally->within <= count && tally->beyond <= count - tally->within;
    for (size_t i = 0; fine && i < tally->n_measures; i++) {
        fine = is_worst(tally, i, first, count) && is_histogram(tally->bins[i], count);
    }
    return fine;
}
