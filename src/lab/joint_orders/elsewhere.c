#include "lab/joint_orders/elsewhere.h"

#include "armtol/sampler.h"
#include "console/exit_code.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { SEED = 1987, MOST_LINKS = 16 };

void elsewhere_wish(const family *family, size_t i, double wish[MOST_WISH])
{
    const armtol_robot *robot = family->robot;
    armtol_link links[MOST_LINKS];
    double q[MOST_JOINTS] = {0};
    size_t joint = 0;
    robot->links(&armtol_errata_none, links);
    for (size_t k = 0; k < robot->n_links; k++) {
        if (links[k].joint != ARMTOL_FIXED) {
            const double range = links[k].joint == ARMTOL_PRISMATIC ? 300 : 3;
            q[joint] = range * armtol_sampler_uniform(SEED, i * robot->n_joints + joint);
            joint++;
        }
    }
    robot->forward(q, &armtol_errata_none, wish);
    for (size_t j = 0; j < robot->n_wish; j++) {
        wish[j] = stored(wish[j]);
    }
}

/* The joint values of a wish, as printed; of joints that the arm does not have, 0. */
static void answer(const family *family, const configuration *how, const double wish[], double printed[MOST_JOINTS])
{
    double q[MOST_JOINTS] = {0};
    family->solve(how, wish, q);
    for (size_t j = 0; j < MOST_JOINTS; j++) {
        printed[j] = printed_of(q[j]);
    }
}

/* The largest difference from the default's answer to wish i, in units of the last digit; inf for nan. */
static double difference_at(const family *family, const configuration *how, size_t i, double printed[MOST_JOINTS])
{
    const configuration configuration = family_default();
    double wish[MOST_WISH], of_default[MOST_JOINTS], largest = 0;
    elsewhere_wish(family, i, wish);
    answer(family, &configuration, wish, of_default);
    answer(family, how, wish, printed);
    for (size_t j = 0; j < MOST_JOINTS; j++) {
        const double difference = fabs(printed[j] - of_default[j]);
        largest = difference <= largest ? largest : isnan(difference) ? (double)INFINITY : difference;
    }
    return largest;
}

elsewhere_difference elsewhere_compare_one(const family *family, const configuration *how, size_t n_wishes)
{
    elsewhere_difference difference = {0, 0};
    for (size_t i = 0; i < n_wishes; i++) {
        double printed[MOST_JOINTS];
        const double units = difference_at(family, how, i, printed);
        difference.n_other += units > 0;
        difference.n_far += units > 10;
    }
    return difference;
}

/* ---- many configurations ---- */

/* FNV-1a over the bytes of an answer. Two of ten thousand sets fall together with a chance below 1e-11. */
static uint64_t add_to_fingerprint(uint64_t hash, const double printed[MOST_JOINTS])
{
    unsigned char bytes[MOST_JOINTS * sizeof printed[0]];
    memcpy(bytes, printed, sizeof bytes);
    for (size_t i = 0; i < sizeof bytes; i++) {
        hash = (hash ^ bytes[i]) * 0x100000001b3u;
    }
    return hash;
}

static int compare_numbers(const void *one, const void *other)
{
    const uint64_t a = *(const uint64_t *)one, b = *(const uint64_t *)other;
    return (a > b) - (a < b);
}

static elsewhere_spread summarize(uint64_t fingerprints[], uint64_t others[], size_t n)
{
    qsort(fingerprints, n, sizeof *fingerprints, compare_numbers);
    qsort(others, n, sizeof *others, compare_numbers);
    elsewhere_spread spread = {
        .least = (size_t)others[0], .median = (size_t)others[n / 2], .most = (size_t)others[n - 1]};
    for (size_t i = 0; i < n; i++) {
        spread.n_answers += i == 0 || fingerprints[i] != fingerprints[i - 1];
        spread.n_same += others[i] == 0;
    }
    return spread;
}

bool elsewhere_compare_all(const family *family, const configuration configurations[], size_t n, size_t n_wishes,
                           elsewhere_spread *spread)
{
    *spread = (elsewhere_spread){0};
    if (n == 0) {
        return true;
    }
    uint64_t *fingerprints = calloc(n, 2 * sizeof *fingerprints);
    if (fingerprints == NULL) {
        out_of_memory();
        return false;
    }
    uint64_t *others = fingerprints + n;
    for (size_t i = 0; i < n; i++) {
        fingerprints[i] = 0xcbf29ce484222325u;
        for (size_t w = 0; w < n_wishes; w++) {
            double printed[MOST_JOINTS];
            others[i] += difference_at(family, &configurations[i], w, printed) > 0;
            fingerprints[i] = add_to_fingerprint(fingerprints[i], printed);
        }
    }
    *spread = summarize(fingerprints, others, n);
    free(fingerprints);
    return true;
}
