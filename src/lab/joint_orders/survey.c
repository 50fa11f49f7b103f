#include "lab/joint_orders/survey.h"

#include "console/list_room.h"
#include "console/message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- the evidence ---- */

/* The joint of a label, theta[1] or d[4], counted from 0; -1 for any other label. */
static int joint_of(const char *label)
{
    int joint;
    char end;
    if ((sscanf(label, "theta[%d%c", &joint, &end) == 2 || sscanf(label, "d[%d%c", &joint, &end) == 2) &&
        end == ']') {
        return joint - 1;
    }
    return -1;
}

/* The wish and the joint values of the case that begins at `first`. False where one is missing. */
static bool read_case(const published_list *list, size_t first, size_t n_wish_wanted, evidence *evidence)
{
    const size_t at = evidence->n_cases * evidence->n_joints;
    size_t n_wish = 0;
    for (size_t i = first; i < list->count; i++) {
        const published_number *number = &list->numbers[i];
        if (!published_same_case(&list->numbers[first], number)) {
            break;
        }
        const int joint = number->role == ROLE_RESULT ? joint_of(number->quantity) : -1;
        if (number->role == ROLE_POSITION && n_wish < MOST_WISH) {
            evidence->wishes[evidence->n_cases][n_wish++] = stored(strtod(number->value, NULL));
        } else if (joint >= 0 && (size_t)joint < evidence->n_joints) {
            evidence->numbers[at + (size_t)joint] = number;
            evidence->printed[at + (size_t)joint] = printed_of(strtod(number->value, NULL));
        }
    }
    bool complete = n_wish == n_wish_wanted;
    for (size_t j = 0; j < evidence->n_joints; j++) {
        complete = complete && evidence->numbers[at + j] != NULL;
    }
    return complete;
}

bool evidence_find(const published_list *list, const family *family, evidence *evidence)
{
    *evidence = (struct evidence){.n_joints = family->robot->n_joints};
    for (size_t i = 0; i < list->count; i++) {
        if (!published_begins_case(list, i) || strcmp(list->numbers[i].program, family->program) != 0) {
            continue;
        }
        if (evidence->n_cases == MOST_CASES) {
            message("%s: more than %d cases", family->program, MOST_CASES);
            return false;
        }
        if (!read_case(list, i, family->robot->n_wish, evidence)) {
            message("%s, case %d: expected %zu numbers of the position and %zu joint values", family->program,
                    list->numbers[i].case_number, family->robot->n_wish, family->robot->n_joints);
            return false;
        }
        evidence->n_cases++;
    }
    if (evidence->n_cases == 0) {
        message("no case of %s among the published numbers", family->program);
    }
    return evidence->n_cases > 0;
}

size_t evidence_count(const evidence *evidence)
{
    return evidence->n_cases * evidence->n_joints;
}

unsigned long evidence_misses(const evidence *evidence, const family *family, const configuration *how,
                              double q[MOST_VALUES])
{
    unsigned long misses = 0;
    for (size_t i = 0; i < evidence->n_cases; i++) {
        family->solve(how, evidence->wishes[i], &q[i * evidence->n_joints]);
    }
    for (size_t i = 0; i < evidence_count(evidence); i++) {
        misses |= (unsigned long)!(printed_of(q[i]) == evidence->printed[i]) << i;
    }
    return misses;
}

/* ---- the survey ---- */

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
