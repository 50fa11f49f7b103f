#ifndef ARMTOL_LIB_REGION_CHAIN_H
#define ARMTOL_LIB_REGION_CHAIN_H

#include "armtol/region.h"
#include "lib/region/loads.h"
#include "lib/private_names.h"

#include <stdint.h>

/*
 * An arm as a function of its variables: two angles of the direction that an error is counted along, which are 0
 * where the measure has only one, and then one variable a joint that moves by itself.
 */
#define CHAIN_FIXED SIZE_MAX
enum { CHAIN_DIRECTIONS = 2 };

typedef struct chain_link {
    double a, d, theta;     /* at joint value 0 */
    double cos_alpha, sin_alpha, cos_beta, sin_beta;
    armtol_joint joint;
    size_t variable;        /* CHAIN_FIXED, or the variable that moves it */
    double times, plus;     /* theta or d grows by times * variable + plus */
    bool leads;             /* the variable is its own */
    double weights[ARMTOL_PARAMETER_COUNT]; /* what its columns count; 0 for those that are none */
} chain_link;

typedef struct chain {
    const armtol_arm *arm;
    size_t n_links, n_joints, n_variables;
    chain_link *links;
    double offset[3];
    bool along_tool, angular, squares; /* errors along the tool's axes; rotations; the root of summed squares */
    size_t n_axes, axes[3];            /* of the error, 0 to 2 */
    double *low, *high;                /* n_variables: the whole box */
    double reach;                      /* the longest that the chain can be, and the tool's offset */
    double blur;                       /* what rounding can make of a point of it */
    double rounding;                   /* what rounding can make of the sum, before corners stretch it (enclose.c) */
    const loads *loads;                /* NULL where nothing of the drives depends on the pose */
    bool loaded;                       /* whether they are in the sum */
    double factor;                     /* of tolerances in the sum: 1, or of standard deviations */
    double shift_rounding;             /* what rounding can make of shifts, before corners stretch them twice */
    double moment_rounding;            /* and of a moment, as a part of what it could be */
} chain;

/* The chain without a measure: its joints, their ranges, its reach. False where memory is short. */
bool chain_make(chain *chain, const armtol_arm *arm, const armtol_tool_point *tool, const armtol_region *region);
void chain_free(chain *chain);

/*
 * What bears on its drives, which has to stay, and what their moments could be in the region. False where memory is
 * short.
 */
bool chain_take_loads(chain *chain, loads *loads);

/*
 * What is asked of it: the components of the error, the columns' tolerances (infinite ones count as 0), whether drives
 * under a load are in it, and the symmetry that region and measure have.
 */
void chain_measure(chain *chain, const armtol_region *region, unsigned components, const double tolerances[],
                   double sigma, bool loaded);

#endif
