#include "bench/enclosure.h"

#include "armtol/region.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

/* A tool of 100 mm, lengths to 0.1 mm and angles to 1 mrad; each joint over `range` degrees or, if 0, over its
   limits. */

enum { JOINTS = 6, MOST_COLUMNS = 64 };

static void take_ranges(const armtol_arm *arm, double range, double low[JOINTS], double high[JOINTS])
{
    for (size_t j = 0; j < JOINTS; j++) {
        const double middle = (arm->drives[j].low + arm->drives[j].high) / 2, half = range / 2 * 0.017453292519943295;
        low[j] = range > 0 ? fmax(arm->drives[j].low, middle - half) : arm->drives[j].low;
        high[j] = range > 0 ? fmin(arm->drives[j].high, middle + half) : arm->drives[j].high;
    }
}

static bool print_one(const armtol_arm *arm, double range, double gap)
{
    const double none = (double)INFINITY, accuracy[6] = {1, none, none, none, none, none};
    double low[JOINTS], high[JOINTS], tolerances[MOST_COLUMNS];
    armtol_column columns[MOST_COLUMNS];
    armtol_region_answer *answer;
    const size_t n = armtol_column_count(arm->links, arm->n_links);
    armtol_columns(arm->links, arm->n_links, columns, n);
    for (size_t k = 0; k < n; k++) {
        tolerances[k] = armtol_parameter_is_length(columns[k].parameter) ? 0.1 : 0.001;
    }
    take_ranges(arm, range, low, high);
    const armtol_region region = {.low = low, .high = high};
    const armtol_question question = {.arm = arm, .tolerances = tolerances, .accuracy = accuracy,
                                      .tool.offset = {0, 0, 100}};
    const armtol_enclosing how = {.gap = gap};
    const clock_t start = clock();
    if (armtol_region_answer_create(&question, &region, &how, &answer, NULL, NULL) != ARMTOL_OK) {
        return false;
    }
    const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    const char *over = range > 0 ? "60 degrees a joint" : "its full range";
    printf("  %-20s to %4.1f %%: %8.3f s, %6llu boxes\n", over, 100 * gap, seconds,
           (unsigned long long)answer->enclosures[0].boxes);
    const bool fine = answer->ended == ARMTOL_ENDED_GAP;
    armtol_region_answer_destroy(answer);
    return fine;
}

bool enclosure_print(void)
{
    static const double gaps[] = {0.05, 0.02, 0.01, 0.005};
    const armtol_arm *arm = armtol_arm_named("puma560");
    bool fine = true;
    printf("the largest dx of a Puma 560, enclosed on one core\n");
    for (size_t i = 0; i < 2 * sizeof gaps / sizeof gaps[0] && fine; i++) {
        fine = print_one(arm, i % 2 == 0 ? 60 : 0, gaps[i / 2]);
    }
    return fine;
}
