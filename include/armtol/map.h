#ifndef ARMTOL_MAP_H
#define ARMTOL_MAP_H

#include "armtol/conventions.h"
#include "armtol/interface.h"
#include "armtol/inverse.h"
#include "armtol/question.h"

#include <stdbool.h>
#include <stddef.h>

ARMTOL_INTERFACE_BEGIN

/* What is asked of each of many poses. */
typedef enum armtol_map_value {
    ARMTOL_MAP_WORST,         /* the largest error that the given tolerances and the drives allow, to first order */
    ARMTOL_MAP_DROOP,         /* how far the loads take the tool, by the exact kinematics */
    ARMTOL_MAP_REPEATABILITY, /* what is left open at each arrival: play that nothing holds, the encoder's step */
    ARMTOL_MAP_TOLERANCE,     /* the least of the largest tolerances that keep to the accuracy in this pose alone */
    ARMTOL_MAP_VALUE_COUNT
} armtol_map_value;

/* "worst", "droop", "repeatability", "tolerance"; "?" for a value that is none. */
const char *armtol_map_value_name(armtol_map_value value);

/*
 * Beside the components dx to wz, 0 to 5: the root of the summed squares of the three linear ones, and of the others.
 */
enum { ARMTOL_MAP_POSITION = 6, ARMTOL_MAP_ROTATION, ARMTOL_MAP_COMPONENT_COUNT };

typedef struct armtol_map {
    armtol_map_value value;
    size_t component;    /* of all but the tolerance */
    const bool *columns; /* of the tolerance, a column of A: whether it is one of those of which the least is meant */
} armtol_map;

/*
 * One number for each of many poses, each pose being asked about by itself.
 *
 * Given:
 *    question   as for armtol_answer_create, but that its poses have nothing to do with each other. A pose whose first
 *               joint value is nan is one that could not be reached
 *    map        what is asked of each of them
 *
 * Returned:
 *    values     n_poses, in the arm's unit of length or radians; nan where the pose could not be reached
 *    *fault     as of armtol_answer_create, the number of a pose being that of the question; may be NULL
 *
 * Notes:
 * 1) Magnitudes. Of several loads the largest; of tolerances the least, which is that of all loads.
 * 2) The worst case needs tolerances. It is the answer's, to the bit: |A s| + |A| t. Of the position it is the half
 *    diagonal of the box that the three components span: no arm is farther off, and none need be as far. It is infinite
 *    where a tolerance without a bound is seen.
 * 3) Droop and repeatability leave the tolerances out of the question and look at no accuracy. For the repeatability
 *    the drives are taken as stiff, and half the play as what a joint may be to either side of the middle of its play,
 *    where the moment does not hold it at one end; of noise ARMTOL_NOISE_SIGMAS count. Two arrivals are apart by no
 *    more than twice the value, but for noise beyond that. It is no measured repeatability (ISO 9283), and what wears,
 *    sticks or swings is not in it.
 * 4) The tolerance needs an accuracy and no given tolerances. 0 where drives and what is given leave nothing of it;
 *    infinite where none of its columns has a bound.
 * 5) Where the drives are in no error (drives_apart, or nothing is known of them), the worst case is found in blocks of
 *    poses (poses.h): many times as fast as an answer a pose.
 *
 * Errors:
 *    those of armtol_answer_create but ARMTOL_NOTHING_LEFT; ARMTOL_BAD_SPREAD where the question has spreads;
 *    ARMTOL_BAD_QUESTION also for a map that is none, without what it needs (notes 2 and 4). The values
 *    are then of no use.
 *
 * Reference:
 *    Hahn 1987, Eqs (4.9), (4.20); the report has two positions of each arm.
 */
armtol_status armtol_map_values(const armtol_question *question, const armtol_map *map, double values[],
                                armtol_fault *fault);

/* Points at which the tool should be: first + i across + j up, i below n_across, j below n_up. */
typedef struct armtol_map_plane {
    double first[3], across[3], up[3];
    size_t n_across, n_up;     /* one at least */
    armtol_transform axes;     /* the tool's, at all of them; its last column is not looked at */
    bool point_only;           /* the axes are free instead */
} armtol_map_plane;

/*
 * What is known of a point: whether it was reached, and whether the arm moves on from it to a neighbour without a jump.
 */
enum { ARMTOL_MAP_REACHED = 1, ARMTOL_MAP_JOINS_NEXT = 2, ARMTOL_MAP_JOINS_ABOVE = 4 };

/*
 * Joint values for every point of a plane.
 *
 * Given:
 *    setup      the arm, its tool, its limits; `near` is the posture to begin with
 *    plane      the points
 *    progress   told now and then of the points that are done; false ends the work. NULL: nobody waits
 *    context    for it
 *
 * Returned:
 *    q          n_across x n_up poses of a value a joint, point (i, j) being number j n_across + i; all nan where the
 *               point was not reached
 *    marks      n_across x n_up: sums of the above. Between two neighbours that were reached and are not joined the arm
 *               would have to change its branch
 *
 * Notes:
 * 1) Where the setup has no `near` and the arm is one of 1987 (note 5 of armtol_inverse_find), and the tool's axes are
 *    wanted, each point is by its own inverse kinematics.
 * 2) Else the branch nearest to `near` at the point that is nearest to where `near` has the tool is the first, and
 *    every point is followed from a neighbour (armtol_inverse_follow) as long as the two are joined. Beside what is
 *    reached then a jump is tried, and what is left at every third point across and up by armtol_inverse_find. So a
 *    region that hangs together with no other, and is narrower than three steps, can be missed; and no point without
 *    joint values is proved to be out of reach.
 * 3) Two neighbours are joined where no joint differs by more than a radian, or a slide by the arm's size, and joint
 *    values halfway between them bring the tool point halfway, to 0.35 of the way. Within a third of a step of where
 *    two branches meet they can be joined too.
 * 4) The same plane has the same joint values to the bit on every machine with IEEE arithmetic.
 *
 * Errors:
 *    those of armtol_inverse_create and armtol_inverse_find but ARMTOL_OUT_OF_REACH; ARMTOL_BAD_QUESTION for a plane
 *    without points. q and marks are then of no use. Ended early by `progress` it is ARMTOL_OK, and what was not done
 *    yet counts as not reached.
 */
armtol_status armtol_map_poses(const armtol_inverse_setup *setup, const armtol_map_plane *plane,
                               bool (*progress)(void *context, size_t done, size_t total), void *context, double q[],
                               unsigned char marks[]);

/* Of a point: whether armtol_inverse_find was asked about it, and what it said. */
enum { ARMTOL_MAP_NOT_SEARCHED, ARMTOL_MAP_FOUND, ARMTOL_MAP_IN_VAIN };

/* The searches of a map, which are most of its work, shared out. */
typedef struct armtol_map_search {
    size_t first, count;    /* the points, n_across x n_up in all, in which to search where nothing is known yet */
    unsigned char *results; /* n_across x n_up: the above */
    const double *q;        /* n_across x n_up poses: joint values where a search found them; NULL where none did yet */
} armtol_map_search;

/*
 * armtol_map_poses in parts.
 *
 * Given:
 *    search     which points to search in, and what is known of searches made elsewhere. The caller's
 *    all else   as for armtol_map_poses
 *
 * Returned:
 *    search->results   with those of the searches made here
 *    q, marks          as if every search that was not to be made, and of which nothing is known, had been in vain;
 *                      where a search made here found joint values they are in q
 *
 * Notes:
 * 1) Once the results of all points are known, with their joint values, a last call returns what armtol_map_poses does,
 *    to the bit, however the points were shared out. What it needs and nobody searched for it searches for itself,
 *    where the points to search in are all of them.
 * 2) Following from neighbours is done anew by each call. So is the search in the first point of all, from which the
 *    others are followed to, where nothing is known of it.
 *
 * Errors: those of armtol_map_poses.
 */
armtol_status armtol_map_poses_in_parts(const armtol_inverse_setup *setup, const armtol_map_plane *plane,
                                        const armtol_map_search *search,
                                        bool (*progress)(void *context, size_t done, size_t total), void *context,
                                        double q[], unsigned char marks[]);

ARMTOL_INTERFACE_END

#endif
