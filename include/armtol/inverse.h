#ifndef ARMTOL_INVERSE_H
#define ARMTOL_INVERSE_H

#include "armtol/arm.h"
#include "armtol/conventions.h"
#include "armtol/interface.h"
#include "armtol/status.h"

#include <stdbool.h>
#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/* Inverse kinematics of any arm: from where its tool should be to joint values that bring it there. */

/* The most branches that are kept of a wish, and the most starts that are made for it. */
enum { ARMTOL_MOST_BRANCHES = 32, ARMTOL_MOST_STARTS = 1024 };

/* Branches no further apart than this, radians or shares of the arm's size, in every joint are one;
   those of note 6 that are as far from `near`, to 1e-6, where they are no further apart than a hundred times this. */
#define ARMTOL_BRANCH_APART 1e-4

/* Where the tool should be: its axes and, in the last column, its point, in base coordinates (euler.h makes one). */
typedef struct armtol_wish {
    armtol_transform tool;
    bool point_only; /* the axes are free, and not looked at */
} armtol_wish;

/* What is asked of. A member that is 0 or NULL has the meaning said here. All is read once, by create. */
typedef struct armtol_inverse_setup {
    const armtol_arm *arm; /* not NULL */
    double offset[3];      /* the tool point, from the last frame's origin, in that frame */
    const double *near;    /* a value a joint: the posture that the branches should be near; NULL: note 3 */
    bool ignore_limits;    /* joint values may be beyond the limits that the drives have */
    size_t enough;         /* so many branches are: no start is made once they are found; 0: all are wanted */
    double within;         /* how near counts as there: radians, and shares of the arm's size, or of the
                              wish's distance where that is larger; 0: 1e-10 */
} armtol_inverse_setup;

/* One way to bring the tool there. */
typedef struct armtol_branch {
    const double *q;  /* a value a joint; the solver's, until it is asked again or destroyed */
    double from_near; /* root of the sum of squares of what the joints differ by, lengths as shares of the size */
    double distance;  /* how far the tool point then is from the wish, in the arm's lengths, and */
    double angle;     /* by which angle the tool is turned against it, radians; 0 where the axes are free */
    bool own;         /* by the arm's own inverse kinematics, as the programs of 1987 choose: note 5 */
} armtol_branch;

/* What was found for a wish. */
typedef struct armtol_branches {
    size_t count; /* 0 where the wish is out of reach */
    armtol_branch branch[ARMTOL_MOST_BRANCHES]; /* note 4 says in which order */
    armtol_branch best; /* the nearest that the tool came, also where that is not near enough */
    size_t starts;      /* how many were made */
} armtol_branches;

typedef struct armtol_inverse armtol_inverse;

/*
 * Prepare for the wishes of one arm.
 *
 * Given:
 *    setup      see above
 *
 * Returned:
 *    *inverse   to be freed with armtol_inverse_destroy; NULL after an error
 *
 * Errors:
 *    ARMTOL_NO_MEMORY
 *    those of armtol_arm_check
 *    ARMTOL_NOT_FINITE  an offset or a value of `near` that is not; a size that overflows
 */
armtol_status armtol_inverse_create(const armtol_inverse_setup *setup, armtol_inverse **inverse);

/* inverse may be NULL. */
void armtol_inverse_destroy(armtol_inverse *inverse);

/* The arm's size: the sum of all |a| and |d|, of what its slides travel, and of the offset; 1 where that is 0. */
double armtol_inverse_size(const armtol_inverse *inverse);

/*
 * All branches found that bring the tool to a wish.
 *
 * Given:
 *    inverse    of armtol_inverse_create
 *    wish       the axes a right-handed system of unit vectors; nothing looks whether they are
 *
 * Returned:
 *    branches   count is 0, and `best` alone is of use, after ARMTOL_OUT_OF_REACH; untouched after ARMTOL_NOT_FINITE
 *
 * Notes:
 * 1) Levenberg and Marquardt's damped least squares: with the error e = (distance by axis / size, rotation vector) and
 *    the Jacobian J of the joints, a step is (J'J + l)^-1 J'e, or J'(JJ' + l)^-1 e, the same in exact arithmetic, where
 *    there are more joints than components. It begins at `near` and at postures drawn within the joints' ranges
 *    (splitmix64 of start and joint: the same each time), until 64 starts (16 where there are more joints than
 *    components), and as many as were made when the last branch was found, have brought nothing new; 256 where nothing
 *    at all is found. So "all" means all that were found: a branch that few starts lead to can be missed.
 *    docs/inverse.md counts how often.
 * 2) A joint that turns freely has its value within its limits that is nearest to `near`; postures that differ by whole
 *    turns are one branch. A branch keeps to the limits of its joints, and of those that follow them.
 * 3) The usual `near` is the middle of each joint's range, where both of its limits are known; else 0, or the limit
 *    where 0 is beyond it. A slide whose limits are not known is looked for over twice the size and the wish's distance
 *    (at least the size) to either side.
 * 4) Branches come by their distance from `near`. Where two are as far (to 1e-9) the one comes first whose first joint
 *    that differs has the larger value.
 * 5) Where `near` is NULL and the arm is one of 1987 (the table of robots.h, corrected, in millimetres) its own inverse
 *    kinematics comes first, as its programs choose it and with nothing wrapped, where it reaches the wish and keeps to
 *    the limits.
 * 6) An arm that can move while its tool stands (more joints than components, or a singular posture) has infinitely
 *    many postures. Each start that arrives is then moved, the tool standing, to where `near` is nearest; what differs
 *    after that is a branch of its own.
 * 7) The same wish has the same branches to the bit on every machine with IEEE arithmetic, whatever was asked before.
 *    Several solvers may be used on several threads, one on each.
 *
 * Errors:
 *    ARMTOL_NOT_FINITE    a number of the wish that is not, or a distance that overflows
 *    ARMTOL_OUT_OF_REACH  no start came near enough: not proof that none could
 *
 * Reference:
 *    Nocedal and Wright 2006, Numerical Optimization, section 10.3; Buss 2004, Introduction to Inverse Kinematics with
 *    Jacobian Transpose, Pseudoinverse and Damped Least Squares Methods.
 */
armtol_status armtol_inverse_find(armtol_inverse *inverse, const armtol_wish *wish, armtol_branches *branches);

/*
 * One branch alone, cheaply: the one that a start leads to, or the arm's own.
 *
 * Given:
 *    inverse, wish   as above
 *    from            a value a joint: where to start, the wish's neighbour say; NULL: the arm's own inverse kinematics,
 *                    where note 5 has it come first
 *
 * Returned:
 *    branch     as above; its q is the solver's until it is asked again. Untouched after an error
 *
 * Errors:
 *    those of armtol_inverse_find; ARMTOL_OUT_OF_REACH where this start does not come near enough within the limits,
 *    where the arm has no inverse kinematics of its own, and where that has no answer
 */
armtol_status armtol_inverse_follow(armtol_inverse *inverse, const armtol_wish *wish, const double from[],
                                    armtol_branch *branch);

ARMTOL_INTERFACE_END

#endif
