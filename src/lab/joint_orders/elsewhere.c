#include "lab/joint_orders/elsewhere.h"

#include "armtol/sampler.h"
#include "console/exit_code.h"
#include "lab/joint_orders/walk.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { SEED = 1987, MOST_LINKS = 16 };

/* ---- wishes ---- */

/* How far each joint is drawn from 0. */
static void ranges_of(const family *family, double ranges[])
{
    armtol_link links[MOST_LINKS];
    size_t joint = 0;
    family->robot->links(&armtol_errata_none, links);
    for (size_t i = 0; i < family->robot->n_links; i++) {
        if (links[i].joint != ARMTOL_FIXED) {
            ranges[joint++] = links[i].joint == ARMTOL_PRISMATIC ? 300 : 3;
        }
    }
}

void elsewhere_draw(const family *family, double wishes[][MOST_WISH], size_t n_wishes)
{
    const size_t n_joints = family->robot->n_joints;
    double ranges[MOST_JOINTS] = {0}, q[MOST_JOINTS];
    ranges_of(family, ranges);
    for (size_t i = 0; i < n_wishes; i++) {
        for (size_t j = 0; j < n_joints; j++) {
            q[j] = ranges[j] * armtol_sampler_uniform(SEED, i * n_joints + j);
        }
        family->robot->forward(q, &armtol_errata_none, wishes[i]);
        for (size_t j = 0; j < family->robot->n_wish; j++) {
            wishes[i][j] = armtol_stored(&armtol_errata_1987, wishes[i][j]);
        }
    }
}

/* ---- answers, as printed ---- */

typedef struct answers {
    walk walk;
    double (*wishes)[MOST_WISH];
    double (*defaults)[MOST_JOINTS]; /* the answers of the default configuration */
} answers;

static void answers_free(answers *answers)
{
    walk_free(&answers->walk);
    free(answers->wishes);
    free(answers->defaults);
}

static void print_joints(const walk *walk, size_t wish, double printed[])
{
    for (size_t j = 0; j < walk->family->robot->n_joints; j++) {
        printed[j] = printed_of(walk_joints(walk, wish)[j]);
    }
}

/* False, after a message and with nothing to free, where memory is short. */
static bool answers_start(answers *answers, const family *family, size_t n_wishes)
{
    const configuration configuration = family_default();
    *answers = (struct answers){.wishes = malloc(n_wishes * sizeof *answers->wishes),
                                .defaults = malloc(n_wishes * sizeof *answers->defaults)};
    if (answers->wishes == NULL || answers->defaults == NULL ||
        !walk_start(&answers->walk, family, (const double(*)[MOST_WISH])answers->wishes, n_wishes)) {
        out_of_memory();
        answers_free(answers);
        return false;
    }
    elsewhere_draw(family, answers->wishes, n_wishes);
    walk_to(&answers->walk, &configuration);
    for (size_t i = 0; i < n_wishes; i++) {
        print_joints(&answers->walk, i, answers->defaults[i]);
    }
    return true;
}

/* The largest difference from the default's answer to a wish, in units of the last digit; inf for nan. */
static double difference_at(const answers *answers, size_t wish)
{
    double largest = 0, printed[MOST_JOINTS];
    print_joints(&answers->walk, wish, printed);
    for (size_t j = 0; j < answers->walk.family->robot->n_joints; j++) {
        const double difference = fabs(printed[j] - answers->defaults[wish][j]);
        largest = difference <= largest ? largest : isnan(difference) ? (double)INFINITY : difference;
    }
    return largest;
}

bool elsewhere_compare_one(const family *family, const configuration *configuration, size_t n_wishes,
                           elsewhere_difference *difference)
{
    answers answers;
    *difference = (elsewhere_difference){0, 0};
    if (!answers_start(&answers, family, n_wishes)) {
        return false;
    }
    walk_to(&answers.walk, configuration);
    for (size_t i = 0; i < n_wishes; i++) {
        const double units = difference_at(&answers, i);
        difference->n_other += units > 0;
        difference->n_far += units > 10;
    }
    answers_free(&answers);
    return true;
}

/* ---- many configurations ---- */

/* FNV-1a over the bytes of all answers. Two of ten thousand sets fall together with a chance below 1e-11. */
static uint64_t fingerprint(const walk *walk)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < walk->n_wishes; i++) {
        double printed[MOST_JOINTS];
        unsigned char bytes[sizeof printed];
        print_joints(walk, i, printed);
        memcpy(bytes, printed, sizeof printed);
        for (size_t j = 0; j < walk->family->robot->n_joints * sizeof printed[0]; j++) {
            hash = (hash ^ bytes[j]) * 0x100000001b3u;
        }
    }
    return hash;
}

static int compare_numbers(const void *one, const void *other)
{
    const uint64_t a = *(const uint64_t *)one, b = *(const uint64_t *)other;
    return (a > b) - (a < b);
}

static void summarize(uint64_t fingerprints[], uint64_t others[], size_t n, elsewhere_spread *spread)
{
    qsort(fingerprints, n, sizeof *fingerprints, compare_numbers);
    qsort(others, n, sizeof *others, compare_numbers);
    *spread = (elsewhere_spread){.least = (size_t)others[0], .median = (size_t)others[n / 2],
                                 .most = (size_t)others[n - 1]};
    for (size_t i = 0; i < n; i++) {
        spread->n_answers += i == 0 || fingerprints[i] != fingerprints[i - 1];
        spread->n_same += others[i] == 0;
    }
}

static void compare_each(answers *answers, const configuration configurations[], size_t n,
                         uint64_t fingerprints[], uint64_t others[])
{
    for (size_t i = 0; i < n; i++) {
        walk_to(&answers->walk, &configurations[i]);
        fingerprints[i] = fingerprint(&answers->walk);
        others[i] = 0;
        for (size_t w = 0; w < answers->walk.n_wishes; w++) {
            others[i] += difference_at(answers, w) > 0;
        }
    }
}

bool elsewhere_compare_all(const family *family, const configuration configurations[],
                           size_t n_configurations, size_t n_wishes, elsewhere_spread *spread)
{
    answers answers;
    *spread = (elsewhere_spread){0};
    if (n_configurations == 0) {
        return true;
    }
    if (!answers_start(&answers, family, n_wishes)) {
        return false;
    }
    uint64_t *numbers = malloc(2 * n_configurations * sizeof *numbers);
    if (numbers == NULL) {
        out_of_memory();
    } else {
        compare_each(&answers, configurations, n_configurations, numbers, numbers + n_configurations);
        summarize(numbers, numbers + n_configurations, n_configurations, spread);
    }
    const bool fine = numbers != NULL;
    free(numbers);
    answers_free(&answers);
    return fine;
}
