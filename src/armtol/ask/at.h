#ifndef ARMTOL_ASK_AT_H
#define ARMTOL_ASK_AT_H

#include "armtol/ask/options.h"
#include "armtol/ask/units.h"
#include "armtol/inverse.h"
#include "armtol/lists/lists.h"

/* The positions of --at and --at-file, and what finds joint values for them. */
typedef struct at_wishes {
    const units *units;
    const armtol_arm *arm;
    bool limited;       /* joints keep to their limits */
    size_t n;
    typed_wish *wishes; /* as typed */
    armtol_inverse *inverse;
} at_wishes;

/* Which branch was taken of a pose that was asked for by its position, and of how many. */
typedef struct at_taken {
    size_t n_branches;
    double distance, angle; /* how far off it is, as armtol_branch says, */
    bool exact;             /* and whether that is rounding */
    bool own;               /* by the inverse kinematics of 1987 */
} at_taken;

bool at_is_asked(const cli_options *options);

/* Read them; units and arm stay where they are. False after a message: nothing is then to be freed. */
bool at_make(at_wishes *at, const cli_options *options, const units *units, const armtol_arm *arm);
void at_free(at_wishes *at);

/* All branches found of a position, numbered from 0. False after a message, where there is none. */
bool at_find(const at_wishes *at, size_t number, armtol_branches *branches);

/*
 * The first branch of each, the poses of a question, in inside units; to be freed, also after a message. A bar on a
 * terminal tells of long lists. False after a message.
 */
bool at_find_poses(const cli_options *options, const units *units, const armtol_arm *arm, double **poses,
                   at_taken **taken, size_t *n_poses);

#endif
