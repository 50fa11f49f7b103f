#ifndef ARMTOL_LIB_REGION_ENCLOSE_H
#define ARMTOL_LIB_REGION_ENCLOSE_H

#include "lib/private_names.h"
#include "lib/region/pose_search.h"

/* What an enclosure starts from, and where it may stop. */
typedef struct enclose_target {
    double gap;      /* high <= (1 + gap) low */
    /* boxes above it are halved though they are within the gap, as long as low is not: infinity for none */
    double limit;
    double too_much; /* an error above it ends the work: infinity for none */
    uint64_t most;
    armtol_region_progress progress;
    void *context;
} enclose_target;

/*
 * Enclose the largest error of a measured chain over the region. variables has in the end the pose of `low`.
 * found->low, high, boxes and ended are written.
 * ARMTOL_OUT_OF_REACH: no pose is in the region. ARMTOL_NOT_SOLVED: none was found. ARMTOL_NO_MEMORY.
 */
armtol_status enclose(pose_search *search, const enclose_target *target, double variables[],
                      armtol_enclosure *found);

/* Whether the measured chain's error is 0 in all of its ranges, rounding apart. False too where memory is short. */
bool enclose_unseen(pose_search *search);

#endif
