#include "lab/joint_orders/survey.h"

#include "console/exit_code.h"
#include "lab/joint_orders/walk.h"

#include <math.h>
#include <stdlib.h>

static size_t count_bits(unsigned long set)
{
    size_t n = 0;
    for (; set != 0; set &= set - 1) {
        n++;
    }
    return n;
}

/* One more place at the end of a list, doubled when full; NULL, after a message, where memory is short. */
static void *grown(void *list, size_t count, size_t size)
{
    const bool full = (count & (count - 1)) == 0; /* 0, or a power of 2 */
    void *longer = full ? realloc(list, (count == 0 ? 1 : 2 * count) * size) : list;
    if (longer == NULL) {
        out_of_memory();
    }
    return longer;
}

static void tally(survey *survey, const configuration *configuration, size_t score)
{
    const size_t n = evidence_count(survey->evidence);
    for (size_t i = 0; i < survey->family->n_choices; i++) {
        if (survey->family->matters(configuration, i)) {
            option_tally *of = &survey->tallies[i][configuration->option[i]];
            of->configurations++;
            of->all += score == n;
            of->all_but_one += score + 1 == n;
            of->best = score > of->best ? score : of->best;
        }
    }
}

static bool note_all(survey *survey, const configuration *configuration)
{
    struct configuration *all = grown(survey->all, survey->n_all, sizeof *all);
    if (all == NULL) {
        return false;
    }
    survey->all = all;
    survey->all[survey->n_all++] = *configuration;
    return true;
}

static closest_miss *find_miss(survey *survey, size_t value, double printed)
{
    for (size_t i = 0; i < survey->n_misses; i++) {
        closest_miss *miss = &survey->misses[i];
        if (miss->value == value && (miss->printed == printed || (isnan(miss->printed) && isnan(printed)))) {
            return miss;
        }
    }
    return NULL;
}

static bool note_miss(survey *survey, const configuration *configuration, size_t value, double printed)
{
    closest_miss *miss = find_miss(survey, value, printed);
    if (miss == NULL) {
        closest_miss *misses = grown(survey->misses, survey->n_misses, sizeof *misses);
        if (misses == NULL) {
            return false;
        }
        survey->misses = misses;
        miss = &survey->misses[survey->n_misses++];
        *miss = (closest_miss){value, printed, 0, *configuration};
    }
    miss->configurations++;
    if (family_changes(survey->family, configuration) < family_changes(survey->family, &miss->nearest)) {
        miss->nearest = *configuration;
    }
    return true;
}

static unsigned long misses_of(const evidence *evidence, const walk *walk)
{
    unsigned long misses = 0;
    for (size_t i = 0; i < evidence->n_cases; i++) {
        misses |= evidence_misses(evidence, i, walk_joints(walk, i));
    }
    return misses;
}

static size_t lowest_bit(unsigned long set)
{
    size_t bit = 0;
    while ((set >> bit & 1) == 0) {
        bit++;
    }
    return bit;
}

static bool note(survey *survey, const walk *walk)
{
    const unsigned long misses = misses_of(survey->evidence, walk);
    const size_t wrong = count_bits(misses), score = evidence_count(survey->evidence) - wrong;
    survey->configurations++;
    survey->by_score[score]++;
    tally(survey, &walk->at, score);
    if (wrong == 0) {
        return note_all(survey, &walk->at);
    }
    if (wrong > 1) {
        return true;
    }
    const size_t value = lowest_bit(misses), n_joints = survey->evidence->n_joints;
    const double q = walk_joints(walk, value / n_joints)[value % n_joints];
    return note_miss(survey, &walk->at, value, printed_of(q));
}

survey survey_start(const family *family, const evidence *evidence)
{
    return (survey){.family = family, .evidence = evidence};
}

bool survey_run(survey *survey, const restriction *given)
{
    walk walk;
    configuration configuration = family_default();
    if (!walk_start(&walk, survey->family, survey->evidence->wishes, survey->evidence->n_cases)) {
        out_of_memory();
        return false;
    }
    bool fine = true;
    bool more = family_allows(survey->family, given, &configuration) ||
                family_next(survey->family, given, &configuration);
    while (more && fine) {
        walk_to(&walk, &configuration);
        fine = note(survey, &walk);
        more = family_next(survey->family, given, &configuration);
    }
    walk_free(&walk);
    return fine;
}

void survey_free(survey *survey)
{
    free(survey->all);
    free(survey->misses);
    survey->all = NULL;
    survey->misses = NULL;
}

void survey_pairs(const survey *one, const survey *other, uint64_t by_score[2 * MOST_VALUES + 1])
{
    for (size_t score = 0; score <= 2 * MOST_VALUES; score++) {
        by_score[score] = 0;
    }
    for (size_t i = 0; i <= MOST_VALUES; i++) {
        for (size_t j = 0; j <= MOST_VALUES; j++) {
            by_score[i + j] += one->by_score[i] * other->by_score[j];
        }
    }
}

unsigned long survey_misses(const survey *survey, const configuration *configuration)
{
    unsigned long misses = 0;
    for (size_t i = 0; i < survey->evidence->n_cases; i++) {
        double q[MOST_JOINTS];
        family_solve(survey->family, configuration, survey->evidence->wishes[i], q);
        misses |= evidence_misses(survey->evidence, i, q);
    }
    return misses;
}
