#include "lib/engine/tally.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

void tally_start(tally *tally, size_t n_measures)
{
    tally->n_measures = n_measures;
    memset(tally, 0, tally_size(tally));
    tally->n_measures = n_measures;
    for (size_t i = 0; i < n_measures; i++) {
        tally->worst[i] = -1;
    }
}

size_t tally_size(const tally *tally)
{
    return offsetof(struct armtol_tally, bins) + (size_t)tally->n_measures * sizeof tally->bins[0];
}

/*
 * Arms of which every measure is within its limit; nan is not. Without a branch an arm, for the compiler to
 * do several arms at once: what they exceed the limits by is summed up, and 0 for those that exceed none.
 */
static uint64_t count_within(const double limits[], size_t n_measures, size_t count, const double magnitudes[])
{
    double excess[TALLY_MOST] = {0};
    for (size_t i = 0; i < n_measures; i++) {
        const double limit = limits[i];
        for (size_t j = 0; j < count; j++) {
            const double more = magnitudes[i * count + j] - limit;
            excess[j] += 0 > more ? 0 : more;
        }
    }
    uint64_t within = 0;
    for (size_t j = 0; j < count; j++) {
        within += excess[j] == 0;
    }
    return within;
}

static void find_worst(tally *tally, size_t i, uint64_t first, size_t count, const double magnitudes[])
{
    for (size_t j = 0; j < count; j++) {
        if (magnitudes[j] > tally->worst[i]) {
            tally->worst[i] = magnitudes[j];
            tally->worst_arm[i] = first + j;
        }
    }
}

/* What two doubles >= 0 share that are in one bin: they are in the order of such bits, nan above all. */
static int64_t key_of(double magnitude)
{
    uint64_t bits;
    memcpy(&bits, &magnitude, sizeof bits);
    return (int64_t)(bits >> (DBL_MANT_DIG - 1 - TALLY_BITS));
}

static int64_t first_key(double range)
{
    return key_of(range) - (TALLY_BINS - 1);
}

/* The least magnitude above all of that key. */
static double end_of(int64_t key)
{
    const uint64_t bits = (uint64_t)(key + 1) << (DBL_MANT_DIG - 1 - TALLY_BITS);
    double end;
    memcpy(&end, &bits, sizeof end);
    return end;
}

/* The last bin takes what rounding took beyond the range, and all where the range is 0. */
static void fill_bins(uint64_t bins[TALLY_BINS], double range, size_t count, const double magnitudes[])
{
    const int64_t first = first_key(range), last = TALLY_BINS - 1;
    int32_t places[TALLY_MOST];
    for (size_t j = 0; j < count; j++) {
        const int64_t place = key_of(magnitudes[j]) - first;
        places[j] = (int32_t)(place < 0 ? 0 : place > last ? last : place);
    }
    for (size_t j = 0; j < count; j++) {
        bins[places[j]]++;
    }
}

/* Arms of which some are outside the accuracy, or worse than all before. */
static void look_closer(tally *tally, const tally_limits *limits, uint64_t first, size_t count,
                        const double magnitudes[])
{
    tally->within += count_within(limits->accuracy, limits->n_measures, count, magnitudes);
    tally->beyond += count - count_within(limits->beyond, limits->n_measures, count, magnitudes);
    for (size_t i = 0; i < limits->n_measures; i++) {
        find_worst(tally, i, first, count, magnitudes + i * count);
    }
}

void tally_add(tally *tally, const tally_limits *limits, uint64_t first, size_t count,
               const double magnitudes[])
{
    double quiet[TALLY_MEASURES]; /* up to here there is nothing to look at */
    for (size_t i = 0; i < limits->n_measures; i++) {
        fill_bins(tally->bins[i], limits->range[i], count, magnitudes + i * count);
        quiet[i] = fmin(tally->worst[i], limits->accuracy[i]);
    }
    tally->drawn += count;
    if (count_within(quiet, limits->n_measures, count, magnitudes) == count) {
        tally->within += count;
    } else {
        look_closer(tally, limits, first, count, magnitudes);
    }
}

static void merge_measure(tally *into, const tally *part, size_t i)
{
    const bool worse = part->worst[i] > into->worst[i];
    const bool earlier = part->worst[i] == into->worst[i] && part->worst_arm[i] < into->worst_arm[i];
    if (worse || earlier) {
        into->worst[i] = part->worst[i];
        into->worst_arm[i] = part->worst_arm[i];
    }
    for (size_t bin = 0; bin < TALLY_BINS; bin++) {
        into->bins[i][bin] += part->bins[i][bin];
    }
}

void tally_merge(tally *into, const tally *part)
{
    into->drawn += part->drawn;
    into->within += part->within;
    into->beyond += part->beyond;
    for (size_t i = 0; i < into->n_measures; i++) {
        merge_measure(into, part, i);
    }
}

/* The least whole number of arms that is this many thousandths of all, without overflow. */
static uint64_t share_of(uint64_t drawn, unsigned thousandths)
{
    return drawn / 1000 * thousandths + (drawn % 1000 * thousandths + 999) / 1000;
}

double tally_quantile(const tally *tally, const tally_limits *limits, size_t measure, unsigned thousandths)
{
    const uint64_t share = share_of(tally->drawn, thousandths);
    const double worst = fmax(tally->worst[measure], 0);
    uint64_t arms = 0;
    for (size_t bin = 0; bin < TALLY_BINS - 1; bin++) {
        arms += tally->bins[measure][bin];
        if (arms >= share) {
            return fmin(end_of(first_key(limits->range[measure]) + (int64_t)bin), worst);
        }
    }
    return worst;
}
