#include "lib/arrivals/one_arm.h"

#include "lib/spread/normal.h"
#include "lib/spread/splitmix.h"

#include <math.h>

/* The draws of a joint at an arrival, each with its place in the numbers whether it is needed or not. */
enum { DRAW_PLAY, DRAW_STEP, DRAW_NOISE, DRAWS };

/* In (0, 1), neither end reached: the upper 52 bits, and half of what would come next. Exact. */
static double open_uniform(uint64_t key, uint64_t number)
{
    return ((double)(splitmix_mix(key + SPLITMIX_STEP * (number + 1)) >> 12) + 0.5) * 0x1p-52;
}

/* What a joint is off by at an arrival; number: of its first draw there. */
static double joint_off(const armtol_drive_arrival *off, uint64_t key, uint64_t number)
{
    double sum = 0;
    if (off->play > 0) {
        sum += off->play * (2 * open_uniform(key, number + DRAW_PLAY) - 1);
    }
    if (off->step > 0) {
        sum += off->step * (2 * open_uniform(key, number + DRAW_STEP) - 1);
    }
    if (off->noise > 0) {
        sum += off->noise * normal_quantile(open_uniform(key, number + DRAW_NOISE));
    }
    return sum;
}

static void arrive(const arrival_source sources[], size_t n, uint64_t key, uint64_t number, double way[3])
{
    way[0] = way[1] = way[2] = 0;
    for (size_t s = 0; s < n; s++) {
        const double off = joint_off(&sources[s].off, key, number + DRAWS * sources[s].link);
        for (int i = 0; i < 3; i++) {
            way[i] += sources[s].way[i] * off;
        }
    }
}

static void mean_of(const double ways[], size_t cycles, double mean[3])
{
    mean[0] = mean[1] = mean[2] = 0;
    for (size_t j = 0; j < cycles; j++) {
        for (size_t i = 0; i < 3; i++) {
            mean[i] += ways[3 * j + i];
        }
    }
    for (int i = 0; i < 3; i++) {
        mean[i] /= (double)cycles;
    }
}

static double distance(const double a[3], const double b[3])
{
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

/* The mean of the distances and 3 of their deviations; what is at the ways is lost. */
static double repeatability(double ways[], size_t cycles, const double mean[3])
{
    double sum = 0, squares = 0;
    for (size_t j = 0; j < cycles; j++) {
        ways[j] = distance(&ways[3 * j], mean); /* place j has been read */
        sum += ways[j];
    }
    const double mean_distance = sum / (double)cycles;
    for (size_t j = 0; j < cycles; j++) {
        const double off = ways[j] - mean_distance;
        squares += off * off;
    }
    return mean_distance + 3 * sqrt(squares / (double)(cycles - 1));
}

arrival_measure arrival_cycles(const arrival_source sources[], size_t n, const double still[3], uint64_t key,
                               size_t n_links, size_t cycles, double ways[])
{
    const double none[3] = {0, 0, 0};
    double mean[3], off[3];
    for (size_t j = 0; j < cycles; j++) {
        arrive(sources, n, key, (uint64_t)j * DRAWS * n_links, &ways[3 * j]);
    }
    mean_of(ways, cycles, mean);
    for (int i = 0; i < 3; i++) {
        off[i] = still[i] + mean[i];
    }
    return (arrival_measure){.accuracy = distance(off, none), .repeatability = repeatability(ways, cycles, mean)};
}
