#ifndef ARMTOL_REGION_H
#define ARMTOL_REGION_H

#include "armtol/answer.h"
#include "armtol/interface.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

ARMTOL_INTERFACE_BEGIN

/* ---- a region ---- */

/* A block: the tool point is between these, counted along the base's axes. Infinite ones bound nothing. */
typedef struct armtol_block {
    double low[3], high[3];
} armtol_block;

/*
 * What lies between two cylinders about one axis: the tool point is from `inner` to `outer` away from the axis, and
 * from `bottom` to `top` along it, counted from `point`. Infinite ones bound nothing.
 */
typedef struct armtol_ring {
    double point[3], axis[3]; /* of the axis, in the base's coordinates; its length does not matter, but is not 0 */
    double inner, outer;      /* 0 <= inner <= outer */
    double bottom, top;
} armtol_ring;

/* A path: the tool point is no further than `radius` from the line through the points. */
typedef struct armtol_path {
    const double *points; /* n_points x 3, in the base's coordinates */
    size_t n_points;      /* one at least */
    double radius;        /* >= 0 */
} armtol_path;

/* A cone: z of the tool's frame is no more than `angle` away from the direction. */
typedef struct armtol_cone {
    double direction[3]; /* in the base's coordinates; its length does not matter, but is not 0 */
    double angle;        /* radians, >= 0 */
} armtol_cone;

/*
 * The poses with joint values in a box whose tool is where all that is named has it. What is NULL asks for nothing. The
 * tool point is that of armtol_tool_point; lengths are the arm's.
 */
typedef struct armtol_region {
    const double *low, *high; /* a joint that moves by itself each, low <= high, finite: radians or lengths */
    const armtol_block *block;
    const armtol_ring *ring;
    const armtol_path *path;
    const armtol_cone *cone;
} armtol_region;

/* ---- the largest error in it ---- */

/* How the work ended. */
typedef enum armtol_ended {
    ARMTOL_ENDED_GAP,    /* the bounds are as near as was asked for */
    ARMTOL_ENDED_MOST,   /* as many boxes were looked at as there may be */
    ARMTOL_ENDED_CALLER, /* progress said so */
    ARMTOL_ENDED_COUNT
} armtol_ended;

/*
 * Called now and then by the thread that called: what of the largest error is still open, (high - low) / high, 1 at
 * first, and how many boxes were looked at. False ends the work; the bounds are then those reached. It must not call
 * back.
 */
typedef bool (*armtol_region_progress)(void *context, double open, uint64_t boxes);

/* From where to where the largest error of a region is. */
typedef struct armtol_enclosure {
    unsigned components; /* bit i for component i of dx, dy, dz, wx, wy, wz: one, or those of a norm (norm.h) */
    double low;     /* an error that the arm has in a pose of the region, to first order */
    double high;    /* what no pose of the region exceeds */
    double accuracy; /* infinity where none is asked for */
    size_t pose;    /* of a region's answer, from 0: where `low` is */
    uint64_t boxes; /* that were looked at */
    armtol_ended ended;
} armtol_enclosure;

/* How an enclosure is to be found. A member that is 0 or NULL has the meaning said here. */
typedef struct armtol_enclosing {
    double gap;    /* high <= (1 + gap) low, from 1e-6 to 10; 0: 0.01 */
    uint64_t most; /* boxes to look at, a measure; 0: 1,000,000. Some 100 bytes and 16 a joint are kept of each */
    armtol_region_progress progress;
    void *context;
} armtol_enclosing;

enum { ARMTOL_MOST_ENCLOSURES = 6 + ARMTOL_MOST_NORMS };

/* The tolerances that hold in a region, or what given ones do there. */
typedef struct armtol_region_answer {
    armtol_answer *answer; /* of the poses below: the worst of the region that were found, and some drawn from it */
    double *q;             /* answer->n_poses / answer->n_loads x answer->n_joints */
    size_t n_poses, n_worst; /* of q; how many of them, the first, are there for being the worst */
    armtol_enclosure enclosures[ARMTOL_MOST_ENCLOSURES]; /* components with an accuracy, or all where none is asked for,
                                                            and then the question's norms */
    size_t n_enclosures;
    /* linear and angular: what the exact error can differ from the first order anywhere in the region */
    double remainder[2];
    armtol_ended ended;  /* the worst of all enclosures */
} armtol_region_answer;

/* What a region's question failed for, beside the subjects of armtol_fault. */
typedef enum armtol_region_fault {
    ARMTOL_REGION_FINE,
    ARMTOL_REGION_RANGE, /* fault.number is the joint: not low <= high, or not finite */
    ARMTOL_REGION_SHAPE, /* a block, ring, path or cone that is none; fault.number 0 to 3 */
    ARMTOL_REGION_EMPTY, /* no pose is in it: proved */
    ARMTOL_REGION_NOT_FOUND, /* no pose was found in it, with as many boxes as there may be */
    ARMTOL_REGION_METHOD,    /* by ARMTOL_METHOD_SPHERE tolerances are of poses */
    ARMTOL_REGION_GAP,       /* not within its limits */
    ARMTOL_REGION_DISCS      /* the bound is of tolerances that are each of their own */
} armtol_region_fault;

/*
 * Find the largest tolerances that keep to the accuracy everywhere in a region, or the largest error that given
 * tolerances make in it.
 *
 * Given:
 *    question   as for armtol_answer_create; its q and n_poses are not looked at
 *    region     NULL is not allowed
 *    how        NULL: as if all were 0
 *
 * Returned:
 *    *answer    to be freed with armtol_region_answer_destroy; NULL after an error
 *    *fault     what the status is about; may be NULL
 *    *why       what is wrong with the region; may be NULL. ARMTOL_REGION_FINE where the fault says it all
 *
 * Notes:
 * 1) The error is the first order's: |A s| + sum |A t| by methods worst and sphere,
 *    |A s| + sigma sqrt(sum (A t)^2 / 3) by rss, s what drives are shifted by under a load (note 3 of answer.h). What
 *    the exact one can differ by is `remainder`.
 * 2) high is proved. In each joint by itself an element of A (frame of base or tool) is affine in the cosine and the
 *    sine of the joint's angle, or in its travel. So the error, a sum of magnitudes or a norm, is convex in that
 *    pair, and over polygons about the arcs of all joints it is largest at corners of all of them. Boxes of joints
 *    are halved until the largest of those is within the gap of an error that was found. Rounding is added to high
 *    (src/lib/region/chain.c says how much).
 * 3) A direction that is not fixed, the length of several components, is one or two angles more that are treated alike.
 * 4) What is symmetric is used: the first joint is not divided where neither the region nor the error sees it turn.
 * 5) Tolerances that are asked for keep to the accuracy by `high`, and are those of an accuracy smaller by no more
 *    than the gap: worst poses of the region are added to the question until no more than a tenth of the gap is
 *    missing. They do not where the work ended early: then `high` says what is proved.
 * 6) Drives under a load. The worst load case counts in each pose. A moment is affine in each joint as an element of A
 *    is; load_sum.c of src/lib/region says how the product of both is bounded, to second order in the size of a box.
 *    Where in a box it is not sure on which side a load holds the play, or whether it does, the worst of these counts.
 *    By rss this may keep the bounds apart where a moment changes its sign. A tolerance that the question gives a motor
 *    counts in each pose and case by itself where it is larger than the half width that its drive has there.
 * 7) A pose counts as in the region to 1e-9 of the arm's length, and of a radian.
 * 8) The same question has the same answer to the bit on every machine with IEEE arithmetic. No threads are begun.
 *
 * Errors:
 *    those of armtol_answer_create; ARMTOL_BAD_SPREAD where the question has spreads, which a region does not know;
 *    ARMTOL_BAD_RANGE where *why is ARMTOL_REGION_RANGE, ARMTOL_REGION_SHAPE or ARMTOL_REGION_GAP;
 *    ARMTOL_OUT_OF_REACH for ARMTOL_REGION_EMPTY, ARMTOL_NOT_SOLVED for ARMTOL_REGION_NOT_FOUND;
 *    ARMTOL_BAD_QUESTION for ARMTOL_REGION_METHOD and ARMTOL_REGION_DISCS;
 *    ARMTOL_UNBOUNDED about an accuracy or a norm that depends on a tolerance without a bound
 *
 * Reference:
 *    Ours. Branch and bound over boxes: Neumaier, Interval Methods for Systems of Equations, 1990, chapter 5.
 */
armtol_status armtol_region_answer_create(const armtol_question *question, const armtol_region *region,
                                          const armtol_enclosing *how, armtol_region_answer **answer,
                                          armtol_fault *fault, armtol_region_fault *why);

/* answer may be NULL. */
void armtol_region_answer_destroy(armtol_region_answer *answer);

ARMTOL_INTERFACE_END

#endif
