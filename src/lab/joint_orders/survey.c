#include "lab/joint_orders/survey.h"

#include "console/list_room.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t count_bits(unsigned long set)
{
    size_t n = 0;
    for (; set != 0; set &= set - 1) {
        n++;
    }
    return n;
}

static void tally(survey *survey, const configuration *configuration, size_t score)
{
    const size_t n = evidence_count(&survey->evidence);
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
    struct configuration *all = list_room(survey->all, survey->n_all, &survey->all_room, sizeof *all);
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
        closest_miss *misses = list_room(survey->misses, survey->n_misses, &survey->misses_room, sizeof *misses);
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

static bool note(survey *survey, const configuration *configuration)
{
    double q[MOST_VALUES];
    const unsigned long misses = evidence_misses(&survey->evidence, survey->family, configuration, q);
    const size_t wrong = count_bits(misses), score = evidence_count(&survey->evidence) - wrong;
    survey->configurations++;
    survey->by_score[score]++;
    tally(survey, configuration, score);
    if (wrong == 0) {
        return note_all(survey, configuration);
    }
    const size_t value = count_bits((misses & -misses) - 1); /* the first that is wrong */
    return wrong > 1 || note_miss(survey, configuration, value, printed_of(q[value]));
}

bool survey_start(survey *survey, const published_list *list, const family *family)
{
    *survey = (struct survey){.family = family};
    return evidence_find(list, family, &survey->evidence);
}

bool survey_run(survey *survey, const restriction *given)
{
    configuration configuration = family_default();
    bool fine = true;
    do {
        fine = !family_allows(survey->family, given, &configuration) || note(survey, &configuration);
    } while (fine && family_next(survey->family, &configuration));
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
    memset(by_score, 0, (2 * MOST_VALUES + 1) * sizeof by_score[0]);
    for (size_t i = 0; i <= MOST_VALUES; i++) {
        for (size_t j = 0; j <= MOST_VALUES; j++) {
            by_score[i + j] += one->by_score[i] * other->by_score[j];
        }
    }
}
