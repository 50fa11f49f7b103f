#ifndef ARMTOL_LIB_REGION_LOADS_H
#define ARMTOL_LIB_REGION_LOADS_H

#include "armtol/region.h"
#include "lib/private_names.h"

/* A drive that a load moves, its column of A, or whose play a load may hold at one end: armtol_drive_offset_under. */
typedef struct load_drive {
    size_t link, column;
    double give;     /* by what the joint moves for a unit of the moment below, less what is compensated */
    double play;
    double doubt, friction; /* in units of that moment: N times the arm's length, or N along a slide */
    double most; /* moment there could be in the region, in any case */
    double held, free_play; /* what it may be off by to either side where a load holds it, and where none does */
} load_drive;

/* What bears on an arm's drives, for all of a question's load cases. */
typedef struct loads {
    const armtol_arm *arm;
    const armtol_loading *loading;
    double offset[3]; /* of the tool point */
    bool pushed;      /* by a force at the tool point */
    double force, reach; /* how large it is, and how far from the last frame's origin */
    double *weights, *turns; /* a link's own: its weight, and that times how far its mass is from the link's end */
    size_t n_cases, n_drives;
    load_drive *drives;
} loads;

/* What of the drives depends on the pose: n_drives is 0 where nothing does. False where memory is short. */
bool loads_make(loads *loads, const armtol_question *question);
void loads_free(loads *loads);

/* The mass held in a case, or NULL. */
const armtol_mass *loads_payload(const loads *loads, size_t which);

/* Whether all that bears on the arm is along z of the base: a turn of the whole arm about it changes no moment. */
bool loads_are_upright(const loads *loads);

/*
 * What a moment would be, were every lever at a right angle: of a link's joint, for a case, where a link's own vector
 * is `lengths` long. Sums of forces and moments as moments.c has them.
 */
void loads_most(const loads *loads, size_t which, const double lengths[], double most[]);

#endif
